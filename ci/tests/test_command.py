"""The `seiche` command as a user meets it: exit statuses, error messages, records."""

import contextlib
import datetime
import json
import os
import re
import resource
import shutil
import subprocess
import time
import unittest

from sealing import sealed
from submitting import SEICHE, SOURCE, Scratch, seiche

class Command(Scratch):
    def refused(self, result, *words):
        """Exit status 2, one line that holds the words, nothing written."""
        self.assertEqual(result.returncode, 2, result.stdout + result.stderr)
        message = (result.stdout + result.stderr).strip()
        for word in words:
            self.assertIn(word, message)
        written = [p.name for p in self.out.glob("*")] if self.out.exists() else []
        self.assertEqual([name for name in written if name != "junit.xml"], [])

    def test_threads_are_as_asked(self):
        for threads in ("1", "2"):
            result = seiche("run", "moving_bore", "--threads", threads, "--out", self.out)
            self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
            self.assertIn("[  1/1]", result.stdout)
            self.assertEqual(self.record("moving_bore")["provenance"]["threads"], int(threads))

    def test_a_record_says_how_long_its_case_ran_on_how_many_threads(self):
        begin = time.monotonic()
        environment = {**os.environ, "OMP_NUM_THREADS": "3"}
        self.assertEqual(seiche("run", "moving_bore", "--out", self.out, env=environment).returncode, 0)
        alone = self.record("moving_bore")
        self.assertTrue(0 < alone["wall_time"] < time.monotonic() - begin, alone["wall_time"])
        self.assertEqual(alone["provenance"]["threads"], 3)
        self.assertEqual(alone["provenance"]["cores"], os.cpu_count())
        self.assertEqual(seiche("run", "moving_bore", "riemann", "--out", self.out, env=environment).returncode, 0)
        self.assertEqual([self.record(name)["provenance"]["threads"] for name in ("moving_bore", "riemann")], [1, 1])

    def test_the_worst_of_several_cases_is_the_status(self):
        """As declared 0, failed 1, unfinished 3, refused 2: in this order, whichever comes first."""
        self.assertEqual(seiche("run", "moving_bore", "--out", self.out).returncode, 0)
        failed = self.record("moving_bore")
        failed["claims"][0].update(verdict="fail", as_declared=False)
        config = self.folder / "case.toml"
        config.write_text("[riemann]\nleft_depth = 0\nright_depth = 0\n")
        slow = "mach_reflection_convergence"
        for names, words, status in ((["thacker"], [], 0), (["moving_bore"], [], 1), (["riemann"], ["--config", config], 2),
                                     (["thacker", "moving_bore"], [], 1), (["riemann", "moving_bore"], ["--config", config], 2),
                                     ([slow, "moving_bore"], ["--most-seconds", 1], 3),
                                     ([slow, "riemann"], ["--most-seconds", 1, "--config", config], 2)):
            for order in (names, names[::-1])[:len(names)]:
                with self.subTest(order):
                    (self.out / "moving_bore.json").write_text(sealed(failed))
                    self.assertEqual(seiche("run", *order, "--resume", *words, "--jobs", 1, "--out", self.out).returncode, status)

    def test_a_terminal_shows_a_bar_for_each_case_that_runs_and_takes_it_away(self):
        ours, theirs = os.openpty()
        with subprocess.Popen([SEICHE, "run", "moving_bore", "riemann", "--jobs", "2", "--out", str(self.out)], stdout=theirs):
            os.close(theirs)
            text = b""
            with contextlib.suppress(OSError):  # Linux' way to say that the other end is closed
                while part := os.read(ours, 65536):
                    text += part
        os.close(ours)
        shown = re.sub("(\x1b\\[1A\x1b\\[2K)+", "", text.decode())
        bars = re.findall("^ +(moving_bore|riemann) +([█·]{30}) +[0-9.]+ s\r$", shown, re.MULTILINE)
        self.assertEqual({name for name, _ in bars}, {"moving_bore", "riemann"})
        self.assertTrue(all("·█" not in bar for _, bar in bars))
        self.assertEqual(text.decode().count("\x1b[1A\x1b[2K"), len(bars))

    def test_list_names_every_case_and_parameter(self):
        cases = json.loads(seiche("list", "--json").stdout)["cases"]
        names = [case["name"] for case in cases]
        self.assertIn("riemann", names)
        self.assertEqual(len(names), len(set(names)))
        listed = seiche("list").stdout
        for case in cases:
            self.assertTrue(case["title"] and case["source"] and case["tiers"], case["name"])
            for parameter in case["parameters"]:
                self.assertTrue(parameter["meaning"] and parameter["unit"] and parameter["range"], case["name"])
                kind, choices = type(parameter["default"]["quick"]), parameter.get("choices", [])
                self.assertEqual("lowest" in parameter, not choices and kind is not bool, parameter)
                self.assertTrue(parameter["default"]["quick"] in choices if choices else kind is not str, parameter)
            self.assertIn(case["name"], listed)

    def test_run_writes_a_record_that_fits_the_schema(self):
        result = seiche("run", "riemann", "--set", "particles=40", "--out", self.out)
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        import jsonschema

        schema = json.loads((SOURCE / "reports/schema/record.schema.json").read_text())
        record = self.record("riemann")
        jsonschema.validate(record, schema)
        self.assertEqual(record["parameters"]["particles"]["value"], 40)
        for name in ["cell_l1_h", "reconstructed_l1_h", "front_position", "star_depth", "star_velocity", "max_courant"]:
            self.assertIn(name, record["measurements"])
        self.assertTrue((self.out / record["data"]).exists())
        self.assertTrue((self.out / "junit.xml").exists())
        self.assertEqual([p.name for p in self.out.glob(".*")], [])

    def test_a_published_set_has_a_record_of_its_own(self):
        cases = json.loads(seiche("list", "--json").stdout)["cases"]
        runs = [(case["name"], set_["tiles"][0]) for case in cases for set_ in case["published"]]
        self.assertIn(("dry_dam_break", "bzz-fig-6"), runs)
        listed = seiche("list", "--published").stdout
        for name, tile in runs:
            self.assertIn(f"seiche run {name} --as {tile}", listed)
        self.assertRegex(listed, r"bzz-fig-5 +picture only\n +bzz-fig-7 +reproduced\n")
        words = subprocess.run(["python3", "-m", "render.atlas"], cwd=SOURCE / "reports", capture_output=True, text=True,
                               input=seiche("list", "--json").stdout, check=True).stdout
        self.assertEqual((SOURCE / "reports/record/tiles.json").read_text(), words, "ci/checks/record writes it")
        # What equals the tier's defaults is the tier's own run; one of its tiles names the set as well as another.
        self.assertEqual(seiche("run", "dry_dam_break", "--as", "bzz-fig-7", "--out", self.out).returncode, 0)
        record = self.record("dry_dam_break")
        self.assertEqual(record["set"], "")
        here = [set_ for set_ in record["published"] if set_["here"]]
        self.assertEqual([set_["tiles"][0] for set_ in here], ["bzz-fig-6"])
        self.assertEqual(here[0]["values"], {name: p["value"] for name, p in record["parameters"].items()})
        self.assertEqual(seiche("run", "dry_dam_break", "--set", "particles=20", "--out", self.out).returncode, 0)
        self.assertEqual([set_["here"] for set_ in self.record("dry_dam_break")["published"]], [False])

    def test_former_names_are_understood(self):
        said = seiche("list", "--claims", "slope_run_up_2d", "--set", "beyond_folds=false")
        self.assertEqual(said.returncode, 0, said.stderr)

    def test_a_published_set_cannot_be_changed(self):
        run = ["run", "dry_dam_break", "--as"]
        self.refused(seiche(*run, "bzz-fig-12", "--out", self.out), "bzz-fig-12", "must be one of bzz-fig-6")
        self.refused(seiche("run", "riemann", "--as", "bzz-fig-6", "--out", self.out), "riemann", "has none")
        self.assertEqual(seiche(*run, "bzz-fig-6", "--set", "particles=10", "--out", self.out).returncode, 0)

    def test_evidence_is_compared_with_a_record(self):
        self.assertEqual(seiche("run", "bore_reflection", "--out", self.out).returncode, 0)
        refused = seiche("record", self.out, "--out", self.out / "quick.csv")
        self.assertEqual(refused.returncode, 3)
        self.assertIn("dry_dam_break: no finished record", refused.stderr)
        self.assertFalse((self.out / "quick.csv").exists())
        # A longer tier comes in parts: other runs that the tier still makes stay, with the commit that made them.
        self.assertEqual(seiche("run", "bore_reflection", "--tier", "full", "--out", self.out / "long").returncode, 0)
        table, runs = self.out / "full.csv", self.out / "long_runs.csv"
        others = [",,c,bound,1,,0,2,,pass", ",gone,c,bound,1,,0,2,,pass"]
        table.write_text("case,set,claim,kind,measured,uncertainty,expected,limit,band,verdict\n"
                         + "".join(f"{case}{row}\n" for case in ("bore_reflection", "moving_bore", "no_case") for row in others))
        runs.write_text("tier,case,set,commit,date,seconds\n" + "".join(
            f"full,{case},,0a1b2c3d,2026-01-01,9\n" for case in ("bore_reflection", "moving_bore", "no_case")))
        self.assertEqual(seiche("record", self.out / "long", "--tier", "full", "--out", table).returncode, 0)
        rows = [line.split(",")[:3] for line in table.read_text().splitlines()]
        self.assertEqual([row for row in rows if row[0] not in ("case", "bore_reflection")], [["moving_bore", "", "c"]])
        self.assertIn(["bore_reflection", "", "mass"], rows)
        self.assertNotIn(["bore_reflection", "", "c"], rows)  # of the run before
        kept = [line.split(",") for line in runs.read_text().splitlines()[1:]]
        self.assertEqual([(row[1], row[3] == "0a1b2c3d") for row in kept], [("bore_reflection", False), ("moving_bore", True)])
        # The table of one record, from the command's own comparison with an empty one.
        table = self.out / "one.csv"
        header = "case,set,claim,kind,measured,uncertainty,expected,limit,band,verdict\n"
        table.write_text(header)
        claims = self.record("bore_reflection")["claims"]
        told = seiche("compare", self.out, "--record", table)
        self.assertEqual(told.returncode, 1)
        self.assertEqual(told.stdout.count("new, "), len(claims))
        # Claims of a case that did not run.
        other = "riemann,,depth,bound,0.1,,0,1,,pass\n"

        def row(claim, **changes):
            c = {"measured": claim["measured"], "verdict": ("declared " if claim["declared"] == "fail" else "")
                 + claim["verdict"], **changes}
            text = [c["measured"], claim["uncertainty"], claim["expected"], claim["criterion"]["limit"],
                    (claim["declared_band"] or [None, None])[1]]
            numbers = ",".join("" if number is None else repr(number) for number in text)
            return f"bore_reflection,bzz-fig-15,{claim['id']},{claim['criterion']['kind']},{numbers},{c['verdict']}\n"

        table.write_text(header + "".join(map(row, claims)) + other)
        same = seiche("compare", self.out, "--record", table)
        self.assertEqual(same.returncode, 0, same.stdout)
        self.assertIn("1 claims of other runs not compared", same.stdout)
        whole = seiche("compare", self.out, "--record", table, "--whole")
        self.assertEqual(whole.returncode, 1)
        self.assertIn("riemann depth: no longer there", whole.stdout)
        table.write_text(header + row(claims[0], measured=1e3) + row(claims[1], verdict="fail") + "".join(map(row, claims[3:]))
                         + row(claims[3]).replace(claims[3]["id"], "old"))
        told = seiche("compare", self.out, "--record", table)
        self.assertEqual(told.returncode, 1)
        for words in (f"{claims[0]['id']}: measured 1000 -> ", f"{claims[1]['id']}: verdict fail -> pass",
                      f"{claims[2]['id']}: new, ", "old: no longer there"):
            self.assertIn(words, told.stdout)
        self.assertEqual(seiche("compare", self.out, "--record", self.out / "none.csv").returncode, 2)

    def test_arrays_describe_themselves(self):
        import h5py

        seiche("run", "riemann", "--set", "particles=40", "--out", self.out)
        with h5py.File(self.out / "riemann.h5") as file:
            arrays = []
            file.visititems(lambda name, node: arrays.append(node) if isinstance(node, h5py.Dataset) else None)
            self.assertTrue(arrays)
            for array in arrays:
                self.assertLessEqual({"name", "unit", "meaning"}, set(array.attrs))

    def test_a_case_that_is_named_twice_runs_once(self):
        result = seiche("run", "riemann", "riemann", "--out", self.out)
        self.assertEqual((result.returncode, result.stdout.count("riemann")), (0, 1), result.stdout + result.stderr)

    def test_same_input_gives_same_numbers(self):
        first, second = self.out / "a", self.out / "b"
        for out in (first, second):
            seiche("run", "riemann", "--set", "particles=60", "--out", out)
        self.assertEqual((first / "riemann.h5").read_bytes(), (second / "riemann.h5").read_bytes())

    def test_wrong_input_is_refused_with_name_value_and_range(self):
        run = lambda *words: seiche("run", *words, "--out", self.out)
        self.refused(run("riemann", "--set", "particels=40"), "particels", "particles")
        self.refused(run("riemann", "--set", "left_depth=-1"), "left_depth", "-1", "[0")
        self.refused(run("riemann", "--set", "left_depth=nan"), "left_depth", "nan")
        self.refused(run("riemann", "--set", "left_depth=inf"), "left_depth", "inf")
        self.refused(run("riemann", "--set", "left_depth=1m"), "left_depth", "1m")
        self.refused(run("riemann", "--set", "left_depth="), "left_depth")
        self.refused(run("riemann", "--set", "particles=2.5"), "particles", "2.5")
        self.refused(run("riemann", "--set", "particles=3"), "particles", "3")
        self.refused(run("riemann", "--set", "scheme=euler"), "scheme", "euler", "H2")
        self.refused(run("riemann", "--set", "jump=1e9"), "jump")
        self.refused(run("riemann", "--set", "left_depth=0", "--set", "right_depth=0"), "depth")

    def test_resume_keeps_numbers_and_renews_the_article(self):
        words = ["run", "moving_bore", "--resume", "--out", self.out]
        seiche(*words)
        record = self.record("moving_bore")
        stale = {**record, "article": "An older text.", "wall_time": 1234.5}
        (self.out / "moving_bore.json").write_text(sealed(stale))
        result = seiche(*words)
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        self.assertIn("kept", result.stdout)
        renewed = self.record("moving_bore")
        self.assertNotEqual(renewed.pop("digest"), record.pop("digest"))
        self.assertEqual(renewed, {**record, "wall_time": 1234.5})
        # Another fingerprint is another computation.
        (self.out / "moving_bore.json").write_text(sealed({**stale, "fingerprint": "0" * 64}))
        self.assertNotIn("kept", seiche(*words).stdout)
        self.assertNotEqual(self.record("moving_bore")["wall_time"], 1234.5)

    def test_configuration_file(self):
        config = self.folder / "case.toml"
        config.write_text("particles = 50\n[riemann]\nright_depth = 0.5\n")
        result = seiche("run", "riemann", "--config", config, "--set", "particles=60", "--out", self.out)
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        values = self.record("riemann")["parameters"]
        self.assertEqual((values["particles"]["value"], values["right_depth"]["value"]), (60, 0.5))

    def test_wrong_configuration_is_refused_with_its_line(self):
        config = self.folder / "case.toml"
        for text, words in [("[riemann]\nparticles = 'many'\n", ["line 2", "particles", "many"]),
                            ("[riemann]\nparticles = [1, 2]\n", ["line 2", "particles"]),
                            ("particles = \n", ["line 1"]),
                            ("[rieman]\nparticles = 50\n", ["rieman"])]:
            config.write_text(text)
            self.refused(seiche("run", "riemann", "--config", config, "--out", self.out), *words)
        self.refused(seiche("run", "riemann", "--config", self.out / "none.toml", "--out", self.out), "none.toml")

    def test_a_folder_that_cannot_be_written_is_status_3(self):
        self.out.parent.mkdir(exist_ok=True)
        self.out.write_text("a file, not a folder")
        self.assertEqual(seiche("run", "riemann", "--out", self.out).returncode, 3)

    def test_compare_tells_what_got_worse(self):
        seiche("run", "riemann", "--out", self.out / "a")
        seiche("run", "riemann", "--set", "particles=30", "--out", self.out / "b")
        same = seiche("compare", self.out / "a", self.out / "a")
        self.assertEqual(same.returncode, 0, same.stdout)
        other = seiche("compare", self.out / "a", self.out / "b")
        self.assertIn("riemann", other.stdout)
        seiche("run", "moving_bore", "--out", self.out / "b")
        (self.out / "b" / "riemann.json").unlink()
        self.assertEqual(seiche("compare", self.out / "a", self.out / "b").returncode, 1)
        # Without a record there is nothing that could be worse.
        (self.out / "empty").mkdir()
        for name in ("empty", "none"):
            folder = self.out / name
            for words in (["report", folder], ["compare", folder], ["compare", folder, "--record"],
                          ["compare", self.out / "a", folder], ["compare", folder, self.out / "a"]):
                result = seiche(*words)
                self.assertEqual((result.returncode, result.stdout), (2, ""), words)
                self.assertEqual(len(result.stderr.splitlines()), 1, result.stderr)
                self.assertIn(str(folder), result.stderr)
            self.assertEqual(list(folder.glob("*")), [])

    def test_compare_names_an_error_that_grew_within_its_limit(self):
        seiche("run", "riemann", "--set", "particles=40", "--out", self.out)
        later = self.folder / "later"
        shutil.copytree(self.out, later)
        record = self.record("riemann")
        (later / "riemann.json").write_text(sealed(record))
        self.assertEqual(seiche("compare", self.out, later).returncode, 0)
        grown = next(claim for claim in record["claims"]
                     if claim["criterion"]["kind"] == "bound" and claim["measured"] and claim["verdict"] == "pass")
        grown["measured"] = grown["expected"] + 1.5 * (grown["measured"] - grown["expected"])
        (later / "riemann.json").write_text(sealed(record))
        result = seiche("compare", self.out, later)
        self.assertEqual(result.returncode, 1, result.stdout)
        self.assertIn(", worse", result.stdout)
        self.assertIn("something got worse", result.stdout)
        self.assertEqual(seiche("compare", self.out, later, "--factor", 2).returncode, 0)
        self.assertEqual(seiche().returncode, 2)
        for factor in ("nan", "0.5", "inf", "x"):
            result = seiche("compare", later, later, "--factor", factor)
            self.assertEqual(result.returncode, 2)
            self.assertIn(factor, result.stderr)

    def test_output_that_cannot_be_written_is_status_3(self):
        for words in (["list"], ["run", "riemann", "--out", str(self.out)], ["score", "riemann", "--template"],
                      ["exact", "riemann"], ["compare", str(self.out), str(self.out)]):
            with open("/dev/full", "w") as full:
                result = subprocess.run([SEICHE, *words], stdout=full, stderr=subprocess.PIPE, text=True, timeout=120)
            self.assertEqual(result.returncode, 3, f"{words}: {result.stderr}")
            self.assertRegex(result.stderr, "No space left|cannot be written")

    def test_the_date_of_a_record_is_universal_time(self):
        before = time.time()
        seiche("run", "riemann", "--out", self.out, env={**os.environ, "TZ": "America/New_York"})
        date = datetime.datetime.fromisoformat(self.record("riemann")["provenance"]["date"].replace("Z", "+00:00"))
        self.assertLess(abs(date.timestamp() - before), 600)

    def test_a_case_without_a_quick_tier_runs_in_its_own(self):
        with subprocess.Popen([SEICHE, "run", "mach_reflection_convergence", "--out", str(self.out)],
                              stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True) as process:
            first = process.stderr.readline()
            process.terminate()
        self.assertIn("no quick tier", first)

    def test_a_mesh_that_folds_at_once_is_a_verdict(self):
        result = seiche("run", "wall_run_up_mesh", "--set", "h1=2", "--set", "rows=1", "--set", "tau=0.5",
                        "--set", "scheme=conservative", "--set", "hourglass=2", "--out", self.out)
        self.assertNotIn("signal", result.stdout + result.stderr)

    def test_exact_prints_header_and_rows(self):
        result = seiche("exact", "riemann", "--set", "right_depth=0.1", "--grid", "x=-1:1:5,t=0.1")
        self.assertEqual(result.returncode, 0, result.stderr)
        rows = [line for line in result.stdout.splitlines() if not line.startswith("#")]
        self.assertEqual(len(rows), 6)
        self.refused(seiche("exact", "riemann", "--set", "left_depth=-1", "--at", "x=0,t=1"), "left_depth")
        self.refused(seiche("exact", "nothing"), "nothing")

    def test_what_others_are_scored_by_is_listed(self):
        listed = seiche("list", "--scores").stdout
        scores = [case["name"] for case in json.loads(seiche("list", "--json").stdout)["cases"] if case["scores"]]
        self.assertEqual([line.split(":")[0] for line in listed.splitlines() if not line.startswith(" ")], scores)
        self.assertIn("x [m], h [m], u [m/s]", listed)
        self.assertIn("seiche score thacker --template --table gauges", listed)

    def test_claims_are_listed_as_json(self):
        claims = json.loads(seiche("list", "moving_bore", "--json").stdout)
        shown = seiche("list", "moving_bore").stdout
        self.assertEqual([line for line in shown.splitlines() if not line.startswith(" ")], [one["id"] for one in claims])
        for one in claims:
            self.assertTrue(all(one[key] for key in ("text", "quantity", "unit", "criterion", "reason")), one)

    def test_lists_solve_nothing(self):
        def least(*words):
            spent = []
            for _ in range(5):
                before = resource.getrusage(resource.RUSAGE_CHILDREN)
                self.assertEqual(seiche(*words).returncode, 0)
                after = resource.getrusage(resource.RUSAGE_CHILDREN)
                spent.append(after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime)
            return min(spent)

        plain = least("list")
        for words in (["list", "--scores"], ["score", "riemann", "--template"], ["--help"]):
            # An overturning wave, which a case describes, takes 2.5 s; reading what is recorded of them a hundredth.
            self.assertLess(least(*words), plain + 0.1, words)

    def test_a_python_without_h5py_is_named(self):
        self.assertEqual(seiche("run", "riemann", "--out", self.out).returncode, 0)
        python = self.folder / "python-without"
        python.write_text("#!/bin/sh\nexec /usr/bin/python3 -c 'import sys, runpy; sys.modules[\"h5py\"] = None; "
                          "del sys.argv[0]; runpy.run_path(sys.argv[0], run_name=\"__main__\")' \"$@\"\n")
        python.chmod(0o755)
        result = seiche("report", self.out, env={**os.environ, "SEICHE_PYTHON": str(python)})
        self.assertEqual(result.returncode, 2, result.stdout + result.stderr)
        for word in ("h5py", "python3", "SEICHE_PYTHON"):
            self.assertIn(word, result.stderr)

    def test_a_missing_time_is_not_zero(self):
        for words in (("--at", "x=0"), ("--grid", "x=-1:1:5"), ("--at", "x=0,t=1", "--at", "x=0")):
            self.refused(seiche("exact", "riemann", *words), "t is missing", "t=0")
        self.assertEqual(seiche("exact", "steady_bump", "--at", "x=0").returncode, 0)

    def test_what_is_mistyped_is_suggested(self):
        self.refused(seiche("scroe", "riemann"), "scroe", "did you mean score?")
        self.refused(seiche("score", "rieman", "--template"), "rieman", "did you mean riemann?")
        self.refused(seiche("exact", "solitery"), "solitery", "did you mean solitary?")

    def test_exact_in_three_formats_says_the_same(self):
        words = ("exact", "solitary", "--set", "amplitude=0.3", "gravity=1", "--at", "x=1,y=-0.5,t=0", "--integrals")
        text = seiche(*words).stdout
        row = [float(word) for word in text.splitlines()[-1].split(",")]
        document = json.loads(seiche(*words, "--format", "json").stdout)
        self.assertEqual(document["rows"], [row])
        self.assertAlmostEqual(document["scalars"]["F"], 1.13752301663104, delta=1e-14)
        file = self.folder / "wave.h5"
        result = seiche(*words, "--format", "hdf5", "--out", file)
        self.assertEqual(result.returncode, 0, result.stderr)
        import h5py

        with h5py.File(file) as saved:
            self.assertEqual([saved[name][0] for name in ("x", "y", "t", "eta", "u", "v")], row)
            self.assertEqual(saved["scalars/F"][0], document["scalars"]["F"])

    def test_exact_leaves_points_outside_the_fluid_to_the_user(self):
        self.refused(seiche("exact", "solitary", "--at", "x=0,y=0.5,t=0"), "y", "0.5")
        self.refused(seiche("exact", "solitary", "--set", "amplitude=0.9"), "amplitude", "0.833")
        grid = seiche("exact", "solitary", "--grid", "x=0:1:2,y=-0.5:0.5:2,t=0")
        self.assertEqual(grid.returncode, 0, grid.stderr)
        self.assertEqual(sum("nan" in line for line in grid.stdout.splitlines()), 2)

    def test_exact_lists_and_tests_itself(self):
        listing = seiche("exact", "list").stdout
        for name in ("airy", "frank_dispersion", "solitary", "stokes", "standing", "overturning_wave", "wavemaker"):
            self.assertIn(f"\n{name}: ", "\n" + listing)
        result = seiche("exact", "solitary", "--self-test")
        self.assertEqual(result.returncode, 0, result.stdout)
        for dry in ("left_depth=0", "right_depth=0"):
            result = seiche("exact", "riemann", "--set", dry, "--self-test")
            self.assertEqual(result.returncode, 0, result.stdout)
            self.assertRegex(result.stdout, "2c is constant")
        result = seiche("exact", "solitary", "--self-test")
        self.assertRegex(result.stdout, r"3 V = \(F\^2 - 1\) M: residual \S+, accuracy \S+ ")

if __name__ == "__main__":
    unittest.main()
