"""The matrix of problems and models on the first screen; and what costs are set beside errors.

    /usr/bin/python3 reports/render/tests/test_matrix.py
"""
import csv
import fnmatch
import math
import pathlib
import re
import tempfile
import tomllib
import unittest

from made import (HOSTILE, Page, claim, contest_row as row, contest_table as table, figure, record, reported,
                  write_arrays)

from render import costs, experiments, league, matrix, pages, records


def compared(name, measured, expected, limit, **changes):
    return claim(name, measured=measured, expected=expected, unit=changes.pop("unit", "m"),
                 criterion={"kind": "bound", "limit": limit, "reason": "r", "relative": False}, **changes)


def loaded(*raw):
    return records.cases([records.Record(f"{one['case']}-{k}.json", one) for k, one in enumerate(raw)])


def number(value, unit="m"):
    return {"value": value, "unit": unit, "default": value, "meaning": "a meaning"}


class Matrix(unittest.TestCase):
    def test_an_error_is_a_share_of_what_is_expected_or_of_what_it_is_said_to_be_over(self):
        for measured, expected, unit, over, wanted in ((1.01, 1.0, "m", None, 0.01), (-0.04, 0.0, "1", None, 0.04),
                                                       (0.2, 0.0, "m", 2.0, 0.1), (0.2, 0.0, "m", None, None),
                                                       (None, 1.0, "m", None, None)):
            self.assertEqual(matrix.share(records.Claim(compared("a", measured, expected, 0.1, unit=unit)), over) is None,
                             wanted is None)
            if wanted:
                self.assertAlmostEqual(
                    matrix.share(records.Claim(compared("a", measured, expected, 0.1, unit=unit)), over), wanted)

    def test_the_ursell_number_is_that_of_height_depth_and_length(self):
        found = matrix.regime(0.2, 2.0, 10.0)
        self.assertAlmostEqual(found["kh"], 0.4 * math.pi)
        self.assertAlmostEqual(found["H/h"], 0.1)
        self.assertAlmostEqual(found["Ur"], 2.5)
        self.assertEqual(matrix.regime(0.2)["Ur"], None)

    def test_failures_count_and_the_worst_is_linked(self):
        made = record("wave", wall_time=3.0, claims=[
            compared("a-1", 1.1, 1.0, 0.2), compared("a-2", 1.3, 1.0, 0.2, verdict="fail", declared="fail", declared_reason="r"),
            compared("b", 9.0, 1.0, 0.2)])
        cell = matrix.of_claims(records.Record("wave.json", made), "a-*", None)
        self.assertAlmostEqual(cell.error, math.sqrt((0.01 + 0.09) / 2))
        self.assertEqual((cell.anchor, cell.readings, cell.seconds, cell.flaws), ("claim-a-2", 2, 3.0, ["1 of 2 exceed"]))
        self.assertAlmostEqual(cell.worst, 0.3)
        self.assertEqual(cell.shade, 3)
        self.assertIsNone(matrix.of_claims(records.Record("wave.json", made), "c", None))
        ended = matrix.of_claims(records.Record("wave.json", {**made, "status": "error", "error": "NaN"}), "a-1", None)
        self.assertEqual(ended.flaws, ["did not finish"])

    def test_every_claim_that_is_named_is_in_the_record(self):
        kept, quick = set(), set()
        for tier in ("quick", "full"):
            with (matrix.PROBLEMS.parent / "record" / f"{tier}.csv").open(encoding="utf-8", newline="") as file:
                kept |= {(row["case"], row["claim"]) for row in csv.DictReader(file)}
            quick = quick or set(kept)
        for problem in tomllib.loads(matrix.PROBLEMS.read_text(encoding="utf-8"))["problem"]:
            for what in problem.get("cells", {}).values():
                case, _, pattern = (what if isinstance(what, str) else what["claims"]).partition(": ")
                if (case, "resolves") in kept:      # of an experiment readings are named, which are one claim
                    pattern = "agreement"
                self.assertTrue(any(one == case and fnmatch.fnmatchcase(claim, pattern) for one, claim in kept), what)
                self.assertEqual(isinstance(what, dict) and what.get("tier") == "full",
                                 not any(one == case and fnmatch.fnmatchcase(claim, pattern) for one, claim in quick), what)

    def test_the_error_of_readings_is_that_of_all_and_the_verdict_that_of_their_experiment(self):
        rows = [["height", "gauges-highest-1", 1.0, 0.1, 1.1, 0.0, 0.0, 1.0],
                ["height", "gauges-highest-2", 1.0, 0.1, 1.3, 0.0, 0.0, 3.0], ["misfit", "gauges-misfit-1", 0.0, 1.0, 0.5, 0.0, 0.0, 0.5]]
        read = [{"id": experiments.TABLE, "title": "m", "caption": "", "columns": [], "rows": rows, "atlas": []}]
        made = record("lab", tables=read, claims=[claim("agreement", "uncertainty", verdict="fail", declared="fail",
                                                        declared_reason="r")])
        cell = matrix.of_claims(records.Record("lab.json", made), "gauges-highest-*", None)
        self.assertAlmostEqual(cell.error, math.sqrt((0.01 + 0.09) / 2))
        self.assertEqual((cell.anchor, cell.readings, cell.flaws), ("claim-agreement", 2, ["exceeds limit"]))

    def test_of_the_order_claims_95_percent_hold_the_theory(self):
        with (matrix.PROBLEMS.parent / "record" / "quick.csv").open(encoding="utf-8", newline="") as file:
            found = [abs(float(row["measured"]) - float(row["expected"])) <= float(row["uncertainty"])
                     for row in csv.DictReader(file) if row["kind"] == "order"]
        doubt = 3 * math.sqrt(0.95 * 0.05 / len(found))     # three standard deviations of the share
        self.assertGreater(sum(found) / len(found), 0.95 - doubt)

    def test_a_contest_says_where_a_model_stops(self):
        rows = [row("Lagrangian mesh", size=0.2, error=0.5),
                row("Lagrangian mesh", size=0.1, error=None, lasted=0.7, **{"broke by": "it tangles"}),
                row("SPH", error=0.03, energy=-0.2)]
        cases = loaded(record("drop_models", group="drop", tables=table(rows)))
        drop = next(one for one in matrix.survey(cases, {}, [])["problems"] if one.id == "drop")
        self.assertEqual((drop.cells["lagrangian-mesh"].error, drop.cells["lagrangian-mesh"].flaws), (0.5, ["stops at t\u00a0=\u00a00.7\u00a0s"]))
        self.assertEqual(drop.cells["sph"].flaws, ["energy −20\u00a0%"])
        self.assertEqual((drop.cells["sph"].uncertainty, drop.cells["sph"].seconds), (0.0011, 0.25))
        self.assertEqual([model for model, _ in drop.sorted_cells], ["sph", "lagrangian-mesh"])

    def test_claims_are_counted_by_evidence_and_of_the_laboratory_readings_alone(self):
        missed = compared("b", 9.0, 1.0, 0.1, verdict="fail", declared="fail", declared_reason="r")
        cases = loaded(record("a", kind="verification", claims=[claim("x"), claim("y")]), record("b", claims=[claim("x"), missed]),
                       record("c", group="laboratory", claims=[claim("x"), claim("y", "uncertainty")]))
        said = pages.overview(cases, [], [])
        self.assertEqual([(name, met, all_of) for name, _, met, all_of in said["evidence"]],
                         [("Verification", 2, 2), ("Theory and sources", 1, 2), ("Laboratory", 1, 1)])
        self.assertEqual([(cause, len(members), counts) for cause, members, counts in said["deviations"]],
                         [("Other causes", 1, [(("b", "cases/b.html"), 1)])])

    def test_results_of_other_solvers_are_counted_apart(self):
        wrong = claim("y", verdict="fail")
        said = pages.overview(loaded(record("a", claims=[claim("x"), wrong]),
                                     record("b", solver="boxes", claims=[claim("x"), wrong, wrong])), [], [])
        self.assertEqual((said["claims"], said["unexpected_count"], said["own_unexpected"]), (2, 3, 1))
        self.assertEqual([(name, met, all_of) for name, _, met, all_of in said["evidence"]],
                         [("Verification", 0, 0), ("Theory and sources", 1, 2), ("Laboratory", 0, 0), ("Other solvers", 1, 3)])

    def test_every_known_deviation_of_the_baseline_has_a_cause(self):
        causes, other, used = matrix.causes(), [], set()
        for file in (matrix.PROBLEMS.parent / "record").glob("*.csv"):
            if file.stem in ("quick", "full", "paper"):
                with file.open(newline="") as table_of_tier:
                    for one in csv.DictReader(table_of_tier):
                        if one["verdict"] == "declared fail":
                            used.add(cause := pages.cause_of(one["case"], one["claim"], causes))
                            other += [f"{one['case']}/{one['claim']}"] if cause == "Other causes" else []
        self.assertEqual(other, [])
        self.assertEqual(used, {cause["title"] for cause in causes})

    def test_the_page_has_counts_matrix_and_other_solvers_and_escapes(self):
        with tempfile.TemporaryDirectory() as folder:
            known = compared("d", 9.0, 1.0, 0.1, verdict="fail", declared="fail", declared_reason="known")
            out = reported(folder, record("wave_sph", parameters={HOSTILE: number(1, HOSTILE)}, claims=[known]),
                           record("riemann", group="dam_break", solver="boxes", standing={"settings": "", "errors": {"h": 0.025}},
                                  claims=[compared("a", 1.01, 1.0, 0.1)]),
                           options=["--scorable", f"bore/riemann,bore/{HOSTILE}"])
            page = (out / "index.html").read_text(encoding="utf-8")
            self.assertEqual(Page(page).faults, [])
            self.assertNotIn("<script>alert", page)
            places = [page.index(f'id="{name}"') for name in ("declared", "matrix", "agreement", "yours", "figures")]
            self.assertEqual(places, sorted(places))
            for text in ("boxes 2.5\u00a0%", "1 known deviation", "2 cases</a> compare your results", "seiche score CASE --data"):
                self.assertIn(text, page)
            self.assertIn("wave_sph.seiche-claim-d", (out / "deviations.html").read_text(encoding="utf-8"))
            self.assertIn(">Validation · dam break<", (out / "cases/riemann.html").read_text(encoding="utf-8"))

    def test_a_problem_shows_the_stored_scores_of_its_cases_and_its_own_films(self):
        def filmed(name):
            return record(name, group="dam_break", data=f"{name}.h5", figures=[figure("film", title=f"Film of {name}", drawing="film")])

        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "evidence").mkdir()
            for name in ("collapse_gauss", "dam_break_sph"):
                write_arrays(pathlib.Path(folder, "evidence", f"{name}.h5"), {"film": [[("a", "computed", "line", [0, 1], [0, 1])]]})
            out = reported(folder, filmed("collapse_gauss"), filmed("dam_break_sph"))
            page = (out / "problems/column-collapse.html").read_text(encoding="utf-8")
        self.assertIn("Film of collapse_gauss", page)
        self.assertNotIn("Film of dam_break_sph", page)
        with open(league.STORED, encoding="utf-8", newline="") as file:
            wanted = {(f"{row['solver']} {row['version']}", pages.percent(float(row["error"])), row["quantity"])
                      for row in csv.DictReader(file)
                      if row["case"] == "dam_break_sph" and not row["solver"].startswith("seiche")}
        table = page.partition('id="solvers"')[2].partition("</table>")[0]
        shown = {(by.partition(" (")[0], error.partition(" in ")[0], error.partition(" in ")[2]) for by, error in
                 re.findall(r"<td>([^<]*)</td><td class=\"r\">([^<]*)</td><td", table)}
        self.assertTrue(wanted)
        self.assertEqual(shown, wanted)


class Costs(unittest.TestCase):
    def ladder(self, errors, times=None):
        columns = ["size", "h"] + (["time"] if times else [])
        rows = [[0.1 / 2**k, error] + ([times[k]] if times else []) for k, error in enumerate(errors)]
        return [{"id": costs.TABLE, "title": "t", "caption": "c", "atlas": [], "rows": rows,
                 "columns": [{"name": name, "unit": ""} for name in columns]}]

    def of(self, *raw):
        return costs.survey([records.Record(f"{k}.json", one) for k, one in enumerate(raw)])

    def test_errors_stand_against_times_and_a_single_run_is_a_point(self):
        found = self.of(record("wave", measurements={"h_relative_l2": 0.3}),
                        record("wave", solver="boxes", tables=self.ladder([0.4, 0.2, 0.1], [1.0, 4.0, 16.0])),
                        record("wave", solver="mute", tables=self.ladder([0.4, 0.2, 0.1])))
        self.assertEqual((found.quantity, found.cost), ("h", "time [s]"))
        self.assertEqual([(c.solver, c.points) for c in found.curves],
                         [("seiche", [(1.5, 0.3)]), ("boxes", [(1.0, 0.4), (4.0, 0.2), (16.0, 0.1)])])
        drawn = str(costs.figure(found))
        self.assertEqual((drawn.count("<circle"), drawn.count("stroke-width=\"1.4\"")), (4, 1))

    def test_without_times_the_cells_are_the_cost(self):
        found = self.of(record("wave", solver="boxes", tables=self.ladder([0.4, 0.0, None])))
        self.assertEqual((found.cost, found.curves[0].points), ("cell [m]", [(0.1, 0.4)]))
        costs.figure(found)     # one point has no range

    def test_nothing_is_made_of_what_is_no_ladder(self):
        broken = self.ladder([0.4, 0.2])
        broken[0]["rows"][0].pop()
        self.assertIsNone(self.of(record("wave"), record("wave", solver="boxes", tables=broken)))

    def test_names_are_escaped(self):
        found = self.of(record("wave", solver="boxes", tables=self.ladder([0.4, 0.2, 0.1])))
        found.curves[0].solver = found.quantity = HOSTILE
        self.assertNotIn("<script>", str(costs.figure(found)))

    def test_the_page_of_a_contest_shows_them(self):
        with tempfile.TemporaryDirectory() as folder:
            scored = record("wave", solver="boxes", wall_time=16.0, tables=self.ladder([0.4, 0.2, 0.1], [1.0, 4.0, 16.0]),
                            measurements={"cell_size": 0.025, "threads": 3.0, "ladder_order_h": 1.25},
                            standing={"settings": "", "errors": {"h": 0.1}})
            out = reported(folder, record("wave"), scored)
            for name in ("cases/wave.html", "league.html"):
                page = (out / name).read_text(encoding="utf-8")
                self.assertEqual(Page(page).faults, [])
                for text in ("16.0 s", 'title="0.025"', 'title="3.0"', 'title="1.25"', "Error against cost"):
                    self.assertIn(text, page, name)


if __name__ == "__main__":
    unittest.main()
