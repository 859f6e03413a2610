"""Many changes of the C++ in one build, each made when it is chosen: what a build and a run per change would cost is paid once.

A change becomes a choice, `(chosen(17) ? (a - b) : (a + b))`, in a copy of the tree that is built as the tree is. One run of
every check with no change chosen says what it finds, and which changes it comes to at all; then each change is tried on those
checks alone. A change that is no expression of its own (of a type, a constant of the compiler's, inside another change)
does not compile so; it is left to who tries one at a time.
"""

import collections
import pathlib
import re
import shutil
import subprocess

from programs import ROOT, Build

CHOSEN = """#pragma once
#include <cstdlib>
#include <fcntl.h>
#include <sys/mman.h>

namespace mutants {
inline const int number = [] { const char* word = std::getenv("SEICHE_MUTANT"); return word ? std::atoi(word) : -1; }();
inline unsigned char* const come_to = [] {
  static unsigned char none[MANY];
  const char* name = std::getenv("SEICHE_MUTANTS_COME_TO");
  const int file = name ? open(name, O_RDWR) : -1;
  void* const shared = file < 0 ? MAP_FAILED : mmap(nullptr, MANY, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
  return shared == MAP_FAILED ? none : static_cast<unsigned char*>(shared);
}();
inline bool chosen(int one) {
  come_to[one] = 1;
  return one == number;
}
}  // namespace mutants
"""
TARGETS = ["seiche_command", "verification_programs", "seiche_python"]


class Together:
    """The programs with the changes in them.

    @param changes  number -> change
    @param scratch  a folder for them; what an earlier run built there stays
    """

    def __init__(self, changes, scratch):
        self.tree, self.many = scratch / "tree", max(changes) + 1
        self.left_out = scratch / "left_out"
        left_out = self.left_out.read_text().split() if self.left_out.is_file() else []
        self.inside = {number: change for number, change in changes.items() if str(number) not in left_out}
        self.header = scratch / "chosen.hpp"
        files = subprocess.run(["git", "-C", ROOT, "ls-files"], check=True, capture_output=True, text=True).stdout.splitlines()
        self.lines = {file: {} for file in {change.file for change in changes.values()}}
        for file in files:
            if (ROOT / file).is_file():
                self.renew(self.tree / file, self.text(file) if file in self.lines else (ROOT / file).read_bytes())
                shutil.copymode(ROOT / file, self.tree / file)
        self.renew(self.header, CHOSEN.replace("MANY", str(self.many)).encode())
        self.build()
        self.programs = Build(self.tree / "build/release")

    @staticmethod
    def renew(path, text):
        """Writes a file, unless this stands there: what was compiled from it stays."""
        if not path.is_file() or path.read_bytes() != text:
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(text)

    def text(self, file):
        """A file with its changes in it; those within others are left out."""
        whole = (ROOT / file).read_bytes()
        edits = sorted((edit, number) for number, change in self.inside.items() if change.file == file
                       for edit in change.chosen(whole, f"::mutants::chosen({number})"))
        last = 0
        for (first, stop, _), number in edits:
            if first < last:
                self.inside.pop(number, None)
            last = max(last, stop)
        # The header goes before the first of the file's own.
        end = max(0, whole.find(b"\n#include") + 1)
        pieces = [whole[:end], f'#include "{self.header}"\n'.encode()]
        line = 2 + pieces[0].count(b"\n")
        where = self.lines[file] = collections.defaultdict(set)
        for (first, stop, text), number in edits:
            if number in self.inside:
                between, text = whole[end:first], text.encode()
                line += between.count(b"\n")
                for one in range(line, line + text.count(b"\n") + 1):
                    where[one].add(number)
                line += text.count(b"\n")
                pieces += [between, text]
                end = stop
        return b"".join([*pieces, whole[end:]])

    def build(self):
        """Builds, without the changes that do not compile."""
        folder = self.tree / "build/release"
        subprocess.run(["cmake", "--preset", "release", "-DCMAKE_CXX_FLAGS=-w -Wno-narrowing -fpermissive"], cwd=self.tree,
                       check=True, capture_output=True)
        while (ended := subprocess.run(["ninja", "-C", folder, "-k0", "-j2", *TARGETS], capture_output=True, text=True)).returncode:
            bad = set()
            for trouble in ended.stdout.split("FAILED: ")[1:]:
                bad |= self.named(trouble, ": (?:fatal )?error:") or self.named(trouble, "")
            if not bad:
                raise OSError(f"the changes do not build together:\n{ended.stdout[-3000:]}{ended.stderr[-1000:]}")
            with self.left_out.open("a") as file:
                file.writelines(f"{number}\n" for number in bad)
            for file in {self.inside.pop(number).file for number in bad}:
                self.renew(self.tree / file, self.text(file))

    def named(self, said, what):
        """The changes on the lines that a compiler names."""
        found = set()
        for path, line in re.findall(rf"^[^\n]*?{re.escape(str(self.tree))}/([^:\s]+):(\d+)(?::\d+)?{what}", said, re.M):
            found |= self.lines.get(str(pathlib.PurePath(path)), {}).get(int(line), set())
        return found & set(self.inside)

    def environment(self, number, come_to):
        """That chooses a change, or none; the file of those come to is begun anew."""
        come_to.write_bytes(bytes(self.many))
        return {"SEICHE_MUTANT": str(number), "SEICHE_MUTANTS_COME_TO": str(come_to)}
