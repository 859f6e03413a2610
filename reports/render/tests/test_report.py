"""The renderer on made-up evidence, hostile and broken records among it.

    /usr/bin/python3 reports/render/tests/test_report.py
"""
import contextlib
import copy
import html.parser
import io
import json
import math
import os
import pathlib
import re
import sys
import tempfile
import tomllib
import unittest
import unittest.mock
import urllib.parse

REPORTS = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(REPORTS))

import h5py  # noqa: E402
import numpy  # noqa: E402

from render import atlas, experiments, layout, marks, mutants, pages, pdf, quantities, records  # noqa: E402
from render.command import main  # noqa: E402
from render.formulas import Formulas  # noqa: E402
from render.store import Store  # noqa: E402
from render.text import Typesetter  # noqa: E402

HOSTILE = "<script>alert('x')</script>\"&'"
VOID = {"meta", "link", "br", "img", "input", "hr", "rect", "path", "circle", "wbr"}


class Page(html.parser.HTMLParser):
    """Checks the balance of tags; gathers ids, references and the elements' names."""

    def __init__(self, text):
        super().__init__()
        self.open, self.ids, self.references, self.faults, self.names = [], [], [], [], []
        self.feed(text)
        self.faults += [f"<{name}> is never closed" for name in self.open]

    def handle_starttag(self, name, attributes):
        self.names.append(name)
        for key, value in attributes:
            if key == "id":
                self.ids.append(value)
            elif key in ("href", "src"):
                self.references.append(value)
            elif key.startswith("on"):
                self.faults.append(f"handler {key} on <{name}>")
        if name not in VOID:
            self.open.append(name)

    def handle_startendtag(self, name, attributes):
        self.handle_starttag(name, attributes)
        if name not in VOID:
            self.open.pop()

    def handle_endtag(self, name):
        if name in VOID:
            return
        if not self.open or self.open[-1] != name:
            self.faults.append(f"</{name}> at {self.getpos()} closes {self.open[-1:] or 'nothing'}")
        if name in self.open:
            while self.open.pop() != name:
                pass


def claim(name, kind="bound", verdict="pass", **changes):
    extras = {"roundoff": {"operations": 1e5, "scale": 3.0}, "order": {"theory": 2.0, "tolerance": 0.2},
              "bound": {"relative": False}, "uncertainty": {"data": 0.01, "input": 0.0, "coverage": 2.0, "useful": None},
              "qualitative": {"detector": "a stated detector"}}[kind]
    made = {"id": name, "text": f"Claim {name} holds.", "quantity": "defect", "unit": "m^3/s", "source": "a source",
            "resolution": "N = 10", "measured": 3.8412e-15, "uncertainty": 0.0, "expected": 0.0,
            "criterion": {"kind": kind, "limit": 1e-12, "reason": "a reason", **extras},
            "verdict": verdict, "declared": "pass", "declared_reason": "", "declared_band": None, "note": ""}
    made.update(changes)
    if made["declared"] == "fail" and made["declared_band"] is None:
        made["declared_band"] = [made["measured"] or 0.0, 0.1]
    return {"as_declared": made["verdict"] == made["declared"], **made}


def record(case, **changes):
    made = {"schema": 3, "case": case, "kind": "validation", "group": "bore", "tier": "quick", "solver": "seiche",
            "title": f"The case {case}", "source": "A source", "article": "Text with $x^2$ and\n\n$$\\frac{a}{b}$$",
            "status": "finished", "error": "", "parameters": {}, "set": "", "published": [], "claims": [claim("one")], "left_out": [], "measurements": {},
            "figures": [], "tables": [], "atlas": [], "data": "", "fields": "", "wall_time": 1.5, "fingerprint": "abc123",
            "provenance": {"commit": "0123456789abcdef", "dirty": False, "compiler": "g++", "flags": "-O3",
                           "build_type": "Release", "libraries": {"fmt": "9"}, "processor": "a processor", "cores": 2,
                           "threads": 1, "system": "Linux", "date": "2026-01-02T03:04:05Z", "version": "1.0",
                           "reference_data": {"a/table.csv": "ff" * 32}}}
    return {**made, **changes}


def published(tile, here, tier="quick", differs="", **changes):
    return [{"tiles": [tile], "tier": tier, "values": {"particles": 12}, "origins": {"particles": "stated"},
             "different": {}, "differs": differs, "contradicted": [], "here": here, **changes}]


def tile_table(tile):
    return [{"id": "t", "title": "t", "caption": "c", "columns": [], "rows": [], "atlas": [tile]}]


def first_look(rows):
    return {"id": "first-look", "title": "t", "caption": "c", "columns": [{"name": "question", "unit": ""}], "rows": rows,
            "atlas": []}


def figure(name, **changes):
    return {**{"id": name, "title": "A figure", "caption": "With $h_0$.", "drawing": "panels", "atlas": []}, **changes}


def write_arrays(path, figures):
    """figures: {id: [[(label, role, style, x, y)]]}"""
    with h5py.File(path, "w", track_order=True) as file:
        for name, panels in figures.items():
            group = file.create_group(f"figures/{name}")
            group.attrs.update({"title": "A figure", "caption": "", "drawing": "panels"})
            for p, panel in enumerate(panels):
                node = group.create_group(f"panel_{p:02d}")
                node.attrs.update({"title": "", "x_label": "x [m]", "y_label": "u [m^2/s] $", "log_x": 0, "log_y": 0,
                                   "aspect": "auto"})
                for s, (label, role, style, x, y) in enumerate(panel):
                    series = node.create_group(f"series_{s:02d}")
                    series.attrs.update({"label": label, "role": role, "style": style})
                    series["x"], series["y"] = numpy.asarray(x, float), numpy.asarray(y, float)
        array = file.create_dataset("arrays/depth", data=numpy.zeros((3, 4)))
        array.attrs.update({"unit": "m", "meaning": HOSTILE})


def write_evidence(folder):
    """Evidence with everything that a report must survive."""
    folder.mkdir()

    def put(content, name=None):
        (folder / f"{name or content['case']}.json").write_text(json.dumps(content), encoding="utf-8")

    x = numpy.linspace(0, 1, 20)
    every_style = [("exact", "exact", "line", x, x), ("steps", "computed", "steps", x, x[1:]),
                   ("data", "data", "points", x, x), ("water", "water", "fill", x, x), ("bed", "bed", "fill", x, 0 * x),
                   ("wall", "guide", "vertical", [0.5], []), ("cells", "water", "steps", x, x[1:]),
                   ("with gaps", "peer", "line", x, numpy.where(x > 0.5, numpy.nan, x)), (HOSTILE, "peer", "points", x, x)]
    many = [("long", "computed", "line", numpy.linspace(0, 1, 40000), numpy.random.default_rng(1).random(40000))]
    put(record("two_solvers", data="two_solvers.h5", published=published("bzz-fig-12", True, differs="ours is 1 m deep"),
               parameters={"particles": {"value": 12, "unit": "1", "default": 12, "meaning": "how many"}}, figures=[figure("f", atlas=["bzz-fig-12"]), figure("long")],
               claims=[claim("one", "roundoff"), claim("two", "order", measured=2.04, uncertainty=0.05, expected=2.0),
                       claim("three", "uncertainty"), claim("four", "qualitative", measured=1, expected=1)]))
    write_arrays(folder / "two_solvers.h5", {"f": [every_style, every_style[:3]], "long": [many]})
    put(record("two_solvers", solver="another", data="two_solvers.another.h5", figures=[figure("f")],
               tables=[first_look([["likely cause", "that of nobody"]])]), "two_solvers.another")
    write_arrays(folder / "two_solvers.another.h5", {"f": [every_style[:2]]})
    put(record("hostile", kind="verification", group=HOSTILE, solver="seiche", title=HOSTILE, source=HOSTILE,
               article=HOSTILE + "\n\n[link](javascript:alert(1)) ![p](http://example.org/p.png) <img src=x onerror=y>",
               parameters={HOSTILE: {"value": HOSTILE, "unit": HOSTILE, "default": True, "meaning": HOSTILE}},
               claims=[claim("one", text=HOSTILE, quantity=HOSTILE, unit=HOSTILE, note=HOSTILE, source=HOSTILE,
                             resolution=HOSTILE, verdict="fail", declared="fail", declared_reason=HOSTILE)],
               measurements={HOSTILE: 1.0}, data="hostile.h5", figures=[figure("f", title=HOSTILE, caption=HOSTILE)],
               tables=[{"id": "t", "title": HOSTILE, "caption": HOSTILE, "columns": [{"name": HOSTILE, "unit": HOSTILE}],
                        "rows": [[HOSTILE], [None], [True], [1e-300]], "atlas": ["frank-table-celerity", "no-such-tile"]}]))
    write_arrays(folder / "hostile.h5", {"f": [[(HOSTILE, "computed", "line", x, x)]]})
    put(record("nulls", wall_time=None, tables=[first_look([["one"], [None, 1.0, "three"]])], measurements={"m": None},
               claims=[claim("one", verdict="fail", measured=None, uncertainty=None, expected=None,
                             criterion={"kind": "bound", "limit": None, "reason": "r", "relative": True}),
                       claim("late", verdict="fail", declared="fail", declared_reason="known"),
                       claim("another_size", verdict="fail", declared="fail", declared_reason="known", as_declared=False),
                       claim("surprise", declared="fail", declared_reason="thought so")]))
    put(record("sharp", left_out=[{"id": "late", "text": "Later.", "reason": "the source stops earlier"}], claims=[
        claim("marginal", measured=0.95e-12), claim("loose", measured=1e-15), claim("wide", measured=0, uncertainty=0.95e-12),
        claim("exact", measured=0.0), claim("middle", measured=0.5e-12), claim("fails", verdict="fail", measured=2e-12),
        claim("seen", "qualitative", measured=1, expected=1)], tables=tile_table("frank-fig-9")))
    put(record("small", parameters={"particles": {"value": 4, "unit": "1", "default": 4, "meaning": "how many"}},
               published=published("sph-fig-6", False, "paper"), tables=tile_table("sph-fig-6")))
    put(record("sizes", claims=[claim("reduced")], published=published("bzz-fig-6", False, "full"),
               tables=tile_table("bzz-fig-6")))
    put(record("sizes", tier="full", set="bzz-fig-6", claims=[claim("whole", verdict="fail")],
               published=published("bzz-fig-6", True, "full"), tables=tile_table("bzz-fig-6")), "sizes@bzz-fig-6")
    failing = [claim("fine"), claim("printed", verdict="fail", declared="fail", declared_reason="the source is wrong")]
    for name, tile, contradicted in (("wrong", "bzz-fig-15", ["printed"]), ("misses", "bzz-fig-18", [])):
        put(record(name, claims=failing, tables=tile_table(tile), published=published(tile, True, contradicted=contradicted)))
    for name, tile, changes in (("exactly", "bzz-fig-22", {}), ("other_value", "bzz-fig-23", {
            "origins": {"particles": "different"}, "different": {"particles": "13 <b>"}})):
        put(record(name, tables=tile_table(tile), published=published(tile, True, **changes)))
    put(record("sketch", kind="verification", tables=tile_table("frank-fig-4")))
    put(record("tiers"))
    put(record("tiers", tier="full"), "tiers@full")
    put(record("crashed", status="error", error="killed by signal 11 <b>", claims=[], figures=[figure("f")], data="gone.h5"))
    put(record("lost_figure", data="two_solvers.h5", figures=[figure("nowhere"), figure("f", drawing="no such")]))
    (folder / "truncated.json").write_text('{"schema": 1, <script>', encoding="utf-8")
    (folder / "not a record.json").write_text("[1, NaN]", encoding="utf-8")
    broken = record("incomplete")
    del broken["tier"]
    put(broken)
    put(record("two_solvers"), "two_solvers_again")
    (folder / "junit.xml").write_text("<testsuites/>", encoding="utf-8")


def render(evidence, out, *more):
    said = io.StringIO()
    with contextlib.redirect_stdout(said), contextlib.redirect_stderr(said):
        status = main([str(evidence), "--out", str(out), *more])
    return status, said.getvalue()


def contents(folder):
    """Bytes of all files of a report."""
    return {str(path.relative_to(folder)): path.read_bytes() for path in sorted(folder.rglob("*")) if path.is_file()}


class Report(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.temporary.name)
        cls.evidence, cls.out = cls.folder / "evidence", cls.folder / "report"
        cls.cache = cls.folder / "cache" / "seiche" / "report"
        os.environ["XDG_CACHE_HOME"] = str(cls.folder / "cache")
        write_evidence(cls.evidence)
        cls.status, cls.said = render(cls.evidence, cls.out, "--with-data")
        cls.pages = {path: Page(path.read_text(encoding="utf-8")) for path in cls.out.rglob("*.html")}
        cls.index = (cls.out / "index.html").read_text(encoding="utf-8")

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def test_a_report_is_made_of_whatever_there_is(self):
        self.assertEqual(self.status, 0, self.said)
        self.assertIn("index.html", self.said)

    def test_pages_are_well_formed(self):
        for path, page in self.pages.items():
            self.assertEqual(page.faults, [], path.name)
            self.assertEqual(len(page.ids), len(set(page.ids)), f"an id twice in {path.name}")

    def test_every_reference_resolves_within_the_report(self):
        for path, page in self.pages.items():
            for reference in page.references:
                address = urllib.parse.urlsplit(reference)
                self.assertEqual((address.scheme, address.netloc), ("", ""), f"{reference} leaves the report")
                target = (path.parent / urllib.parse.unquote(address.path)).resolve() if address.path else path
                self.assertTrue(target.is_relative_to(self.out.resolve()), reference)
                self.assertTrue(target.is_file(), f"{path.name}: {reference}")
                if address.fragment:
                    self.assertIn(address.fragment, self.pages[self.out / target.relative_to(self.out.resolve())].ids, reference)

    def hostile(self):
        """The page of the only verification group with a hostile name."""
        name = records.Record("hostile.json", record("hostile", kind="verification", group=HOSTILE)).page
        return (self.out / name).read_text(encoding="utf-8")

    def test_every_record_appears(self):
        listed = (self.out / "cases.html").read_text(encoding="utf-8")
        for case in ("two_solvers", "nulls", "crashed", "lost_figure"):
            self.assertTrue((self.out / "cases" / f"{case}.html").is_file(), case)
            self.assertIn(f"cases/{case}.html", listed)
        self.assertIn('id="hostile-claim-one"', self.hostile())
        for broken in ("truncated.json", "not a record.json", "incomplete.json", "two_solvers_again.json"):
            self.assertIn(broken, self.index)
        self.assertIn("tier", self.index)
        page = (self.out / "cases/two_solvers.html").read_text(encoding="utf-8")
        self.assertIn("another", page)

    def test_what_is_seen_first_comes_first_and_anything_else_of_that_name_is_a_table(self):
        page = (self.out / "cases/two_solvers.html").read_text(encoding="utf-8")
        self.assertLess(page.index("that of nobody"), page.index("Solvers side by side"))
        self.assertNotIn('id="two_solvers.another-table-first-look"', page)
        self.assertIn('id="nulls-table-first-look"', (self.out / "cases/nulls.html").read_text(encoding="utf-8"))

    def test_surprises_are_called_out_and_declared_failures_explained(self):
        alarm = self.index[self.index.index('id="unexpected"'):self.index.index('id="matrix"')]
        declared = (self.out / "deviations.html").read_text(encoding="utf-8")
        self.assertIn("nulls-claim-one", alarm)
        self.assertIn("nulls-claim-surprise", alarm)
        self.assertIn("unexpected pass", alarm)
        self.assertIn("killed by signal 11", alarm)
        self.assertIn("nulls-claim-another_size", alarm)
        self.assertNotIn("nulls-claim-late", alarm)
        self.assertIn("nulls-claim-late", declared)
        self.assertIn("hostile-claim-one", declared)

    def test_sharpness_lists_what_is_marginal_and_what_is_loose(self):
        page = (self.out / "quality.html").read_text(encoding="utf-8")
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
        self.assertEqual(experiments.scatter_figure(lines).count("<circle"), 2)

    def cells(self, page, mark):
        """The text of each cell, row by row, of the first table after a mark."""
        table = page[page.index(mark):].split("</table>")[0]
        return [[re.sub("<[^>]*>", "", cell).strip() for cell in re.split("</t[dh]>", row)[:-1]]
                for row in re.split("<tr[^>]*>", table)[1:]]

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
        memo = Store(self.cache).memo
        page = pages.environment(Typesetter(memo, Formulas(memo).html)).get_template("mutants_body.html.j2").make_module(
            {"root": "", "mutants": found}).body()
        self.assertEqual(self.cells(page, 'id="rates"')[1:],
                         [["Exact", "1", "1", "0", "0", "0", "100 %", "21 % to 100 %"],
                          ["Linear", "11", "7", "1", "2", "1", "70 %", "40 % to 89 %"],
                          ["All rooms", "12", "8", "1", "2", "1", "73 %", "43 % to 90 %"]])
        self.assertEqual(self.cells(page, 'id="survivors"')[1:],
                         [["Linear"], ["linear.cpp:8", "sign: 8", "survived by 8"],
                          ["linear.cpp:9", "sign: 9", "survived by 9"],
                          ["linear.cpp:10", "sign: 10", "baseline only by 10"],
                          ["linear.cpp:11", "sign: 11", "equivalent never read"]])
        self.assertEqual(self.cells(page, 'id="seeded"')[1:], [["Exact", "2", "1", "sign: 14 exact.cpp:14"]])
        self.assertIn("12 mutants of seed 7 at commit abc", page)

    def test_the_report_has_the_mutants_of_the_record(self):
        page = (self.out / "quality.html").read_text(encoding="utf-8")
        found = mutants.survey(mutants.read())
        self.assertEqual(len(self.cells(page, 'id="seeded"')), 1 + len(found["seeded"]))
        self.assertIn("quality.html", self.index)

    def tile(self, name):
        atlas = (self.out / "atlas.html").read_text(encoding="utf-8")
        return atlas[atlas.index(f'<li id="{name}"'):].split("</li>")[0]

    def test_the_word_of_a_tile_follows_from_its_runs(self):
        # No set; a verification; a surprise; a declared failure, with its proof and without.
        words = {"frank-fig-9": "not yet", "frank-table-celerity": "not yet", "bzz-fig-6": "not yet",
                 "bzz-fig-18": "not yet", "bzz-fig-15": "source contradicted", "bzz-fig-22": "reproduced",
                 "bzz-fig-23": "reproduced by another method", "bzz-fig-12": "reproduced by another method",
                 "frank-fig-4": "picture only", "sph-fig-6": "reduced size", "bzz-fig-7": "not yet"}
        for name, word in words.items():
            self.assertIn(f'<span class="word">{word}</span>', self.tile(name), name)
        counts = {word: list(words.values()).count(word) for word in words.values()}
        counts["not yet"] = 58 - len(words) + counts["not yet"]
        for page in (self.index, (self.out / "atlas.html").read_text(encoding="utf-8")):
            self.assertIn(", ".join(f"{counts[word]} {word}" for word in atlas.WORDS), page)
        self.assertIn("tier paper", self.tile("sph-fig-6"))

    def test_a_tile_gives_the_parameters_of_its_source_and_what_differs(self):
        self.assertIn('<code>particles</code> <span class="n">12</span>', self.tile("bzz-fig-12"))
        self.assertIn("ours is 1 m deep", self.tile("bzz-fig-12"))
        self.assertIn("Stated by the source", self.tile("bzz-fig-12"))
        self.assertIn("(source: 13 &lt;b&gt;)", self.tile("bzz-fig-23"))
        self.assertNotIn("(here", self.tile("bzz-fig-12"))
        self.assertRegex(self.tile("sph-fig-6"), "<code>particles</code> <span[^>]*>12</span> <b>.here <span[^>]*>4</span>")

    def test_records_of_sets_and_tiers_stand_on_one_page_the_best_first(self):
        page = (self.out / "cases/sizes.html").read_text(encoding="utf-8")
        self.assertIn("seiche, bzz-fig-6", page)
        self.assertLess(page.index("-claim-whole"), page.index('id="sizes-claim-reduced"'))
        self.assertIn('href="#sizes-claims"', page)

    def test_evidence_of_record_is_mentioned_where_the_report_has_only_less(self):
        (self.folder / "record").mkdir(exist_ok=True)
        header = "case,set,claim,kind,measured,uncertainty,expected,limit,band,verdict\n"
        table = self.folder / "record/paper.csv"
        for verdicts, expected in ((("pass", "declared fail"), {("small", "sph-fig-6"): "paper"}), (("pass", "fail"), {})):
            table.write_text(header + "".join(f"small,sph-fig-6,c{i},bound,1,,1,1,,{v}\n" for i, v in enumerate(verdicts)))
            self.assertEqual(atlas.kept_sets(self.folder / "record"), expected)
        table.write_text(header + "small,sph-fig-6,c,bound,1,,1,1,,pass\n")
        (table.parent / "long_runs.csv").write_text("tier,case,set,commit,date,seconds\npaper,small,sph-fig-6,0a1b2c3d,2026-11-27,90\n")
        self.assertEqual(atlas.kept_sets(table.parent), {("small", "sph-fig-6"): "paper, commit 0a1b2c3d of 2026-11-27"})

    def test_tiers_stand_side_by_side(self):
        page = (self.out / "cases/tiers.html").read_text(encoding="utf-8")
        self.assertIn("seiche, full", page)
        self.assertLess(page.index("tiers-full"), page.index('id="tiers-claim-one"'))

    def test_what_does_not_apply_is_said(self):
        page = (self.out / "cases/sharp.html").read_text(encoding="utf-8")
        self.assertIn("1 claim does not apply at these parameters", page)

    def test_what_could_not_be_drawn_is_said(self):
        page = (self.out / "cases/lost_figure.html").read_text(encoding="utf-8")
        self.assertIn("holds no figure", page)
        self.assertIn("no drawing is called", page)
        said = (self.out / "provenance.html").read_text(encoding="utf-8")
        self.assertIn("no-such-tile", said)
        self.assertIn("gone.h5 cannot be read", said)
        self.assertIn("provenance.html#problems", self.index)

    def test_every_tile_of_the_atlas_appears(self):
        page = self.pages[self.out / "atlas.html"]
        sources = tomllib.loads((REPORTS / "atlas.toml").read_text(encoding="utf-8"))["source"]
        tiles = [tile["id"] for source in sources for tile in source["tile"]]
        self.assertEqual(len(tiles), len(set(tiles)))
        for tile in tiles:
            self.assertIn(tile, page.ids)
        text = (self.out / "atlas.html").read_text(encoding="utf-8")
        self.assertEqual(text.count("no run"), len(tiles) - 10)

    def test_hostile_text_is_printed_not_obeyed(self):
        for path, page in self.pages.items():
            text = path.read_text(encoding="utf-8")
            self.assertNotIn("<script>alert", text, path.name)
            self.assertNotIn("javascript:", "".join(page.references))
            self.assertEqual(page.names.count("script"), 1, path.name)
        self.assertIn("&lt;script&gt;alert", self.hostile())
        for path in self.out.rglob("*.svg"):
            self.assertNotIn("<script>alert", path.read_text(encoding="utf-8"), path.name)

    def test_formulas_are_set(self):
        page = (self.out / "cases/two_solvers.html").read_text(encoding="utf-8")
        self.assertIn('aria-label="x^2"', page)
        self.assertIn("<title>\\frac{a}{b}</title>", page)

    def test_figures_are_small(self):
        for path in self.out.rglob("*.svg"):
            self.assertLess(path.stat().st_size, 600_000, path.name)

    def test_records_and_arrays_travel_with_the_report(self):
        for name in ("two_solvers.json", "two_solvers.h5", "hostile.json", "truncated.json", "junit.xml"):
            self.assertEqual((self.out / "data" / name).read_bytes(), (self.evidence / name).read_bytes())

    def test_second_run_draws_nothing_and_gives_the_same_bytes(self):
        first = contents(self.out)
        cached = {path: path.stat().st_mtime_ns for path in (self.cache / "figures").iterdir()}
        self.assertEqual(render(self.evidence, self.out, "--with-data")[0], 0)
        self.assertEqual(contents(self.out), first)
        self.assertEqual({path: path.stat().st_mtime_ns for path in (self.cache / "figures").iterdir()}, cached)

    def test_a_fresh_report_elsewhere_has_the_same_bytes(self):
        self.assertEqual(render(self.evidence, self.folder / "elsewhere", "--jobs", "1", "--with-data")[0], 0)
        self.assertEqual(contents(self.folder / "elsewhere"), contents(self.out))

    def test_stale_pages_go_and_nothing_is_left_beside(self):
        evidence, out = self.folder / "changing", self.folder / "changing_report"
        write_evidence(evidence)
        render(evidence, out)
        (evidence / "nulls.json").unlink()
        render(evidence, out)
        self.assertFalse((out / "cases/nulls.html").exists())
        self.assertEqual([path.name for path in self.folder.iterdir() if path.name.startswith(".")], [])

    def test_what_is_not_a_report_is_never_replaced(self):
        precious = self.folder / "precious"
        precious.mkdir()
        (precious / "thesis.tex").write_text("work of years")
        status, said = render(self.evidence, precious)
        self.assertEqual(status, 2)
        self.assertIn("not a report", said)
        self.assertTrue((precious / "thesis.tex").exists())

    def test_a_folder_without_records_is_named(self):
        (self.folder / "empty").mkdir()
        for name in ("empty", "nowhere"):
            status, said = render(self.folder / name, self.folder / "x")
            self.assertEqual((status, len(said.splitlines())), (2, 1), said)
            self.assertIn(str(self.folder / name), said)
            self.assertFalse((self.folder / "x").exists())

    def printed(self, path):
        """Status, words and file of a report that is printed with the programs of that PATH."""
        with unittest.mock.patch.dict(os.environ, PATH=path):
            return *render(self.evidence, self.folder / "printed", "--pdf", str(self.folder / "x.pdf")), self.folder / "x.pdf"

    def test_missing_browser_is_named(self):
        status, said, _ = self.printed(str(self.folder))
        self.assertEqual(status, 2)
        self.assertIn("chromium", said)

    def test_the_whole_report_is_printed(self):
        stand_in = self.folder / "browser" / "chromium"     # prints a page as it is
        stand_in.parent.mkdir()
        stand_in.write_text(f"""#!{sys.executable}
import shutil, sys, urllib.parse
target = next(word.split("=", 1)[1] for word in sys.argv if word.startswith("--print-to-pdf="))
shutil.copy(urllib.parse.unquote(urllib.parse.urlsplit(sys.argv[-1]).path), target)
""")
        stand_in.chmod(0o755)
        status, said, file = self.printed(str(stand_in.parent))
        self.assertEqual(status, 0, said)
        text = file.read_text(encoding="utf-8")
        self.assertEqual(Page(text).faults, [])
        self.assertEqual(text.count('<div class="sheet">'), 3)      # deviations, agreement, figures of the sources
        if pdf.find_browser():
            status, said, file = self.printed(os.environ["PATH"])
            self.assertEqual(status, 0, said)
            self.assertGreater(len(re.findall(rb"/Type\s*/Page\b", file.read_bytes())), 3)


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


class Axes(unittest.TestCase):
    def test_error_bars_stay_on_shared_axes(self):
        def panel(error):
            return {"y_label": "h", "series": [{"style": "points", "x": numpy.array([0.0, 1.0]), "y": numpy.array([1.0, 2.0]),
                                                "y_error": numpy.array([0.1, error])}]}
        shown = [panel(0.7), panel(0.5)]
        layout.share_limits(shown)
        for one in shown:
            self.assertGreater(one["y_max"], 2.7)
            self.assertLess(one["y_min"], 0.9)


if __name__ == "__main__":
    unittest.main()
