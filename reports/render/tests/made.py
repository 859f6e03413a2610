"""Evidence that tests make up, and reports of it: what the tests of the renderer share."""
import contextlib
import functools
import html.parser
import io
import json
import os
import pathlib
import re
import sys
import tempfile
import types
import unittest

REPORTS = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(REPORTS))

import h5py  # noqa: E402
import matplotlib  # noqa: E402
import numpy  # noqa: E402

from render import pages, records, side_by_side  # noqa: E402
from render.command import main  # noqa: E402
from render.formulas import Formulas  # noqa: E402
from render.store import Store  # noqa: E402
from render.text import Typesetter  # noqa: E402

SCRATCH = tempfile.TemporaryDirectory(prefix="seiche-test-")    # goes with the process
CACHE = pathlib.Path(SCRATCH.name, "cache")                     # of all reports: what they share is set and drawn once
os.environ["MPLCONFIGDIR"] = matplotlib.get_cachedir()          # its list of fonts takes seconds
os.environ["XDG_CACHE_HOME"] = str(CACHE)

HOSTILE = "<script>alert('x')</script>\"&'"
VOID = {"meta", "link", "br", "img", "input", "hr", "rect", "path", "circle", "wbr"}


class Page(html.parser.HTMLParser):
    """Checks the balance of tags; gathers ids, references and the elements' names."""

    def __init__(self, text):
        super().__init__()
        self.open, self.ids, self.references, self.faults, self.names = [], [], [], [], []
        self.feed(text)
        self.references += re.findall(r'url\("([^"]+)"\)', text)
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


def contest_row(model, **changes):
    """Of the table of models side by side."""
    cells = {"model": model, "size of": "cell", "size": 0.1, "error": 0.0123, "uncertainty": 0.0011,
             "processor time": 0.25, "energy": -0.0312, "momentum": 1e-16, "lasted": 3.0, "asked": 3.0, "broke by": ""}
    return [{**cells, **changes}[name] for name in side_by_side.COLUMNS]


def contest_table(rows, columns=side_by_side.COLUMNS):
    units = {"size": "depth", "error": "radius", "uncertainty": "radius", "processor time": "s", "lasted": "s",
             "asked": "s"}
    return [{"id": side_by_side.TABLE, "title": "t", "caption": "c", "atlas": [], "rows": rows,
             "columns": [{"name": name, "unit": units.get(name, "")} for name in columns]}]


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


def body(template, **context):
    """A page's body of a template alone."""
    store = Store(CACHE / "seiche/report")
    environment = pages.environment(Typesetter(store.memo, Formulas(store.memo).html), store.folder)
    return environment.get_template(f"{template}_body.html.j2").make_module({"root": "", **context}).body()


def reported(folder, *made, options=()):
    """Writes the records into a folder's `evidence` and renders them; the report's folder."""
    evidence, out = pathlib.Path(folder, "evidence"), pathlib.Path(folder, "report")
    evidence.mkdir(exist_ok=True)
    for one in made:
        (evidence / f"{one['case']}.{one['solver']}.json").write_text(json.dumps(one), encoding="utf-8")
    status, said = render(evidence, out, *options)
    assert status == 0, said
    return out


@functools.cache
def whole():
    """The report of all that a report must survive, with its evidence, pages by path, and what was said."""
    folder = pathlib.Path(SCRATCH.name, "whole")
    folder.mkdir()
    evidence, out = folder / "evidence", folder / "report"
    write_evidence(evidence)
    status, said = render(evidence, out, "--with-data")
    return types.SimpleNamespace(
        folder=folder, evidence=evidence, out=out, status=status, said=said,
        pages={path: Page(path.read_text(encoding="utf-8")) for path in out.rglob("*.html")},
        index=(out / "index.html").read_text(encoding="utf-8"))


class Whole(unittest.TestCase):
    """Tests of that report."""

    @classmethod
    def setUpClass(cls):
        for name, value in vars(whole()).items():
            setattr(cls, name, value)

    def page(self, name):
        return (self.out / f"{name}.html").read_text(encoding="utf-8")

    def hostile(self):
        """The page of the only verification group with a hostile name."""
        return (self.out / records.Record("hostile.json", record("hostile", kind="verification", group=HOSTILE)).page).read_text(
            encoding="utf-8")
