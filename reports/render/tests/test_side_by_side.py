"""The page of models side by side, on made-up records: what it shows, what it says of what is not there.

    /usr/bin/python3 reports/render/tests/test_side_by_side.py
"""
import json
import os
import pathlib
import re
import sys
import tempfile
import unittest

REPORTS = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(REPORTS))

from render import side_by_side  # noqa: E402
from render.tests.test_report import HOSTILE, Page, figure, record, render, write_arrays  # noqa: E402


def row(model, **changes):
    cells = {"model": model, "size of": "cell", "size": 0.1, "error": 0.0123, "uncertainty": 0.0011,
             "processor time": 0.25, "energy": -0.0312, "momentum": 1e-16, "lasted": 3.0, "asked": 3.0, "broke by": ""}
    return [{**cells, **changes}[name] for name in side_by_side.COLUMNS]


def table(rows, columns=side_by_side.COLUMNS):
    units = {"size": "depth", "error": "radius", "uncertainty": "radius", "processor time": "s", "lasted": "s",
             "asked": "s"}
    return [{"id": side_by_side.TABLE, "title": "t", "caption": "c", "atlas": [], "rows": rows,
             "columns": [{"name": name, "unit": units.get(name, "")} for name in columns]}]


class Models(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.temporary.name)
        os.environ["XDG_CACHE_HOME"] = str(cls.folder / "cache")
        evidence, cls.out = cls.folder / "evidence", cls.folder / "report"
        evidence.mkdir()
        drop = [row("coarse and fine", size=0.2, error=0.5), row("coarse and fine", size=0.1, error=0.0123),
                row("breaks late", size=0.125, error=0.044), row("breaks late", size=0.0625, error=None, uncertainty=None,
                                                              energy=None, momentum=None, lasted=1.25,
                                                              **{"broke by": f"folds {HOSTILE}"}),
                row("never there", error=None, uncertainty=None, energy=None, momentum=None, lasted=0.0,
                    **{"broke by": "refuses to start"}),
                row("between walls", momentum=None, energy=3e-16)]
        for made in (record("drop_models", tables=table(drop), figures=[figure("cost")], data="drop_models.h5"),
                     record("standing_wave_models", tables=table([row("odd")[:-1]], side_by_side.COLUMNS[:-1])),
                     record("solitary_wave_models", status="error", error="killed", claims=[]),
                     record("stokes_models")):
            (evidence / f"{made['case']}.json").write_text(json.dumps(made))
        stranger = record("dam_break_models", solver="another", tables=table([row("a stranger's model")]))
        (evidence / "dam_break_models.another.json").write_text(json.dumps(stranger))
        write_arrays(evidence / "drop_models.h5", {"cost": [[("a", "computed", "points", [1, 2], [2, 1])]]})
        cls.status, cls.said = render(evidence, cls.out)
        cls.page = (cls.out / "models.html").read_text(encoding="utf-8")

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def section(self, name):
        return self.page[self.page.index(f'<section id="{name}"'):].split("</section>")[0]

    def line(self, model):
        return next(part for part in self.section("drop").split("<tr>") if f'<th scope="row">{model}</th>' in part)

    def test_the_page_is_made_and_linked(self):
        self.assertEqual(self.status, 0, self.said)
        self.assertEqual(Page(self.page).faults, [])
        index = (self.out / "index.html").read_text(encoding="utf-8")
        self.assertIn('href="models.html"', index)
        self.assertIn("sets 4 models side by side on 1 problem:", index)

    def test_numbers_are_those_of_the_record_at_the_finest_resolution(self):
        line = self.line("coarse and fine")
        self.assertIn('title="0.0123 ± 0.0011"', line)
        self.assertIn('title="0.1"', line)
        self.assertNotIn("0.5", line)
        self.assertIn("250 ms", line)
        self.assertIn('title="-0.0312"', line)
        self.assertIn("not until", line)

    def test_what_is_conserved_is_told_from_what_walls_take(self):
        self.assertRegex(self.line("coarse and fine"), r'<span title="1e-16">round-off</span>')
        line = self.line("between walls")
        self.assertRegex(line, r'<span title="3e-16">round-off</span>')
        self.assertIn("walls", line)

    def test_a_coarser_resolution_stands_for_a_finest_one_that_broke_before_its_error_was_taken(self):
        line = self.line("breaks late")
        self.assertIn('title="0.044 ± 0.0011"', line)
        self.assertIn(">0.125<", line)
        self.assertRegex(re.sub("<[^>]*>", "", line), "coarse to fine: not, 1.2")

    def test_a_model_that_gives_no_error_is_a_row_with_its_cause(self):
        line = self.line("never there")
        self.assertIn("refuses to start", line)
        self.assertNotIn("round-off", line)
        self.assertNotIn("walls", line)

    def test_the_figure_and_the_case_are_linked(self):
        self.assertIn('href="cases/drop_models.html"', self.section("drop"))
        self.assertIn('src="figures/drop_models/cost.svg"', self.section("drop"))
        self.assertIn('href="cases/stokes_models.html"', self.section("also"))

    def test_what_is_not_there_is_said(self):
        self.assertIn("no record of the case", self.section("dam-break"))
        self.assertIn("seiche run dam_break_models", self.section("dam-break"))
        self.assertIn("other columns", self.section("standing-wave"))
        self.assertIn("did not finish", self.section("solitary-wave"))

    def test_another_solvers_numbers_are_none_of_ours(self):
        self.assertNotIn("stranger", self.page)

    def test_hostile_words_are_printed(self):
        self.assertNotIn("<script>alert", self.page)

    def test_every_problem_has_a_case(self):
        for _, _, case in side_by_side.PROBLEMS:
            self.assertEqual(len(list((REPORTS.parent / "validation").glob(f"*/{case}.cpp"))), 1, case)
        for case in side_by_side.ALSO:
            self.assertEqual(len(list((REPORTS.parent / "validation").glob(f"*/{case}.cpp"))), 1, case)

    def test_the_columns_are_those_that_contests_write(self):
        source = (REPORTS.parent / "validation/studies/side_by_side/contest.cpp").read_text(encoding="utf-8")
        written = source[source.index(".columns ="):source.index(".rows =")]
        self.assertEqual(tuple(re.findall(r'\{"([^"]*)", ', written)), side_by_side.COLUMNS)
        self.assertIn(f'.id = "{side_by_side.TABLE}"', source)
        self.assertIn(f'.figure("{side_by_side.FIGURE}"', source)


if __name__ == "__main__":
    unittest.main()
