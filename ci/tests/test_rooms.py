"""Who may include whom: the house of README's layout, checked arrow by arrow."""

import os
import pathlib
import re
import unittest

SOURCE = pathlib.Path(os.environ["SEICHE_SOURCE"])
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*"([^"]+)"', re.MULTILINE)
IMPORT = re.compile(r"^[ \t]*(?:from render import ([\w, ]+)|from render\.(\w+) import|import render\.(\w+))", re.MULTILINE)
# Verdicts: what an instrument does not know.
VERDICTS = {f"reports/evidence/{name}.hpp" for name in ("criterion", "verdict", "record", "record_files")}
# Rooms that test what validation itself is made of.
INSIDE = {"evidence", "robustness"}


def room(path):
    """solver/seiche/models/X, validation/case, verification/exact, ...: where a file lives."""
    parts = pathlib.PurePath(path).parts
    if parts[:3] == ("solver", "seiche", "models"):
        return "/".join(parts[:4])
    if parts[:2] == ("validation", "studies"):
        return "validation/studies"
    return "/".join(parts[:2])


def allowed(file, included):
    """Whether the arrow from a file to what it includes points down."""
    here, there = room(file), room(included)
    top, below = here.split("/")[0], there.split("/")[0]
    if here == there:
        return True
    if top == "solver":
        two_models = here.startswith("solver/seiche/models/") and there.startswith("solver/seiche/models/")
        return below == "solver" and not two_models
    if top == "reports":
        return below == "solver"
    if below in ("solver", "reports"):
        return here != "validation/instruments" or included not in VERDICTS
    if top == "verification":
        # validation/case reads the reference tables.
        outside = here.split("/")[1] not in INSIDE
        return below == "verification" or there in ("validation/instruments", "validation/case") or not outside
    if here == "validation/instruments":
        return False
    if here == "validation/case":
        return there == "validation/instruments"
    if here == "validation/scoring":
        return there in ("validation/instruments", "validation/case")
    if here == "validation/studies":
        return there in ("validation/instruments", "validation/case")
    if here == "validation/command":
        return there in ("validation/case", "validation/scoring")
    return there in ("validation/instruments", "validation/case", "validation/scoring", "validation/studies")


class Rooms(unittest.TestCase):
    def test_arrows_point_down(self):
        wrong = []
        for top in ("solver", "validation", "verification", "reports"):
            for path in sorted((SOURCE / top).rglob("*.[ch]pp")):
                file = str(path.relative_to(SOURCE))
                for name in INCLUDE.findall(path.read_text()):
                    included = f"solver/{name}" if name.startswith("seiche/") else name
                    if (SOURCE / included).is_file() and not allowed(file, included):
                        wrong.append(f"{file} includes {included}")
        self.assertEqual(wrong, [])

    def test_a_wrong_arrow_is_noticed(self):
        for file, included in (("solver/seiche/io/a.cpp", "reports/evidence/record.hpp"),
                               ("solver/seiche/models/wcsph/a.hpp", "solver/seiche/models/mesh/b.hpp"),
                               ("reports/evidence/a.cpp", "validation/case/case.hpp"),
                               ("validation/instruments/a.hpp", "reports/evidence/record.hpp"),
                               ("validation/instruments/a.hpp", "validation/case/case.hpp"),
                               ("validation/studies/wcsph/a.hpp", "validation/bore/b.hpp"),
                               ("validation/bore/a.cpp", "validation/run_up/b.hpp"),
                               ("verification/exact/a_test.cpp", "validation/studies/wcsph/b.hpp")):
            self.assertFalse(allowed(file, included), f"{file} -> {included}")

    def test_the_renderer_has_no_circles(self):
        folder = SOURCE / "reports/render"
        modules = {path.stem for path in folder.glob("*.py")}
        imports = {}
        for path in folder.glob("*.py"):
            found = set()
            for several, one, other in IMPORT.findall(path.read_text()):
                found |= {name.strip() for name in several.split(",")} | {one, other}
            imports[path.stem] = found & modules
        for start in imports:
            seen, todo = set(), set(imports[start])
            while todo:
                module = todo.pop()
                self.assertNotEqual(module, start, f"{start} imports itself, by way of {sorted(seen)}")
                if module not in seen:
                    seen.add(module)
                    todo |= imports[module]

    def test_the_map_of_the_readme_is_the_tree(self):
        layout = (SOURCE / "README.md").read_text().split("## Layout")[1].split("\n## ")[0]
        above, named = "", set()
        for indent, folder in re.findall(r"^( +)([\w/<>]+)/ ", layout, re.MULTILINE):
            above = folder if len(indent) == 4 else above
            named.add(folder if len(indent) == 4 else f"{above}/{folder}")
        for folder in named:
            if "<" not in folder:
                self.assertTrue((SOURCE / folder).is_dir(), folder)
        tops = {path.name for path in SOURCE.iterdir() if path.is_dir() and not path.name.startswith((".", "build"))}
        self.assertEqual(tops, {folder.split("/")[0] for folder in named})


if __name__ == "__main__":
    unittest.main()
