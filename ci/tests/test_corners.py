"""What ci/checks/corners makes of a run: a crash, an error of the program and an empty record are told from a breakdown."""

import importlib.machinery
import importlib.util
import json
import os
import pathlib
import tempfile
import time
import types
import unittest

SCRIPT = pathlib.Path(os.environ["SEICHE_SOURCE"]) / "ci/checks/corners"
loader = importlib.machinery.SourceFileLoader("corners", str(SCRIPT))
corners = importlib.util.module_from_spec(importlib.util.spec_from_loader("corners", loader))
loader.exec_module(corners)


def became(status, text="", **record):
    with tempfile.TemporaryDirectory() as folder:
        (pathlib.Path(folder) / "riemann.json").write_text(json.dumps({"error": "", "claims": []} | record))
        process = types.SimpleNamespace(returncode=status, stdout=text, stderr="")
        return corners.outcome(process, pathlib.Path(folder), {"depth": "0"})[0]


class Corners(unittest.TestCase):
    def test_defects(self):
        found = [became(-11), became(3, error="killed by signal 11 (Segmentation fault)"),
                 became(3, error="the case made no claim"), became(3, error="vector::_M_range_check"),
                 became(2, "something went wrong"), became(1, claims=[])]
        self.assertEqual(found, ["crashed", "crashed", "no claims", "program error", "refused without a name",
                                 "no claims"])
        self.assertEqual(set(found) - set(corners.DEFECTS), set())

    def test_results(self):
        found = [became(0, claims=[{"id": "mass", "as_declared": True, "verdict": "pass"}]),
                 became(1, claims=[{"id": "mass", "as_declared": False, "verdict": "fail"}]),
                 became(2, "depth = 0 is out of range: must be in [1, 2]"),
                 became(3, error="the mesh tangles at x = 2, t = 0.7, after 17 steps"),
                 became(3, error="stopped at its time limit of 8 s, 21 % done")]
        self.assertEqual(found, ["as declared", "failed claims", "refused", "broke down", "stopped"])
        self.assertEqual(set(found) & set(corners.DEFECTS), set())

    def test_a_corner_is_the_same_each_time(self):
        cases = [{"name": "riemann", "parameters": [
            {"name": "depth", "default": {"quick": 1.0}, "lowest": 0.5, "highest": 2.0},
            {"name": "scheme", "default": {"quick": "G1"}, "choices": ["G1", "M2"]}]}]
        self.assertEqual(corners.corner(cases, "1", 7), corners.corner(cases, "1", 7))
        ends = {corners.corner(cases, "1", k)[1].get("depth") for k in range(40)}
        self.assertEqual(ends - {None}, {"0.5", "2.0"})

    def test_corners_broken_before_are_read(self):
        broken = corners.corners_broken_before()
        self.assertIn(("steady_bump", {"particles": "8", "regime": "all"}), broken)
        self.assertTrue(all(settings for _, settings in broken))

    def test_an_exact_corner_is_the_same_each_time(self):
        solutions = [{"name": "riemann", "parameters": [{"name": "depth", "minimum": "0", "maximum": "2"},
                                                        {"name": "kind", "choices": ["piston", "flap"]},
                                                        {"name": "markers", "minimum": "64", "maximum": "4096"}]}]
        drawn = [corners.exact_corner(solutions, "1", k)[1] for k in range(60)]
        self.assertEqual(drawn[7], corners.exact_corner(solutions, "1", 7)[1])
        self.assertEqual({one.get("depth") for one in drawn}, {None, "0", "2"})
        self.assertEqual({one.get("kind") for one in drawn}, {None, "piston", "flap"})
        self.assertFalse(any("markers" in one for one in drawn))

    def test_what_outlives_its_limit_is_ended_with_its_children(self):
        options = types.SimpleNamespace(most_seconds=0.2 - corners.GRACE)
        begin = time.monotonic()
        self.assertIsNone(corners.limited(options, ["sh", "-c", "sleep 60 & sleep 60"]))
        self.assertLess(time.monotonic() - begin, 10)

    def test_runs_of_the_same_seed_are_not_repeated(self):
        with tempfile.TemporaryDirectory() as folder:
            table = pathlib.Path(folder) / "corners.jsonl"
            table.write_text("".join(json.dumps({"number": k, "seed": seed, "exact": False}) + "\n"
                                     for k, seed in ((0, "1"), (3, "1"), (1, "2"), (9, "1"))))
            options = types.SimpleNamespace(only=None, table=table, seed="1", exact=False, count=5)
            self.assertEqual([one["number"] for one in corners.kept(options)], [0, 3])


if __name__ == "__main__":
    unittest.main()
