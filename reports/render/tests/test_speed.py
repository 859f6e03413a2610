"""The page of benchmarks, beside what the machine can do."""
import pathlib
import sys
import tempfile
import unittest

REPORTS = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(REPORTS))

from render import pages, speed  # noqa: E402
from render.formulas import Formulas  # noqa: E402
from render.store import Store  # noqa: E402
from render.text import Typesetter  # noqa: E402

RECORD = """program,benchmark,nanoseconds_per_item,bytes_per_second,of_bandwidth,operations_per_second,of_peak,bytes_per_item,processor,date
machine,triad/1000,0.1,2e11,,,,,A processor,2026-01-02
particles,G1/1000/1/iterations:4/real_time,36,8.5e9,0.43,4e9,,,A processor,2026-01-02
exact_waves,solve/2,,adaptive,adaptive,adaptive,adaptive,,A processor,2026-01-02
wcsph,steps/2,36,8.5e9,0.43,4e9,0.12,321,A processor,2026-01-02
"""


def page_of(rows, folder, build=()):
    memo = Store(folder / "cache").memo
    return pages.environment(Typesetter(memo, Formulas(memo).html)).get_template("speed_body.html.j2").make_module(
        dict(root="", speed=speed.survey(rows, build))).body()


class Speed(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)

    def test_benchmarks_stand_beside_the_machine(self):
        record = self.folder / "speed.csv"
        record.write_text(RECORD)
        page = page_of(speed.read(record), self.folder)
        self.assertIn(">200</span> GB/s", page)
        self.assertIn(">43</span> %</td><td class=\"r\"></td>", page)
        self.assertIn("<code>G1/1000/1</code>", page)
        self.assertIn("A processor, 2026-01-02", page)
        self.assertIn("adaptive", page[page.index('id="exact_waves"'):page.index('id="wcsph"')])
        self.assertIn(">321</span>", page[page.index('id="wcsph"'):])
        self.assertEqual(page.count("bytes per item"), 1)
        self.assertNotIn("triad", page[page.index('id="particles"'):])

    def test_time_of_building_stands_beside_its_aim(self):
        table = self.folder / "build_time.csv"
        table.write_text("step,seconds,aim,cores,processor,commit,date\ncold build,612.3,600,2,A processor,1a2b3c4,2026-01-02\n")
        page = page_of([], self.folder, speed.build_time(table))
        self.assertIn("on 2 cores (A processor) without a compiler cache, commit 1a2b3c4, 2026-01-02", page)
        row = page[page.index("<td>cold build"):]
        self.assertLess(row.index(">612</span>"), row.index(">600</span>"))

    def test_without_a_table_the_page_says_how_to_make_one(self):
        self.assertIn("ci/checks/benchmarks --table", page_of(speed.read(self.folder / "none.csv"), self.folder))


if __name__ == "__main__":
    unittest.main()
