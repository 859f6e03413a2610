"""Wrong results that no change of the reference by a size (test_resolving_power.py) makes; what is said of wrong ones."""

import unittest

import numpy as np

from submitting import SOURCE, Scoring, exact, printed, rows_of, seiche


class Riemann(Scoring):
    LENGTH, JUMP, TIME = 50.0, 20.0, 6.0

    def profile(self, points, gravity=9.81, right=0.1, time=TIME):
        """The exact solution of the case's problem at the centres of so many cells."""
        half = self.LENGTH / points / 2
        columns = exact("riemann", "--set", f"jump={self.JUMP},right_depth={right},gravity={gravity}", "--grid",
                        f"x={half}:{self.LENGTH - half}:{points},t={time}")
        return {name: columns[name] for name in ("x", "h", "u")}

    def judged(self, columns, *words, status):
        self.accepted(self.score("riemann", "--data", self.table(columns), *words), status)
        return self.verdicts("riemann.mine")

    def test_the_exact_profile_passes_however_densely_it_is_printed(self):
        limits = set()
        for points in (50, 400, 4000):
            self.judged(self.profile(points), "--dx", self.LENGTH / 50, status=0)
            limits.add(tuple(claim["criterion"]["limit"] for claim in self.record("riemann.mine")["claims"]))
        self.assertEqual(len(limits), 1, "the limits follow the cells, not the points")
        self.judged(self.profile(4000), "--dx", self.LENGTH / 4000, status=0)

    def smeared(self, cells):
        """Depth and discharge of 400 points, means over so many of them."""
        right = self.profile(400)
        h, q = (np.convolve(np.pad(y, cells // 2, "edge"), np.ones(cells) / cells, "valid")
                for y in (right["h"], right["h"] * right["u"]))
        return {"x": right["x"], "h": h, "u": q / h}

    def test_a_smaller_cell_is_judged_more_strictly(self):
        self.judged(self.smeared(11), "--dx", 0.125, status=0)
        self.judged(self.smeared(11), status=0)
        self.judged(self.smeared(49), "--dx", 1, status=0)
        self.judged(self.smeared(49), "--dx", 0.125, status=1)
        self.judged(self.smeared(49), status=1)

    def test_water_that_never_moved_fails_at_any_number_of_points(self):
        for points in (50, 400, 4000):
            still = self.profile(points)
            still["h"], still["u"] = np.where(still["x"] < self.JUMP, 1.0, 0.1), np.zeros(points)
            for cell in (self.LENGTH / points, 1.0, 12.5):
                with self.subTest(points=points, cell=cell):
                    verdicts = self.judged(still, "--dx", cell, status=1)
                    self.assertNotEqual(verdicts["depth"], "pass")
                    self.assertNotEqual(verdicts["discharge"], "pass")

    def test_too_few_points_are_no_result(self):
        for points in (2, 12):
            self.refused(self.score("riemann", "--data", self.table(self.profile(points))), "column x", "two cells",
                         "--dx")
        self.refused(self.score("riemann", "--data", self.table(self.profile(12)), "--dx", 20), "--dx 20", "12.5")

    def test_another_problem_fails(self):
        """As a reader of the README would try it, on cells of 1 m."""
        for wrong in ({"gravity": 9.0}, {"right": 0.12}, {"right": 0.08}, {"time": 5.82}, {"time": 6.18}):
            for points in (50, 400):
                with self.subTest(wrong, points=points):
                    self.judged(self.profile(points, **wrong), "--dx", 1, status=1)

    def test_a_dry_front_that_stays_behind_fails(self):
        """A drying depth of 5 cm."""
        dry = self.profile(50, right=0.0, time=4.0)
        words = ("--set", "right_depth=0,time=4")
        self.judged(dry, *words, "--dx", 1, status=0)
        for name in "uh":
            dry[name] = np.where(dry["h"] < 0.05, 0, dry[name])
        self.judged(dry, *words, "--dx", 1, status=1)

    def test_half_a_domain_says_what_is_missing(self):
        half = {name: values[:25] for name, values in self.profile(50).items()}
        scored = self.score("riemann", "--data", self.table(half))
        self.accepted(scored, 1)
        said = [line for line in scored.stdout.splitlines() if not line.startswith("  ")]
        self.assertNotIn("nan", " ".join(said))
        self.assertIn("the submitted points do not reach the front", scored.stdout)

    def test_our_own_on_cells_too_coarse_to_tell_says_so_and_decides_the_rest(self):
        self.accepted(seiche("run", "riemann", "--set", "particles=4", "--out", self.out))
        record = self.record("riemann")
        self.assertEqual({claim["verdict"] for claim in record["claims"]}, {"pass"})
        self.assertIn("celerity", [one["id"] for one in record["left_out"]])


class Standing(Scoring):
    """The standing wave of finite amplitude: neither linear theory nor another tank is it."""

    def wave(self, depth=1.0, gravity=9.81, amplitude=0.05):
        words = ("--set", f"depth={depth},gravity={gravity},amplitude={amplitude}")
        times, _ = rows_of(printed("score", "standing_wave", "--template", "--table", "wall"))[::-1]
        end = float(times[-1][0])
        wall = exact("standing", *words, "--grid", f"x=0,t=0:{end}:{len(times)}")
        return {"t": wall["t"], "eta": wall["eta"]}, exact("standing", *words, "--integrals")["omega"][0]

    def judged(self, wall, omega, status):
        numbers = self.table({"omega": [omega]}, "omega.csv")
        self.accepted(self.score("standing_wave", "--data", self.table(wall), "--data", numbers), status)
        return self.verdicts("standing_wave.mine")

    def test_the_wave_of_theory_passes_with_the_defaults_of_both_commands(self):
        wall, omega = self.wave()
        self.judged(wall, omega, 0)
        default = exact("standing", "--grid", f"x=0,t=0:{wall['t'][-1]}:{len(wall['t'])}")
        self.judged({"t": default["t"], "eta": default["eta"]}, omega, 0)

    def test_errors_are_printed_as_errors_and_the_time_as_the_solver_s(self):
        wall, omega = self.wave()
        numbers = self.table({"omega": [1.0005 * omega]}, "omega.csv")
        scored = self.score("standing_wave", "--data", self.table(wall), "--data", numbers, "--seconds", 73, "--threads", 4)
        self.accepted(scored)
        self.assertIn("error +0.05 %", scored.stdout)
        self.assertEqual(self.record("standing_wave.mine")["wall_time"], 73)
        self.assertEqual(self.record("standing_wave.mine")["measurements"]["threads"], 4)
        self.accepted(self.score("standing_wave", "--data", self.table(wall), "--data", numbers))
        self.assertEqual(self.record("standing_wave.mine")["wall_time"], 0)
        self.assertTrue((self.out / "junit.xml").is_file())

    def test_a_tank_too_shallow_another_gravity_and_linear_theory_fail(self):
        right, omega = self.wave()
        for depth in (0.85, 0.97):
            verdicts = self.judged(*self.wave(depth=depth), 1)
            self.assertEqual((verdicts["eta-relative_l2"], verdicts["omega-value"]), ("fail", "fail"), depth)
        self.assertEqual(self.judged(*self.wave(gravity=9.7), 1)["omega-value"], "fail")
        linear = np.sqrt(9.81 * np.tanh(1.0))
        wall = {"t": right["t"], "eta": 0.05 * np.cos(linear * right["t"])}
        self.assertEqual(self.judged(wall, linear, 1)["eta-relative_l2"], "fail")

    def test_a_table_left_out_is_no_success(self):
        wall, omega = self.wave()
        self.accepted(self.score("standing_wave", "--data", self.table(wall)), 1)
        self.accepted(self.score("standing_wave", "--data", self.table({"omega": [omega]})), 1)
        self.assertEqual(self.verdicts("standing_wave.mine")["wall-coverage"], "fail")
        self.accepted(self.score("standing_wave", "--data", self.table(wall), "--table", "wall"), 0)


class ColumnFront(Scoring):
    """The front of a collapsing column: when it was let go is not judged, how fast it runs is."""

    def front(self):
        path = SOURCE / "reference_data/martin_moyce_1952_tall_wide/table.csv"
        T, X = np.loadtxt(path, delimiter=",", skiprows=1).T
        times = np.arange(0, T[-1], 0.02)
        return {"T": times, "X": np.interp(times, np.append(0, T), np.append(1, X))}

    def judged(self, front, *words, status, uncertainty="X=0"):
        stated = ("--uncertainty", uncertainty) if uncertainty else ()
        scored = self.score("dam_break_sph", "--data", self.table(front), *stated, *words)
        self.accepted(scored, status)
        return self.verdicts("dam_break_sph.mine"), scored.stdout

    def test_the_published_front_passes_late_or_not(self):
        front = self.front()
        self.judged(front, status=0)
        early = {"T": front["T"][front["T"] >= 0.15] - 0.15, "X": front["X"][front["T"] >= 0.15]}
        self.judged(early, status=0)
        self.judged(front, status=0, uncertainty="X=0.5%")

    def test_a_front_a_quarter_too_slow_fails_whatever_its_uncertainty(self):
        right = self.front()
        verdicts, said = self.judged({**right, "T": right["T"] / 0.73}, status=1, uncertainty=None)
        self.assertEqual(verdicts["rate"], "fail")
        self.assertIn("its numerical uncertainty was not estimated, but", said)

    def test_noise_fails(self):
        right = self.front()
        for seed in range(3):
            noise = 0.05 * np.random.default_rng(seed).standard_normal(len(right["X"]))
            verdicts, _ = self.judged({**right, "X": right["X"] + noise}, status=1)
            self.assertEqual(verdicts["advance"], "fail")

    def test_what_counts_is_said(self):
        front = self.front()
        _, said = self.judged(front, status=0)
        self.assertIn("14 of 15 published points count, 1 later than the front is known", said)
        verdicts, said = self.judged(front, "--set", "judged_to=3.9", status=1)   # its name in version 0.1
        self.assertIn("4 of 15 published points count, 11 lie beyond X/a = 3.9", said)
        self.assertEqual(verdicts["rate"], "inconclusive")

    def test_the_stated_uncertainty_counts(self):
        front = self.front()
        for uncertainty in (None, "X=20%"):
            verdicts, _ = self.judged(front, status=1, uncertainty=uncertainty)
            self.assertEqual(verdicts["rate"], "inconclusive")


class Templates(Scoring):
    def test_the_commands_that_a_template_prints_give_what_passes(self):
        for case, tables in {"riemann": ["profile"], "standing_wave": ["wall"], "stokes_wave": ["surface"],
                             "wave_attenuation": ["surface"], "solitary_wave": ["surface"],
                             "wavemaker_start": ["gauge"], "thacker": ["gauges"], "moving_bore": ["profile"],
                             "bore_reflection": ["profile"], "colliding_bores": ["profile"],
                             "steady_bump": ["profile"], "macdonald_channel": ["profile"],
                             "wave_kinematics": ["velocities"],
                             "wall_run_up_exact": ["numbers"]}.items():
            for table in tables:
                with self.subTest(case, table=table):
                    data = self.table(self.reference(case, table))
                    self.accepted(self.score(case, "--data", data, "--table", table))


class Diagnosis(Scoring):
    """What a file got wrong is said in words, in the output and in the record; the verdict is of the file as it is."""

    def said(self, columns, case="thacker", table="gauges"):
        scored = self.score(case, "--data", self.table(columns), "--table", table)
        self.accepted(scored, status=1)
        tables = {table["id"]: table for table in self.record(f"{case}.mine")["tables"]}
        words = [row[1] for row in tables["diagnosis"]["rows"]] if "diagnosis" in tables else []
        for one in words:
            self.assertIn(one, scored.stdout)
        return words

    def gauge(self, **options):
        x, t, h = self.gauges(**options)
        return {"x": x, "t": t, "h": h}

    def test_a_gauge_that_is_late_is_told_by_how_much(self):
        for late in (0.3, -0.3):
            words = self.said(self.gauge(late=late))
            self.assertEqual(len(words), 1, words)
            self.assertIn(f"fits the reference 0.3 s {'earlier' if late > 0 else 'later'}", words[0])

    def test_another_datum_and_another_unit_are_told(self):
        right = self.gauge()
        self.assertIn("lies 0.02 m higher", self.said({**right, "h": right["h"] + 0.02})[0])
        self.assertIn("lies 1 m lower", self.said({**right, "h": right["h"] - 1})[0])
        self.assertIn("divided by 100: centimetres for metres", self.said({**right, "h": 100 * right["h"]})[0])
        self.assertIn("divided by 1000: milliseconds for seconds", self.said({**right, "t": 1000 * right["t"]})[0])

    def test_inverted_mirrored_neighbouring_scaled_and_cut_are_told(self):
        right = self.gauge()
        self.assertIn("reversed sign", self.said({**right, "h": -right["h"]})[0])
        self.assertIn("divided by 0.82", self.said({**right, "h": 0.82 * right["h"]})[0])
        wrong = dict(right)
        gauges = sorted(set(right["x"]))
        wrong["h"] = np.concatenate([right["h"][right["x"] == x] for x in (gauges[1], gauges[0], gauges[2])])
        self.assertIn(f"is the reference of x = {gauges[1]:g} m", " ".join(self.said(wrong)))
        half = right["t"] < right["t"].max() / 2
        self.assertIn("a file cut short", self.said({name: values[half] for name, values in right.items()})[0])

    def test_of_a_right_result_nothing_is_said(self):
        scored = self.score("thacker", "--data", self.table(self.gauge()), "--table", "gauges")
        self.accepted(scored)
        self.assertNotIn("your result", scored.stdout)
        self.assertNotIn("diagnosis", [table["id"] for table in self.record("thacker.mine")["tables"]])


if __name__ == "__main__":
    unittest.main()
