"""A program with a change in it, made from the build that is there: what the change touches is compiled anew.

The commands are Ninja's own, at -O1. The changed objects go to the head of the link, where they take precedence over the
members of the static libraries that define the same symbols; nothing of the build itself is written. A changed header
lies in a tree that is searched first, and the sources that decide the check and read the header are compiled,
without precompiled headers. A change of a reference table or of a Python file needs no compiler: the program stands
beside a folder of tables one of which is altered, its checksum with it, so that it is not the checksum that notices.
"""

import functools
import hashlib
import os
import pathlib
import re
import resource
import shlex
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "ci/cmake"))
from fingerprints import Sources  # noqa: E402

MEMBER = re.compile(r'^#include "(.*)"', re.MULTILINE)


class NotBuilt(RuntimeError):
    """The changed program could not be made: the change says nothing about the checks."""


def processor_time():
    """Seconds that children have taken: what else runs on the machine does not count."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


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
        compile_of, link = {}, []
        for line in said:
            words = shlex.split(line)
            if words[0] == ":" and "-o" in words:
                link = shlex.split(line.split(" && ")[1])
            elif "-c" in words and "-o" in words:
                if "c++-header" not in words:
                    source = os.path.relpath(value_after(words, "-c"), ROOT)
                    compile_of[source] = words
                    if "/Unity/unity_" in source and (ROOT / source).is_file():
                        for member in MEMBER.findall((ROOT / source).read_text()):
                            self.together[target, os.path.relpath(member, ROOT)] = source
        return compile_of, link

    def program(self, target):
        """The program without a change."""
        return self.folder / value_after(self.commands(target)[1], "-o")

    @functools.cache
    def parsing(self):
        """Standard, folders of headers and definitions that any file of the project can be parsed with."""
        compile_of, _ = self.commands("seiche_command")
        words = [word for command in compile_of.values() for word in command]
        system = [words[i + 1] for i, word in enumerate(words) if word == "-isystem"]
        kept = [word for word in words if word.startswith(("-I", "-D"))]
        return ["-xc++", "-std=c++20", *dict.fromkeys(kept), *(f"-isystem{folder}" for folder in dict.fromkeys(system))]

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


class Changed:
    """The programs of a build with a change in them, each made when it is asked for, in a scratch folder."""

    def __init__(self, build, change, scratch):
        self.build, self.change, self.scratch = build, change, scratch
        self.tree = scratch / "tree"
        self.objects = {}
        self.programs = {}
        self.making = 0  # seconds of compiling and linking so far
        self.whole = change.applied((ROOT / change.file).read_bytes())
        # Neighbours are links, so that whoever reads the tree finds all of it; a Python package is a copy.
        package = change.file.endswith(".py") and pathlib.PurePath(*pathlib.PurePath(change.file).parts[:2])
        place, original = self.tree, ROOT
        for part in [*pathlib.PurePath(change.file).parts]:
            place.mkdir(parents=True)
            for entry in original.iterdir():
                if entry.name != part:
                    (place / entry.name).symlink_to(entry)
            place, original = place / part, original / part
            if package and original == ROOT / package:
                shutil.copytree(original, place, ignore=shutil.ignore_patterns("__pycache__"))
                break
        (self.tree / change.file).write_bytes(self.whole)

    @property
    def compiled(self):
        return self.change.file.endswith((".cpp", ".hpp"))

    @functools.cache
    def touched(self, check):
        """The sources to compile anew, those that the check's numbers depend on."""
        build, file = self.build, self.change.file
        compile_of, _ = build.commands(check.target)
        if file.endswith(".cpp"):
            found = [file]
        else:
            deciding = [*compile_of, *(path for target, path in build.together if target == check.target)
                        ] if check.is_python else build.sources.deciding(check.file)
            found = [path for path in deciding if (path in compile_of or (check.target, path) in build.together)
                     and (ROOT / path).is_file() and file in build.read_by(path)]
        found = list(dict.fromkeys(build.together.get((check.target, path), path) for path in found))
        if not found or any(path not in compile_of for path in found):
            raise NotBuilt(f"{check.target} is not made from {file}")
        return found

    def to_compile(self, check):
        """How many sources are still to be compiled for a check."""
        return sum(source not in self.objects for source in self.touched(check)) if self.compiled else 0

    def compile(self, target, source):
        """Compiles a source, from the tree with the change if it is there, with that tree's headers."""
        words, file = list(self.build.commands(target)[0][source]), self.change.file
        text = ROOT / source
        if not file.endswith(".cpp"):
            words = without_precompiled(words)
            first = next(i for i, word in enumerate(words) if word.startswith("-I"))
            words[first:first] = [f"-I{self.tree}/solver", f"-I{self.tree}"]
        elif source == file:
            text = self.tree / file
        else:
            text = self.scratch / pathlib.PurePath(source).name
            text.write_text((ROOT / source).read_text().replace(f'"{ROOT / file}"', f'"{self.tree / file}"'))
        made = self.scratch / f"{len(self.objects)}_{pathlib.PurePath(source).stem}.o"
        for option, value in (("-o", made), ("-MT", made), ("-MF", f"{made}.d"), ("-c", text)):
            if option in words:
                words[words.index(option) + 1] = str(value)
        # A change may leave a name unused; that is no reason for it not to compile.
        words = [word for word in words if word != "-Werror"]
        self.run([*words, "-iquote", str((ROOT / source).parent), "-w", "-O1"], "compile")
        return made

    def run(self, words, what):
        begin = processor_time()
        ended = subprocess.run(words, cwd=self.build.folder, capture_output=True, text=True)
        self.making += processor_time() - begin
        if ended.returncode != 0:
            raise NotBuilt(f"does not {what}:\n{ended.stdout}{ended.stderr}")

    def link(self, check, program):
        """Links the program with other objects for some sources."""
        compile_of, link = self.build.commands(check.target)
        objects = {}
        for source in self.touched(check):
            if source not in self.objects:
                self.objects[source] = self.compile(check.target, source)
            objects[value_after(compile_of[source], "-o")] = str(self.objects[source])
        words = [word for word in link if word not in objects]
        words[words.index("-o") + 1] = str(program)
        first = next(i for i, word in enumerate(words) if word.endswith((".o", ".a")))
        words[first:first] = objects.values()
        self.run(words, "link")

    def program(self, check):
        """The program that runs the check. Throws NotBuilt."""
        original = self.build.program(check.target)
        # Of a header, what is compiled depends on the check.
        key = check if self.change.file.endswith(".hpp") else check.target
        if key not in self.programs:
            made = self.scratch / str(len(self.programs))
            program = made / original.relative_to(self.build.folder)
            shared = program.parent / "share/seiche"
            shared.mkdir(parents=True)
            for entry in (self.build.folder / "share/seiche").iterdir():
                (shared / entry.name).symlink_to(entry.resolve())
            if self.change.file.startswith("reference_data/"):
                self.alter_table(shared / "reference_data")
            if self.compiled:
                self.link(check, program)
            else:
                shutil.copy2(original, program)
            if check.target == "seiche_python":
                (made / "seiche").symlink_to(self.build.program("seiche_command"))
                for file in filter(pathlib.Path.is_file, (self.tree / "solver/python/seiche").iterdir()):
                    shutil.copy2(file, program.parent)
            self.programs[key] = program
        return self.programs[key]

    def alter_table(self, tables):
        """Replaces the link to the tables by a folder of links to each, one of them altered."""
        original = tables.resolve()
        tables.unlink()
        tables.mkdir()
        altered = pathlib.PurePath(self.change.file).parts[1]
        for source in original.iterdir():
            if source.name != altered:
                (tables / source.name).symlink_to(source)
        shutil.copytree(original / altered, tables / altered)
        (tables / altered / pathlib.PurePath(self.change.file).name).write_bytes(self.whole)
        description = tables / altered / "source.toml"
        digest = hashlib.sha256((tables / altered / "table.csv").read_bytes()).hexdigest()
        description.write_text(re.sub(r'^(sha256\s*=\s*)"[0-9a-f]{64}"', rf'\1"{digest}"', description.read_text(),
                                      flags=re.M))
