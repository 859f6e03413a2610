"""The schema of records, and numbers as they are set in print."""
import copy
import re
import unittest

from made import claim, figure, record

from render import quantities, records


class Schema(unittest.TestCase):
    def test_complete_records_pass(self):
        self.assertEqual(records.violations(record("a")), [])

    def test_each_change_for_the_worse_is_found(self):
        def broken(change):
            made = copy.deepcopy(record("a", figures=[figure("f")], claims=[claim("one"), claim("two", "order")]))
            change(made)
            return records.violations(made)

        for change in (lambda r: r.pop("fingerprint"), lambda r: r.update(extra=1), lambda r: r.update(case="../up"),
                       lambda r: r.update(data="../x.h5"), lambda r: r["claims"][0].update(verdict="fine"),
                       lambda r: r["claims"][0].update(declared="fail"),
                       lambda r: r["claims"][0].pop("as_declared"), lambda r: r.pop("left_out"), lambda r: r["claims"][0]["criterion"].pop("relative"),
                       lambda r: r["claims"][1]["criterion"].update(reason=""), lambda r: r["provenance"].pop("commit"),
                       lambda r: r["figures"][0].update(id="a b"), lambda r: r["measurements"].update(x="1")):
            self.assertNotEqual(broken(change), [])


class Numbers(unittest.TestCase):
    def test_numbers_are_set_as_in_print(self):
        cases = {3.8412e-15: "3.841 × 10<sup>−15</sup>", 0.0: "0", 1.0: "1", -2.5: "−2.5", 1234.56: "1235", 99999.7: "10<sup>5</sup>",
                 0.00012345: "1.234 × 10<sup>−4</sup>", 1e5: "10<sup>5</sup>", 120.0: "120", 123456.0: "1.235 × 10<sup>5</sup>", 9.99996: "10"}
        for number, expected in cases.items():
            self.assertEqual(quantities.plain(number).replace(quantities.THIN, " "), expected, number)

    def test_uncertainty_gives_the_digits(self):
        def text(*pair):
            return re.sub("<[^>]*>", "", str(quantities.with_uncertainty(*pair))).replace(quantities.THIN, " ")
        self.assertEqual(text(1.23456, 0.021), "1.235 ± 0.021")
        self.assertEqual(text(3.81e-7, 2e-9), "(3.810 ± 0.020) × 10−7")
        self.assertEqual(text(1.23456, 0.00021), "1.23456 ± 0.00021")
        self.assertEqual(text(1.23456, 0.00047), "1.2346 ± 0.0005")
        self.assertEqual(text(2.0, 0.0), "2")
        self.assertEqual(text(None, 0.1), "—")

    def test_no_uncertainty_is_rounded_by_more_than_a_sixth(self):
        for measured in (0.0, 1.23456, -9.87654321e-7, 4321.0):
            for k in range(1, 400):
                uncertainty = max(abs(measured), 1e-5) * 10 ** (1 - k / 50)
                text = re.sub("<sup>(.*?)</sup>", r"^\1", str(quantities.with_uncertainty(measured, uncertainty)))
                said = re.sub("<[^>]*>", "", text).replace(quantities.THIN, "").replace("−", "-").split("±")[1]
                shown, power = re.fullmatch(r"([\d.]+)\)?(?:×10\^(-?\d+))?", re.sub(r"^10\^", "1×10^", said)).groups("0")
                # Half a unit of one digit that is 3 or more.
                self.assertLessEqual(abs(float(shown) * 10.0 ** int(power) / uncertainty - 1), 0.5 / 3 + 1e-9, (measured, said))

    def test_full_value_is_in_the_title(self):
        self.assertIn('title="1.23456789"', str(quantities.number(1.23456789)))

    def test_units_are_upright_and_raised(self):
        self.assertIn("m<sup>3</sup>/s", str(quantities.unit("m^3/s")))
        self.assertIn(">(g H)<sup>1/2</sup>/s<", str(quantities.unit("(g H)^(1/2)/s")))
        self.assertEqual(str(quantities.unit("1")), "")


if __name__ == "__main__":
    unittest.main()
