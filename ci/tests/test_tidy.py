"""What ci/tidy looks at again: a file that changed, or a header under it, or the rules."""

import importlib.machinery
import importlib.util
import os
import pathlib
import tempfile
import unittest

SCRIPT = pathlib.Path(os.environ["SEICHE_SOURCE"]) / "ci/tidy"
loader = importlib.machinery.SourceFileLoader("tidy", str(SCRIPT))
tidy = importlib.util.module_from_spec(importlib.util.spec_from_loader("tidy", loader))
loader.exec_module(tidy)


class Stamps(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        for room in ("solver", "ci"):
            (self.root / room).mkdir()
        self.write(".clang-tidy", "Checks: bugprone-*\n")
        self.write(tidy.PLUGIN, "int walked();\n")
        self.write("solver/under.hpp", "int depth();\n")
        self.write("solver/wave.hpp", '#include "under.hpp"\n')
        self.write("solver/other.hpp", "int other();\n")
        self.write("solver/wave.cpp", '#include "wave.hpp"\n')

    def write(self, path, text):
        (self.root / path).write_text(text)

    def stamp(self):
        return tidy.stamp(tidy.Sources(self.root), "solver/wave.cpp")

    def test_what_a_file_includes_counts(self):
        for path, text in ((".clang-tidy", "Checks: misc-*\n"), ("solver/.clang-tidy", "InheritParentConfig: true\n"),
                           (tidy.PLUGIN, "int walked_otherwise();\n"), ("solver/under.hpp", "// NOLINT\nint depth();\n"),
                           ("solver/wave.hpp", '#include "under.hpp"\nint wave();\n'), ("solver/wave.cpp", "\n")):
            before = self.stamp()
            self.write(path, text)
            self.assertNotEqual(self.stamp(), before, path)

    def test_what_it_does_not_include_does_not(self):
        before = self.stamp()
        self.write("solver/other.hpp", "int another();\n")
        self.assertEqual(self.stamp(), before)


class Files(unittest.TestCase):
    built = {"solver/wave.cpp"}

    def test_examples_are_looked_at_and_what_needs_petsc_is_counted(self):
        named = ["solver/wave.cpp", "examples/waves/main.cpp", "solver/seiche/distributed/petsc.cpp"]
        self.assertEqual(tidy.to_look_at(named, self.built), (named[:2], 1))

    def test_a_file_that_nothing_builds_is_refused_by_name(self):
        for file in ("solver/wvae.cpp", "solver/seiche/new_room/wave.cpp"):
            with self.assertRaisesRegex(ValueError, file):
                tidy.to_look_at(["solver/wave.cpp", file], self.built)


if __name__ == "__main__":
    unittest.main()
