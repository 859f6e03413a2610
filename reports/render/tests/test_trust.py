"""What the overview says first: how far models are trusted, from the records; and what costs are set beside errors.

    /usr/bin/python3 reports/render/tests/test_trust.py
"""
import json
import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2]))

from render import costs, league, records, side_by_side, trust  # noqa: E402
from render.tests.test_report import HOSTILE, Page, claim, record, render  # noqa: E402
from render.tests.test_side_by_side import row, table  # noqa: E402


def compared(name, measured, expected, limit, **changes):
    return claim(name, measured=measured, expected=expected, unit=changes.pop("unit", "m"),
                 criterion={"kind": "bound", "limit": limit, "reason": "r", "relative": False}, **changes)


def loaded(*raw):
    return records.cases([records.Record(f"{one['case']}-{k}.json", one) for k, one in enumerate(raw)])


def number(value, unit="m"):
    return {"value": value, "unit": unit, "default": value, "meaning": "a meaning"}


class Trusted(unittest.TestCase):
    def survey(self, *raw):
        cases = loaded(*raw)
        return {(group, one.model): one for group, all_of in
                trust.survey(cases, side_by_side.survey(cases, {})["problems"], league.survey(cases)) for one in all_of}

    def test_a_model_is_told_by_the_case_s_name_or_by_the_list(self):
        models = trust.Models()
        self.assertEqual(models.of_case("a_wave_mesh_figures"), "Lagrangian mesh")
        self.assertEqual(models.of_case("breakwater"), "Lagrangian mesh")
        self.assertEqual(models.of_case("wave_attenuation"), "")
        self.assertIsNone(models.of_case("nobody_told"))
        self.assertEqual(models.of_claim("variable-mass-height"), "variable mass")
        self.assertEqual(models.of_claim("height"), "")

    def test_ranges_errors_times_and_limits_are_those_of_all_records_of_a_model(self):
        first = record("wave_sph", wall_time=2.0, parameters={"alpha": number(1, "1"), "height": number(0.1)},
                       claims=[compared("a", 1.01, 1.0, 0.1), compared("b", 2.4, 2.0, 0.45), claim("kept", "roundoff")])
        second = record("bore_sph", wall_time=8.0, parameters={"alpha": number(3, "1"), "on": number(True, "1")},
                        claims=[compared("c", 0.97, 1.0, 0.1),
                                compared("d", 9.0, 1.0, 0.1, verdict="fail", declared="fail", declared_reason="known")])
        one = self.survey(first, second)["bore", "SPH"]
        self.assertEqual([(t.name, t.least, t.most) for t in one.tried], [("alpha", 1, 3), ("height", 0.1, 0.1)])
        self.assertEqual([round(c.error, 9) for c in one.comparisons], [0.2, 0.03, 0.01])
        self.assertAlmostEqual(one.typical, 0.03)
        self.assertEqual((one.kept, one.seconds), (1, (2.0, 8.0)))
        self.assertEqual([limit.id for _, limit in one.limits], ["d"])

    def test_what_bounds_counts_or_covers_is_no_error(self):
        for made in (compared("a", 0.5, 0.0, 1.0, unit="1"), compared("a", 1.2, 1.0, 0.25), compared("a", 3.0, 3.0, 0.0),
                     compared("a", 0.1, 0.0, 0.2), compared("a", None, 1.0, 0.1), compared("x-coverage", 1.0, 1.0, 0.1)):
            one = self.survey(record("wave_sph", claims=[made]))["bore", "SPH"]
            self.assertEqual(one.comparisons, [], made["id"])
        self.assertEqual(trust.share(records.Claim(compared("a", -0.04, 0.0, 0.2, unit="1"))), 0.04)

    def test_side_by_side_gives_size_time_and_where_a_model_breaks(self):
        rows = [row("Lagrangian mesh", size=0.2, error=0.5), row("Lagrangian mesh", size=0.1, **{"broke by": "it folds"})]
        found = self.survey(record("drop_models", group="drop", tables=table(rows),
                                   claims=[compared("mesh-order", 1.0, 1.0, 0.1), compared("all", 1.0, 1.0, 0.1)]))
        self.assertEqual(list(found), [("drop", "Lagrangian mesh")])
        one = found["drop", "Lagrangian mesh"]
        self.assertEqual((one.tried[0].least, one.tried[0].most, one.seconds), (0.1, 0.2, (0.25, 0.25)))
        self.assertEqual([len(one.broken), [c.id for _, c in one.claims]], [1, ["mesh-order"]])

    def test_the_page_has_all_of_it_before_declared_failures_and_escapes(self):
        with tempfile.TemporaryDirectory() as folder:
            evidence, out = pathlib.Path(folder, "evidence"), pathlib.Path(folder, "report")
            evidence.mkdir()
            known = compared("d", 9.0, 1.0, 0.1, verdict="fail", declared="fail", declared_reason="known")
            for made in (record("wave_sph", parameters={HOSTILE: number(1, HOSTILE)}, claims=[known]),
                         record("riemann", solver="boxes", measurements={"h_relative_l1": 0.025},
                                claims=[compared("a", 1.01, 1.0, 0.1)])):
                (evidence / f"{made['case']}.{made['solver']}.json").write_text(json.dumps(made))
            self.assertEqual(render(evidence, out, "--scorable", f"bore/riemann,bore/{HOSTILE}")[0], 0)
            page = (out / "index.html").read_text(encoding="utf-8")
            self.assertEqual(Page(page).faults, [])
            self.assertNotIn("<script>alert", page)
            places = [page.index(f'id="{name}"') for name in ("trust", "yours", "declared", "cases")]
            self.assertEqual(places, sorted(places))
            trusted, yours = page[places[0]:places[1]], page[places[1]:places[2]]
            for text in ("SPH", "boxes", "0.025", "relative L1 error of h", "wave_sph.seiche-claim-d"):
                self.assertIn(text, trusted)
            for text in ("2 cases score others", 'href="cases/riemann.html"', "seiche score CASE --data"):
                self.assertIn(text, yours)
            self.assertIn("<details><summary><h2>1 failure declared beforehand</h2>", page)


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
            evidence, out = pathlib.Path(folder, "evidence"), pathlib.Path(folder, "report")
            evidence.mkdir()
            scored = record("wave", solver="boxes", wall_time=16.0, tables=self.ladder([0.4, 0.2, 0.1], [1.0, 4.0, 16.0]),
                            measurements={"cell_size": 0.025, "threads": 3.0, "ladder_order_h": 1.25, "h_relative_l2": 0.1})
            for made in (record("wave"), scored):
                (evidence / f"wave.{made['solver']}.json").write_text(json.dumps(made))
            self.assertEqual(render(evidence, out)[0], 0)
            for name in ("cases/wave.html", "league.html"):
                page = (out / name).read_text(encoding="utf-8")
                self.assertEqual(Page(page).faults, [])
                for text in ("16.0 s", 'title="0.025"', 'title="3.0"', 'title="1.25"', "Error against cost"):
                    self.assertIn(text, page, name)


if __name__ == "__main__":
    unittest.main()
