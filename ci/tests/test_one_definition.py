"""A name of a namespace has one definition: two types of one name in two headers are undefined behaviour as soon as one
program holds both, and no compiler tells (a vector of one of them then grows by the size of the other).

What is looked at is the shape that clang-format gives: what a namespace defines begins at the margin.
"""

import collections
import os
import pathlib
import re
import subprocess
import unittest

SOURCE = pathlib.Path(os.environ.get("SEICHE_SOURCE", pathlib.Path(__file__).parents[2]))
TYPE = re.compile(r"(?:struct|class|union|enum class|enum) (?:\[\[\w+\]\] )?(\w+)(?: final)?(?: : .*)?(?: \{.*)?$")


def definitions(text):
    """Full names of the types that a file defines, without those of anonymous namespaces; of templates too."""
    spaces = []
    for line in text.splitlines():
        if opened := re.match(r"(?:inline )?namespace ?([\w:]*) \{", line):
            if not line.endswith("}"):
                spaces.append(opened[1])
        elif line.startswith("}  // namespace"):
            spaces.pop()
        elif (found := TYPE.match(line)) and "" not in spaces and ("{" in line or not line.endswith(";")):
            yield "::".join([*spaces, found[1]])


class OneDefinition(unittest.TestCase):
    def test_a_repeated_name_is_found(self):
        text = "namespace a::b {\nnamespace {\nstruct Own {\n};\n}  // namespace\nstruct Later;\nstruct Crest : Base {\n" \
               "};\nstruct Short {};\n}  // namespace a::b\nenum class Kind { one };\n"
        self.assertEqual(list(definitions(text.replace("Short {};", "Short {"))), ["a::b::Crest", "a::b::Short", "Kind"])

    def test_every_type_is_defined_once(self):
        listed = subprocess.run(["git", "ls-files", "solver", "validation", "verification", "reports"], cwd=SOURCE,
                                capture_output=True, text=True)
        if listed.returncode:
            self.skipTest("no repository")
        places = collections.defaultdict(list)
        for name in listed.stdout.split():
            if name.endswith((".hpp", ".cpp")) and (SOURCE / name).exists():
                for defined in definitions((SOURCE / name).read_text(encoding="utf-8")):
                    places[defined].append(name)
        self.assertGreater(len(places), 300)
        self.assertEqual({name: files for name, files in places.items() if len(files) > 1}, {})


if __name__ == "__main__":
    unittest.main()
