"""What decides the numbers of a check, as one SHA-256 per check.

    fingerprints.py --source DIR --toolchain TEXT --output FILE CHECK.cpp...

writes C++ (constants seiche::validation::fingerprints::NAME) to a FILE.cpp, and a dictionary to a FILE.json.

The code that decides the numbers of a check is its own file, the headers it includes, and the files that implement
those headers, followed to the end. Comments and layout do not count, so that an edited article or a commit leaves the
evidence valid. The toolchain (compiler, flags, versions of libraries) counts.

A header is implemented by the .cpp of its own name and by those .cpp beside it that include it and have no header of
their own. That this finds all a check links is tested against the objects themselves: ci/tests/test_fingerprints.py.
"""

import argparse
import functools
import hashlib
import json
import pathlib
import re
import sys

REGISTRY = "validation/case/registry.hpp"
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*"([^"]+)"', re.MULTILINE)
# A raw string, a string, a character (not a digit separator), a comment: whichever begins first.
TOKEN = re.compile(r'R"(?P<mark>[^()\\\s]*)\(.*?\)(?P=mark)"|"(?:\\.|[^"\\\n])*"|(?<![0-9A-Za-z_])\'(?:\\.|[^\'\\\n])+\''
                   r"|//(?:\\\n|[^\n])*|/\*.*?\*/", re.DOTALL)


def without_comments(text):
    """The code with each comment and each run of blanks as one blank; strings stay as they are."""
    pieces, end = [], 0
    for token in TOKEN.finditer(text):
        pieces.append(re.sub(r"[ \t]+", " ", text[end:token.start()]))
        pieces.append(" " if token[0].startswith(("//", "/*")) else token[0])
        end = token.end()
    pieces.append(re.sub(r"[ \t]+", " ", text[end:]))
    return re.sub(r" *\n\s*", "\n", "".join(pieces)).strip()


class Sources:
    """The source tree, each file read once."""

    def __init__(self, root):
        self.root = pathlib.Path(root)

    @functools.cache
    def text(self, path):
        return (self.root / path).read_text()

    @functools.cache
    def digest(self, path):
        return hashlib.sha256(without_comments(self.text(path)).encode()).hexdigest()

    @functools.cache
    def includes(self, path):
        found = set()
        for name in INCLUDE.findall(self.text(path)):
            for place in (name, f"solver/{name}", str(pathlib.PurePath(path).parent / name)):
                if (self.root / place).is_file():
                    found.add(place)
                    break
        return frozenset(found)

    @functools.cache
    def including(self, folder):
        """Header of the folder -> the .cpp files of the folder that include it."""
        found = {}
        for file in sorted((self.root / folder).glob("*.cpp")):
            path = str(file.relative_to(self.root))
            for header in self.includes(path):
                if str(pathlib.PurePath(header).parent) == folder:
                    found.setdefault(header, set()).add(path)
        return found

    @functools.cached_property
    def cases(self):
        """The files that define cases: what the generated list of the registry is made of."""
        return {path for path in (str(file.relative_to(self.root)) for file in self.root.glob("validation/*/*.cpp"))
                if f"\nvoid {pathlib.PurePath(path).stem}(Case& c) {{" in self.text(path)}

    def implementing(self, header):
        including = self.including(str(pathlib.PurePath(header).parent)).get(header, set())
        parts = {path for path in including - self.cases if not (self.root / path).with_suffix(".hpp").is_file()}
        own = str(pathlib.PurePath(header).with_suffix(".cpp"))
        found = parts | {own} if (self.root / own).is_file() else parts or including - self.cases
        return found | self.cases if header == REGISTRY else found

    def deciding(self, check):
        """Every file of the tree that decides the numbers of a check."""
        seen, todo = set(), [check]
        while todo:
            path = todo.pop()
            if path in seen:
                continue
            seen.add(path)
            todo.extend(self.includes(path))
            if path.endswith(".hpp"):
                todo.extend(self.implementing(path))
        return sorted(seen)

    def fingerprint(self, check, toolchain):
        lines = [f"{path} {self.digest(path)}\n" for path in self.deciding(check)]
        return hashlib.sha256((toolchain + "\n" + "".join(lines)).encode()).hexdigest()


def as_cpp(fingerprints):
    lines = ["namespace seiche::validation::fingerprints {", ""]
    for check, digest in fingerprints.items():
        name = pathlib.PurePath(check).stem
        lines += [f"extern const char* const {name};", f'const char* const {name} = "{digest}";']
    return "\n".join([*lines, "", "}  // namespace seiche::validation::fingerprints", ""])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--source", type=pathlib.Path, required=True, help="root of the source tree")
    parser.add_argument("--toolchain", required=True, help="compiler, flags, versions of libraries")
    parser.add_argument("--output", type=pathlib.Path, required=True)
    parser.add_argument("checks", nargs="+", help="relative to the root")
    options = parser.parse_args()
    sources = Sources(options.source)
    cases = {check for check in options.checks if check.startswith("validation/")}
    if cases and cases != sources.cases:
        sys.exit(f"fingerprints.py takes other files for cases than the registry does: {sorted(cases ^ sources.cases)[:3]}, ...")
    found = {check: sources.fingerprint(check, options.toolchain) for check in options.checks}
    text = as_cpp(found) if options.output.suffix == ".cpp" else json.dumps(found, indent=1) + "\n"
    # An unchanged file keeps its time: what depends on it is not made again.
    if not options.output.exists() or options.output.read_text() != text:
        options.output.write_text(text)


if __name__ == "__main__":
    main()
