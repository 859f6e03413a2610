"""Small drawings, numbers and formulas of pages read back: each coordinate, word and threshold by hand."""
import json
import math
import re
import unittest
import xml.etree.ElementTree as xml

from made import claim, record

from render import costs, experiments, figures, formulas, marks, pages, quantities, records

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
        return ((share(left), share(left + width)), share(drawn["centre"].get("d").split()[0][1:]), tuple(map(share, spread)),
                share(dot),
                (re.findall(r"l(-?4) ", drawn["dot"].get("d", "")) or [""])[0])

    def near(self, found, wanted):
        for one, other in zip(found[0] + found[1:2] + found[2] + found[3:4], wanted[0] + wanted[1:2] + wanted[2] + wanted[3:4]):
            self.assertAlmostEqual(one, other, delta=0.011)
        self.assertEqual((len(found[2]), found[4]), (len(wanted[2]), wanted[4]))

    def test_the_dot_stands_at_its_share_of_the_limit_with_its_uncertainty(self):
        for arguments, wanted in (((2.5, 2.0, 1.0), ((-1, 1), 0, (), 0.5, "")), ((-0.5, 0.0, 1.0), ((-1, 1), 0, (), -0.5, "")),
                                  ((0.5, 0.0, 1.0), ((0, 1), 0, (), 0.5, "")), ((9.0, 0.0, 1.0), ((0, 1), 0, (), 1.5, "4")),
                                  ((-9.0, 0.0, 2.0), ((-1, 1), 0, (), -1.6, "-4")),
                                  ((9.0, 1.0, 2.0), ((-1, 1), 0, (), 1.6, "4"))):
            self.near(self.parts(*arguments), wanted)
        self.near(self.parts(2.5, 2.0, 2.0, uncertainty=0.5), ((-1, 1), 0, (0, 0.5), 0.25, ""))
        self.near(self.parts(2.5, 2.0, 2.0, uncertainty=9.0), ((-1, 1), 0, (-1.6, 1.6), 0.25, ""))
        self.near(self.parts(0.5, 0.0, 1.0, kind="order"), ((-1, 1), 0, (), 0.5, ""))
        self.near(self.parts(0.5, 0.0, 1.0, kind="roundoff", verdict="fail"), ((0, 1), 0, (), 0.5, ""))
        self.assertIn("0.25 of the limit", pages.gauge(judged(1.5, 2.0, 2.0)))

    def test_there_is_none_where_it_makes_no_sense(self):
        for arguments in ((None, 0.0, 1.0), (1.0, None, 1.0), (1.0, 0.0, None), (1.0, 0.0, 0.0), (1.0, 0.0, -1.0),
                          (math.inf, 0.0, 1.0)):
            self.assertIsNone(self.parts(*arguments))
        self.assertIsNone(self.parts(1.0, 0.0, 1.0, kind="qualitative"))
        self.assertIsNone(self.parts(1.0, 0.0, 1.0, uncertainty=math.inf))
        self.assertIsNotNone(self.parts(1.0, 0.0, 1.0, uncertainty=None))


class Words(unittest.TestCase):
    def test_limits_readings_and_shares(self):
        for one, wanted in ((judged(1, 2, 0.5), "± 0.5"), (judged(1, -2, 0.5, relative=True), "± 0.5 (25 %)"),
                            (judged(1, 0, 0.5, relative=True), "± 0.5"),
                            (judged(1, 2, None), ""), (judged(1, 1, 1.0, "qualitative"), ""),
                            (judged(1, 2, 0.5, "order", relative=True), "± 0.5")):
            self.assertEqual(re.sub("<[^>]*>", "", pages.limit_html(one)), wanted)
        seen, number = judged(1, 1, None, "qualitative"), judged(1, 1, None)
        self.assertEqual([re.sub("<[^>]*>", "", str(pages.readable(one,
                                                                   value))) for one in (seen, number) for value in (0, 1, 2)],
                         ["absent", "present", "2", "0", "1", "2"])
        self.assertEqual([str(pages.percent(share)).replace("\u00a0",
                                                            " ").replace("&lt;",
                                                                         "<") for share in (0, 0.12345, 1, 1e-6, 1e-5, 2.5)],
                         ["0 %", "12 %", "100 %", "< 0.001 %", "0.001 %", "250 %"])
        self.assertEqual([pages.plural(*words) for words in ((1, "case"), (2, "case"), (0, "case"), (1, "entry", "entries"),
                                                             (2, "entry", "entries"))],
                         ["1 case", "2 cases", "0 cases", "1 entry", "2 entries"])
        self.assertEqual([pages.capital("wave of h"), pages.capital("")], ["Wave of h", ""])
        self.assertEqual([pages._date(text) for text in ("2026-03-01T12:30:59Z", "2026-03-01T12:30:59.25+00:00",
                                                         "2026-03-01T12:30Z", "May")],
                         ["2026-03-01 12:30 UTC"] * 3 + ["May"])
        self.assertEqual(pages.short_commit({"commit": "0123456789abcdef", "dirty": True}),
                         "0123456789 with uncommitted changes")

    def test_a_tally_counts_verdicts_what_surprises_first(self):
        claims = [judged(1, 1, 1, verdict=verdict) for verdict in ("pass", "fail", "pass", "error", "inconclusive")]
        for one, expected in zip(claims, (True, True, True, False, True)):
            one.raw["as_declared"] = expected
        self.assertEqual(pages.tally(claims), [("error", True, 1), ("pass", False, 2), ("fail", False, 1),
                                               ("inconclusive", False, 1)])

    def test_what_is_seen_first_is_pairs_of_words(self):
        for rows, name, wanted in (([["a", "b"]], "first-look", True), ([["a", 1]], "first-look", False),
                                   ([["a"]], "first-look", False), ([["a", "b"]], "t", False)):
            self.assertEqual(pages.is_first_look({"id": name, "rows": rows}), wanted)

    def test_the_overview_names_the_slowest_and_what_did_not_finish(self):
        made = [of(wall_time=time, case=f"c{time}") for time in (0.25, 1.5, 2.5, 0.5, 3.5)]
        made += [of(status="error", error="x", wall_time=None, claims=[])]
        told = pages.overview([records.Case(one.case, [one]) for one in made], ["broken"], ["problem"])
        self.assertEqual(([one.wall_time for one in told["slowest"]], told["wall_time"], told["crashed"], told["quiet"],
                          told["records"]), ([3.5, 2.5, 1.5, 0.5, 0.25], 8.25, made[5:], False, 6))

        quiet = [pages.overview([records.Case("c", members)], broken, [])["quiet"] for members,
                 broken in ((made[:1], []), (made[:1], [1]), (made[5:], []))]
        self.assertEqual(quiet, [True, False, False])
        other = pages.overview([records.Case("c", [of(solver="theirs", wall_time=3.0)])], [], [])
        self.assertEqual((other["claims"], other["wall_time"], len(other["evidence"])), (1, 3, 3))

    def test_durations_and_numbers(self):
        for seconds, wanted in ((None, "—"), (0.00099, "< 1 ms"), (0.001, "1 ms"), (0.9994, "999 ms"), (0.9996, "1 s"),
                                (9.99, "9.99 s"), (9.996, "10.0 s"),
                                (59.94, "59.9 s"), (59.96, "1 min 00 s"), (252, "4 min 12 s"), (3599.6, "1 h 00 min"),
                                (7500, "2 h 05 min")):
            self.assertEqual(quantities.duration(seconds), wanted)
        for value, wanted in ((True, "yes"), (False, "no"), (9999, "9999"), (-10000, "−10 000"), (1234567, "1 234 567"),
                              (10**9, "10<sup>9</sup>"), (None, "—"),
                              (0.5, "0.5"), (math.inf, "—"), ("<b>", "&lt;b&gt;"), (99999, "99 999")):
            self.assertEqual(re.sub("</?span[^>]*>", "", str(quantities.value(value))).replace(quantities.THIN, " "), wanted)
        for value, digits, wanted in ((0.0001, 4, "10<sup>−4</sup>"), (0.00012, 2, "1.2 × 10<sup>−4</sup>"),
                                      (0.001, 4, "0.001"), (12345.6, 4, "12350"), (100000.0, 7, "100000"),
                                      (1e-300, 4, "10<sup>−300</sup>"), (9999.0, 4, "9999"), (10000.0, 4, "10000"),
                                      (0.1 + 0.2, 3, "0.3")):
            self.assertEqual(quantities.plain(value, digits).replace(quantities.THIN, " "), wanted)
        for text_, wanted in (("kg*m", "kg m"), ("m^-1", "m<sup>−1</sup>"), ("-", ""), ("", ""),
                              ("m^{1/2}", "m<sup>1/2</sup>")):
            self.assertEqual(re.sub("</?span[^>]*>", "", str(quantities.unit(text_))).replace(quantities.THIN, " "), wanted)


def paths(svg, **wanted):
    return [part.get("d") for part in tree(svg).iter("path") if all(part.get(name.replace("_", "-")) == value for name,
                                                                    value in wanted.items())]


class Drawings(unittest.TestCase):
    def test_marks_are_shapes_about_their_place(self):
        circle = tree(marks.mark(0).svg(10, 20, 3))
        self.assertEqual((circle.tag, circle.get("cx"), circle.get("cy"), circle.get("r"), circle.get("fill")),
                         ("circle", "10.0", "20.0", "3", marks.COLOURS[0]))
        for number, shape in ((6, "m-3 -3h6v6h-6z"), (12, "m0 -3.6l3.6 6.3h-7.2z"),
                              (18, "m0 -3.9l3.9 3.9l-3.9 3.9l-3.9 -3.9z")):
            self.assertEqual(tree(marks.mark(number).svg(10, 20, 3)).get("d"), f"M10.0 20.0{shape}")
        self.assertEqual([(marks.mark(k).colour, marks.mark(k).letter) for k in (5, 6, 23, 24)],
                         [(marks.COLOURS[5], "●"), (marks.COLOURS[0], "■"), (marks.COLOURS[5], "◆"), (marks.COLOURS[0], "●")])

    def test_axes_have_ticks_at_their_places_and_names(self):
        parts = marks.axes(50, 200, 100, lambda value, axis: (70 if axis else 60) + 10 * math.log10(value),
                           [(0, 0.5), (-0.2, 0.1)], "cost", "<error>")
        drawn = tree(f"<svg>{''.join(parts)}</svg>")
        self.assertEqual([part.get("d") for part in drawn.iter("path")],
                         ["M50 0V100H250", "M60.0 100v3", "M63.0 100v3", "M50 70.0h-3"])
        self.assertEqual([(one.text, one.get("x"), one.get("y"), one.get("text-anchor")) for one in drawn.iter("text")], [
            ("1", "60.0", "115", "middle"), ("2", "63.0", "115", "middle"), ("1", "45", "74.0", "end"),
            ("cost", "150.0", "134", "middle"),
            ("<error>", "12", "50.0", "middle")])
        self.assertEqual(list(drawn.iter("text"))[-1].get("transform"), "rotate(-90 12 50.0)")
        self.assertEqual([marks._ticks(*span) for span in ((0, 2), (-0.5, 1.6), (0.31, 0.69))],
                         [[1, 2, 5, 10, 20, 50, 100], [1, 10], []])

    def test_errors_stand_against_costs_on_logarithmic_axes(self):
        found = costs.Costs("h", "time [s]", [costs.Curve("a", [(1.0, 0.1), (100.0, 0.001)]), costs.Curve("b", [(10.0, 0.01)])])
        drawn = tree(f"<div>{costs.figure(found)}</div>")
        (line,) = (part.get("d") for part in drawn.iter("path") if part.get("stroke-width") == "1.4")
        x, y = (lambda decade: costs.LEFT + costs.WIDTH * (decade + 0.12) / 2.24), (lambda decade: costs.HEIGHT * (1 - (decade + 3.12) / 2.24))
        self.assertEqual(line, f"M{x(0):.1f} {y(-1):.1f}L{x(2):.1f} {y(-3):.1f}")
        self.assertEqual([(float(one.get("cx")), float(one.get("cy")), one.get("fill"),
                           one.find("title").text) for one in drawn.iter("circle")], [
            (round(x(0), 1), round(y(-1), 1), marks.COLOURS[0],
             "a: 0.1 for 1"), (round(x(2), 1), round(y(-3), 1), marks.COLOURS[0], "a: 0.001 for 100"),
            (round(x(1), 1), round(y(-2), 1), marks.COLOURS[1], "b: 0.01 for 10")])
        self.assertEqual(["".join(one.itertext()) for one in drawn.iter("span")], ["● a", "● b"])
        self.assertEqual([one.get("style") for one in drawn.iter("b")], [f"color: {marks.COLOURS[k]}" for k in (0, 1)])
        self.assertEqual(drawn.find("svg").get("viewBox"), "0 -6 396 256")

    def test_costs_are_read_by_the_names_of_their_columns(self):
        def ladder(names, *rows, name=costs.TABLE):
            return [{"id": name, "title": "", "caption": "", "atlas": [],
                     "columns": [{"name": one, "unit": ""} for one in names], "rows": list(rows)}]
        found = costs.survey([of(tables=ladder(("size", "time", "u", "h"), [0.1, 9.0, 0.4, 0.3])),
                              of(solver="b", tables=ladder(("size", "h"), [0.2, 0.6])),
                              of(solver="c", wall_time=5.0, measurements={"h_relative_l2": 0.25})])
        self.assertEqual((found.quantity, found.cost, [(one.solver, one.points) for one in found.curves]),
                         ("h", "time [s]", [("seiche", [(9, 0.3)]), ("c", [(5, 0.25)])]))
        found = costs.survey([of(tables=ladder(("size", "h"), [0.1, 0.3])),
                              of(solver="c", measurements={"h_relative_l2": 0.25, "cell_size": 0.5})])
        self.assertEqual((found.cost, [one.points for one in found.curves]), ("cell [m]", [[(0.1, 0.3)], [(0.5, 0.25)]]))
        for tables in (ladder(("size",), [1.0]), ladder(("cell", "h"), [1.0, 2.0]), ladder(("size", "h"), [1.0, 2.0], name="t"),
                       ladder(("size", "time"), [1.0, 2.0])):
            self.assertIsNone(costs.survey([of(tables=tables)]))
        self.assertIsNone(costs.survey([of(tables=ladder(("size", "h"), [1.0, 2.0])),
                                        of(solver="b", tables=ladder(("size", "u"), [1.0, 2.0]))]))
        self.assertEqual([costs._positive(value) for value in (1, 0.5, 0, -1, True, math.inf, None, "1")],
                         [True, True, *6 * [False]])
        self.assertEqual([costs.of(one, what) for one in (of(measurements={"x": 3.0}),
                                                          of(solver="b", wall_time=0.0, measurements={"threads": 4.0}))
                          for what in ("wall_time", "threads", "x")], [1.5, 1, 3, None, 4, None])

    def test_readings_stand_where_computed_meets_measured(self):
        pairs = [experiments.Pair(None, "r", 1.0, 0.1, 10.0), experiments.Pair(None, "s", 10.0, 1.0, 10.0)]
        drawn = experiments.scatter_figure([experiments.Line("m", marks.mark(0), pairs, 0, [])])
        self.assertEqual(experiments.scatter_figure([]), "")
        left, size, whole = experiments.LEFT, experiments.SIZE, 1.2
        low, high = left + size * 0.1 / whole, left + size * 1.1 / whole
        self.assertEqual([(one.get("cx"), one.get("cy"), one.get("fill-opacity"),
                           one.find("title").text) for one in tree(drawn).iter("circle")], [
            (f"{low:.1f}", f"{size * 0.1 / whole:.1f}", ".75", "m, r: computed 10, measured 1"),
            (f"{high:.1f}", f"{size * 0.1 / whole:.1f}", ".75", "m, s: computed 10, measured 10")])
        offset = size * math.log10(1.2) / whole     # twice the experiments' 10 %
        self.assertEqual(paths(drawn, stroke_dasharray="3 3"),
                         [f"M{left + offset:.1f} {size:.1f}L{left + size:.1f} {offset:.1f}",
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
            self.assertTrue(box[0] <= low[0] and box[1] <= low[1] and high[0] <= box[0] + box[2] and high[1] <= box[1] + box[3],
                            (tex, low, high, box))
            self.assertAlmostEqual(box[2] / box[3], float(style["width"]) / float(style["height"]), delta=0.01)
            self.assertAlmostEqual(float(style["width"]), box[2] / 1000, delta=0.002)
            self.assertAlmostEqual(float(style["vertical-align"]), -(box[1] + box[3]) / 1000,
                                   delta=0.002)       # what hangs below zero
            self.assertEqual((svg.get("aria-label"), svg.find("title").text), (tex, tex))
            sizes[tex] = float(style["width"]) + 2 * float(style["margin"] if "margin" in style else 0), float(style["height"])
        self.assertGreater(sizes["xx"][0], 1.5 * sizes["x"][0])
        self.assertGreater(float(re.search(r"height:([\d.]+)", str(formulas._set(r"\frac{a}{b}", True)))[1]),
                           sizes[r"\frac{a}{b}"][1])      # set larger

    def test_formulas_of_several_lines_and_those_that_cannot_be_set(self):
        shown = formulas._set(r"\begin{aligned}a &= b \\ c &= d\end{aligned} \tag{3.1}", True)
        self.assertEqual((shown.count('<span class="row">'), shown.count("<svg")), (2, 2))
        self.assertIn('<span class="tag">(3.1)</span>', shown)
        self.assertNotIn("display", formulas._set("x", False))
        self.assertEqual(formulas._set(r"\nothing<", False), r'<code class="tex" title="formula">\nothing&lt;</code>')
        for tex, like in ((r"\text{a b}", r"\mathrm{a\ b}"), (r"\tfrac 1 2", r"\frac{1}{2}"), (r"\dfrac{a}{b}", r"\frac{a}{b}"),
                          (r"\bigl(a\bigr)", "(a)"), (r"\lvert a\rvert", "|a|"),
                          (r"\le", r"\leq"), (r"\ge", r"\geq"), (r"\to", r"\rightarrow"), (r"\bm{a}", r"\mathbf{a}"),
                          (r"\dots", r"\ldots"), (r"\Fr", r"\mathrm{Fr}"), ("a~b", r"a\ b"),
                          (r"\operatorname{sn} x", r"\mathrm{sn} x"), (r"\lVert a\rVert", r"\|a\|"),
                          (r"\mathrm d x", r"\mathrm{d} x"), (r"\displaystyle a", "a")):
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
        self.assertRegex(slim,
                         r'<marker id="(m\d+)" overflow="visible" markerUnits="userSpaceOnUse"><use href="#n0" style="fill: red"/></marker>'
                               r'<path d="M3.1 4.0 5.5 6.5" style="fill: none; marker: url\(#\1\)"/>\n<use href="#n0" x="7.5" y="8.5" style="fill: blue"/>')
        for gone in ("DOCTYPE", "metadata", "<!--", "xlink", "\n   "):
            self.assertNotIn(gone, slim)

    def test_a_figure_says_where_its_panels_stand_and_what_they_span(self):
        from render import panels
        from test_drawn import panel, series
        content = {"panels": [panel(series("a"), x_min=0.5, x_max=4.5, y_min=1.0, y_max=9.0, log_y=1),
                              panel(series("b"), x_label="other", log_x=1)]}
        canvas = panels.panels(content, False)
        about = json.loads(tree(figures._answering("<svg ></svg>", canvas, content).replace("href", "h")).get("data-figure"))
        self.assertEqual((about["labels"], [one["log"] for one in about["panels"]]),
                         (["a", "b"], [[False, True], [True, False]]))
        self.assertEqual((about["panels"][0]["x"], about["panels"][0]["y"]), ([0.5, 4.5], [1, 9]))
        width, height = 72 * canvas.get_size_inches()
        for one, axis in zip(about["panels"], canvas.axes):
            box, (left, top, wide, high) = axis.get_position(), one["box"]
            for found, wanted in ((left, box.x0 * width), (left + wide, box.x1 * width), (height - top, box.y1 * height),
                                  (height - top - high, box.y0 * height)):
                self.assertAlmostEqual(found, wanted)
        panels.matplotlib.pyplot.close("all")


if __name__ == "__main__":
    unittest.main()
