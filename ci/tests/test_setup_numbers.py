"""Set-up numbers of experiments are stated by the source or derived with a reason: setup_numbers.csv."""

import csv
import pathlib
import re
import unittest

HERE = pathlib.Path(__file__).resolve().parents[2] / "validation"


class SetUpNumbers(unittest.TestCase):
    def setUp(self):
        with open(HERE / "laboratory" / "setup_numbers.csv", newline="") as file:
            self.rows = list(csv.DictReader(file))

    def test_every_number_has_a_kind_and_a_reason(self):
        for row in self.rows:
            with self.subTest(case=row["case"], number=row["number"]):
                self.assertIn(row["kind"], ("stated", "derived"))
                self.assertTrue(row["source or reason"])
                self.assertTrue(list(HERE.glob(f"*/{row['case']}.cpp")))

    def test_every_laboratory_case_with_a_model_is_listed(self):
        listed = {row["case"] for row in self.rows}
        for file in (HERE / "laboratory").glob("*.cpp"):
            text = file.read_text()
            if re.search(r"^void \w+\(Case&", text, re.M) and re.search(r"compute|_experiment\(|_in_shallow_water\(", text):
                with self.subTest(case=file.stem):
                    self.assertIn(file.stem, listed)


if __name__ == "__main__":
    unittest.main()
