"""The tables of seeded faults: each is complete and its text stands in the source once."""

import csv
import os
import pathlib
import sys
import tempfile
import tomllib
import unittest

SOURCE = pathlib.Path(os.environ["SEICHE_SOURCE"])
sys.path.insert(0, str(SOURCE / "verification/mutants"))

import defects  # noqa: E402
import noticing  # noqa: E402
import plant  # noqa: E402

COMPLETE = """what = "a"
file = "LICENSE"
text = "MIT License"
replacement = "No License"
check = "verification/linear/tridiagonal_test.cpp"
claim = "record: id"
"""


class Files(unittest.TestCase):
    def test_the_record_is_of_defects_that_are_there(self):
        with (SOURCE / "reports/record/defects.csv").open(newline="") as file:
            rows = list(csv.DictReader(file))
        known = {defect.name for defect in defects.all_defects()}
        self.assertTrue(known)
        self.assertLessEqual(len(known), 150)
        self.assertEqual(sorted({row["defect"] for row in rows} - known), [])
        self.assertEqual([row["defect"] for row in rows if row["verdict"] == "not found"], [])


class Reading(unittest.TestCase):
    def read(self, text):
        return defects.defect("a/b", tomllib.loads(text))

    def test_a_complete_table_is_read(self):
        for text in (COMPLETE, COMPLETE.replace("MIT License", "MIT\\n   Li  cense")):
            defect = self.read(text)
            self.assertTrue(defect.broken().startswith("No License\n"))
            self.assertEqual(defect.check.target, "verify_linear")

    def test_each_fault_is_refused(self):
        for before, after in [("MIT License", "GPL"), ("MIT License", "the"), ("No License", "MIT License"),
                              ("LICENSE", "LICENCE"), ("tridiagonal_test", "no_test"), ("record: id", "id"),
                              ('what = "a"\n', ""), ("what", "why"), ('claim = "record: id"\n', ""),
                              ('claim = "record: id"', 'claim = "record: id"\ntest = "a"'),
                              ("claim", 'set = ["a=1"]\nclaim')]:
            with self.subTest(after=after):
                self.assertIn(before, COMPLETE)
                with self.assertRaises(defects.BadDefect):
                    self.read(COMPLETE.replace(before, after))


class Finding(unittest.TestCase):
    """What counts as found, and what does not."""

    def compare(self, sound, broken):
        check = defects.Check("verification/linear/tridiagonal_test.cpp")
        defect = defects.Defect("a/b", "", "", "", "", check, claim="record: id")
        result = plant.Result(defect)
        try:
            plant.compare(result, sound, broken)
        except noticing.NoAnswer as trouble:
            result.trouble = str(trouble)
        return result

    def test_only_an_unexpected_verdict_of_the_named_claim_is_found(self):
        good, bad = noticing.Finding("pass", False), noticing.Finding("fail", True)
        found = self.compare({"record: id": good, "record: other": good}, {"record: id": bad, "record: other": bad})
        self.assertTrue(found.found)
        self.assertEqual(found.others, 1)
        for sound, broken in [({"record: id": good}, {"record: id": good}),
                              ({"record: id": good, "record: other": good}, {"record: id": good, "record: other": bad}),
                              ({"record: id": good}, {}), ({"record: other": good}, {"record: id": bad}),
                              ({"record: id": bad}, {"record: id": bad}),
                              (noticing.NoAnswer("crashes"), {"record: id": bad})]:
            self.assertFalse(self.compare(sound, broken).found, (sound, broken))

    def test_a_record_of_a_run_that_did_not_finish_says_nothing(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "a.json"
            path.write_text('{"case": "a", "status": "error", "error": "b", "claims": []}')
            self.assertEqual(noticing.of_record(path), {})


if __name__ == "__main__":
    unittest.main()
