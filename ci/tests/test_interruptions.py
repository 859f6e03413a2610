"""What is interrupted, changed afterwards, taken twice or aimed at the wrong place ends in a result or a sentence."""

import json
import os
import pathlib
import resource
import shutil
import signal
import stat
import subprocess
import time
import unittest

from sealing import sealed
from submitting import SEICHE, Scratch, seiche

QUICK = ["run", "riemann", "--set", "particles=40"]


def children_of(process):
    found = []
    for entry in pathlib.Path("/proc").glob("[0-9]*/stat"):
        try:
            fields = entry.read_text().rsplit(")", 1)[1].split()
        except OSError:
            continue  # ended meanwhile
        if int(fields[1]) == process.pid:
            found.append(int(entry.parent.name))
    return found


class Interruptions(Scratch):
    def setUp(self):
        super().setUp()
        self.json = self.out / "riemann.json"

    def run_once(self, *words, out=None):
        result = seiche(*QUICK, *words, "--out", out or self.out)
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        return result

    def test_a_run_is_stopped_after_the_most_seconds(self):
        result = seiche("run", "lake_at_rest_1d", "--set", "time=1000000", "--most-seconds", "1", "--out", self.out)
        self.ends(result, 3, "time limit of 1 s")
        record = json.loads((self.out / "lake_at_rest_1d.json").read_text())
        self.assertEqual(record["status"], "error")
        self.assertRegex(record["error"], r"time limit of 1 s, \d+ % done")
        self.assertEqual([claim["verdict"] for claim in record["claims"] if claim["verdict"] != "error"], [])

    def ends(self, result, status, *words):
        text = result.stdout + result.stderr
        self.assertEqual(result.returncode, status, text)
        for word in words:
            self.assertIn(word, text)

    def test_resume_keeps_only_what_is_as_it_was_written(self):
        self.run_once()
        self.assertIn("kept", self.run_once("--resume").stdout)
        arrays = self.out / "riemann.h5"
        other = self.folder / "other"
        self.assertEqual(seiche("run", "riemann", "--set", "particles=44", "--out", other).returncode, 0)
        first = arrays.read_bytes()

        def lost():
            arrays.unlink()

        def exchanged():
            shutil.copy(other / "riemann.h5", arrays)

        def edited():
            text = self.json.read_text()
            self.json.write_text(text.replace('"measured": ', '"measured": 1', 1))

        def without_digest():
            record = json.loads(self.json.read_text())
            del record["digest"]
            self.json.write_text(json.dumps(record, indent=1) + "\n")

        for spoilt in (lost, exchanged, edited, without_digest):
            spoilt()
            with self.subTest(spoilt.__name__):
                self.assertNotIn("kept", self.run_once("--resume").stdout)
                self.assertEqual(arrays.read_bytes(), first)
                self.assertIn("kept", self.run_once("--resume").stdout)

    def test_compare_and_report_see_what_was_changed(self):
        self.run_once()
        changed = self.folder / "changed"
        shutil.copytree(self.out, changed)
        (changed / "riemann.h5").write_bytes(b"something else")
        self.ends(seiche("compare", self.out, changed), 1, "riemann.h5 is not the file", "something got worse")
        report = seiche("report", changed, "--jobs", 1)
        self.ends(report, 0)
        self.assertIn("riemann.h5 is not the file", (changed / "report/provenance.html").read_text())
        record = changed / "riemann.json"
        record.write_text(record.read_text().replace('"wall_time": ', '"wall_time": 1', 1))
        self.ends(seiche("compare", self.out, changed), 1, "changed after it was written")
        self.ends(seiche("report", changed, "--jobs", 1), 0, "1 broken record")
        self.ends(seiche("compare", self.out, self.out), 0)

    def test_a_record_without_a_digest_is_said(self):
        self.run_once()
        record = json.loads(self.json.read_text())
        del record["digest"]
        self.json.write_text(json.dumps(record))
        self.ends(seiche("compare", self.out, self.out), 0, "carry no digest")
        self.ends(seiche("report", self.out, "--jobs", 1), 0)
        self.assertIn("carries no digest", (self.out / "report/provenance.html").read_text())

    def test_a_second_writer_is_told(self):
        slow = ["run", "lake_at_rest_1d", "--set", "time=1000000", "--out", self.out]
        with subprocess.Popen([SEICHE, *map(str, slow)], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE) as first:
            for _ in range(500):
                if (self.out / ".lake_at_rest_1d.lock").exists():
                    break
                time.sleep(0.01)
            self.ends(seiche(*slow), 3, "lake_at_rest_1d.json", "written by another process", "--out")
            self.run_once()     # another record may be written meanwhile
            first.send_signal(signal.SIGINT)
            first.communicate()
        self.assertEqual([path.name for path in self.out.glob(".*")], [])

    def test_what_a_killed_writer_left_goes(self):
        self.run_once()
        for name in (".riemann.json.4242.part", ".riemann.h5.4242.part", ".riemann.lock"):
            (self.out / name).write_text("half of")
        self.run_once("--resume")
        self.assertEqual([path.name for path in self.out.glob(".*")], [])

    def test_a_refused_rerun_leaves_no_record_that_looks_current(self):
        self.run_once()
        refused = seiche("run", "riemann", "--set", "left_depth=0", "--set", "right_depth=0", "--out", self.out)
        self.ends(refused, 2, "depth", "riemann.json.earlier")
        self.assertFalse(self.json.exists())
        self.assertTrue((self.out / "riemann.json.earlier").exists())
        self.assertNotIn('"riemann', (self.out / "junit.xml").read_text())
        self.assertNotIn(".riemann", (self.out / "junit.xml").read_text())

    def test_a_file_that_may_not_grow_is_a_sentence(self):
        limit = lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (4096, 4096))
        # Where lines are counted the counts would be cut off too: they go where nobody reads them.
        limited = {"preexec_fn": limit, "env": os.environ | {"GCOV_PREFIX": str(self.folder / "counts")}}
        result = seiche("exact", "riemann", "--grid", "x=-1:1:4000,t=1", "--out", self.folder / "big.csv", **limited)
        self.ends(result, 3, "big.csv", "too large")
        self.ends(seiche(*QUICK, "--out", self.out, **limited), 3, "cannot write")
        left = [path.name for path in [*self.folder.glob(".*"), *self.out.glob(".*")]]
        self.assertEqual(left, [])

    def test_only_files_are_replaced(self):
        pipe, link, target = (self.folder / name for name in ("pipe", "link", "target"))
        os.mkfifo(pipe)
        link.symlink_to(target)
        words = ["exact", "riemann", "--at", "x=0,t=1", "--out"]
        self.ends(seiche(*words, pipe), 3, "pipe")
        self.ends(seiche(*words, link), 3, "symbolic link")
        self.ends(seiche(*words, "/dev/null"), 3, "/dev/null", "device")
        self.assertTrue(stat.S_ISFIFO(pipe.lstat().st_mode))
        self.assertTrue(stat.S_ISCHR(os.lstat("/dev/null").st_mode))
        self.assertTrue(link.is_symlink())
        self.assertFalse(target.exists())
        self.ends(seiche(*words, target), 0)
        self.ends(seiche(*words, target), 0)    # a file is

    def test_streams_that_are_closed(self):
        shell = lambda text: subprocess.run(["bash", "-c", text], capture_output=True, text=True, timeout=60)
        self.assertEqual(shell(f"{SEICHE} run nothing 2>&-").returncode, 2)
        self.assertEqual(shell(f"{SEICHE} run nothing 2>/dev/full").returncode, 2)
        self.ends(shell(f"{SEICHE} list >&-"), 3)
        self.assertEqual(shell(f"{SEICHE} list <&-").returncode, 0)
        # No file of ours takes the place of a stream.
        self.assertEqual(shell(f"{SEICHE} {' '.join(QUICK)} --out {self.out} <&- 2>&-").returncode, 0)
        self.assertIn("kept", self.run_once("--resume").stdout)

    def test_escape_sequences_stay_in_their_files(self):
        self.run_once()
        record = json.loads(self.json.read_text())
        evil = "\x1b]0;owned\x07\x1b[2J\u009b31m"
        record["claims"][0]["id"] += evil
        record["solver"] += evil
        other = self.folder / "other"
        other.mkdir()
        (other / "riemann.json").write_text(sealed(record))
        for words in (["compare", self.out, other], ["compare", other], ["compare", other, "--record"]):
            result = seiche(*words)
            for character in "\x1b\x07\u009b":
                self.assertNotIn(character, result.stdout + result.stderr)
        name = self.folder / f"x{evil}.csv"
        name.write_text("x,h,u\n0,1\n")
        result = seiche("score", "riemann", "--data", name, "--out", self.out)
        self.ends(result, 2, "line 2")
        self.assertNotIn("\x1b", result.stdout + result.stderr)

    def test_a_limit_of_time_holds_before_anything_is_done(self):
        begin = time.monotonic()
        result = seiche("run", "wavemaker_start", "--set", "period=190", "--most-seconds", 1, "--out", self.out)
        self.ends(result, 3, "time limit of 1 s, 0 % done")
        self.assertLess(time.monotonic() - begin, 60)
        self.assertEqual(json.loads((self.out / "wavemaker_start.json").read_text())["status"], "error")

    def test_deep_tables_are_refused(self):
        config = self.folder / "deep.toml"
        for text in ("a=" + "[" * 40000, "a=" + "{a=" * 40000, "[" + "a." * 200000 + "a]", "a." * 200000 + "a = 1"):
            config.write_text(text)
            for words in (["run", "riemann", "--out", self.out], ["score", "riemann", "--template"]):
                self.ends(seiche(*words, "--config", config), 2, "deep.toml: ")


class Killed(Scratch):
    # A run long enough to be caught in the act.
    LONG = ["riemann", "--set", "particles=4000", "--set", "time_step=0.00005", "--set", "time=5"]

    def test_a_killed_case_is_an_error_and_the_others_go_on(self):
        run = subprocess.Popen([SEICHE, "run", "riemann", "bore_reflection", "--set", "particles=1000", "--set",
                                "time_step=0.001", "--set", "time=2.6", "--jobs", "2", "--out", self.out],
                               stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        victims = []
        for _ in range(200):
            victims = children_of(run)
            if victims:
                break
            time.sleep(0.02)
        self.assertTrue(victims, "no child process was seen")
        os.kill(min(victims), signal.SIGKILL)
        output, _ = run.communicate(timeout=120)
        self.assertEqual(run.returncode, 3, output)
        records = {name: self.record(name) for name in ("riemann", "bore_reflection")}
        states = sorted(record["status"] for record in records.values())
        self.assertIn("error", states)
        errors = [record["error"] for record in records.values() if record["status"] == "error"]
        self.assertTrue(any("signal 9" in error for error in errors), errors)
        self.assertTrue(all(record["wall_time"] > 0 for record in records.values()), records)
        self.assertEqual([p.name for p in self.out.glob(".*")], [])

    def test_resume_after_kill_redoes_only_what_is_not_finished(self):
        seiche("run", "riemann", "--out", self.out)
        stamp = (self.out / "riemann.json").stat().st_mtime_ns
        run = subprocess.Popen([SEICHE, "run", *self.LONG, "--out", self.out / "other"], stdout=subprocess.DEVNULL)
        time.sleep(0.3)
        run.kill()
        run.wait()
        time.sleep(0.2)
        self.assertFalse((self.out / "other" / "riemann.json").exists())
        result = seiche("run", "riemann", "stationary_jump", "--resume", "--out", self.out)
        self.assertIn(result.returncode, (0, 1), result.stdout)
        self.assertIn("kept", result.stdout)
        self.assertEqual((self.out / "riemann.json").stat().st_mtime_ns, stamp)
        self.assertTrue((self.out / "stationary_jump.json").exists())
        # Another value is another run.
        seiche("run", "riemann", "--set", "particles=44", "--resume", "--out", self.out)
        self.assertNotEqual((self.out / "riemann.json").stat().st_mtime_ns, stamp)

    def killed_when(self, kept, *words):
        """Kills a run once `kept(files)` holds of its checkpoints, and returns their names."""
        run = subprocess.Popen([SEICHE, "run", *words, "--checkpoint-every", "0", "--out", str(self.out)],
                               stdout=subprocess.DEVNULL)
        files = []
        for _ in range(6000):
            files = sorted(p.name for p in self.out.glob(".checkpoints/*/*.checkpoint"))
            if kept(files) or run.poll() is not None:
                break
            time.sleep(0.01)
        self.assertIsNone(run.poll(), "the run ended before it could be killed")
        children = children_of(run)
        run.kill()
        run.wait()
        for _ in range(500):  # children die with their parent
            if not any(pathlib.Path(f"/proc/{child}").exists() for child in children):
                break
            time.sleep(0.01)
        self.assertEqual(list(self.out.glob("*.json")), [])
        return files

    def goes_on_after_a_kill(self, kept, *words):
        """A run that is killed and resumed writes the same arrays as one that is left alone."""
        whole = seiche("run", *words, "--out", self.folder / "whole")
        self.assertIn(whole.returncode, (0, 1), whole.stdout + whole.stderr)
        files = self.killed_when(kept, *words)
        resumed = seiche("run", *words, "--resume", "--out", self.out)
        self.assertEqual(resumed.returncode, whole.returncode, resumed.stdout + resumed.stderr)
        for array in (self.folder / "whole").glob("*.h5"):
            self.assertEqual(array.read_bytes(), (self.out / array.name).read_bytes(), files)
        # Nothing is left beside the records.
        self.assertEqual([p.name for p in self.out.glob(".*")], [])
        return resumed.stdout

    SWEEP = ["mach_reflection_curves", "--set", "h=1.2", "--set", "time=250"]
    BREAKER = ["overturning_sph", "--set", "columns=60"]

    def test_a_sweep_goes_on_after_the_parts_that_were_finished(self):
        self.goes_on_after_a_kill(lambda files: len(files) >= 2, *self.SWEEP)

    def test_particles_go_on_in_the_midst_of_a_run_to_the_last_bit(self):
        self.goes_on_after_a_kill(lambda files: len(files) >= 3 and any("unfinished" in name for name in files),
                                  *self.BREAKER)

    def test_checkpoints_that_are_damaged_are_ignored_with_a_note(self):
        self.killed_when(lambda files: len(files) >= 2, *self.SWEEP)
        for path in self.out.glob(".checkpoints/*/*.checkpoint"):
            path.write_bytes(path.read_bytes()[:-1])
        # What reads the whole folder does not stumble over them.
        self.assertEqual(seiche("run", "thacker", "--out", self.out).returncode, 0)
        self.assertEqual(seiche("compare", self.out, self.out).returncode, 0)
        self.assertIn("damaged checkpoints", seiche("run", *self.SWEEP, "--resume", "--out", self.out).stdout)
        self.assertEqual([p.name for p in self.out.glob(".*")], [])


if __name__ == "__main__":
    unittest.main()
