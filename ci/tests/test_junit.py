"""junit.xml as CI systems read it: its form, its totals, and that it never says better than the exit status."""

import math
import tempfile
import unittest

from lxml import etree

import junit
from submitting import Scratch, seiche


def filled(template, h, u):
    """A template of case riemann with one depth and velocity everywhere."""
    lines = [line for line in template.splitlines() if not line.startswith("#")]
    return "\n".join([lines[0], *(f"{line.split(',')[0]},{h},{u}" for line in lines[1:])]) + "\n"


class Junit(Scratch):
    def shown(self):
        """Outcomes of the test cases of a file without faults."""
        self.assertEqual(junit.faults(self.out / "junit.xml"), [])
        return junit.outcomes(self.out / "junit.xml")

    def test_passes_and_declared_failures(self):
        result = seiche("run", "riemann", "dam_break_discharge", "--out", self.out)
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        shown = self.shown()
        self.assertIsNone(shown["dam_break.riemann", "run"])
        self.assertIsNone(shown["dam_break.riemann", "mass"])
        element, kind, message = shown["dam_break.dam_break_discharge", "critical-ratio"]
        self.assertEqual((element, kind), ("skipped", "declared fail"))
        self.assertIn("Measured 0.138", message)
        self.assertIn("Reason: ", message)

    def test_properties_hold_the_numbers(self):
        seiche("run", "riemann", "--out", self.out)
        suite = etree.parse(str(self.out / "junit.xml")).find("testsuite")
        of_run = {node.get("name"): node.get("value") for node in suite.find("properties")}
        self.assertEqual((of_run["tier"], of_run["solver"]), ("quick", "seiche"))
        self.assertGreater(float(of_run["wall_time"]), 0)
        self.assertTrue(of_run["commit"])
        depth = next(test for test in suite.iter("testcase") if test.get("name") == "depth")
        of_claim = {node.get("name"): node.get("value") for node in depth.find("properties")}
        self.assertLess(float(of_claim["measured"]), float(of_claim["limit"]))
        self.assertEqual(of_claim["uncertainty"], "not estimated")
        self.assertEqual((of_claim["unit"], of_claim["verdict"], of_claim["declared"]), ("m", "pass", "pass"))

    def test_scores_are_written_beside_our_own(self):
        seiche("run", "riemann", "--out", self.out)
        data = self.out.parent / "mine.csv"
        data.write_text(filled(seiche("score", "riemann", "--template").stdout, 0.5, 0))
        result = seiche("score", "riemann", "--data", data, "--solver", "mine", "--out", self.out)
        self.assertEqual(result.returncode, 1, result.stdout)
        shown = self.shown()
        self.assertIsNone(shown["dam_break.riemann", "depth"])
        self.assertEqual(shown["dam_break.riemann.mine", "depth"][:2], ("failure", "fail"))

    def test_inconclusive_is_a_failure(self):
        """The depth at gauges in a parabolic bowl (Thacker 1981), late by as much as its author's uncertainty of time."""
        template = seiche("score", "thacker", "--template", "--table", "gauges").stdout
        rows = [line.split(",") for line in template.splitlines() if not line.startswith("#")][1:]
        data = self.out.parent / "late.csv"
        with data.open("w") as file:
            print("x,t,h", file=file)
            for x, t in ((float(row[0]), float(row[1])) for row in rows):
                middle = 1.875 - 0.5 * math.cos(math.sqrt(9.81) * (t - 0.05))
                print(x, t, max(0.0, 0.5 * (1 - (x - middle) ** 2)), sep=",", file=file)
        result = seiche("score", "thacker", "--data", data, "--solver", "late", "--uncertainty", "t=0.05",
                        "--out", self.out)
        self.assertEqual(result.returncode, 1, result.stdout + result.stderr)
        element, kind, message = self.shown()["basin.thacker.late", "h-shift"]
        self.assertEqual((element, kind), ("failure", "inconclusive"))
        self.assertTrue(message.startswith("inconclusive, declared pass: "), message)


class Faults(unittest.TestCase):
    """The judge is judged: each change for the worse is found."""

    GOOD = """<testsuites name="seiche" tests="2" failures="1" errors="0" skipped="0" time="1.500">
      <testsuite name="a" timestamp="2026-01-02T03:04:05" tests="2" failures="1" errors="0" skipped="0" time="1.500">
        <properties><property name="tier" value="quick"/></properties>
        <testcase classname="a" name="run" time="1.500"/>
        <testcase classname="a" name="b" time="0.000"><failure type="fail" message="m">m</failure></testcase>
      </testsuite></testsuites>"""

    def faults(self, text):
        with tempfile.NamedTemporaryFile("w", suffix=".xml") as file:
            file.write(text)
            file.flush()
            return junit.faults(file.name)

    def test_each_change_for_the_worse_is_found(self):
        self.assertEqual(self.faults(self.GOOD), [])
        for before, after in [('skipped="0"', ""), ('failures="1"', 'failures="0"'), ('tests="2"', 'tests="3"'),
                              ('"1.500"', '"1.5e0"'), ('time="1.500"/>', 'time="9.000"/>'), ('name="b"', 'name="run"'),
                              ("failure", "inconclusive"), (' message="m"', ""), ("05\"", "05Z\"")]:
            with self.subTest(before=before):
                self.assertIn(before, self.GOOD)
                self.assertNotEqual(self.faults(self.GOOD.replace(before, after)), [])


if __name__ == "__main__":
    unittest.main()
