"""`seiche score` as somebody with a solver of their own meets it: templates, CSV and HDF5, units, mistakes."""

import json
import pathlib
import resource
import time
import unittest

import h5py
import numpy as np

from submitting import SEICHE, SOURCE, Scoring, printed, rows_of, seiche


class Score(Scoring):
    def riemann(self):
        """x, h, u of the exact solution of the case's standard problem."""
        _, rows = rows_of(printed("score", "riemann", "--template"))
        points = [word for row in rows for word in ("--at", f"x={row[0]},t=6")]
        names, values = rows_of(printed("exact", "riemann", "--set", "jump=20", "--set", "right_depth=0.1", *points))
        names = [name.split("[")[0].strip() for name in names]
        columns = {name: np.array([float(row[k]) for row in values]) for k, name in enumerate(names)}
        depth = columns.get("h", columns.get("depth"))
        velocity = columns.get("u", columns.get("velocity"))
        return columns["x"], depth, velocity

    # What is taken.

    def test_csv_and_hdf5_of_the_same_numbers_get_the_same_score(self):
        x, h, u = self.riemann()
        csv = self.write("x [m],h [m],u [m/s]\n" + "".join(f"{a!r},{b!r},{c!r}\n" for a, b, c in
                                                           zip(x.tolist(), h.tolist(), u.tolist())))
        h5 = self.hdf5(x=x, h=h, u=u, units={"x": "m", "h": "m", "u": "m/s"})
        self.accepted(self.score("riemann", "--data", csv, solver="csv"))
        self.accepted(self.score("riemann", "--data", h5, solver="hdf5"))
        first, second = self.record("riemann.csv"), self.record("riemann.hdf5")
        self.assertEqual(first["measurements"], second["measurements"])
        for name in ["h_relative_l1", "h_relative_l2", "h_relative_linf", "h_shift", "h_amplitude_ratio", "h_skill",
                     "h_coverage", "u_relative_l2", "front_position"]:
            self.assertIn(name, first["measurements"])
        self.assertLess(first["measurements"]["h_relative_linf"], 1e-12)
        self.assertAlmostEqual(first["measurements"]["h_skill"], 1, 12)
        import jsonschema

        jsonschema.validate(first, json.loads((SOURCE / "reports/schema/record.schema.json").read_text()))

    def test_content_decides_not_the_name(self):
        x, h, u = self.riemann()
        self.accepted(self.score("riemann", "--data", self.hdf5(name="mine.csv", x=x, h=h, u=u)))

    def test_blanks_part_a_unit_from_its_name_as_well(self):
        x, h, u = self.riemann()
        data = self.write("x [m] h [m] u [m/s]\n" + "".join(f"{a} {b} {c}\n" for a, b, c in zip(x, h, u)), "blanks.txt")
        self.accepted(self.score("riemann", "--data", data))
        template = seiche("score", "wall_run_up_exact", "--template").stdout
        _, [[run_up, *_]] = rows_of(seiche("exact", "wall_runup", "--set", "amplitude=0.3,depth=1").stdout)
        self.accepted(self.score("wall_run_up_exact", "--data", self.write(f"{template}{run_up}\n", "one.csv")))

    def test_a_unit_without_the_name_of_its_column_is_refused(self):
        data = self.write("[m]\n0.66\n", "unit.csv")
        self.refused(self.score("wall_run_up_exact", "--data", data), "[m]", "without the name")

    def test_columns_may_have_other_names(self):
        x, h, u = self.riemann()
        data = self.write("pos,depth,velocity,extra\n" + "".join(f"{a},{b},{c},7\n" for a, b, c in zip(x, h, u)))
        self.accepted(self.score("riemann", "--data", data, "--map", "pos=x,depth=h", "--map", "velocity=u"))
        nested = self.folder / "nested.h5"
        with h5py.File(nested, "w") as file:
            file["run/x"], file["run/depth"], file["run/u"] = x, h, u
            file["picture"] = np.zeros((3, 3))
        self.accepted(self.score("riemann", "--data", nested, "--map", "run/x=x,run/depth=h,run/u=u"))

    def test_several_parameters_in_one_option(self):
        template = seiche("score", "riemann", "--template", "--set", "particles=7,start=-1,time=1", "--set", "end=30").stdout
        _, rows = rows_of(template)
        self.assertEqual(len(rows), 7)
        self.assertAlmostEqual(float(rows[0][0]), -1 + 31 / 14)

    def test_other_line_ends_quotes_and_byte_order_mark(self):
        x, h, u = self.riemann()
        for end in ("\n", "\r\n", "\r"):
            text = "\ufeff# mine" + end + '"x [m]","h [m]","u [m/s]"' + end
            text += "".join(f"{a},{b},+{c}{end}" for a, b, c in zip(x, h, np.abs(u)))
            self.accepted(self.score("riemann", "--data", self.write(text)))

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
                                                          "h-shift": "pass", "h-skill": "pass"})
        self.assertIn("not judged", alone.stdout)
        self.accepted(self.score("thacker", "--data", gauges, "--table", "gauges", solver="alone"))
        self.assertEqual([left["id"] for left in self.record("thacker.alone")["left_out"]],
                         ["left-largest_error", "right-largest_error"])
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
                ("x,h\n1,1\n2,1\n", ["column u is missing"]),
                ("x,h,u\n1,1,zero\n", ["line 2", "column u", "'zero'"]),
                ("x,h,u\n1,1,\n", ["line 2", "column u", "''"]),
                ("x,h,u\n1,1\n", ["line 2", "column u"]),
                ("x,h,u\n1,1,0,0\n", ["line 2", "4 entries"]),
                ("x,h,u\n1,nan,0\n2,1,0\n", ["line 2", "column h", "nan"]),
                ("# mine\nx,h,u\n1,1,0\n2,inf,0\n", ["line 4", "column h", "inf"]),
                ("x,h,u\n1,1e999,0\n", ["line 2", "column h", "1e999"]),
                ("x,h,u\n2,1,0\n1,1,0\n", ["line 3", "column x", "1 follows 2", "increase"]),
                ("x,h,u\n\n1,1,0\n# again\n1,1,0\n", ["line 5", "column x", "increase"]),
                ("x [m],h [cm],u [m/s]\n" + good, ["column h", "unit cm", "must be m"]),
                ("x [m],h [m],u [km/h]\n" + good, ["column u", "unit km/h", "must be m/s"]),
                ("x,h [m,u\n" + good, ["line 1", "column h", "bracket"]),
                ("x,h,h,u\n" + good, ["line 1", "column h", "twice"]),
                ("x,,u\n" + good, ["line 1", "column 2 has no name"]),
                ("# x,h,u\n1,1,0\n2,1,0\n", ["line 2", "column '1'", "name the columns"]),
                ("x,h,u\n1,1,0\n", ["rows", "at least two"]),
                ("x;h;u\n1;1;0\n", ["rows", "at least two"]),
                ("x;h;u\n0,5;1;0\n1;1;0\n", ["line 2", "column x", "decimal comma", "points"]),
                ("0 1 0\n1 1 0\n", ["line 1", "--columns"]),
                ("x h u\n0 1 0\n1 1\n", ["line 3", "2 entries", "must be 3"]),
                ("x,h,u\n-7,1,0\n-6,1,0\n", ["column x", "[-7, -6]"]),
                ("", ["no rows"]),
                ("# only a comment\n", ["no rows"]),
                ("x,h,u\n", ["no rows"]),
                (b"\x7fELF\x02\x01\x01\x00" + bytes(range(256)), ["line 1", "binary"]),
                (b"\x89PNG\r\n\x1a\n" + bytes(100), ["binary"]),
                (",".join(f"c{k}" for k in range(5000)) + "\n", ["line 1", "1000 columns"])]:
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
                ({"x": x, "h": h}, None, ["column u is missing", "h, x"]),
                ({"x": x, "h": h[:-1], "u": u}, None, ["column", "50", "49"]),
                ({"x": x, "h": wrong, "u": u}, None, ["column h", "element 3", "nan"]),
                ({"x": x[::-1], "h": h, "u": u}, None, ["element 1", "column x", "increase"]),
                ({"x": x, "h": h.reshape(5, 10), "u": u}, None, ["column h", "2 dimensions"]),
                ({"x": x, "h": np.array([b"one"] * 50), "u": u}, None, ["column h", "not numbers"]),
                ({"x": x, "h": h, "u": u}, {"h": "cm"}, ["column h", "unit cm", "must be m"]),
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
        for words, expected in [(["--map", "depth"], ["--map", "name=value"]),
                                (["--map", "depth=H"], ["--map", "H", "energy, h, momentum, t, u, volume, x"]),
                                (["--map", "a=h,b=h"], ["--map", "h", "twice"]),
                                (["--map", "depth=h"], ["column depth is missing"]),
                                (["--uncertainty", "h=-1"], ["h = -1", "at least 0"]),
                                (["--uncertainty", "h=one"], ["h = one"]),
                                (["--uncertainty", "q=1"], ["--uncertainty", "q"]),
                                (["--set", "time=6,nothing=1"], ["nothing"]),
                                (["--set", "time=1000"], ["time = 1000"]),
                                (["--solver", "seiche"], ["--solver"]),
                                (["--solver", "../x"], ["--solver"])]:
            with self.subTest(words=words):
                self.refused(seiche("score", "riemann", "--data", data, *words, "--out", self.out), *expected)
        self.refused(seiche("score", "riemann", "--out", self.out), "--data")
        self.refused(seiche("score", "thacker", "--template"), "--table", "shorelines, gauges")
        self.refused(seiche("score", "shock_formation", "--data", data), "shock_formation")


if __name__ == "__main__":
    unittest.main()
