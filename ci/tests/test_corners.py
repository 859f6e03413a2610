"""What ci/corners makes of a run: a crash, an error of the program and an empty record are told from a breakdown."""

import importlib.machinery
import importlib.util
import json
import os
import pathlib
import tempfile
import types
import unittest

SCRIPT = pathlib.Path(os.environ["SEICHE_SOURCE"]) / "ci/corners"
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
                 became(3, error="the mesh folds at x = 2, t = 0.7, after 17 steps"),
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


if __name__ == "__main__":
    unittest.main()
