"""Small drawings, numbers, formulas and lists of pages read back: each coordinate, word and threshold by hand."""
import json
import math
import os
import pathlib
import re
import tempfile
import time
import types
import unittest
import unittest.mock
import xml.etree.ElementTree as xml

from made import HOSTILE, claim, figure, record

from render import (arrays, atlas, costs, experiments, figures, files, formulas, gallery, marks, matrix, pages, pictures, power, printed, quantities, records,
                    report, search, sharpness, speed, store, text)

figures.prepare()


def of(case="c", **changes):
    return records.Record(f"c.{changes['solver']}.json" if "solver" in changes else "c.json", record(case, **changes))


def judged(measured, expected, limit, kind="bound", uncertainty=0.0, verdict="pass", **more):
    made = claim("a", kind, verdict, measured=measured, expected=expected, uncertainty=uncertainty)
    return records.Claim({**made, "criterion": {**made["criterion"], "limit": limit, **more}})


def tree(svg):
    return xml.fromstring(str(svg))


class Gauges(unittest.TestCase):
    def parts(self, *arguments, **more):
        """Band, centre, spread and dot, in shares of the limit from what is expected."""
        one = judged(*arguments, **more)
        if not pages.gauge(one):
            return None
        drawn = {part.get("class"): part for part in tree(pages.gauge(one)) if part.get("class")}
        low, high = (-0.06, 1.5) if float(drawn["band"].get("x")) < 10 else (-1.6, 1.6)

        def share(x):
            return round(low + (float(x) - 4) / 112 * (high - low), 2)
        left, width = (float(drawn["band"].get(name)) for name in ("x", "width"))
        spread = re.findall(r"[MH](\S+)", drawn["spread"].get("d").replace(" 8H", " H")) if "spread" in drawn else ()
        dot = drawn["dot"].get("cx") or re.match(r"M(\S+) ", drawn["dot"].get("d"))[1]
        self.assertEqual((drawn["axis"].get("d"), tree(pages.gauge(one)).get("class")), ("M4 8H116", f"gauge {one.verdict}"))
        return ((share(left), share(left + width)), share(drawn["centre"].get("d").split()[0][1:]), tuple(map(share, spread)), share(dot),
                (re.findall(r"l(-?4) ", drawn["dot"].get("d", "")) or [""])[0])

    def near(self, found, wanted):
        for one, other in zip(found[0] + found[1:2] + found[2] + found[3:4], wanted[0] + wanted[1:2] + wanted[2] + wanted[3:4]):
            self.assertAlmostEqual(one, other, delta=0.011)
        self.assertEqual((len(found[2]), found[4]), (len(wanted[2]), wanted[4]))

    def test_the_dot_stands_at_its_share_of_the_limit_with_its_uncertainty(self):
        for arguments, wanted in (((2.5, 2.0, 1.0), ((-1, 1), 0, (), 0.5, "")), ((-0.5, 0.0, 1.0), ((-1, 1), 0, (), -0.5, "")),
                                  ((0.5, 0.0, 1.0), ((0, 1), 0, (), 0.5, "")), ((9.0, 0.0, 1.0), ((0, 1), 0, (), 1.5, "4")),
                                  ((-9.0, 0.0, 2.0), ((-1, 1), 0, (), -1.6, "-4")), ((9.0, 1.0, 2.0), ((-1, 1), 0, (), 1.6, "4"))):
            self.near(self.parts(*arguments), wanted)
        self.near(self.parts(2.5, 2.0, 2.0, uncertainty=0.5), ((-1, 1), 0, (0, 0.5), 0.25, ""))
        self.near(self.parts(2.5, 2.0, 2.0, uncertainty=9.0), ((-1, 1), 0, (-1.6, 1.6), 0.25, ""))
        self.near(self.parts(0.5, 0.0, 1.0, kind="order"), ((-1, 1), 0, (), 0.5, ""))
        self.near(self.parts(0.5, 0.0, 1.0, kind="roundoff", verdict="fail"), ((0, 1), 0, (), 0.5, ""))
        self.assertIn("0.25 of the limit", pages.gauge(judged(1.5, 2.0, 2.0)))

    def test_there_is_none_where_it_makes_no_sense(self):
        for arguments in ((None, 0.0, 1.0), (1.0, None, 1.0), (1.0, 0.0, None), (1.0, 0.0, 0.0), (1.0, 0.0, -1.0), (math.inf, 0.0, 1.0)):
            self.assertIsNone(self.parts(*arguments))
        self.assertIsNone(self.parts(1.0, 0.0, 1.0, kind="qualitative"))
        self.assertIsNone(self.parts(1.0, 0.0, 1.0, uncertainty=math.inf))
        self.assertIsNotNone(self.parts(1.0, 0.0, 1.0, uncertainty=None))


class Words(unittest.TestCase):
    def test_limits_readings_and_shares(self):
        for one, wanted in ((judged(1, 2, 0.5), "± 0.5"), (judged(1, -2, 0.5, relative=True), "± 0.5 (25 %)"), (judged(1, 0, 0.5, relative=True), "± 0.5"),
                            (judged(1, 2, None), ""), (judged(1, 1, 1.0, "qualitative"), ""), (judged(1, 2, 0.5, "order", relative=True), "± 0.5")):
            self.assertEqual(re.sub("<[^>]*>", "", pages.limit_html(one)), wanted)
        seen, number = judged(1, 1, None, "qualitative"), judged(1, 1, None)
        self.assertEqual([re.sub("<[^>]*>", "", str(pages.readable(one, value))) for one in (seen, number) for value in (0, 1, 2)],
                         ["absent", "present", "2", "0", "1", "2"])
        self.assertEqual([str(pages.percent(share)).replace("\u00a0", " ").replace("&lt;", "<") for share in (0, 0.12345, 1, 1e-6, 1e-5, 2.5)],
                         ["0 %", "12 %", "100 %", "< 0.001 %", "0.001 %", "250 %"])
        self.assertEqual([pages.plural(*words) for words in ((1, "case"), (2, "case"), (0, "case"), (1, "entry", "entries"), (2, "entry", "entries"))],
                         ["1 case", "2 cases", "0 cases", "1 entry", "2 entries"])
        self.assertEqual([pages.capital("wave of h"), pages.capital("")], ["Wave of h", ""])
        self.assertEqual([pages._date(text) for text in ("2026-03-01T12:30:59Z", "2026-03-01T12:30:59.25+00:00", "2026-03-01T12:30Z", "May")],
                         ["2026-03-01 12:30 UTC"] * 3 + ["May"])
        self.assertEqual(pages.short_commit({"commit": "0123456789abcdef", "dirty": True}), "0123456789 with uncommitted changes")

    def test_a_tally_counts_verdicts_what_surprises_first(self):
        claims = [judged(1, 1, 1, verdict=verdict) for verdict in ("pass", "fail", "pass", "error", "inconclusive")]
        for one, expected in zip(claims, (True, True, True, False, True)):
            one.raw["as_declared"] = expected
        self.assertEqual(pages.tally(claims), [("error", True, 1), ("pass", False, 2), ("fail", False, 1), ("inconclusive", False, 1)])

    def test_what_is_seen_first_is_pairs_of_words(self):
        for rows, name, wanted in (([["a", "b"]], "first-look", True), ([["a", 1]], "first-look", False), ([["a"]], "first-look", False), ([["a", "b"]], "t", False)):
            self.assertEqual(pages.is_first_look({"id": name, "rows": rows}), wanted)

    def test_the_overview_names_the_slowest_and_what_did_not_finish(self):
        made = [of(wall_time=float(time), case=f"c{time}") for time in range(7)] + [of(status="error", error="x", wall_time=None, claims=[])]
        told = pages.overview([records.Case(one.case, [one]) for one in made], ["broken"], ["problem"])
        self.assertEqual(([one.wall_time for one in told["slowest"]], told["wall_time"], told["crashed"], told["quiet"], told["records"]),
                         ([6, 5, 4, 3, 2], 21, made[7:], False, 8))
        quiet = [pages.overview([records.Case("c", members)], broken, [])["quiet"] for members, broken in ((made[:1], []), (made[:1], [1]), (made[7:], []))]
        self.assertEqual(quiet, [True, False, False])
        other = pages.overview([records.Case("c", [of(solver="theirs", wall_time=3.0)])], [], [])
        self.assertEqual((other["claims"], other["wall_time"], len(other["evidence"])), (1, 3, 3))

    def test_durations_and_numbers(self):
        for seconds, wanted in ((None, "—"), (0.00099, "< 1 ms"), (0.001, "1 ms"), (0.9994, "999 ms"), (0.9996, "1 s"), (9.99, "9.99 s"), (9.996, "10.0 s"),
                                (59.94, "59.9 s"), (59.96, "1 min 00 s"), (252, "4 min 12 s"), (3599.6, "1 h 00 min"), (7500, "2 h 05 min")):
            self.assertEqual(quantities.duration(seconds), wanted)
        for value, wanted in ((True, "yes"), (False, "no"), (9999, "9999"), (-10000, "−10 000"), (1234567, "1 234 567"), (10**9, "10<sup>9</sup>"), (None, "—"),
                              (0.5, "0.5"), (math.inf, "—"), ("<b>", "&lt;b&gt;"), (99999, "99 999")):
            self.assertEqual(re.sub("</?span[^>]*>", "", str(quantities.value(value))).replace(quantities.THIN, " "), wanted)
        for value, digits, wanted in ((0.0001, 4, "10<sup>−4</sup>"), (0.00012, 2, "1.2 × 10<sup>−4</sup>"), (0.001, 4, "0.001"), (12345.6, 4, "12350"), (100000.0, 7, "100000"),
                                      (1e-300, 4, "10<sup>−300</sup>"), (9999.0, 4, "9999"), (10000.0, 4, "10000"), (0.1 + 0.2, 3, "0.3")):
            self.assertEqual(quantities.plain(value, digits).replace(quantities.THIN, " "), wanted)
        for text_, wanted in (("kg*m", "kg m"), ("m^-1", "m<sup>−1</sup>"), ("-", ""), ("", ""), ("m^{1/2}", "m<sup>1/2</sup>")):
            self.assertEqual(re.sub("</?span[^>]*>", "", str(quantities.unit(text_))).replace(quantities.THIN, " "), wanted)


def paths(svg, **wanted):
    return [part.get("d") for part in tree(svg).iter("path") if all(part.get(name.replace("_", "-")) == value for name, value in wanted.items())]


class Drawings(unittest.TestCase):
    def test_marks_are_shapes_about_their_place(self):
        circle = tree(marks.mark(0).svg(10, 20, 3))
        self.assertEqual((circle.tag, circle.get("cx"), circle.get("cy"), circle.get("r"), circle.get("fill")), ("circle", "10.0", "20.0", "3", marks.COLOURS[0]))
        for number, shape in ((6, "m-3 -3h6v6h-6z"), (12, "m0 -3.6l3.6 6.3h-7.2z"), (18, "m0 -3.9l3.9 3.9l-3.9 3.9l-3.9 -3.9z")):
            self.assertEqual(tree(marks.mark(number).svg(10, 20, 3)).get("d"), f"M10.0 20.0{shape}")
        self.assertEqual([(marks.mark(k).colour, marks.mark(k).letter) for k in (5, 6, 23, 24)],
                         [(marks.COLOURS[5], "●"), (marks.COLOURS[0], "■"), (marks.COLOURS[5], "◆"), (marks.COLOURS[0], "●")])

    def test_axes_have_ticks_at_their_places_and_names(self):
        parts = marks.axes(50, 200, 100, lambda value, axis: (70 if axis else 60) + 10 * math.log10(value), [(0, 0.5), (-0.2, 0.1)], "cost", "<error>")
        drawn = tree(f"<svg>{''.join(parts)}</svg>")
        self.assertEqual([part.get("d") for part in drawn.iter("path")], ["M50 0V100H250", "M60.0 100v3", "M63.0 100v3", "M50 70.0h-3"])
        self.assertEqual([(one.text, one.get("x"), one.get("y"), one.get("text-anchor")) for one in drawn.iter("text")], [
            ("1", "60.0", "115", "middle"), ("2", "63.0", "115", "middle"), ("1", "45", "74.0", "end"), ("cost", "150.0", "134", "middle"),
            ("<error>", "12", "50.0", "middle")])
        self.assertEqual(list(drawn.iter("text"))[-1].get("transform"), "rotate(-90 12 50.0)")
        self.assertEqual([marks._ticks(*span) for span in ((0, 2), (-0.5, 1.6), (0.31, 0.69))], [[1, 2, 5, 10, 20, 50, 100], [1, 10], []])

    def test_errors_stand_against_costs_on_logarithmic_axes(self):
        found = costs.Costs("h", "time [s]", [costs.Curve("a", [(1.0, 0.1), (100.0, 0.001)]), costs.Curve("b", [(10.0, 0.01)])])
        drawn = tree(f"<div>{costs.figure(found)}</div>")
        (line,) = (part.get("d") for part in drawn.iter("path") if part.get("stroke-width") == "1.4")
        x, y = (lambda decade: costs.LEFT + costs.WIDTH * (decade + 0.12) / 2.24), (lambda decade: costs.HEIGHT * (1 - (decade + 3.12) / 2.24))
        self.assertEqual(line, f"M{x(0):.1f} {y(-1):.1f}L{x(2):.1f} {y(-3):.1f}")
        self.assertEqual([(float(one.get("cx")), float(one.get("cy")), one.get("fill"), one.find("title").text) for one in drawn.iter("circle")], [
            (round(x(0), 1), round(y(-1), 1), marks.COLOURS[0], "a: 0.1 for 1"), (round(x(2), 1), round(y(-3), 1), marks.COLOURS[0], "a: 0.001 for 100"),
            (round(x(1), 1), round(y(-2), 1), marks.COLOURS[1], "b: 0.01 for 10")])
        self.assertEqual(["".join(one.itertext()) for one in drawn.iter("span")], ["● a", "● b"])
        self.assertEqual([one.get("style") for one in drawn.iter("b")], [f"color: {marks.COLOURS[k]}" for k in (0, 1)])
        self.assertEqual(drawn.find("svg").get("viewBox"), "0 -6 396 256")

    def test_costs_are_read_by_the_names_of_their_columns(self):
        def ladder(names, *rows, name=costs.TABLE):
            return [{"id": name, "title": "", "caption": "", "atlas": [], "columns": [{"name": one, "unit": ""} for one in names], "rows": list(rows)}]
        found = costs.survey([of(tables=ladder(("size", "time", "u", "h"), [0.1, 9.0, 0.4, 0.3])), of(solver="b", tables=ladder(("size", "h"), [0.2, 0.6])),
                              of(solver="c", wall_time=5.0, measurements={"h_relative_l2": 0.25})])
        self.assertEqual((found.quantity, found.cost, [(one.solver, one.points) for one in found.curves]), ("h", "time [s]", [("seiche", [(9, 0.3)]), ("c", [(5, 0.25)])]))
        found = costs.survey([of(tables=ladder(("size", "h"), [0.1, 0.3])), of(solver="c", measurements={"h_relative_l2": 0.25, "cell_size": 0.5})])
        self.assertEqual((found.cost, [one.points for one in found.curves]), ("cell [m]", [[(0.1, 0.3)], [(0.5, 0.25)]]))
        for tables in (ladder(("size",), [1.0]), ladder(("cell", "h"), [1.0, 2.0]), ladder(("size", "h"), [1.0, 2.0], name="t"), ladder(("size", "time"), [1.0, 2.0])):
            self.assertIsNone(costs.survey([of(tables=tables)]))
        self.assertIsNone(costs.survey([of(tables=ladder(("size", "h"), [1.0, 2.0])), of(solver="b", tables=ladder(("size", "u"), [1.0, 2.0]))]))
        self.assertEqual([costs._positive(value) for value in (1, 0.5, 0, -1, True, math.inf, None, "1")], [True, True, *6 * [False]])
        self.assertEqual([costs.of(one, what) for one in (of(measurements={"x": 3.0}), of(solver="b", wall_time=0.0, measurements={"threads": 4.0}))
                          for what in ("wall_time", "threads", "x")], [1.5, 1, 3, None, 4, None])

    def test_readings_stand_where_computed_meets_measured(self):
        pairs = [experiments.Pair(None, "r", 1.0, 0.1, 10.0), experiments.Pair(None, "s", 10.0, 1.0, 10.0)]
        drawn = experiments.scatter_figure([experiments.Line("m", marks.mark(0), pairs, 0, [])])
        self.assertEqual(experiments.scatter_figure([]), "")
        left, size, whole = experiments.LEFT, experiments.SIZE, 1.2
        low, high = left + size * 0.1 / whole, left + size * 1.1 / whole
        self.assertEqual([(one.get("cx"), one.get("cy"), one.get("fill-opacity"), one.find("title").text) for one in tree(drawn).iter("circle")], [
            (f"{low:.1f}", f"{size * 0.1 / whole:.1f}", ".75", "m, r: computed 10, measured 1"),
            (f"{high:.1f}", f"{size * 0.1 / whole:.1f}", ".75", "m, s: computed 10, measured 10")])
        offset = size * math.log10(1.2) / whole     # twice the experiments' 10 %
        self.assertEqual(paths(drawn, stroke_dasharray="3 3"), [f"M{left + offset:.1f} {size:.1f}L{left + size:.1f} {offset:.1f}",
                                                                f"M{left:.1f} {size - offset:.1f}L{left + size - offset:.1f} 0.0"])

    def test_formulas_have_their_size_and_sit_on_their_baseline(self):
        def set_(tex, display=False):
            return tree(f"<div>{formulas._set(tex, display)}</div>")
        sizes = {}
        for tex in ("x", "xx", "x^2", "y", r"\frac{a}{b}", r"\frac{x}{y}"):
            svg = set_(tex).find("svg")
            style = dict(re.findall(r"([\w-]+):(-?[\d.]+)", svg.get("style")))
            box = list(map(float, svg.get("viewBox").split()))
            path = svg.find("path").get("d")
            here, low, high = [0, 0], [1e9, 1e9], [-1e9, -1e9]
            for letter, numbers in re.findall(r"([MlqcZz])([^MlqcZz]*)", path):
                numbers = list(map(int, re.findall(r"-?\d+", numbers)))
                start = [0, 0] if letter == "M" else list(here)
                for x, y in zip(numbers[::2], numbers[1::2]):
                    here = [start[0] + x, start[1] + y]
                    low, high = ([pick(a, b) for a, b in zip(end, here)] for pick, end in ((min, low), (max, high)))
            self.assertTrue(box[0] <= low[0] and box[1] <= low[1] and high[0] <= box[0] + box[2] and high[1] <= box[1] + box[3], (tex, low, high, box))
            self.assertAlmostEqual(box[2] / box[3], float(style["width"]) / float(style["height"]), delta=0.01)
            self.assertAlmostEqual(float(style["width"]), box[2] / 1000, delta=0.002)
            self.assertAlmostEqual(float(style["vertical-align"]), -(box[1] + box[3]) / 1000, delta=0.002)       # what hangs below zero
            self.assertEqual((svg.get("aria-label"), svg.find("title").text), (tex, tex))
            sizes[tex] = float(style["width"]) + 2 * float(style["margin"] if "margin" in style else 0), float(style["height"])
        self.assertGreater(sizes["xx"][0], 1.5 * sizes["x"][0])
        self.assertGreater(float(re.search(r"height:([\d.]+)", str(formulas._set(r"\frac{a}{b}", True)))[1]), sizes[r"\frac{a}{b}"][1])      # set larger

    def test_formulas_of_several_lines_and_those_that_cannot_be_set(self):
        shown = formulas._set(r"\begin{aligned}a &= b \\ c &= d\end{aligned} \tag{3.1}", True)
        self.assertEqual((shown.count('<span class="row">'), shown.count("<svg")), (2, 2))
        self.assertIn('<span class="tag">(3.1)</span>', shown)
        self.assertNotIn("display", formulas._set("x", False))
        self.assertEqual(formulas._set(r"\nothing<", False), r'<code class="tex" title="formula">\nothing&lt;</code>')
        for tex, like in ((r"\text{a b}", r"\mathrm{a\ b}"), (r"\tfrac 1 2", r"\frac{1}{2}"), (r"\dfrac{a}{b}", r"\frac{a}{b}"), (r"\bigl(a\bigr)", "(a)"), (r"\lvert a\rvert", "|a|"),
                          (r"\le", r"\leq"), (r"\ge", r"\geq"), (r"\to", r"\rightarrow"), (r"\bm{a}", r"\mathbf{a}"), (r"\dots", r"\ldots"), (r"\Fr", r"\mathrm{Fr}"), ("a~b", r"a\ b"),
                          (r"\operatorname{sn} x", r"\mathrm{sn} x"), (r"\lVert a\rVert", r"\|a\|"), (r"\mathrm d x", r"\mathrm{d} x"), (r"\displaystyle a", "a")):
            self.assertEqual(*(tree(formulas._set(one, False)).find("path").get("d") for one in (tex, like)), tex)

    def test_svg_is_slimmed_without_a_change_of_what_is_seen(self):
        png = "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNk+M9QDwADhgGAWjR9awAAAABJRU5ErkJggg=="
        svg = f"""<?xml version="1.0"?><!DOCTYPE x><!-- c
--><svg><metadata>m</metadata>
   <g id="frame-0 series-2"><path id="abc" d="M 1.234 5.678"/></g>
   <g id="frame-1"/><g id="lost"/><image xlink:href="data:image/png;base64,{png}"/>
   <use xlink:href="#abc" transform="translate(3.19 4.08)" style="fill: red"/>
   <use xlink:href="#abc" x="5.5" y="6.5" style="fill: red"/>
   <use xlink:href="#abc" x="7.5" y="8.5" style="fill: blue"/></svg>"""
        slim = figures._slim(svg, 1)
        self.assertIn('<g data-frame="0" display="none" data-series="2"><path id="n0" d="M 1.2 5.6"/></g>\n<g data-frame="1"/><g/>', slim)
        self.assertIn("data:image/webp;base64,", slim)
        self.assertRegex(slim, r'<marker id="(m\d+)" overflow="visible" markerUnits="userSpaceOnUse"><use href="#n0" style="fill: red"/></marker>'
                               r'<path d="M3.1 4.0 5.5 6.5" style="fill: none; marker: url\(#\1\)"/>\n<use href="#n0" x="7.5" y="8.5" style="fill: blue"/>')
        for gone in ("DOCTYPE", "metadata", "<!--", "xlink", "\n   "):
            self.assertNotIn(gone, slim)

    def test_a_figure_says_where_its_panels_stand_and_what_they_span(self):
        from render import panels
        from test_drawn import panel, series
        content = {"panels": [panel(series("a"), x_min=0.5, x_max=4.5, y_min=1.0, y_max=9.0, log_y=1), panel(series("b"), x_label="other", log_x=1)]}
        canvas = panels.panels(content, False)
        about = json.loads(tree(figures._answering("<svg ></svg>", canvas, content).replace("href", "h")).get("data-figure"))
        self.assertEqual((about["labels"], [one["log"] for one in about["panels"]]), (["a", "b"], [[False, True], [True, False]]))
        self.assertEqual((about["panels"][0]["x"], about["panels"][0]["y"]), ([0.5, 4.5], [1, 9]))
        width, height = 72 * canvas.get_size_inches()
        for one, axis in zip(about["panels"], canvas.axes):
            box, (left, top, wide, high) = axis.get_position(), one["box"]
            for found, wanted in ((left, box.x0 * width), (left + wide, box.x1 * width), (height - top, box.y1 * height), (height - top - high, box.y0 * height)):
                self.assertAlmostEqual(found, wanted)
        panels.matplotlib.pyplot.close("all")


class Lists(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))

    def test_the_share_of_a_limit(self):
        for one, wanted in ((judged(1.5, 1.0, 2.0), 0.25), (judged(0.5, 1.0, 2.0, uncertainty=0.5), 0.5), (judged(0.5, 1.0, 2.0, "uncertainty", 0.5), 0.25),
                            (judged(1.5, 1.0, 2.0, "order", 0.5), 0.5), (judged(1.5, 1.0, 2.0, "roundoff", 0.5), 0.5), (judged(1.5, 1.0, 2.0, verdict="fail"), None),
                            (judged(1.0, 1.0, 1.0, "qualitative"), None), (judged(None, 1.0, 1.0), None), (judged(1.0, None, 1.0), None), (judged(1.0, 1.0, 0.0), None),
                            (judged(math.inf, 1.0, 1.0), None), (judged(1.5, 1.0, 2.0, uncertainty=None), 0.25)):
            self.assertEqual(sharpness.share(one), wanted)
        shares = (0.0, 0.5e-4, 1e-4, 0.005, 0.01, 0.1, 0.3, 0.89, 0.9, 1.0)
        told = sharpness.survey([of(claims=[judged(share, 0.0, 1.0).raw for share in shares] + [judged(0.5, 0.0, 1.0, "order").raw])])
        self.assertEqual(told["columns"], ["0", "below 0.0001", "0.0001 to 0.001", "0.001 to 0.01", "0.01 to 0.1", "0.1 to 0.3", "0.3 to 0.6", "0.6 to 0.9", "0.9 to 1"])
        self.assertEqual(told["kinds"], {"bound": [1, 1, 1, 1, 1, 1, 1, 1, 2], "order": [0, 0, 0, 0, 0, 0, 1, 0, 0]})
        self.assertEqual((told["count"], told["exact"], [one.share for one in told["marginal"]], [one.share for one in told["loose"]]), (11, 1, [1], [0.5e-4, 1e-4, 0.005]))

    def test_power_has_a_column_for_each_change_with_a_size(self):
        def row(change, by="a", unit="1", quantity="eta", table="wall"):
            return {"table": table, "quantity": quantity, "change": change, "by": by, "smallest": "0.04", "amount": "0.0213", "unit": unit}
        table = power.table([row("amplitude"), row("datum", unit="m"), row("shift", by=""), row("amplitude", quantity="u"), row("mirror"), row("noise", by=""), row("copy", by="same"),
                             row("other", table="")])
        self.assertEqual([column["name"] for column in table["columns"]], ["table", "quantity", "amplitude", "datum", "shift"])
        self.assertEqual(table["rows"], [["wall", "eta", "4 %", "4 % (0.021 m)", "not detected"], ["wall", "u", "4 %", "", ""]])
        self.assertTrue(table["caption"].endswith("without a size: detected: mirror (wall); not detected: noise (wall)."))

    def test_the_index_of_the_search_has_each_word_once(self):
        case = records.Case("long_wave", [of(case="long_wave", group="dam_break", source="Ritter", title="A <wave>", article="Ritter's depth of a wave " + " ".join(f"word{k}x" for k in range(70)))])
        test = records.Case("t", [of(case="t", kind="verification", source="Stoker", title="T")])
        found = types.SimpleNamespace(title="P", id="p", words="Big", quantity="Front", group="drop")
        model = {"title": "M", "id": "m", "equations": "Euler", "avoid": "Foam"}
        search.write(self.folder / "deep/search.js", {"problems": [found], "models": [model], "synonyms": {"a": "b"}}, [case, test])
        said = (self.folder / "deep/search.js").read_text()
        self.assertNotIn("<", said)
        index = json.loads(said.removeprefix("window.searchIndex=").removesuffix(";\n"))
        words = index["entries"].pop(2)
        self.assertEqual(index, {"entries": [["P", "problems/p.html", "big front drop"], ["M", "models/m.html", "euler foam"],
                                             ["T", "verification/bore.html#c", "stoker"]], "synonyms": {"a": "b"}})
        self.assertEqual(words[:2], ["A <wave>", "cases/long_wave.html"])
        self.assertEqual(words[2].split()[:8], ["long", "wave", "dam", "break", "ritter", "seiche", "defect", "depth"])
        self.assertEqual(words[2].split()[-1], "word58x")      # sixty of the article

    def test_speeds_are_numbers_or_a_word(self):
        row = {"program": "p", "benchmark": "b/4/iterations:4/real_time", "nanoseconds_per_item": "0.5", "of_peak": "adaptive", "processor": "a", "date": "d"}
        told = speed._numbers(row)
        self.assertEqual(told, {**row, "benchmark": "b/4", "nanoseconds_per_item": 0.5, "of_peak": None, "bytes_per_item": None, "not_counted": "adaptive"})
        self.assertEqual((speed._numbers({**row, "of_peak": "0.5"})["not_counted"], speed._number("")), ("", None))
        other = {**told, "program": speed.MACHINE, "processor": "b", "date": "c"}
        found = speed.survey([told, other], ["x"])
        self.assertEqual(found, {"machine": [other], "build": ["x"], "programs": {"p": [told]}, "count": 2, "processors": ["a", "b"], "dates": ["c", "d"]})

    def test_regimes_come_from_a_case_or_from_numbers(self):
        own = {"wave": of(parameters={"a": {"value": 0.2}, "h": {"value": 2.0}}), "gone": None}
        for said, wanted in (({}, (None, None, None)), ({"height": 0.1}, (None, 0.1, None)), ({"case": "wave", "height": "a", "depth": "h", "length": 10.0}, (0.4 * math.pi, 0.1, 2.5)),
                             ({"case": "wave", "height": "a", "both": True}, (None, 0.4, None)), ({"case": "gone", "height": 0.1}, (None,) * 3), ({"case": "wave", "height": "b"}, (None,) * 3),
                             ({"length": math.pi}, (2, None, None))):
            found = matrix._regime(said, own)
            for name, value in zip(("kh", "H/h", "Ur"), wanted):
                self.assertEqual(found[name], value if value is None else unittest.mock.ANY)
                self.assertAlmostEqual(found[name] or 0, value or 0)
        for error, shade in ((None, 0), (0.0099, 0), (0.01, 1), (0.05, 2), (0.1, 3), (0.25, 4)):
            self.assertEqual(matrix.Cell(None, "", error, None, 1).shade, shade)
        self.assertEqual([[(one.phenomenon, one.name, one.case) for one in members] for _, members in matrix.scorable("b/x,a/y,b/z", [types.SimpleNamespace(name="z")])][0],
                         [("a", "y", None)])

    def test_what_the_report_could_not_show_is_a_sentence(self):
        one, two = of(figures=[figure("f"), figure("g")], fields="c.xdmf"), of(digest="0" * 64, figures=[figure("f")])
        two.stem = "two"
        drawn = {("c", "f"): gallery.Drawn(problem="torn"), ("c", "g"): gallery.Drawn(), ("two", "f"): gallery.Drawn(problem="unread")}
        surveys = {"c": {"problem": ""}, "two": {"problem": "unread"}}
        self.assertEqual([said for _, said in report._problems([one, two], surveys, drawn, [(one, "no-tile")], self.folder)], [
            "figure “f”: torn", "c.xdmf is missing", "it carries no digest: a change after it was written would not be seen", "unread", "no tile of the atlas is called “no-tile”"])
        (self.folder / "c.xdmf").touch()
        sealed = of(digest="0" * 64, fields="c.xdmf", files={"c.xdmf": "other"})
        self.assertEqual([said for _, said in report._problems([sealed], {"c": {"problem": ""}}, {}, [], self.folder)],
                         ["c.xdmf is not the file that was written with the record: its digest differs"])

    def test_the_menu_and_the_pages_of_cases_lead_to_their_neighbours(self):
        self.assertEqual([name for name, _ in report._menu(True)],
                         ["index.html", "cases.html", "agreement.html", "atlas.html", "league.html", "deviations.html", "quality.html", "reading.html"])
        self.assertNotIn("league.html", [name for name, _ in report._menu(False)])
        cases = [records.Case(name, [of(case=name, kind=kind)]) for name, kind in (("a", "validation"), ("b", "validation"), ("c", "validation"), ("v", "verification"))]
        told, broken = [], []
        for case in cases:
            report._made(case, cases, {}, {}, lambda template, page, root, **more: told.append((page, root, more["before"], more["after"])), broken)
        self.assertEqual(told, [("cases/a.html", "../", None, cases[1]), ("cases/b.html", "../", cases[0], cases[2]), ("cases/c.html", "../", cases[1], None)])

        def fails(template, page, root, **more):
            if template == "case.html.j2":
                raise ValueError("torn")
            told.append((template, page, more["reason"]))
        self.assertFalse(report._made(cases[0], cases, {}, {}, fails, broken))
        self.assertEqual((told[-1], broken[0].file, broken[0].reasons), (("broken.html.j2", "cases/a.html", "ValueError: torn"), "c.json", ["page not made: ValueError: torn"]))

    def test_records_are_ordered_and_named(self):
        def case(**changes):
            return records.cases([of(**one) for one in ({"solver": "b"}, {"solver": "a"}, {}, {"tier": "paper"}, {"tier": "full"},
                                                        {"set": "s", "published": [{"here": True, "tiles": []}]})])[0]
        self.assertEqual([one.by for one in case().records], ["seiche, s", "seiche, paper", "seiche, full", "seiche", "a", "b"])
        self.assertTrue(case().peers)
        verdicts = {"error": of(status="error", claims=[]), "none": of(claims=[]), "fail": of(claims=[claim("a"), claim("b", verdict="fail"), claim("c", verdict="inconclusive")]),
                    "inconclusive": of(claims=[claim("a", verdict="inconclusive"), claim("b")]), "pass": of()}
        self.assertEqual([one.worst for one in verdicts.values()], list(verdicts))
        self.assertEqual([one.unexpected for one in verdicts.values()], [True, False, True, True, False])
        shown = [figure("f", atlas=["t"]), figure("g")]
        for changes, names in (({}, "fg"), ({"kind": "verification"}, "f"), ({"kind": "verification", "claims": [claim("a", verdict="fail")]}, "fg"),
                               ({"kind": "verification", "claims": [claim("a", "order")]}, "fg")):
            self.assertEqual([one["id"] for one in of(figures=shown, **changes).shown], list(names))
        self.assertEqual([of(parameters={"a": {"value": 1, "default": default}}, set=name).standard for default, name in ((1, ""), (2, ""), (2, "s"))], [True, False, True])
        self.assertEqual((records.slug("a b"), records.slug("a.b-c_1")), (f"a-b-{store.digest('a b')[:6]}", "a.b-c_1"))
        several = of(kind="verification", group="a")
        several.sheet = "-2"
        self.assertEqual(several.page, "verification/a-2.html")
        self.assertEqual(of(atlas=["x"], figures=[figure("f", atlas=["y"])], tables=[{"atlas": ["x", "z"]}]).tiles, ["x", "y", "z"])

    def test_a_strip_takes_as_many_of_each_source_as_there_is_room_for(self):
        def tiles(name, count, picture=True):
            return [atlas.Tile(f"{name}{k}", "figure", "", "", "", picture=(1,) if picture else None) for k in range(count)]
        shown = [({}, tiles("a", 9)), ({}, tiles("b", 9)), ({}, tiles("c", 2)), ({}, tiles("d", 5, False))]
        self.assertEqual([tile.id for tile in atlas.strip(shown)], ["a0", "a1", "a2", "b0", "b1", "b2", "c0", "c1"])
        self.assertEqual(atlas.strip([]), [])

    def test_a_store_keeps_what_is_used_and_drops_what_is_not(self):
        kept = store.Store(self.folder, "r")
        self.assertEqual([kept.memo("k", "a", lambda: made) for made in (1, 2)], [1, 1])
        self.assertEqual(kept.memo("k", "b", lambda: 3), 3)
        kept.save()
        again = store.Store(self.folder, "r")
        self.assertEqual([again.memo("k", "a", lambda: 9), again.memo("l", "a", lambda: 9)], [1, 9])
        again.save()
        self.assertEqual(store.Store(self.folder, "other").memo("k", "a", lambda: 7), 1)       # begins with the latest
        self.assertEqual(store.Store(self.folder, "r").memo("k", "b", lambda: 5), 5)           # no longer used
        old, new = (self.folder / "figures" / f"{name}.svg" for name in ("old", "new"))
        for path, days in ((old, 31), (new, 29)):
            path.touch()
            os.utime(path, 2 * (time.time() - 86400 * days,))
        self.assertEqual((again.figure("new"), again.figure("none").exists()), (new, False))
        self.assertLess(abs(new.stat().st_atime - time.time()), 60)
        again.save()
        self.assertEqual((old.exists(), new.exists()), (False, True))
        self.assertNotEqual(store.digest("a", "bc"), store.digest("ab", "c"))
        self.assertEqual((store.digest("é"), len(store.digest())), (store.digest("é".encode()), 40))
        (self.folder / "torn").mkdir()
        (self.folder / "torn" / f"texts-{store.digest('')}.json").write_text("{")
        self.assertEqual(store.Store(self.folder / "torn").memo("k", "a", lambda: 4), 4)

    def test_files_of_strangers_are_regular_and_not_too_large(self):
        path = self.folder / "a.json"
        path.write_bytes(b"x" * 10)
        with unittest.mock.patch.object(files, "LARGEST_RECORD", 10):
            self.assertEqual(files.read_text(path), 10 * "x")
        with unittest.mock.patch.object(files, "LARGEST_RECORD", 9), self.assertRaisesRegex(ValueError, "10 bytes, more than the 9"):
            files.read_text(path)
        (self.folder / "link").symlink_to(path)
        self.assertEqual([files.is_regular(self.folder / name) for name in ("a.json", "link", "none", ".")], [True, False, False, False])
        with self.assertRaisesRegex(ValueError, "not a regular file"):
            files.read_text(self.folder / "link")

    def test_a_picture_is_drawn_of_the_first_record_of_a_longer_tier_with_the_parameters_of_the_source(self):
        from made import published, write_arrays
        for name, tier, here in (("a", "full", True), ("b", "quick", True), ("c", "paper", False)):
            one = record(name, tier=tier, data=f"{name}.h5", figures=[figure("f", atlas=[f"tile-{name}"])], published=published(f"tile-{name}", here))
            (self.folder / f"{name}.json").write_text(json.dumps(one))
            write_arrays(self.folder / f"{name}.h5", {"f": [[("a", "computed", "line", [0, 1], [0, 1])]]})
        self.assertEqual(pictures.draw(self.folder, self.folder / "kept"), ["tile-a"])
        with unittest.mock.patch.object(pictures, "KEPT", self.folder / "kept"):
            self.assertEqual((pictures.of("tile-a"), pictures.of("tile-b")), (self.folder / "kept/tile-a.webp", None))

    def test_articles_are_set_and_harmless(self):
        setter = text.Typesetter(lambda kind, key, make: make(), lambda tex, display: f"<f>{tex}{display}</f>")
        for said, wanted in (("# A", "<h3>A</h3>"), ("##### A", "<h6>A</h6>"), ("###### A", "<h6>A</h6>"), ("$a$, $$b$$", "<p><span class=\"n\"><f>aFalse</f>,</span> <f>bTrue</f></p>"), ("5$ and $6", "<p>5$ and $6</p>"),
                             ("`$b$`", "<p><code>$b$</code></p>"), ("[a](http://b)", '<p><a href="http://b">a</a></p>'), ("[a](file:b)", "<p><span>a</span></p>"),
                             ("[a](#b)", '<p><a href="#b">a</a></p>'), ("![p](q)", "<p><em>p</em></p>"), ("a|b\n-|-\n1|2\n\nc", None), ("<b>x</b>", "<p>&lt;b&gt;x&lt;/b&gt;</p>")):
            found = setter.block(said)
            if wanted is None:
                self.assertRegex(found, r'(?s)^<div class="scroll"><table>.*</table>\s*</div>\s*<p>c</p>$')
            else:
                self.assertEqual(found, wanted)
        for said, wanted in (("plain", "plain"), ("a < b", "a &lt; b"), ("*a*", "<em>a</em>"), ("a\n\nb", "a\n\nb"), ("- a", "- a")):
            self.assertEqual(setter.inline(said), wanted)
        with unittest.mock.patch.object(text, "LONGEST", 0.05):
            slow = text.Typesetter(lambda kind, key, make: make(), lambda tex, display: time.sleep(1))
            self.assertEqual(slow.block("$a$ <"), "<pre>$a$ &lt;</pre>")


if __name__ == "__main__":
    unittest.main()
