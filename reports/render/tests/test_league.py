"""The page of solvers beside each other.

    /usr/bin/python3 reports/render/tests/test_league.py
"""
import csv
import pathlib
import tempfile
import unittest

from made import record, reported

from render import league, records


def scored(solver, cell, error, **changes):
    """A record of somebody's solver with that cell and error."""
    measured = {"cell_size": cell, "other": 7.0, **changes.pop("measurements", {})}
    standing = {"settings": changes.pop("settings", ""), "errors": {"eta": error}}
    return record("wave", solver=solver, measurements=measured, standing=standing, **changes)


class League(unittest.TestCase):
    def table(self, *raw):
        loaded = [records.Record(f"{k}.json", one) for k, one in enumerate(raw)]
        return league.survey([records.Case("wave", loaded)])

    def test_order_is_that_of_the_quantity_shown(self):
        ladder = {"ladder_order_R": 1.0, "ladder_order_eta": 1.5, "ladder_order_u": 2.0}
        one, = self.table(record("wave"), scored("boxes", 0.05, 0.2, measurements=ladder), scored("circles", None, 0.2))
        self.assertEqual([(run.record.solver, run.order) for run in one.runs],
                         [("seiche", None), ("boxes", 1.5), ("circles", None)])

    def test_without_a_common_quantity_each_shows_its_own(self):
        other = scored("circles", 0.2, 0.5, measurements={"ladder_order_h": 1.5})
        other["standing"]["errors"] = {"u": 0.4, "h": 0.3}
        one, = self.table(scored("boxes", 0.1, 0.25), other)
        self.assertEqual((one.quantity, [(run.error, run.quantity, run.order) for run in one.runs]),
                         ("", [(0.25, "eta", None), (0.3, "h", 1.5)]))

    def test_what_was_not_found_says_so(self):
        one, = self.table(record("wave"), scored("boxes", 0.1, 0.25), scored("circles", None, None))
        self.assertEqual((one.quantity, [run.error for run in one.runs]), ("eta", [None, 0.25, None]))
        self.assertEqual([run.missing for run in one.runs], ["see its claims", "", "not found"])

    def test_a_stored_result_is_what_the_record_said(self):
        rows = [row for one in (scored("boxes", 0.1, 0.25, measurements={"ladder_order_eta": 1.5}), scored("circles", 0.2, 0.5))
                for row in league.rows_of(records.Record("0.json", one), {"boxes": "2.1"})]
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "solvers.csv"
            with open(path, "w", newline="") as file:
                writer = csv.DictWriter(file, league.COLUMNS)
                writer.writeheader()
                writer.writerows(rows)
            kept = league.stored(path)
        one, = league.survey([records.Case("wave", [records.Record("0.json", scored("circles", 0.1, 0.1))])], kept)
        self.assertEqual([(run.record.by, run.cell, run.error, run.order) for run in one.runs],
                         [("circles", 0.1, 0.1, None), ("boxes 2.1", 0.1, 0.25, 1.5)], "a solver's own record takes its place")

    def test_settings_are_those_of_the_record(self):
        row, = league.rows_of(records.Record("0.json", scored("boxes", 0.1, 0.25, settings="open=true;time=8")), {})
        self.assertEqual(row["settings"], "open=true;time=8")

    def test_page_is_made_where_others_are(self):
        with tempfile.TemporaryDirectory() as folder:
            out = reported(folder, record("wave"))
            self.assertFalse((out / "league.html").exists())
            self.assertNotIn("league.html", (out / "index.html").read_text())
            reported(folder, scored("boxes-10", 0.1, 0.25))
            self.assertIn("league.html", (out / "index.html").read_text())
            page = (out / "league.html").read_text()
            for text in ("boxes-10", "25</span> %", "Error of eta", "0.1</span> m", "see its claims"):
                self.assertIn(text, page)


if __name__ == "__main__":
    unittest.main()
