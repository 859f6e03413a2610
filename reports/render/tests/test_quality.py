"""What the report says of the checks and the machine: margins, agreement with experiments, mutants, lines, speed."""
import math
import pathlib
import re
import runpy
import tempfile
import types
import unittest

from made import Whole, body, record

from render import coverage, experiments, marks, mutants, pages, records, report, speed

LINES = """file,lines,ran
solver/seiche/exact/bore.cpp,100,95
solver/seiche/exact/entries/bore.cpp,20,5
solver/seiche/models/wcsph/lanes.cpp,50,50
validation/bore/bore_flow.cpp,10,9
"""

BENCHMARKS = """program,benchmark,nanoseconds_per_item,bytes_per_second,of_bandwidth,operations_per_second,of_peak,bytes_per_item,processor,date
machine,triad/1000,0.1,2e11,,,,,A processor,2026-01-02
particles,G1/1000/1/iterations:4/real_time,36,8.5e9,0.43,4e9,,,A processor,2026-01-02
exact_waves,solve/2,,adaptive,adaptive,adaptive,adaptive,,A processor,2026-01-02
wcsph,steps/2,36,8.5e9,0.43,4e9,0.12,321,A processor,2026-01-02
"""


class Quality(Whole):
    def cells(self, page, mark):
        """The text of each cell, row by row, of the first table after a mark."""
        table = page[page.index(mark):].split("</table>")[0]
        return [[re.sub("<[^>]*>", "", cell).strip() for cell in re.split("</t[dh]>", row)[:-1]]
                for row in re.split("<tr[^>]*>", table)[1:]]

    def test_sharpness_lists_what_is_marginal_and_what_is_loose(self):
        page = self.page("quality")
        marginal = page[page.index('id="marginal"'):page.index('id="loose"')]
        loose = page[page.index('id="loose"'):page.index('id="random-mutants"')]
        page = page[:page.index('id="random-mutants"')]
        self.assertIn("sharp-claim-marginal", marginal)
        self.assertIn("sharp-claim-loose", loose)
        self.assertIn("sharp-claim-wide", marginal)     # its uncertainty uses up the limit
        for neither in ("exact", "middle", "fails", "seen"):
            self.assertNotIn(f"sharp-claim-{neither}", page)

    def test_bias_and_scatter_of_models_over_experiments(self):
        pairs = [experiments.Pair(None, "c", measured, 0.1 * measured, ratio * measured)
                 for measured, ratio in ((1.0, 1.1), (2.0, 1.3), (3.0, 1.7))]
        line = experiments.line_of("mine", marks.mark(0), pairs, 0)
        logs = [math.log(ratio) for ratio in (1.1, 1.3, 1.7)]
        mean = sum(logs) / 3
        own = sum((one - mean) ** 2 for one in logs) / 2 - 0.01
        self.assertAlmostEqual(line.experimental, 0.1)
        self.assertAlmostEqual(line.scatter, math.sqrt(own))
        self.assertAlmostEqual(line.bias, math.exp(mean + (own - 0.01) / 2))
        alike = [experiments.Pair(None, "c", 1.0, 0.1, 1.01) for _ in range(3)]
        self.assertIsNone(experiments.line_of("mine", marks.mark(0), alike, 0).scatter)
        rows = [["arrival", "a", 31.0, 0.1, 31.1, 0.0, 30.0, 1.0], ["misfit", "m", 0.0, 1.0, 0.5, 0.0, 0.0, 0.5],
                ["arrival", "b", 29.0, 0.1, 31.1, 0.0, 30.0, 21.0], ["arrival", "c", 32.0, 0.1, None, 0.0, 30.0, None],
                ["arrival", "d", 30.1, 0.1, 30.2, 0.0, 30.0, 1.0]]
        table = {"id": experiments.TABLE, "title": "Our model", "caption": "", "columns": [], "rows": rows, "atlas": []}
        ours = records.Record("lab.json", record("lab", tables=[table]))
        theirs = records.Record("lab.theirs.json", record("lab", solver="theirs", tables=[table]))
        (kind, lines), = experiments.survey([ours, theirs])
        self.assertEqual((kind, [line.solver for line in lines]), ("arrival", ["Our model", "theirs"]))
        self.assertEqual([(len(line.pairs), line.left_out, line.bias) for line in lines], [(1, 3, None)] * 2)
        self.assertAlmostEqual(lines[0].pairs[0].computed, 1.1)
        self.assertEqual(len(lines[0].errors), 2)       # of another sign as well: 31.1 for 29 is 2.1 of 1
        self.assertAlmostEqual(lines[0].median, 1.1)
        self.assertAlmostEqual(lines[0].worst, 2.1)
        drawn = experiments.scatter_figure(lines)
        self.assertEqual(drawn.count("<circle"), 2)
        left, size = experiments.LEFT, experiments.SIZE
        self.assertIn(f"M{left} {size}L{left + size} 0", drawn)     # where computed and measured are equal

    def test_a_logarithmic_axis_has_ticks_at_1_2_and_5_or_at_powers_alone(self):
        self.assertEqual(marks._ticks(0, 1), [1, 2, 5, 10])
        self.assertEqual(marks._ticks(-1, 1.5), [0.1, 1, 10])

    def test_facts_of_provenance_stand_the_most_frequent_first(self):
        def of(**facts):
            one = record("c")
            return records.Record("c.json", {**one, "provenance": {**one["provenance"], **facts}})
        rare = dict(commit="a" * 16, processor="slow", system="rare", compiler="rare", flags="rare", build_type="rare",
                    threads=9, version="9")
        told = pages.facts([of(**rare), of(), of()])
        usual = {"commit": "0", "machine": "a", "system": "L", "compiler": "g", "flags": "-", "build": "R", "threads": "1",
                 "version": "1"}
        self.assertEqual({name: told[name][0][0] for name in usual}, usual)
        self.assertEqual({name: len(told[name]) for name in told if name not in ("first", "last")},
                         {**dict.fromkeys(usual, 2), "libraries": 1})

    def test_a_sheet_of_tests_goes_on_with_the_next_where_it_is_full(self):
        made = [records.Record(f"{name}.json", record(name, kind="verification")) for name in "abc"]
        parts = iter(("x" * 100, "x" * (report.SHEET - 100), "x"))
        write = types.SimpleNamespace(part=lambda *_: next(parts))
        sheets = report._sheets(records.cases(made), write, [])
        self.assertEqual([one.sheet for one in made], ["", "", "-2"])
        self.assertEqual([len(tests) for tests in sheets.values()], [2, 1])

    def test_mutants_are_counted_by_room_and_survivors_named(self):
        def row(seed, room, line, outcome, reason=""):
            return {"seed": seed, "number": str(line), "room": room, "file": f"{room}.cpp", "line": str(line),
                    "change": f"sign: {line}", "outcome": outcome, "by": f"by {line}", "seconds": "1", "commit": "abc",
                    "reason": reason}
        rows = [*(row("7", "linear", line, "killed") for line in range(7)), row("7", "linear", 8, "survived"),
                row("7", "linear", 9, "survived"), row("7", "linear", 10, "record only"),
                row("7", "linear", 11, "equivalent", "never read"), row("7", "exact", 12, "killed"),
                row("seeded", "exact", 13, "killed"), row("seeded", "exact", 14, "survived")]
        found = mutants.survey(rows)
        # Wilson's interval of 7 of 10, as printed by Newcombe's method 3.
        self.assertEqual([round(end, 4) for end in found["rooms"][1].interval], [0.3968, 0.8922])
        page = body("mutants", mutants=found)
        self.assertEqual(self.cells(page, 'id="rates"')[1:],
                         [["Exact", "1", "1", "0", "0", "0", "100 %", "21 % to 100 %"],
                          ["Linear", "11", "7", "1", "2", "1", "70 %", "40 % to 89 %"],
                          ["All parts", "12", "8", "1", "2", "1", "73 %", "43 % to 90 %"]])
        self.assertIn("<summary>Linear: 4</summary>", page)
        self.assertEqual(self.cells(page, 'id="survivors"')[1:],
                         [["linear.cpp:8", "sign: 8", "survived by 8"],
                          ["linear.cpp:9", "sign: 9", "survived by 9"],
                          ["linear.cpp:10", "sign: 10", "baseline only by 10"],
                          ["linear.cpp:11", "sign: 11", "equivalent never read"]])
        self.assertEqual(self.cells(page, 'id="seeded"')[1:], [["Exact", "2", "1", "sign: 14 exact.cpp:14"]])
        self.assertIn("12 mutants of seed 7 at commit abc", page)

    def test_the_report_has_the_mutants_of_the_record(self):
        page = self.page("quality")
        found = mutants.survey(mutants.read())
        self.assertEqual(len(self.cells(page, 'id="seeded"')), 1 + len(found["seeded"]))
        self.assertIn("quality.html", self.index)


class Coverage(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        record = self.folder / "coverage.csv"
        record.write_text(LINES)
        self.rooms = coverage.survey(coverage.read(record))

    def test_lines_are_added_by_room(self):
        self.assertEqual([(room.name, room.lines, room.ran) for room in self.rooms],
                         [("solver/seiche/exact", 120, 100), ("solver/seiche/models/wcsph", 50, 50),
                          ("validation/bore", 10, 9)])
        self.assertEqual([room.wanting for room in self.rooms], [True, False, False])

    def test_what_the_check_writes_is_read(self):
        check = runpy.run_path(str(pathlib.Path(coverage.__file__).parents[2] / "ci/checks/coverage"))
        rows = [("solver/seiche/exact/bore.cpp", 100, 95), ("validation/bore/bore.cpp", 10, 9)]
        check["write"](rows, self.folder / "written.csv")
        self.assertEqual(coverage.read(self.folder / "written.csv"), rows)

    def test_the_page_names_what_a_room_lacks(self):
        page = body("coverage", rooms=self.rooms, wanted_lines=coverage.WANTED)
        self.assertIn("<code>entries/bore.cpp</code> 5/20", page)
        self.assertNotIn("<code>bore.cpp</code>", page)
        self.assertEqual(page.count("too few"), 1)

    def test_without_a_table_the_page_says_how_to_make_one(self):
        rooms = coverage.survey(coverage.read(self.folder / "none.csv"))
        self.assertIn("ci/checks/coverage", body("coverage", rooms=rooms, wanted_lines=coverage.WANTED))


class Speed(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))

    def test_benchmarks_stand_beside_the_machine(self):
        record = self.folder / "speed.csv"
        record.write_text(BENCHMARKS)
        page = body("speed", speed=speed.survey(speed.read(record)))
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
        page = body("speed", speed=speed.survey([], speed.build_time(table)))
        self.assertIn("on 2 cores (A processor) without a compiler cache, commit 1a2b3c4, 2026-01-02", page)
        row = page[page.index("<td>cold build"):]
        self.assertLess(row.index(">612</span>"), row.index(">600</span>"))

    def test_without_a_table_the_page_says_how_to_make_one(self):
        self.assertIn("ci/checks/benchmarks --table", body("speed", speed=speed.survey(speed.read(self.folder / "none.csv"))))


if __name__ == "__main__":
    unittest.main()
