"""The sizes at which long cases run under sanitizers are accepted by the cases, and not those of the quick tier."""

import json
import os
import pathlib
import subprocess
import tomllib
import unittest

SIZES = pathlib.Path(os.environ["SEICHE_SOURCE"]) / "ci/checks/sanitize_sizes.toml"


class Sizes(unittest.TestCase):
    def test_accepted(self):
        listed = subprocess.run([os.environ["SEICHE"], "list", "--json"], capture_output=True, text=True, check=True)
        cases = {case["name"]: {one["name"]: one for one in case["parameters"]}
                 for case in json.loads(listed.stdout)["cases"]}
        for case, values in tomllib.loads(SIZES.read_text(encoding="utf-8")).items():
            self.assertIn(case, cases)
            self.assertTrue(values)
            for name, value in values.items():
                with self.subTest(case=case, parameter=name):
                    parameter = cases[case][name]
                    self.assertLessEqual(parameter["lowest"], value)
                    self.assertLessEqual(value, parameter["highest"])
                    self.assertNotEqual(parameter["default"]["quick"], value)


if __name__ == "__main__":
    unittest.main()
