"""The page of models side by side, on made-up records: what it shows, what it says of what is not there.

    /usr/bin/python3 reports/render/tests/test_side_by_side.py
"""
import pathlib
import re
import tempfile
import unittest

from made import (HOSTILE, REPORTS, Page, contest_row as row, contest_table as table, figure, record, reported,
                  write_arrays)

from render import side_by_side


class Models(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = pathlib.Path(cls.enterClassContext(tempfile.TemporaryDirectory()))
        (folder / "evidence").mkdir()
        drop = [row("coarse and fine", size=0.2, error=0.5), row("coarse and fine", size=0.1, error=0.0123),
                row("breaks late", size=0.125, error=0.044), row("breaks late", size=0.0625, error=None, uncertainty=None,
                                                              energy=None, momentum=None, lasted=1.25,
                                                              **{"broke by": f"tangles {HOSTILE}"}),
                row("never there", error=None, uncertainty=None, energy=None, momentum=None, lasted=0.0,
                    **{"broke by": "cannot start"}),
                row("between walls", momentum=None, energy=3e-16)]
        write_arrays(folder / "evidence/drop_models.h5", {"cost": [[("a", "computed", "points", [1, 2], [2, 1])]]})
        cls.out = reported(
            folder, record("drop_models", tables=table(drop), figures=[figure("cost")], data="drop_models.h5"),
            record("standing_wave_models", tables=table([row("odd")[:-1]], side_by_side.COLUMNS[:-1])),
            record("solitary_wave_models", status="error", error="killed", claims=[]),
            record("dam_break_models", solver="another", tables=table([row("a stranger's model")])))
        cls.pages = {path.stem: path.read_text(encoding="utf-8") for path in (cls.out / "problems").iterdir()}
        cls.page = cls.pages["drop"]

    def lines(self, model):
        """The rows of a model in the table of all resolutions."""
        table = self.page[self.page.index('id="contest"'):].split("</table>")[0]
        own = next(group for group in table.split('<th scope="rowgroup"')[1:] if f">{model}</th>" in group)
        return [part for part in own.split("<tr>") if part.strip()]

    def test_the_page_is_made_and_linked(self):
        self.assertEqual(Page(self.page).faults, [])
        index = (self.out / "index.html").read_text(encoding="utf-8")
        self.assertIn('href="problems/drop.html"', index)

    def test_numbers_are_those_of_the_record(self):
        coarse, line = self.lines("coarse and fine")
        self.assertIn("0.5", coarse)
        self.assertIn('title="0.0123 ± 0.0011"', line)
        self.assertIn('title="0.1"', line)
        self.assertNotIn("0.5", line)
        self.assertIn("250 ms", line)
        self.assertIn('title="-0.0312"', line)
        self.assertIn("completes", line)

    def test_a_change_of_energy_or_momentum_is_round_off_a_number_or_not_there(self):
        self.assertRegex(self.lines("coarse and fine")[1], r'<span title="1e-16">round-off</span>')
        line, = self.lines("between walls")
        self.assertRegex(line, r'<span title="3e-16">round-off</span></td><td class="r"></td>')

    def test_a_coarser_resolution_stands_for_a_finest_one_that_broke_before_its_error_was_taken(self):
        fine = self.lines("breaks late")[1]
        self.assertIn("1.25", fine)
        rows = [side_by_side.Row(dict(zip(side_by_side.COLUMNS, row("m", error=error)))) for error in (0.5, 0.1, None)]
        self.assertEqual(side_by_side.Problem.shown(rows).cells["error"], 0.1)

    def test_a_model_that_gives_no_error_is_a_row_with_its_cause(self):
        line, = self.lines("never there")
        self.assertIn("cannot start", line)
        self.assertNotIn("round-off", line)

    def test_the_figure_and_the_case_are_linked(self):
        self.assertIn('href="../cases/drop_models.html"', self.page)
        self.assertIn('src="../figures/drop_models.seiche/cost.svg"', self.page)

    def test_what_is_not_there_is_said(self):
        self.assertIn("no record of the case", self.pages["column-collapse"])
        self.assertIn("seiche run dam_break_models", self.pages["column-collapse"])
        self.assertIn("other columns", self.pages["standing-wave"])
        self.assertIn("did not finish", self.pages["solitary-wave"])

    def test_another_solvers_numbers_are_none_of_ours(self):
        self.assertNotIn("stranger", "".join(self.pages.values()))

    def test_hostile_words_are_printed(self):
        self.assertNotIn("<script>alert", self.page)

    def test_the_columns_are_those_that_contests_write(self):
        source = (REPORTS.parent / "validation/studies/side_by_side/contest.cpp").read_text(encoding="utf-8")
        written = source[source.index('{"model"'):].split("});")[0]
        self.assertEqual(tuple(re.findall(r'"([^"\[]*?)(?: \[[^"]*)?"', written)), side_by_side.COLUMNS)
        self.assertIn(f'exhibit, "{side_by_side.TABLE}"', source)
        self.assertIn(f'exhibit, "{side_by_side.FIGURE}"', source)


if __name__ == "__main__":
    unittest.main()
