"""A program with a defect in it, made from the build that is there: what the defect touches is compiled anew.

The commands are Ninja's own. The broken objects go to the head of the link, where they take precedence over the
members of the static libraries that define the same symbols; nothing of the build itself is written. A defect in a
header lies in a tree that is searched first, and the sources that decide the check and read the header are compiled,
without precompiled headers. A defect in a reference table needs no compiler: the program stands beside a folder of
tables one of which is altered, its checksum with it, so that it is not the checksum that notices.
"""

import functools
import hashlib
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys

from defects import ROOT

sys.path.insert(0, str(ROOT / "ci/cmake"))
from fingerprints import Sources  # noqa: E402


class NotBuilt(RuntimeError):
    """The broken program could not be made: the defect says nothing about the checks."""


MEMBER = re.compile(r'^#include "(.*)"', re.MULTILINE)


def value_after(words, option):
    return words[words.index(option) + 1]


def without_precompiled(words):
    """A compile command that reads no precompiled header."""
    kept, skip = [], False
    for word, following in zip(words, [*words[1:], ""]):
        if skip or word == "-Winvalid-pch":
            skip = False
        elif word == "-include" and "cmake_pch" in following:
            skip = True
        else:
            kept.append(word)
    return kept


class Build:
    """A build tree of Ninja, and what it would do for a program."""

    def __init__(self, folder):
        self.folder = folder.resolve()
        self.sources = Sources(ROOT)
        self.together = {}  # (target, file) -> the source that includes it
        cache = (self.folder / "CMakeCache.txt").read_text()
        self.ninja = re.search(r"^CMAKE_MAKE_PROGRAM:\w+=(.*)$", cache, re.M)[1]

    @functools.cache
    def commands(self, target):
        """(source -> words of its compile command, words of the link) of a program. A file that is compiled together with
        others is a source through the one that includes them (self.together)."""
        said = subprocess.run([self.ninja, "-C", self.folder, "-t", "commands", target], check=True,
                              capture_output=True, text=True).stdout.splitlines()
        compile_of = {}
        for line in said:
            words = shlex.split(line)
            if "-c" in words and "-o" in words and "c++-header" not in words:
                source = os.path.relpath(value_after(words, "-c"), ROOT)
                compile_of[source] = words
                if "/Unity/unity_" in source and (ROOT / source).is_file():
                    for member in MEMBER.findall((ROOT / source).read_text()):
                        self.together[target, os.path.relpath(member, ROOT)] = source
        link = shlex.split(said[-1].split(" && ")[1])
        return compile_of, link

    def program(self, target):
        """The program without a defect."""
        return self.folder / value_after(self.commands(target)[1], "-o")

    @functools.cache
    def read_by(self, source):
        """Every file of the tree that a source includes, headers of headers too."""
        seen, todo = set(), [source]
        while todo:
            path = todo.pop()
            if path not in seen:
                seen.add(path)
                todo.extend(self.sources.includes(path))
        return seen

    def touched(self, defect):
        """The sources to compile anew."""
        target = defect.check.target
        compile_of, _ = self.commands(target)
        if defect.file.endswith(".cpp"):
            found = [defect.file]
        else:
            found = [path for path in self.sources.deciding(defect.check.file)
                     if (path in compile_of or (target, path) in self.together) and defect.file in self.read_by(path)]
        found = list(dict.fromkeys(self.together.get((target, path), path) for path in found))
        missing = [path for path in found if path not in compile_of]
        if missing or not found:
            raise NotBuilt(f"{target} is not made from {' '.join(missing) or defect.file}")
        return found

    def compile(self, defect, source, tree, target_object):
        """Compiles a source, from the tree with the defect if it is there, with that tree's headers."""
        words = list(self.commands(defect.check.target)[0][source])
        if not defect.file.endswith(".cpp"):
            words = without_precompiled(words)
            first = next(i for i, word in enumerate(words) if word.startswith("-I"))
            words[first:first] = [f"-I{tree}/solver", f"-I{tree}"]
        text = tree / source if (tree / source).is_file() else ROOT / source
        if (defect.check.target, defect.file) in self.together and defect.file.endswith(".cpp"):
            text = tree / pathlib.PurePath(source).name
            text.write_text((ROOT / source).read_text().replace(f'"{ROOT / defect.file}"', f'"{tree / defect.file}"'))
        for option, value in (("-o", target_object), ("-MT", target_object), ("-MF", f"{target_object}.d"),
                              ("-c", text)):
            if option in words:
                words[words.index(option) + 1] = str(value)
        # A defect may leave a name unused; that is no reason for it not to compile.
        words = [word for word in words if word != "-Werror"]
        self.run([*words, "-iquote", str((ROOT / source).parent), "-w"], "compile")

    def run(self, words, what):
        ended = subprocess.run(words, cwd=self.folder, capture_output=True, text=True)
        if ended.returncode != 0:
            raise NotBuilt(f"does not {what}:\n{ended.stdout}{ended.stderr}")

    def link(self, target, objects, program):
        """Links the program with other objects for some sources."""
        compile_of, link = self.commands(target)
        replaced = {value_after(compile_of[source], "-o") for source in objects}
        words = [word for word in link if word not in replaced]
        words[words.index("-o") + 1] = str(program)
        first = next(i for i, word in enumerate(words) if word.endswith((".o", ".a")))
        words[first:first] = [str(path) for path in objects.values()]
        self.run(words, "link")

    def plant(self, defect, scratch):
        """The program with the defect, in a scratch folder. Throws NotBuilt."""
        original = self.program(defect.check.target)
        program = scratch / original.name
        tree = scratch / "tree"
        broken = tree / defect.file
        broken.parent.mkdir(parents=True)
        broken.write_text(defect.broken())
        shared = scratch / "share/seiche"
        shared.mkdir(parents=True)
        for entry in (self.folder / "share/seiche").iterdir():
            (shared / entry.name).symlink_to(entry.resolve())
        if defect.is_data:
            alter_table(shared / "reference_data", defect, broken)
            shutil.copy2(original, program)
        else:
            objects = {}
            for number, source in enumerate(self.touched(defect)):
                objects[source] = scratch / f"{number}_{pathlib.PurePath(source).stem}.o"
                self.compile(defect, source, tree, objects[source])
            self.link(defect.check.target, objects, program)
        return program


def alter_table(tables, defect, broken):
    """Replaces the link to the tables by a folder of links to each, one of them altered."""
    original = tables.resolve()
    tables.unlink()
    tables.mkdir()
    altered = pathlib.PurePath(defect.file).parts[1]
    for source in original.iterdir():
        if source.name != altered:
            (tables / source.name).symlink_to(source)
    shutil.copytree(original / altered, tables / altered)
    shutil.copy2(broken, tables / altered / broken.name)
    description = tables / altered / "source.toml"
    digest = hashlib.sha256((tables / altered / "table.csv").read_bytes()).hexdigest()
    description.write_text(re.sub(r'^(sha256\s*=\s*)"[0-9a-f]{64}"', rf'\1"{digest}"', description.read_text(),
                                  flags=re.M))
