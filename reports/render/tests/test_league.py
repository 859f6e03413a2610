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
    """A record of somebody's solver with that cell, whose error at two times is this and a half of it."""
    measured = {"cell_size": cell, "eta_relative_l1_t_1": error / 2, "eta_relative_l1_t_2": error, "other": 7.0}
    return record("wave", solver=solver, measurements={**measured, **changes.pop("measurements", {})}, **changes)


class League(unittest.TestCase):
    def table(self, *raw):
        loaded = [records.Record(f"{k}.json", one) for k, one in enumerate(raw)]
        return league.survey([records.Case("wave", loaded)])

    def test_order_is_that_of_the_quantity_shown(self):
        ladder = {"ladder_order_R": 1.0, "ladder_order_eta": 1.5, "ladder_order_u": 2.0}
        one, = self.table(record("wave"), scored("boxes", 0.05, 0.2, measurements=ladder), scored("circles", None, 0.2))
        self.assertEqual([(run.record.solver, run.order) for run in one.runs],
                         [("seiche", None), ("boxes", 1.5), ("circles", None)])

    def test_error_is_that_of_the_worst_time(self):
        one, = self.table(scored("boxes", 0.1, 0.25))
        self.assertEqual((one.quantity, one.runs[0].error), ("largest relative L1 error of eta", 0.25))

    def test_a_solver_without_the_measurement_has_no_error(self):
        one, = self.table(scored("boxes", 0.1, 0.25), scored("circles", 0.1, 0.5, measurements={"eta_relative_l1_t_2": None}))
        self.assertEqual([run.error for run in one.runs], [0.25, None])

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

    def test_settings_are_written_as_the_command_writes_them(self):
        parameters = {name: {"value": value, "default": None}
                      for name, value in {"depth": 0.6343140641800991, "open": True, "time": 8.0}.items()}
        row, = league.rows_of(records.Record("0.json", scored("boxes", 0.1, 0.25, parameters=parameters)), {})
        self.assertEqual(row["settings"], "depth=0.6343140641800991;open=true;time=8")

    def test_page_is_made_where_others_are(self):
        with tempfile.TemporaryDirectory() as folder:
            out = reported(folder, record("wave"))
            self.assertFalse((out / "league.html").exists())
            self.assertNotIn("league.html", (out / "index.html").read_text())
            reported(folder, scored("boxes-10", 0.1, 0.25))
            self.assertIn("league.html", (out / "index.html").read_text())
            page = (out / "league.html").read_text()
            for text in ("boxes-10", "0.25", "Largest relative L1 error of eta"):
                self.assertIn(text, page)


if __name__ == "__main__":
    unittest.main()
