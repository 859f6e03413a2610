"""Tables read back: each column of a page holds the record's number of that name."""
import html.parser
import pathlib
import tempfile
import unittest

from made import claim, figure, record, reported, write_arrays
from render import pages, quantities


class Tables(html.parser.HTMLParser):
    """Class of a table -> its rows, each a list of the cells' texts."""

    def __init__(self, text):
        super().__init__()
        self.tables, self.rows, self.cell = [], None, None
        self.feed(text)

    def handle_starttag(self, name, attributes):
        if name == "table":
            self.rows = []
            self.tables.append((dict(attributes).get("class", ""), self.rows))
        elif name == "tr" and self.rows is not None:
            self.rows.append([])
        elif name in ("td", "th") and self.rows:
            self.cell = []

    def handle_endtag(self, name):
        if name in ("td", "th") and self.cell is not None:
            self.rows[-1].append(" ".join("".join(self.cell).split()))
            self.cell = None
        elif name == "table":
            self.rows = None

    def handle_data(self, data):
        if self.cell is not None:
            self.cell.append(data)

    def of(self, *first):
        """The table with these headings, without them."""
        return next(rows[1:] for _, rows in self.tables if rows and tuple(rows[0][:len(first)]) == first)


CLAIMS = [claim("a", "bound", measured=1.25, uncertainty=0.5, expected=1.5, unit="m",
                criterion={"kind": "bound", "limit": 0.75, "reason": "r", "relative": False}),
          claim("b", "bound", measured=2.25, expected=2.0, unit="s",
                criterion={"kind": "bound", "limit": 0.2, "reason": "r", "relative": True}),
          claim("c", "order", measured=2.125, uncertainty=0.25, expected=2.0, unit="",
                criterion={"kind": "order", "limit": 0.375, "reason": "r", "theory": 2.0, "tolerance": 0.375}),
          claim("d", "qualitative", verdict="fail", measured=0, expected=1, unit="")]
WORDS = {"particles": {"value": 12, "unit": "1", "default": 13, "meaning": "how many"},
         "depth": {"value": 0.5, "unit": "m", "default": 0.25, "meaning": "of the water"}}
TABLE = {"id": "t", "title": "t", "caption": "c", "columns": [{"name": "x", "unit": "m"}, {"name": "y", "unit": "s"}],
         "rows": [[1.5, 2.5], [3.5, None]], "atlas": []}


class CasePage(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = pathlib.Path(cls.enterClassContext(tempfile.TemporaryDirectory()))
        (folder / "evidence").mkdir()
        write_arrays(folder / "evidence/a.h5", {"f": [[("a", "computed", "line", [0, 1], [0, 1])]]})
        ours = record("numbers", claims=CLAIMS, parameters=WORDS, tables=[TABLE], data="a.h5", figures=[figure("f")],
                      measurements={"speed": 4.5, "rise": 6.5}, wall_time=75.0)
        theirs = record("numbers", solver="theirs", wall_time=30.0, measurements={"speed": 4.25, "rise": 6.25},
                        claims=[{**one, "measured": one["measured"] + 0.0625, "uncertainty": 0.0} for one in CLAIMS[:3]],
                        parameters={name: {**one, "value": one["value"] + 2} for name, one in WORDS.items()})
        report = reported(folder, ours, theirs)
        cls.pages = {str(path.relative_to(report).with_suffix("")): Tables(path.read_text(encoding="utf-8"))
                     for path in report.rglob("*.html")}
        cls.page = cls.pages["cases/numbers"]

    def rows(self, *headings, page="cases/numbers"):
        return self.pages[page].of(*headings)

    def test_claims(self):
        ours, theirs = (rows[1:] for kind, rows in self.page.tables if kind == "claims")
        # Share of the limit: 0.25 of 0.75, 0.25 of 0.2, 0.125 of 0.375.
        self.assertEqual(ours[::2], [
            ["✓pass", "Claim a holds.", "bound", "1.25 ± 0.50 m", "1.5", "± 0.75", "0.333 of the limit"],
            ["✓pass", "Claim b holds.", "bound", "2.25 s", "2", "± 0.2 (10 %)", "1.25 of the limit"],
            ["✓pass", "Claim c holds.", "order", "2.12 ± 0.25", "2", "± 0.375", "0.333 of the limit"],
            ["✗fail", "Claim d holds.", "qualitative", "absent", "present", "–", ""]])
        self.assertEqual([row[3] for row in theirs[::2]], ["1.312 m", "2.312 s", "2.188"])
        self.assertIn("Detected by: a stated detector. A reason. A source.Declared: pass.", ours[-1][1])

    def test_solvers_side_by_side(self):
        self.assertEqual(self.rows("Quantity", "Expected"), [
            ["Defect m", "1.5", "✓pass 1.25 ± 0.50", "✓pass 1.312"], ["Defect s", "2", "✓pass 2.25", "✓pass 2.312"],
            ["Defect", "2", "✓pass 2.12 ± 0.25", "✓pass 2.188"], ["Defect", "present", "✗fail absent", "not claimed"],
            ["Time", "", "1 min 15 s", "30.0 s"], ["Threads", "", "1", "not stated"]])

    def test_a_share_is_per_cent(self):
        self.assertEqual((pages.percent(0.25), pages.percent(None)), ("25\N{NO-BREAK SPACE}%", ""))

    def test_a_time_that_nobody_told_is_not_stated(self):
        self.assertEqual([quantities.duration(seconds) for seconds in (0.0, 1e-4, 75)], ["not stated", "< 1 ms", "1 min 15 s"])

    def test_parameters_measurements_tables_and_arrays(self):
        self.assertEqual(self.rows("Name", "seiche", "theirs", "Unit", "Default"), [
            ["particles", "12", "14", "", "13", "how many"], ["depth", "0.5", "2.5", "m", "0.25", "of the water"]])
        self.assertEqual(self.rows("Quantity", "seiche", "theirs"), [["speed", "4.5", "4.25"], ["rise", "6.5", "6.25"]])
        self.assertEqual(self.rows("x m", "y s"), [["1.5", "2.5"], ["3.5", "—"]])
        self.assertEqual(self.rows("Name", "Shape")[0][:3], ["depth", "3 × 4", "m"])

    def test_margins_to_the_limits(self):
        # With the uncertainty: 0.25 / 0.2; (0.25 + 0.5) / 0.75; (0.125 + 0.25) / 0.375.
        self.assertEqual([row[1:6] for row in self.rows("Case", "Claim", page="quality")], [
            ["Claim b holds.", "bound", "1.2", "2.25", "± 0.2 (10 %)"],
            ["Claim a holds.", "bound", "1", "1.25 ± 0.50", "± 0.75"],
            ["Claim c holds.", "order", "1", "2.12 ± 0.25", "± 0.375"]])
        self.assertEqual([(row[0], row[-1]) for row in self.rows("Kind", page="quality")], [("Order", "1"), ("Bound", "2")])

    def test_cases_and_solvers(self):
        self.assertEqual(self.rows("Case", "Round-off", page="cases")[1:], [
            ["The case numbers", "", "✓1pass", "✓2pass", "", "✗1fail", "1 min 15 s"],
            ["The case numbers theirs", "", "✓1pass", "✓2pass", "", "", "30.0 s"]])
        self.assertEqual([[row[0], *row[4:]] for row in self.rows("Solver", "Cell", page="league")], [
            ["seiche", "1 min 15 s", "1", "✗1fail ✓3pass"], ["theirs", "30.0 s", "not stated", "✓3pass"]])


if __name__ == "__main__":
    unittest.main()
