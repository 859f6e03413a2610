"""The page of the lines that run, and the rooms they are of."""
import pathlib
import sys
import tempfile
import unittest

REPORTS = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(REPORTS))

from render import coverage, pages  # noqa: E402
from render.formulas import Formulas  # noqa: E402
from render.store import Store  # noqa: E402
from render.text import Typesetter  # noqa: E402

RECORD = """file,lines,ran
solver/seiche/exact/bore.cpp,100,95
solver/seiche/exact/entries/bore.cpp,20,5
solver/seiche/models/wcsph/lanes.cpp,50,50
validation/bore/bore_flow.cpp,10,9
"""


def page_of(rooms, folder):
    memo = Store(folder / "cache").memo
    return pages.environment(Typesetter(memo, Formulas(memo).html)).get_template("coverage_body.html.j2").make_module(
        dict(root="", rooms=rooms, wanted_lines=coverage.WANTED)).body()


class Coverage(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)
        record = self.folder / "coverage.csv"
        record.write_text(RECORD)
        self.rooms = coverage.survey(coverage.read(record))

    def test_lines_are_added_by_room(self):
        self.assertEqual([(room.name, room.lines, room.ran) for room in self.rooms],
                         [("solver/seiche/exact", 120, 100), ("solver/seiche/models/wcsph", 50, 50),
                          ("validation/bore", 10, 9)])
        self.assertEqual([room.wanting for room in self.rooms], [True, False, False])

    def test_the_page_names_what_a_room_lacks(self):
        page = page_of(self.rooms, self.folder)
        self.assertIn("<code>entries/bore.cpp</code> 5/20", page)
        self.assertNotIn("<code>bore.cpp</code>", page)
        self.assertEqual(page.count("too few"), 1)

    def test_without_a_table_the_page_says_how_to_make_one(self):
        self.assertIn("ci/checks/coverage", page_of(coverage.survey(coverage.read(self.folder / "none.csv")), self.folder))


if __name__ == "__main__":
    unittest.main()
