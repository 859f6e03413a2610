"""`seiche score` as somebody with a solver of their own meets it: templates, CSV and HDF5, units, mistakes."""

import csv
import json
import math
import pathlib
import re
import resource
import shutil
import time
import unittest

import numpy as np

from sealing import sealed
from submitting import SEICHE, SOURCE, Scoring, rows_of, seiche


def rows(columns):
    return zip(*(values.tolist() for values in columns.values()))


def denser(columns, group):
    """Points in the midst between those of each group, on the straight lines."""
    ends = np.ones(len(next(iter(columns.values()))) - 1)
    if group:
        ends = np.diff(columns[group]) == 0
    between = np.flatnonzero(ends) + 1
    return {name: np.insert(values, between, ((values[1:] + values[:-1]) / 2)[between - 1])
            for name, values in columns.items()}


class Metamorphic(Scoring):
    """The same result in other words gets the same score; with L times the lengths and T times the times, the same
    claims.

    Results are the references of several cases, spoilt by per cents, so that no measure is zero and some claims fail.
    """

    # Table, the column of its groups, words that go with it; and settings for other units with L and T, factors of two:
    # no number loses a bit by them.
    CASES = {"riemann": ("profile", None, ["--dx", "1"],
                         ["left_depth=4,right_depth=0.4,end=200,jump=80,time=12"], 4, 2),
             "moving_bore": ("profile", None, ["--dx", "1"], ["gravity=39.24,time_step=0.04"], 1, 0.5),
             "standing_wave": ("wall", None, [], [f"amplitude=0.2,depth=4,wavelength={8 * math.pi!r}"], 4, 2),
             "thacker": ("gauges", "x", ["--uncertainty", "h=1%,t=0.1%"], ["radius=4,depth=2,displacement=2"], 4, 2),
             "wave_kinematics": ("velocities", "x", [], ["height=1.2,wavelength=32,depth=4,way=88"], 4, 2),
             "mach_reflection_theory": ("numbers", None, [], [], 1, 1)}
    CELLS = ("riemann", "moving_bore")
    COUNTS = ("points", "fewest_points", "front_width")     # of points, whatever they say
    # What one is told in other words by, and the largest difference that it may make, relative to the number. Points on
    # the straight lines between others leave curves as they are, to the rounding of 1 in the correlation by which a shift
    # is found. Profiles of shallow water are means of cells, one to a point: their sums change by what the half cells at
    # a jump hold.
    RELATIONS = {"again": 0, "columns in another order": 0, "rows of several gauges in another order": 0,
                 "on twice as many points": 1e-8, "HDF5": 0, "HDF5 with the name of CSV": 0,
                 "HDF5 in groups with other names": 0, "other names": 0, "blanks, and a unit after its name": 0,
                 "line ends, quotes, signs and a byte order mark": 0, "four equal runs": 0, "beside another solver": 0}

    def result(self, case, *words):
        numbers = {"a_w_over_a_i": 2.1, "a_r_over_a_i": 0.6, "psi_r": 31.0, "stem_angle": 3.2, "growth": 0.02}
        columns = ({name: np.array([value]) for name, value in numbers.items()} if case == "mach_reflection_theory"
                   else self.reference(case, self.CASES[case][0], *words))
        return {name: values if name in "xyzt" else values * (1.01 + 0.02 * np.cos(np.arange(len(values))))
                for name, values in columns.items()}

    def told(self, relation, columns, group):
        """The words by which a result is given in that way."""
        names, body = list(columns), list(rows(columns))
        if relation == "columns in another order":
            return ["--data", self.table({name: columns[name] for name in reversed(names)})]
        if relation == "rows of several gauges in another order":
            order = np.lexsort([-columns[group], columns[names[1]]]) if group else slice(None)
            return ["--data", self.table({name: values[order] for name, values in columns.items()})]
        if relation == "on twice as many points":
            return ["--data", self.table(denser(columns, group) if len(body) > 1 else columns)]
        if relation.startswith("HDF5"):
            other = relation.endswith("other names")
            data = self.hdf5("mine.csv" if relation.endswith("CSV") else "mine.h5", picture=np.zeros((3, 3)),
                             **{f"run/my_{name}" if other else name: values for name, values in columns.items()})
            return ["--data", data, *(["--map", ",".join(f"run/my_{name}={name}" for name in names)] if other else [])]
        if relation == "other names":
            data = self.table({**{f"my_{name}": values for name, values in columns.items()}, "extra": np.arange(len(body))})
            return ["--data", data, *(word for name in names for word in ("--map", f"my_{name}={name}"))]
        if relation.startswith("blanks"):
            units = {"x": "[m]", "h": "[m]", "eta": "[m]", "t": "[s]", "u": "[m/s]"}
            return ["--data", self.write(" ".join(f'"{name}" {units.get(name, "")}' for name in names) + "\n"
                                         + "".join(" ".join(map(repr, row)) + "\n" for row in body), "mine.txt")]
        if relation.startswith("line ends"):
            end = {1: "\n", 2: "\r"}.get(len(names), "\r\n")
            text = "\ufeff# mine" + end + ",".join(f'"{name}"' for name in names) + end
            return ["--data", self.write(text + "".join(",".join(f"{value:+}" for value in row) + end for row in body))]
        if relation == "four equal runs":
            return [*(word for _ in range(4) for word in ("--data", self.table(columns))), "--repeats", "4"]
        if relation == "beside another solver":
            self.score(self.case, "--data", self.table(columns), *self.words, solver="other")
        return ["--data", self.table(columns)]

    def judged(self, *words):
        """Numbers of the score by name, and the verdicts."""
        self.assertIn(self.score(self.case, *words, *self.words).returncode, (0, 1))
        record = self.record(f"{self.case}.mine")
        numbers = {name: value for name, value in record["measurements"].items()
                   if not name.startswith("repeats") and name not in self.COUNTS}
        for claim in record["claims"]:
            for key in ("measured", "uncertainty", "expected"):
                numbers[claim["id"], key, claim["unit"]] = claim[key]
            numbers[claim["id"], "limit", claim["unit"]] = claim["criterion"]["limit"]
        return numbers, self.verdicts(f"{self.case}.mine")

    def alike(self, got, expected, allowed):
        self.assertEqual(got[1], expected[1])
        self.assertEqual(set(got[0]), set(expected[0]))
        def size(name, number):
            """What is allowed is a share of: a number, or the limit of what a claim measured."""
            limit = expected[0][(name[0], "limit", name[2])] if allowed and name[1:2] == ("measured",) else None
            return max(abs(number), limit or 0)

        far = {name: (got[0][name], number) for name, number in expected[0].items()
               if got[0][name] != number and (None in (number, got[0][name])
                                              or abs(got[0][name] - number) > allowed * size(name, number))}
        self.assertEqual(far, {})

    def test_the_same_result_in_other_words_gets_the_same_score(self):
        for self.case, (table, group, words, settings, length, time) in self.CASES.items():
            self.words = [*words, "--table", table]
            columns = self.result(self.case)
            first = self.judged("--data", self.table(columns))
            self.assertNotIn(0, [value for name, value in first[0].items() if "relative_" in name])
            for relation, allowed in self.RELATIONS.items():
                with self.subTest(self.case, relation=relation):
                    if "twice" in relation and self.case in self.CELLS:
                        allowed = 0.1
                    self.alike(self.judged(*self.told(relation, columns, group)), first, allowed)
            if not settings:
                continue
            with self.subTest(self.case, relation="other units"):
                factors = {"m": length, "s": time, "m/s": length / time, "m^2": length**2, "m^2/s": length**2 / time,
                           "m^3/s": length**3 / time, "1": 1}
                self.words = ["--set", *settings, "--table", table]
                for option, value in zip(words[::2], words[1::2]):
                    self.words += [option, value if option != "--dx" else repr(float(value) * length)]
                numbers, verdicts = self.judged("--data", self.table(self.result(self.case, "--set", *settings)))
                scaled = {name: value and value / factors[name[2]] for name, value in numbers.items()
                          if isinstance(name, tuple)}
                self.alike((scaled, verdicts), ({name: first[0][name] for name in scaled}, first[1]), 0)

    def test_comparison_is_of_two_and_of_the_same_records(self):
        data = {solver: self.table(self.reference("riemann", "profile"), f"{solver}.csv") for solver in "ab"}
        worse = self.reference("riemann", "profile")
        data["b"] = self.table({**worse, "h": 1.02 * worse["h"]}, "b.csv")
        folders = {solver: self.folder / solver for solver in "ab"}
        for solver, folder in folders.items():
            seiche("score", "riemann", "--data", data[solver], "--solver", "mine", "--out", folder)

        def compared(before, after):
            ended = seiche("compare", before, after)
            return ended.returncode, ended.stdout.splitlines()[1:]

        for folder in folders.values():     # a result and itself
            self.assertEqual(compared(folder, folder), (0, ["nothing got worse"]))
        status, there = compared(folders["a"], folders["b"])
        self.assertEqual((status, compared(folders["b"], folders["a"])[0]), (1, 0))
        turned = [re.sub(r"(\S+) -> (\S+)$", r"\2 -> \1", re.sub(", worse|, not as declared", "", line)) for line in there]
        self.assertEqual(compared(folders["b"], folders["a"])[1][:-1], turned[:-1])
        # Solvers beside each other, whoever came first.
        for order in ("ab", "ba"):
            for solver in order:
                seiche("score", "riemann", "--data", data[solver], "--solver", solver, "--out", self.folder / order)
        self.assertEqual(*(seiche("compare", self.folder / order).stdout for order in ("ab", "ba")))
        # Quick and quick beside full: what is the same is not touched by what is new.
        record = json.loads((folders["a"] / "riemann.mine.json").read_text())
        both = self.folder / "both"
        shutil.copytree(folders["a"], both)
        (both / "riemann@full.mine.json").write_text(sealed({**record, "tier": "full"}))
        status, lines = compared(folders["a"], both)
        self.assertEqual((status, [line.split()[:2] for line in lines]), (0, [["riemann@full.mine", "new,"], ["nothing", "got"]]))
        status, lines = compared(both, folders["a"])
        self.assertEqual((status, [line.split()[:2] for line in lines]),
                         (1, [["riemann@full.mine", "no"], ["something", "got"]]))


class Score(Scoring):
    def riemann(self):
        """x, h, u of the exact solution of the case's standard problem."""
        return tuple(self.reference("riemann", "profile").values())

    def test_an_error_is_ranked_among_the_stored_solvers(self):
        with open(SOURCE / "reports/record/solvers.csv") as file:
            stored = [row["solver"] for row in csv.DictReader(file)
                      if (row["case"], row["settings"], row["quantity"]) == ("riemann", "", "h")]
        self.assertGreaterEqual(len(stored), 4)
        columns = self.reference("riemann", "profile")
        for factor, solver, words, smaller in ((1, "mine", (), f"smaller than {len(stored)} of {len(stored)}"),
                                               (2, "mine", (), f"smaller than 0 of {len(stored)}"),
                                               (1, stored[0], (), f"smaller than {len(stored) - 1} of {len(stored) - 1}"),
                                               (1, "mine", ("--set", "gravity=9"), None)):
            with self.subTest(factor=factor, solver=solver, words=words):
                said = self.score("riemann", "--data", self.table({**columns, "h": factor * columns["h"]}), *words,
                                  solver=solver).stdout.splitlines()
                rank = [line for line in said if line.startswith("rank: h:")]
                self.assertEqual([smaller in line for line in rank], [True] if smaller else [])

    # What is taken.

    def test_measures_of_an_exact_result_and_their_record(self):
        x, h, u = self.riemann()
        self.accepted(self.score("riemann", "--data", self.hdf5(x=x, h=h, u=u, units={"x": "m", "h": "m", "u": "m/s"})))
        record = self.record("riemann.mine")
        for name in ["h_relative_l1", "h_relative_l2", "h_relative_linf", "h_shift", "h_amplitude_ratio", "h_skill",
                     "h_coverage", "u_relative_l2", "front_position"]:
            self.assertIn(name, record["measurements"])
        self.assertLess(record["measurements"]["h_relative_linf"], 1e-12)
        self.assertEqual(record["standing"], {"settings": "", "errors": {
            name: record["measurements"][f"{name}_relative_l1"] for name in "hu"}})
        self.assertAlmostEqual(record["measurements"]["h_skill"], 1, 12)
        import jsonschema

        jsonschema.validate(record, json.loads((SOURCE / "reports/schema/record.schema.json").read_text()))

    def test_a_unit_without_the_name_of_its_column_is_refused(self):
        data = self.write("[m]\n0.66\n", "unit.csv")
        self.refused(self.score("wall_run_up_exact", "--data", data), "[m]", "without the name")

    def test_several_parameters_in_one_option(self):
        template = seiche("score", "riemann", "--template", "--set", "particles=7,start=-1,time=1", "--set", "end=30").stdout
        _, rows = rows_of(template)
        self.assertEqual(len(rows), 7)
        self.assertAlmostEqual(float(rows[0][0]), -1 + 31 / 14)

    def test_a_result_on_other_points_is_interpolated_and_nothing_is_extrapolated(self):
        x, h, u = self.riemann()
        half = slice(10, 41)
        data = self.write("x,h,u\n" + "".join(f"{a},{b},{c}\n" for a, b, c in zip(x[half], h[half], u[half])))
        self.accepted(self.score("riemann", "--data", data), status=1)
        record = self.record("riemann.mine")
        self.assertAlmostEqual(record["measurements"]["h_coverage"], 31 / 50)
        verdicts = {claim["id"]: claim["verdict"] for claim in record["claims"]}
        self.assertEqual(verdicts["profile-coverage"], "fail")

    def test_gauge_series_and_shorelines(self):
        x, t, h = self.gauges()
        gauges = self.write("x,t,h\n" + "".join(f"{a!r},{b!r},{c!r}\n" for a, b, c in
                                                zip(x.tolist(), t.tolist(), h.tolist())), "gauges.csv")
        times = t[x == x[0]]
        shift = -0.5 * np.cos(np.sqrt(9.81) * times)
        shorelines = self.hdf5(name="shorelines.h5", t=times, left=0.875 + shift, right=2.875 + shift)
        self.accepted(self.score("thacker", "--data", gauges, "--data", shorelines))
        measured = self.record("thacker.mine")["measurements"]
        self.assertLess(measured["left_largest_error"], 1e-12)
        self.assertLess(max(abs(value) for name, value in measured.items() if name.startswith("h_shift")), 1e-9)
        # The gauges alone may be judged where that is said; without a word what is missing fails.
        alone = self.score("thacker", "--data", gauges, solver="alone")
        self.accepted(alone, status=1)
        self.assertEqual(self.verdicts("thacker.alone"), {"shorelines-coverage": "fail", "gauges-coverage": "pass",
                                                          "h-shift": "pass", "h-relative_l2": "pass"})
        self.assertIn("not scored", alone.stdout)
        self.accepted(self.score("thacker", "--data", gauges, "--table", "gauges", solver="alone"))
        self.assertEqual([left["id"] for left in self.record("thacker.alone")["left_out"]],
                         ["left-relative_l2", "right-relative_l2"])
        # One that is a tenth of a period late and too low must fail.
        x, t, h = self.gauges(late=0.2, factor=0.7)
        late = self.write("x,t,h\n" + "".join(f"{a!r},{b!r},{c!r}\n" for a, b, c in
                                              zip(x.tolist(), t.tolist(), h.tolist())), "late.csv")
        self.accepted(self.score("thacker", "--data", late, solver="late"), status=1)
        record = self.record("thacker.late")
        self.assertAlmostEqual(record["measurements"]["h_shift_x_1.875"], 0.2, 2)
        self.assertAlmostEqual(record["measurements"]["h_amplitude_ratio_x_1.875"], 0.7, 2)
        self.assertEqual({claim["id"]: claim["verdict"] for claim in record["claims"]}["h-shift"], "fail")

    def test_stated_uncertainty_is_used_and_cannot_buy_a_pass(self):
        x, t, h = self.gauges(late=0.05)
        data = self.write("x,t,h\n" + "".join(f"{a!r},{b!r},{c!r}\n" for a, b, c in
                                              zip(x.tolist(), t.tolist(), h.tolist())))
        self.accepted(self.score("thacker", "--data", data), status=1)
        self.accepted(self.score("thacker", "--data", data, "--uncertainty", "t=0.05"), status=1)
        claim = next(c for c in self.record("thacker.mine")["claims"] if c["id"] == "h-shift")
        self.assertEqual((claim["verdict"], claim["uncertainty"]), ("inconclusive", 0.1))

    def test_report_and_compare_show_solvers_side_by_side(self):
        x, h, u = self.riemann()
        for solver, factor in (("good", 1.0), ("high", 2.0)):
            data = self.write("x,h,u\n" + "".join(f"{a},{b},{c}\n" for a, b, c in zip(x, factor * h, u)))
            cost = ("--dx", 0.5, "--seconds", 73, "--threads", 4) if solver == "good" else ()
            self.score("riemann", "--data", data, *cost, solver=solver)
        table = seiche("compare", self.out)
        costs = {line.split("  ")[1]: line.split()[-2:] for line in table.stdout.splitlines() if "cost: " in line}
        self.assertEqual(costs, {"cost: time [s]": ["73", "-"], "cost: cell [m]": ["0.5", "-"],
                                 "cost: threads": ["4", "-"]})
        self.assertEqual(table.returncode, 1, table.stdout)
        header = next(line for line in table.stdout.splitlines() if "good" in line)
        self.assertIn("high", header)
        report = seiche("report", self.out)
        self.assertEqual(report.returncode, 0, report.stdout + report.stderr)
        page = (self.out / "report" / "cases" / "riemann.html").read_text()
        self.assertIn("good", page)
        self.assertIn("high", page)

    # What is refused.

    def test_malformed_csv_is_refused_with_line_and_column(self):
        good = "1,1,0\n2,1,0\n"
        for text, words in [
                ("x,v\n1,1\n2,1\n", ["column h is missing"]),
                ("x,h,u\n1,1,zero\n", ["line 2", "column u", "'zero'"]),
                ("x,h,u\n1,1,\n2,1,0\n3,1,0\n", ["line 2", "column u", "no value"]),
                ("x,h,u\n1,1\n", ["line 2", "column u"]),
                ("x,h,u\n1,1,0,0\n", ["line 2", "4 entries"]),
                ("x,h,u\n1,nan,0\n2,1,0\n", ["line 2", "column h", "no value", "depth"]),
                ("x,h,u\nnan,1,0\n2,1,0\n", ["line 2", "column x", "no value"]),
                ("# mine\nx,h,u\n1,1,0\n2,inf,0\n", ["line 4", "column h", "inf"]),
                ("x,h,u\n1,1e999,0\n", ["line 2", "column h", "1e999"]),
                ("x,h,u\n\n1,1,0\n# again\n1,1,0\n", ["1 rows", "at least two"]),
                ("x,t,h,u\n1,0,1,0\n2,0,1,0\n1,1,1,0\n", ["line 4", "column x", "1 follows 2", "increase"]),
                ("x [m],h [s],u [m/s]\n" + good, ["column h", "unit s", "must be m"]),
                ("x [m],h [m],u [kg/h]\n" + good, ["column u", "unit kg/h", "must be m/s"]),
                ("x,h [m,u\n" + good, ["line 1", "column h", "bracket"]),
                ("x,h,h\n" + good, ["line 1", "column h", "twice"]),
                ("x,h,h,u\n" + good, ["line 2", "3 entries", "must be 4"]),
                ("x,,v\n" + good, ["column h is missing", "column 2"]),
                ("1,1,0\n2,1,0\n", ["line 1", "no names", "--columns"]),
                ("x,h,u\n1,1,0\n", ["rows", "at least two"]),
                ("x;h;u\n1;1;0\n", ["rows", "at least two"]),
                ("0 1 0\n1 1 0\n", ["line 1", "--columns"]),
                ("x h u\n0 1 0\n1 1\n", ["line 3", "2 entries", "must be 3"]),
                ("x,h,u\n-7,1,0\n-6,1,0\n", ["column x", "[-7, -6]"]),
                ("", ["no rows"]),
                ("# only a comment\n", ["no rows"]),
                ("x,h,u\n", ["no rows"]),
                (b"\x7fELF\x02\x01\x01\x00" + bytes(range(256)), ["line 1", "binary"]),
                (b"\x89PNG\r\n\x1a\n" + bytes(100), ["binary"]),
                (",".join("1" * 5000) + "\n", ["line 1", "1000 columns"])]:
            with self.subTest(text=text[:40]):
                self.refused(self.score("riemann", "--data", self.write(text)), "mine.csv", *words)
        self.refused(self.score("riemann", "--data", self.folder), "is a folder without times")
        self.refused(self.score("riemann", "--data", self.folder / "none.csv"), "none.csv")

    def test_a_line_of_a_gigabyte_is_refused_at_once_and_in_little_memory(self):
        path = self.folder / "mine.csv"
        with open(path, "wb") as file:
            file.write(b"x,h,u\n1,1,0\n")
            file.write(b"1" * (1 << 22))
            file.truncate(1 << 30)  # the rest is a hole
        limit = lambda: resource.setrlimit(resource.RLIMIT_AS, (1 << 29, 1 << 29))
        sanitized = b"__asan" in pathlib.Path(SEICHE).read_bytes()  # whose shadow memory is larger than any limit
        begin = time.monotonic()
        result = self.score("riemann", "--data", path) if sanitized else seiche(
            "score", "riemann", "--data", path, "--solver", "mine", "--out", self.out, preexec_fn=limit)
        self.refused(result, "mine.csv", "line 3", "1 MiB")
        self.assertLess(time.monotonic() - begin, 5)

    def test_malformed_hdf5_is_refused_in_one_line(self):
        x, h, u = self.riemann()
        wrong = h.copy()
        wrong[3] = np.nan
        for columns, units, words in [
                ({"x": x, "v": u}, None, ["column h is missing", "x, v"]),
                ({"x": x, "h": h[:-1], "u": u}, None, ["column", "50", "49"]),
                ({"x": x, "h": wrong, "u": u}, None, ["column h", "element 3", "no value"]),
                ({"x": x, "h": h.reshape(5, 10), "u": u}, None, ["column h", "2 dimensions"]),
                ({"x": x, "h": np.array([b"one"] * 50), "u": u}, None, ["column h", "not numbers"]),
                ({"x": x, "h": h, "u": u}, {"h": "s"}, ["column h", "unit s", "must be m"]),
                ({"x": x, "h": h, "u": u}, {"h": 3.0}, ["column h", "attribute unit", "not a text"]),
                ({"x": [], "h": [], "u": []}, None, ["column x", "no values"]),
                ({}, None, ["column x is missing", "none"])]:
            with self.subTest(columns=list(columns), words=words):
                self.refused(self.score("riemann", "--data", self.hdf5(units=units, **columns)), "mine.h5", *words)
        whole = self.hdf5(x=x, h=h, u=u).read_bytes()
        self.refused(self.score("riemann", "--data", self.write(whole[:1000], "cut.h5")), "cut.h5", "damaged")
        self.refused(self.score("riemann", "--data", self.write(whole[:8] + bytes(3000), "zero.h5")), "zero.h5",
                     "damaged")

    def test_wrong_options_are_refused(self):
        x, h, u = self.riemann()
        data = self.write("x,h,u\n" + "".join(f"{a},{b},{c}\n" for a, b, c in zip(x, h, u)))
        for words, expected in [(["--map", "depth=h"], ["column depth is missing"]),
                                (["--set", "time=6,nothing=1"], ["nothing"]),
                                (["--set", "time=1000"], ["time = 1000"])]:
            with self.subTest(words=words):
                self.refused(seiche("score", "riemann", "--data", data, *words, "--out", self.out), *expected)


if __name__ == "__main__":
    unittest.main()
