"""What is given of a result is judged, and what is missing is named: some gauges, quantities or instants, shorter records."""

import unittest

import numpy as np

from submitting import SOURCE, Scoring, rows_of, seiche


class Parts(Scoring):
    def test_some_quantities_are_judged_and_the_others_named(self):
        columns = self.reference("riemann", "profile")
        for keep, missing, not_scored in (("h", "u", "discharge"), ("u", "h", "depth")):
            for factor in (1, 1.05):
                part = {"x": columns["x"], keep: factor * columns[keep]}
                scored = self.score("riemann", "--data", self.table(part))
                self.accepted(scored, 1)
                self.assertIn(f"1 of 2 given, without {missing}", scored.stdout)
                verdicts = self.verdicts("riemann.mine")
                self.assertNotIn(not_scored, verdicts)
                failed = {name for name, verdict in verdicts.items() if verdict != "pass"}
                self.assertEqual("volume" in failed, keep == "h" and factor != 1)
                self.assertTrue(failed <= {"profile-quantities-given", "volume", "depth"}, failed)
        files = [self.table({"x": columns["x"], name: columns[name]}, f"{name}.csv") for name in "hu"]
        self.accepted(self.score("riemann", "--data", files[0], "--data", files[1]))
        for path in self.out.glob("*"):
            path.unlink()
        self.refused(self.score("riemann", "--data", files[0], "--map", "speed=u"), "column speed is missing")
        self.refused(self.score("riemann", "--data", self.table({"x": columns["x"]})), "column h is missing")

    def test_a_gauge_that_has_a_misfit_alone_is_judged_by_it(self):
        data = (SOURCE / "reference_data/briggs_1995_conical_island_a/table.csv").read_text().splitlines()
        for factor, verdict in ((1, "pass"), (1.4, "fail"), (0, "fail")):
            text = "gauge,t,eta\n" + "".join(f"{gauge},{t},{factor * float(eta)}\n" for gauge, t, eta in (
                line.split(",") for line in data if line[:2] in ("1,", "2,", "3,", "4,")))
            told = self.agreement("island_gauges", text, "--table", "gauges", "--uncertainty", "eta=0,t=0")
            self.assertEqual(told[0], verdict, told)

    def test_what_no_reading_is_taken_of_is_undecided(self):
        text = "probe,t,p\n" + "".join(f"5,{k / 100},{k}\n" for k in range(400))
        told = self.agreement("dam_break_box", text, "--table", "pressure", "--uncertainty", "p=0,t=0")
        self.assertEqual(told[:2], ("inconclusive", "no reading is taken of what was submitted"))
        self.assertIn("submit the rest: pressure-given", told[2])

    def test_one_instant_of_a_train_of_waves_has_no_rate(self):
        surface = self.reference("wave_attenuation", "surface")
        last = surface["t"] == surface["t"].max()
        scored = self.score("wave_attenuation", "--data", self.table({name: values[last] for name, values in surface.items()}))
        self.accepted(scored, 1)
        self.assertIn("a rate needs two instants", scored.stdout)
        verdicts = self.verdicts("wave_attenuation.mine")
        self.assertEqual({name for name, verdict in verdicts.items() if verdict != "pass"}, {"surface-given"})

    def test_some_gauges_are_judged_and_the_others_named(self):
        pulse = lambda t: 0.01 * np.exp(-((t - 30) ** 2))
        t = np.arange(25, 36, 0.1)
        folder = self.folder / "stations"
        folder.mkdir()
        for gauge in (6, 9, 16, 22):
            (folder / f"sta_{gauge:04d}").write_text("".join(f" {a:.6E} {b:.6E} 0 0\n" for a, b in zip(t, pulse(t))))
        wide = "".join(",".join([f"{a}", *[repr(pulse(a))] * 4]) + "\n" for a in t)
        places = [(9.36, 13.8), (10.36, 13.8), (12.96, 11.22), (15.56, 13.8)]
        long = "x,y,t,eta\n" + "".join(f"{x},{y},{a},{pulse(a)}\n" for x, y in places for a in t)
        named = "t,A,B,C,D\n" + wide
        for words in (["--data", folder], ["--data", self.write(wide, "wide.txt"), "--columns", "t,6,9,16,22"],
                      ["--data", self.write("t,6,9,16,22\n" + wide)], ["--data", self.write(long, "long.csv")],
                      ["--data", self.write(named, "named.csv"), "--gauges", "A=6,B=9,C=12.96:11.22,D=22"]):
            with self.subTest(words):
                scored = self.score("island_gauges", *words, "--table", "gauges")
                self.accepted(scored, 1)
                self.assertIn("4 of 8 given, without gauge = 1, 2, 3, 4", scored.stdout)
                self.assertIn(self.verdicts("island_gauges.mine")["agreement"], ("fail", "inconclusive"))
        for path in self.out.glob("*"):
            path.unlink()
        self.refused(self.score("island_gauges", "--data", self.write(named), "--gauges", "E=6"), "--gauges E=6", "is called E")
        self.refused(self.score("island_gauges", "--data", self.write(named), "--gauges", "A=7"), "--gauges A=7", "6, 9, 16")
        # Numbers in names count where nobody says what the columns hold.
        twice = self.write("t,P1,P2,P6,Q1\n" + wide)
        self.refused(self.score("island_gauges", "--data", twice), "gauge = 1, which another of its columns holds")
        numbered = self.write("t,P1,P2,P6,total\n" + wide)
        for words, given in ((("--gauges", "P1=9,P2=1"), "2 of 8 given, without gauge = 2, 3, 4, 6, 16, 22"),
                             ((), "3 of 8 given, without gauge = 3, 4, 9, 16, 22")):
            scored = self.score("island_gauges", "--data", numbered, "--table", "gauges", *words)
            self.assertIn(given, scored.stdout, scored.stderr)
            self.assertEqual("column P6 is taken for gauge = 6" in scored.stdout, not words)
        for path in self.out.glob("*"):
            path.unlink()
        self.refused(self.score("isolated_building", "--data", self.write("t,1,2,3,4\n" + wide)),
                     "fits the tables depths and velocity: add --table")

    def test_places_and_tables_that_are_not_asked_for_are_refused(self):
        rows = lambda places: "x,t,h\n" + "".join(f"{x},{t},1\n" for x in places for t in (0, 1))
        names, template = rows_of(seiche("score", "thacker", "--template", "--table", "gauges").stdout)
        some = ", ".join(dict.fromkeys(row[0] for row in template))
        gauges = ("--table", "gauges")
        for count in (1, 8, 9):
            holds = ", ".join(map(str, range(11, 19)[:count])) + (", ..." if count > 8 else "")
            self.refused(self.score("thacker", "--data", self.write(rows(range(11, 11 + count))), *gauges),
                         f"mine.csv: column x: holds {holds}, must be some of {some}\n")
        self.refused(self.score("island_gauges", "--data", self.write("x,y,t,eta\n1,1,0,0\n1,1,1,0\n"), *gauges),
                     "column gauge: holds places where none is, must be some of 1, 2, 3, 4, 6, 9, 16, 22\n")
        one = self.write("x,h,u\n0,1,0\n1,1,0\n", "one.csv")
        self.refused(self.score("riemann", "--data", one, "--data", self.write("x,h,u\n0,1,0\n1,1,0\n")),
                     f"mine.csv: holds the table profile, which {one} holds as well")

    def test_what_the_record_does_not_hold_is_named(self):
        water = "T,p\n" + "".join(f"{k / 20},0.01\n" for k in range(201))
        scored = self.score("dam_break_wall_pressure", "--data", self.write(water))
        self.accepted(scored, 1)
        self.assertEqual(self.verdicts("dam_break_wall_pressure.mine")["agreement"], "fail")  # nothing sets its clock
        names, rows = rows_of(seiche("score", "composite_beach", "--template", "--table", "gauges").stdout)
        still = ",".join(names) + "\n" + "".join(f"{gauge},{t},0\n" for gauge, t, _ in rows)
        scored = self.score("composite_beach", "--data", self.write(still), "--table", "gauges")
        self.accepted(scored, 1)
        self.assertIn("readings, u_num not stated, without gauges-arrival-", scored.stdout)
        self.assertIn("the measured quantity is missing", scored.stdout)
        self.assertNotIn("error nan %", scored.stdout)
        names, rows = rows_of(seiche("score", "breaking_on_slope", "--template", "--table", "levels").stdout)
        wrong = ",".join(names) + "\n" + "".join(f"{case},{x},0.02\n" for case, x, _ in rows)
        scored = self.score("breaking_on_slope", "--data", self.write(wrong), "--table", "levels")
        self.accepted(scored, 1)
        self.assertEqual(self.verdicts("breaking_on_slope.mine")["agreement"], "fail")  # by its misfit alone

    def test_a_part_of_an_experiment_is_no_full_pass(self):
        """The data themselves, but for one gauge, or the end of the record."""
        data = (SOURCE / "reference_data/matsuyama_tanaka_2001_monai_valley/table.csv").read_text().splitlines()
        head = [k for k, line in enumerate(data) if line.startswith("gauge")][0]
        rows = [line.split(",") for line in data[head + 1:]]
        words = ("--table", "gauges", "--uncertainty", "eta=0.0001,t=0.01")
        for keep, status in ((lambda row: True, 0), (lambda row: row[0] != "7", 1), (lambda row: float(row[1]) < 17, 1)):
            text = "\n".join([data[head], *(",".join(row) for row in rows if keep(row))])
            self.accepted(self.score("monai_valley", "--data", self.write(text), *words), status)
            verdicts = self.verdicts("monai_valley.mine")
            self.assertNotIn("error", verdicts.values())
            missed = {name for name, verdict in verdicts.items() if verdict != "pass"}
            self.assertTrue(all(name.endswith(("-given", "-coverage")) for name in missed), missed)
        # Gauges that differ in y alone.
        places = {"5": "4.521,1.196", "7": "4.521,1.696", "9": "4.521,2.196"}
        text = "x,y,t,eta\n" + "\n".join(",".join([places[gauge], *rest]) for gauge, *rest in rows)
        self.accepted(self.score("monai_valley", "--data", self.write(text), *words), 0)

    def agreement(self, case, text, *words):
        """Verdict and resolution of the comparison with the data; what is there is no full pass."""
        scored = self.score(case, "--data", self.write(text), *words)
        self.accepted(scored, 1)
        claim, = (one for one in self.record(f"{case}.mine")["claims"] if one["id"] == "agreement")
        return claim["verdict"], claim["resolution"], scored.stdout

    def test_one_gauge_is_known_by_the_name_of_its_column_under_any_header(self):
        data = (SOURCE / "reference_data/briggs_1995_conical_island_a/table.csv").read_text().splitlines()
        rows = [line.split(",")[1:] for line in data if line.startswith("6,")]
        plain, cm = ("".join(f"{t},{float(eta) * per}\n" for t, eta in rows) for per in (1, 100))
        measured = set()
        for text in ("t,6\n" + plain, "# my data\nt,WG6\n" + plain, "# t,WG6\n# s,m\n" + plain, "t,WG6\ns,cm\n" + cm,
                     "t,WG6\n[s],[cm]\n" + cm):
            told = self.agreement("island_gauges", text, "--table", "gauges", "--uncertainty", "eta=0.0001,t=0.001")
            self.assertIn("1 of 8 given, without gauge = 1, 2, 3, 4, 9, 16, 22", told[2])
            claim, = (one for one in self.record("island_gauges.mine")["claims"] if one["id"] == "agreement")
            measured.add(round(claim["measured"], 9))
        self.assertEqual(len(measured), 1, measured)
        self.accepted(self.score("island_gauges", "--data", self.write("t,WG7\n" + plain), "--table", "gauges"), 2)

    def test_a_record_that_ends_before_the_clocks_window_does_is_judged_by_what_it_holds(self):
        data = (SOURCE / "reference_data/briggs_1995_conical_island_a/table.csv").read_text().splitlines()
        rows = [line.split(",") for line in data if line[0].isdigit()]
        for end, late, factor, verdict in ((30, 0, 1, "pass"), (30, 0.5, 1, "pass"), (30, 0, 1.4, "fail"),
                                           (21, 0, 1, "inconclusive")):
            text = "gauge,t,eta\n" + "".join(f"{gauge},{float(t) + late},{factor * float(eta)}\n" for gauge, t, eta in rows
                                             if float(t) <= end)
            told = self.agreement("island_gauges", text, "--table", "gauges", "--uncertainty", "eta=0.0001,t=0.001")
            self.assertEqual(told[0], verdict, told)
            self.assertEqual("too short to set its clock" in told[1], verdict == "inconclusive", told)

    def test_what_is_given_of_a_wave_on_a_beach_is_judged(self):
        """Seven of eight instants, or one gauge: as good as the whole, and named."""
        for table, column, missing in (("profiles", "eta_over_d", "t"), ("gauges", "gauge_over_d", "x_over_d")):
            data = (SOURCE / f"reference_data/synolakis_1987_analytic_{'series' if table == 'gauges' else table}/table.csv"
                    ).read_text().splitlines()
            names = [name.split(" ")[0] for name in next(line for line in data if "eta" in line and line[0] != "#").split(",")]
            rows = [dict(zip(names, line.split(","))) for line in data if line[0] in "-0123456789"]
            left = min(float(row[missing]) for row in rows)
            for factor, verdict in ((1, "pass"), (1.2, "fail")):
                text = f"t,x_over_d,{column}\n" + "".join(
                    f"{row['t']},{row['x_over_d']},{factor * float(row['eta_over_d'])}\n" for row in rows
                    if float(row[missing]) != left)
                scored = self.score("synolakis_beach", "--data", self.write(text), "--table", table)
                self.accepted(scored, 1)
                self.assertIn(f"given, without {missing} = {left:g}", scored.stdout)
                verdicts = self.verdicts("synolakis_beach.mine")
                judged = {verdicts[one] for one in verdicts if not one.endswith(("-given", "-coverage"))}
                self.assertEqual(judged, {verdict})

    def test_some_of_several_run_ups_are_judged_and_the_others_named(self):
        means = {1: 0.5375 / 6, 2: 0.3625 / 6, 3: 0.3350 / 6}
        words = ("--table", "runup", "--uncertainty", "R=0.001")
        self.refused(self.score("island_gauges", "--data", self.write("angle,R\n80,0.03\n"), *words), "at least two")
        for places, named in (((1,), "1 of 3 given, without place = 2, 3"), ((1, 3), "2 of 3 given, without place = 2")):
            for factor, verdict in ((1, "pass"), (1.3, "fail")):
                text = "place,R\n" + "".join(f"{place},{factor * means[place]}\n" for place in places)
                told = self.agreement("monai_valley", text, *words)
                self.assertEqual(told[:2], (verdict, f"{len(places)} readings"))
                self.assertIn(named, told[2])
        for factor, verdict in ((1, "inconclusive"), (1.5, "fail")):  # one run-up is known to a fifth
            told = self.agreement("island_gauges", f"angle,R\n90,{0.02659 * factor}\n", *words)
            self.assertEqual(told[:2], (verdict, "1 readings"))
            self.assertIn("1 point, 1 of 9 reference points", told[2].splitlines()[0])

    def test_a_gauge_sets_the_clock_where_that_of_the_clock_is_missing(self):
        data = (SOURCE / "reference_data/luth_1994_bar_a/table.csv").read_text().splitlines()
        rows = [line.split(",") for line in data if line.startswith("17.3,")]
        for late, factor, verdict in ((0, 1, "pass"), (0.6, 1, "pass"), (0.6, 1.4, "fail")):
            text = "x,t,eta\n" + "".join(f"{x},{float(t) + late},{factor * float(eta)}\n" for x, t, eta in rows)
            told = self.agreement("luth_bar", text, "--uncertainty", "eta=0.0001")
            self.assertIn(", clock set at x = 17.3", told[1])
            self.assertEqual(told[0], verdict)
            self.assertAlmostEqual(self.record("luth_bar.mine")["measurements"]["gauges_time_shift"], late,
                                   delta=0.05)  # points are 0.1 s apart


if __name__ == "__main__":
    unittest.main()
