"""`seiche score` beyond one file: ladders of sizes, histories of what is conserved, baselines, the first screen."""

import json
import unittest

import numpy as np

from submitting import Scoring, seiche


class Sines(Scoring):
    def wave(self, error=0.0, name="mine.csv"):
        """The standing wave's elevation at the wall, by theory, too high by a share."""
        wave = self.reference("standing_wave", "wall")
        return self.table({"t": wave["t"], "eta": (1 + error) * wave["eta"]}, name)

    def judged(self, *words, status=0):
        scored = self.score("standing_wave", *words, "--table", "wall")
        self.accepted(scored, status)
        return scored.stdout


class Ladders(Sines):
    def ladder(self, *words, power=1, status=0, sizes=(0.2, 0.1, 0.05)):
        files = [self.wave(0.4 * h**power, f"{h}.csv") for h in sizes]
        data = [word for file in files for word in ("--data", file)]
        return self.judged(*data, "--sizes", ",".join(map(str, sizes)), *words, status=status)

    def test_order_and_what_one_per_cent_needs_are_said_and_shown(self):
        said = self.ladder("--seconds", "1,8,64")
        self.assertIn("eta: your order is 1 (1 to 1); error on 0.05 is 2 %; 1 % needs dx = 0.025 and 5.1e+02 s", said)
        record = self.record("standing_wave.mine")
        self.assertAlmostEqual(record["measurements"]["ladder_order_eta"], 1, 6)
        self.assertAlmostEqual(record["measurements"]["ladder_size_for_1_percent_eta"], 0.025, 6)
        self.assertEqual(record["measurements"]["cell_size"], 0.05)
        self.assertEqual(record["wall_time"], 64)
        self.assertNotIn("threads", record["measurements"])
        self.assertIn("ladder", [figure["id"] for figure in record["figures"]])
        report = seiche("report", self.out)
        self.assertEqual(report.returncode, 0, report.stderr)
        page = (self.out / "report/cases/standing_wave.html").read_text()
        self.assertIn("Summary: mine", page)
        self.assertIn("your order is 1", page)

    def test_the_finest_is_judged_in_whatever_order_it_comes(self):
        self.ladder(sizes=(0.05, 0.2, 0.1))
        self.assertAlmostEqual(self.record("standing_wave.mine")["measurements"]["eta_amplitude_ratio"], 1.02, 6)

    def test_second_order_is_told(self):
        self.assertIn("your order is 2 (2 to 2)", self.ladder(power=2))

    def test_sizes_and_tables_that_do_not_go_together_are_refused(self):
        file = self.wave()
        for words, expected in [
                (["--data", file, "--sizes", "0.1,0.2"], "sizes 0.1,0.2: must be three or more, all different"),
                (["--data", file, "--data", file, "--sizes", "0.1,0.1,0.2"], "sizes 0.1,0.1,0.2: must be three or more")]:
            with self.subTest(words=words[-2:]):
                self.refused(self.score("standing_wave", "--data", file, "--table", "wall", *words), expected)
        x, t, h = self.gauges()
        tables = {"gauges": self.table({"x": x, "t": t, "h": h}, "gauges.csv"),
                  "shorelines": self.table({name: t[x == x[0]] for name in ("t", "left", "right")}, "shorelines.csv")}
        three = [word for name in ("gauges", "gauges", "shorelines") for word in ("--data", tables[name])]
        self.refused(self.score("thacker", *three, "--sizes", "1,2,3"), "size 3: other tables than the coarsest")
        both = ("--data", tables["gauges"], "--data", tables["shorelines"])
        self.refused(self.score("thacker", *both, "--repeats", 2), "--repeats: the runs differ in ")


class RepeatedRuns(Sines):
    def test_the_mean_of_several_runs_is_judged_and_their_scatter_said(self):
        data = [word for share in (-0.1, 0, 0.13) for word in ("--data", self.wave(share, f"run{share}.csv"))]
        self.judged(*data[:2], status=1)
        self.judged(*data, "--repeats", "3")
        measured = self.record("standing_wave.mine")["measurements"]
        self.assertEqual(measured["repeats"], 3)
        self.assertAlmostEqual(measured["eta_amplitude_ratio"], 1.01, 6)
        self.assertGreater(measured["repeats_scatter_eta"], 0)


class Histories(Sines):
    def test_a_history_beside_the_result_is_judged(self):
        t = np.linspace(0, 10, 21)
        kept = self.table({"t": t, "volume": 3 + 0 * t, "energy": 2 - 0.001 * t}, "kept.csv")
        self.judged("--data", self.wave(), "--data", kept)
        self.assertEqual(self.verdicts("standing_wave.mine")["conserved-energy"], "pass")
        rest = self.table({"t": t, "volume": 1000 * (3 + 0 * t), "momentum": 0 * t}, "rest.csv")
        self.judged("--data", self.wave(), "--data", rest)      # in litres, and from rest between walls
        lost = self.table({"t": t, "volume": 3 - 0.001 * t}, "lost.csv")
        said = self.judged("--data", self.wave(), "--data", lost, status=1)
        self.assertEqual(self.verdicts("standing_wave.mine")["conserved-volume"], "fail")
        self.assertIn("at t = 10 s", said)

    def test_a_history_that_cannot_be_judged_is_refused(self):
        again = self.table({"t": [0, 1], "energy": [3, 3]}, "again.csv")
        for columns, said in (({"t": [0, 1], "volume": [3, 3]}, "again.csv: holds a history, which mine.csv holds as well"),
                              ({"t": [0], "volume": [3]}, "mine.csv: 1 rows, must be at least two"),
                              ({"t": [0, 1], "volume": [3, np.nan]}, "mine.csv: line 3: column volume: no value"),
                              ({"t": [np.nan, 1], "volume": [3, 3]}, "mine.csv: 1 rows, must be at least two"),
                              ({"t": [0, 1], "volume": [0, 3]}, "column volume: is 0 at t = 0, must not be")):
            words = ["--data", self.wave(name="wave.csv"), "--data", self.table(columns)]
            with self.subTest(said):
                said = said.replace("which ", f"which {self.folder}/")
                self.refused(self.score("standing_wave", *words, *(["--data", again] if "again" in said else []),
                                        "--table", "wall"), said)
        short = self.hdf5(t=[0.0, 1.0], volume=[3.0, 3.0, 3.0])
        self.refused(self.score("standing_wave", "--data", self.wave(name="wave.csv"), "--data", short, "--table", "wall"),
                     "mine.h5: column volume: 3 values, must be as many as in column t: 2")

    def test_its_columns_may_be_mapped(self):
        mass = self.table({"time": [0, 1], "mass": [3, 2]}, "mass.csv")
        wave = self.wave(name="w.csv")
        text = wave.read_text().replace("t,", "time,", 1)
        self.judged("--data", self.write(text, "w.csv"), "--data", mass, "--map", "mass=volume,time=t", status=1)
        self.assertEqual(self.verdicts("standing_wave.mine")["conserved-volume"], "fail")


class Baselines(Sines):
    def kept(self, error, *words, status=0):
        return self.judged("--data", self.wave(error), "--baseline", self.folder / "kept", *words, status=status)

    def test_a_baseline_is_made_compared_and_blessed(self):
        missing = self.score("standing_wave", "--data", self.wave(), "--table", "wall", "--baseline", self.folder / "kept")
        self.refused(missing, "has no standing_wave.mine.json", "--bless")
        self.assertIn("is this score now", self.kept(0.01, "--bless"))
        self.assertIn("nothing got worse", self.kept(0.01))
        self.assertIn("nothing got worse", self.kept(0.0102))
        self.assertIn("WORSE", self.kept(0.03, status=1))
        self.assertIn("nothing got worse", self.kept(0.01))  # what is worse is not kept
        self.assertIn("is this score now", self.kept(0.2, "--bless"))
        self.assertIn("nothing got worse", self.kept(0.2))   # a failure that is known
        self.assertIn("unexpected pass", self.kept(0.01))
        self.assertTrue((self.folder / "kept/standing_wave.mine.h5").is_file())

    def test_what_is_no_baseline_is_refused_before_anything_is_written(self):
        self.kept(0.01, "--bless")
        words = ("standing_wave", "--data", self.wave(0.03), "--table", "wall")
        before = {path: path.read_bytes() for folder in (self.out, self.folder / "kept") for path in folder.iterdir()}
        for kept, settings, said in [(self.out, (), "is --out"), (f"{self.out}/../evidence/", ("--bless",), "is --out"),
                                     (self.folder / "kept", ("--set", "depth=1.5"), "depth = 1, not 1.5")]:
            with self.subTest(said, settings=settings):
                result = self.score(*words, "--baseline", kept, *settings)
                self.assertEqual((result.returncode, result.stdout), (2, ""), result.stderr)
                self.assertIn(said, result.stderr)
        record = self.folder / "kept/standing_wave.mine.json"
        record.write_text(record.read_text().replace('"solver": "mine"', '"solver": "mimd"'))
        self.assertEqual(self.score(*words, "--baseline", self.folder / "kept").returncode, 2)
        record.write_bytes(before[record])
        self.assertEqual({path: path.read_bytes() for path in before}, before)

    def test_a_foreign_file_beside_the_records_takes_no_verdict(self):
        self.out.mkdir()
        (self.out / "package.json").write_text('{"name": "somebody"}')
        self.assertIn("every claim is met", self.judged("--data", self.wave()))
        self.assertIn("broken.package", (self.out / "junit.xml").read_text())


class FirstLook(Sines):
    def test_the_first_lines_say_what_where_whose_and_what_next(self):
        said = self.judged("--data", self.wave(0.2), status=1)
        lines = dict(line.split(": ", 1) for line in said.splitlines() if ": " in line)
        self.assertIn("not met", lines["result"])
        self.assertIn("eta-relative_l2", lines["closest limit"])
        self.assertIn("amplitude: 100 %", lines["type of error"])
        self.assertIn("t = ", lines["largest error"])
        self.assertIn("amplitude is wrong", lines["start with"])
        self.assertIn("check the file", lines["next step"])
        import jsonschema

        from submitting import SOURCE
        record = self.record("standing_wave.mine")
        jsonschema.validate(record, json.loads((SOURCE / "reports/schema/record.schema.json").read_text()))
        self.assertIn("first-look", [table["id"] for table in record["tables"]])


if __name__ == "__main__":
    unittest.main()
