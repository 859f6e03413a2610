"""The files of planted defects: each is complete and its text stands in the source once, and nothing goes without."""

import collections
import csv
import os
import pathlib
import sys
import tempfile
import tomllib
import unittest
from unittest import mock

SOURCE = pathlib.Path(os.environ["SEICHE_SOURCE"])
sys.path.insert(0, str(SOURCE / "verification/defects"))

import defects  # noqa: E402
import noticing  # noqa: E402
import plant  # noqa: E402

FEWEST = 4  # of each thing that can be broken
COMPLETE = """what = "a"
of = "b"
file = "LICENSE"
text = "MIT License"
replacement = "No License"
check = "verification/linear/tridiagonal_test.cpp"
claim = "record: id"
"""


class Files(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.all = defects.all_defects()

    def test_there_are_enough_of_each(self):
        self.assertGreaterEqual(len(self.all), 60)
        counts = collections.Counter((defect.room, defect.of) for defect in self.all
                                     if defect.room != "reference_data")
        few = {what: count for what, count in counts.items() if count < FEWEST}
        self.assertEqual(few, {}, f"fewer than {FEWEST}")

    def test_every_model_has_some(self):
        models = {path.name for path in (SOURCE / "solver/seiche/models").iterdir() if path.is_dir()}
        # Parts that models share lie outside their folders: there `of` tells whose they are.
        broken = collections.Counter(pathlib.PurePath(defect.file).parts[3]
                                     if defect.file.startswith("solver/seiche/models/") else defect.of
                                     for defect in self.all)
        if broken:
            for model in models:
                self.assertGreaterEqual(broken[model], FEWEST, model)

    def test_the_record_is_of_defects_that_are_there(self):
        with (SOURCE / "reports/record/defects.csv").open(newline="") as file:
            rows = list(csv.DictReader(file))
        known = {defect.name for defect in self.all}
        self.assertEqual(sorted({row["defect"] for row in rows} - known), [])
        self.assertEqual([row["defect"] for row in rows if row["verdict"] == "not found"], [])


class Reading(unittest.TestCase):
    def read(self, text):
        with tempfile.TemporaryDirectory() as folder, mock.patch.object(defects, "FOLDER", pathlib.Path(folder)):
            path = pathlib.Path(folder) / "a.toml"
            path.write_text(text)
            return defects.read(path)

    def test_a_complete_file_is_read(self):
        defect = self.read(COMPLETE)
        self.assertTrue(defect.broken().startswith("No License"))
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
        with self.assertRaises(tomllib.TOMLDecodeError):
            self.read("what = ")


class Finding(unittest.TestCase):
    """What counts as found, and what does not."""

    def compare(self, sound, broken):
        check = defects.Check("verification/linear/tridiagonal_test.cpp")
        defect = defects.Defect("a/b", "", "", "", "", "", check, claim="record: id")
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
