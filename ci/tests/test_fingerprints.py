"""Nothing that a check links is missing from its fingerprint: the closure over sources that ci/cmake/fingerprints.py
follows is compared with what the linker would follow, symbol by symbol."""

import json
import os
import pathlib
import re
import subprocess
import sys
import unittest

SOURCE = pathlib.Path(os.environ["SEICHE_SOURCE"])
BUILD = pathlib.Path(os.environ["SEICHE_BUILD"])
sys.path.insert(0, str(SOURCE / "ci/cmake"))
import fingerprints  # noqa: E402


def compiled():
    """Source -> object, as the build has them."""
    found = {}
    for entry in json.loads((BUILD / "compile_commands.json").read_text()):
        source = pathlib.Path(entry["file"])
        object_file = pathlib.Path(entry["directory"]) / re.search(r" -o (\S+)", entry["command"])[1]
        if source.is_relative_to(SOURCE) and not source.is_relative_to(BUILD) and object_file.exists():
            found[str(source.relative_to(SOURCE))] = object_file
    return found


def symbols(objects):
    """Source -> symbols it defines for others, and source -> symbols it needs."""
    listing = subprocess.run(["nm", "--print-file-name", *map(str, objects.values())], capture_output=True, text=True,
                             check=True).stdout
    by_object = {str(file): source for source, file in objects.items()}
    defines, needs = {}, {source: set() for source in objects}
    for line in listing.splitlines():
        file, rest = line.split(":", 1)
        kind, name = rest.split()[-2:]
        if kind == "U":
            needs[by_object[file]].add(name)
        elif kind in "TDBR":  # a weak symbol is in every object that needs it
            defines[name] = by_object[file]
    return defines, needs


# Catch2 itself, compiled there where it comes as a header.
FRAME = {"verification/main.cpp", "verification/distributed/main.cpp"}


class Fingerprints(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.sources = fingerprints.Sources(SOURCE)
        cls.defines, cls.needs = symbols(compiled())

    def linked(self, check):
        seen, todo = set(), [check]
        while todo:
            source = todo.pop()
            if source not in seen | FRAME:
                seen.add(source)
                todo.extend(self.defines[name] for name in self.needs[source] if name in self.defines)
        return seen

    def checks(self):
        for source in sorted(self.needs):
            if source.startswith("verification/") and source.endswith("_test.cpp"):
                yield source
            elif source.startswith("validation/") and f"{pathlib.PurePath(source).stem}" in self.cases():
                yield source

    def cases(self):
        if not hasattr(self, "_cases"):
            listed = json.loads(subprocess.run([os.environ["SEICHE"], "list", "--json"], capture_output=True, text=True,
                                               check=True).stdout)
            self._cases = {case["name"] for case in listed["cases"]}
        return self._cases

    def test_every_linked_source_decides(self):
        checks = list(self.checks())
        self.assertGreater(len(checks), 150)
        for check in checks:
            missing = self.linked(check) - set(self.sources.deciding(check)) - FRAME
            self.assertFalse(missing, f"{check} links what its fingerprint leaves out")


if __name__ == "__main__":
    unittest.main()
