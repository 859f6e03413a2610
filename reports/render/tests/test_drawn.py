"""Figures read back: the artists of a drawing hold the numbers, labels and looks of the record, each at its own place."""
import math
import re
import unittest

import made  # noqa: F401  (finds render)
import numpy
from matplotlib.colors import to_hex

from render import figures, layout

figures.prepare()

from render import panels  # noqa: E402

X, Y = numpy.array([0.5, 1.25, 2.0, 4.0]), numpy.array([7.0, -3.0, 5.0, 11.0])


def series(label, role="computed", style="line", **changes):
    return {"label": label, "role": role, "style": style, "x": X, "y": Y, **changes}


def panel(*members, **changes):
    return {"title": "T", "x_label": "abscissa", "y_label": "ordinate", "series": list(members), **changes}


def drawn(*shown, small=False):
    return panels.panels({"panels": list(shown)}, small)


def points(artist):
    return [list(map(float, values)) for values in artist.get_data()]


def look(artist):
    return to_hex(artist.get_color()), artist.get_linestyle(), artist.get_marker(), to_hex(artist.get_markerfacecolor())


class Drawn(unittest.TestCase):
    def tearDown(self):
        panels.matplotlib.pyplot.close("all")

    def test_lines_points_and_text(self):
        (axis,) = drawn(panel(series("a"), series("b", "data", "points", y=Y + 1), x_min=0.25, y_max=20.0)).axes
        self.assertEqual([points(line) for line in axis.lines], [[list(X), list(Y)], [list(X), list(Y + 1)]])
        self.assertEqual((axis.get_title(loc="left"), axis.get_xlabel(), axis.get_ylabel()), ("T", "abscissa", "ordinate"))
        self.assertEqual((axis.get_xlim()[0], axis.get_ylim()[1]), (0.25, 20.0))
        self.assertGreater(axis.get_xlim()[1], 4)
        self.assertLess(axis.get_ylim()[0], -3)
        (axis,) = drawn(panel(series("a"), x_max=9.0, y_min=-8.0)).axes
        self.assertEqual((axis.get_xlim()[1], axis.get_ylim()[0]), (9, -8))

    def test_error_bars_reach_from_value_less_error_to_value_and_error(self):
        error = numpy.array([0.5, 1.0, math.nan, 2.0])
        (axis,) = drawn(panel(series("a", "data", "points", y_error=error))).axes
        (bars,) = axis.containers[0].lines[2]
        expected = [[[x, y - e], [x, y + e]] for x, y, e in zip(X, Y, [0.5, 1, 0, 2])]
        self.assertEqual([segment.tolist() for segment in bars.get_segments()], expected)

    def test_vertical_lines_stand_at_x_and_steps_have_their_edges(self):
        edges = numpy.append(X, 6.0)
        (axis,) = drawn(panel(series("a", "guide", "vertical", x=numpy.array([3.0, math.nan, 1.0]), y=numpy.empty(0)),
                              series("b", style="steps", x=edges))).axes
        self.assertEqual([points(line)[0] for line in axis.lines[:2]], [[3, 3], [1, 1]])
        self.assertEqual(points(axis.lines[2]), [[0.5, 1.25, 1.25, 2, 2, 4, 4, 6], [7, 7, -3, -3, 5, 5, 11, 11]])

    def test_water_stands_on_its_bottom_and_the_bed_on_less(self):
        water, bed = series("w", "water", "fill"), series("b", "bed", "fill", y=Y - 10)
        (axis,) = drawn(panel(water, bed)).axes
        tops = [collection.get_paths()[0].vertices for collection in axis.collections]
        base = axis.get_ylim()[0]
        self.assertLess(base, -13)
        for vertices, y in zip(tops, (Y, Y - 10)):
            self.assertEqual({tuple(vertex) for vertex in vertices},
                             {(X[0], base), (X[-1], base), *((x, base) for x in X), *zip(X, y)})
        (axis,) = drawn(panel(series("w", "water", "fill", y=Y + 10))).axes
        self.assertEqual(axis.get_ylim()[0], 0)
        (axis,) = drawn(panel(series("w", style="fill"))).axes
        self.assertEqual(axis.get_ylim()[0], axis.collections[0].get_paths()[0].vertices[:, 1].min())

    def test_steps_of_water_are_filled_columns_with_edges_to_the_lower_neighbour(self):
        edges = numpy.append(X, 6.0)
        (axis,) = drawn(panel(series("w", "water", "steps", x=edges, y=Y + 10), y_min=1.0)).axes
        (columns,) = axis.patches
        self.assertEqual([list(values) for values in columns.get_data()[:2]], [list(Y + 10), list(edges)])
        self.assertEqual(columns.get_data().baseline, 1)
        (upright,) = axis.collections
        self.assertEqual([segment.tolist() for segment in upright.get_segments()],
                         [[[x, 1], [x, top]] for x, top in zip(edges, [17, 7, 7, 15, 21])])

    def test_an_equal_aspect_is_kept_but_for_logarithms(self):
        aspects = [drawn(panel(series("a"), aspect="equal", **more)).axes[0].get_aspect() for more in ({}, {"log_x": 1})]
        self.assertEqual(aspects, [1, "auto"])

    def test_no_marker_is_cut_in_half_and_many_are_small(self):
        (axis,) = drawn(panel(series("a", "data", "points"))).axes
        self.assertEqual(axis.get_xlim(), (0.5 - 0.03 * 3.5, 4 + 0.03 * 3.5))
        sizes = []
        for count in (60, 61, 400, 401, 3000, 3001, 5001):
            (axis,) = drawn(panel(series("a", "data", "points", x=numpy.arange(count), y=numpy.arange(count)))).axes
            sizes.append((axis.lines[0].get_markersize(), bool(axis.lines[0].get_rasterized())))
        self.assertEqual(sizes, [(4.2, False), (2.8, False), (2.8, False), (1.6, False), (1.6, False), (0.8, False),
                                 (0.8, True)])

    def test_logarithmic_axes_of_a_decade_say_one_two_and_five(self):
        for low, high, said in ((1.0, 20.0, ["2", "5"]), (1.0, 2000.0, []), (1e-3, 1e-2, ["0.002", "0.005"]),
                                (1e4, 1e5, ["20000", "50000"]), (1e-4, 1e-3, [])):
            x = low * numpy.array([1.0, 2, 5, high / low])
            (axis,) = drawn(panel(series("a", x=x), log_x=1, x_min=low, x_max=high)).axes
            axis.figure.canvas.draw()
            self.assertEqual([text.get_text() for text in axis.get_xticklabels() if low < text.get_position()[0] < high
                              and re.fullmatch("0*[.]?0*[25]0*", text.get_text())], said)
            self.assertTrue(all(line.get_visible() for line in axis.get_xgridlines()))

    def test_logarithms_are_of_the_axis_that_asks(self):
        for name, scales in (("log_x", ("log", "linear")), ("log_y", ("linear", "log"))):
            (axis,) = drawn(panel(series("a", y=Y + 4), **{name: 1})).axes
            self.assertEqual((axis.get_xscale(), axis.get_yscale()), scales)

    def test_a_legend_names_each_series_with_its_own_look(self):
        members = [series("a"), series("b", "peer"), series("c", "exact"), series("d", "data", "points"),
                   series("e", "guide"), series("f", "computed", "points")]
        one = drawn(panel(*members))
        two = drawn(panel(*members), panel(*members, title="U"))
        for canvas, legend in ((one, one.axes[0].get_legend()), (two, two.legends[0])):
            named = {text.get_text(): look(handle) for text, handle in zip(legend.get_texts(), legend.get_lines())}
            self.assertEqual(list(named), list("abcdef"))
            self.assertEqual(len(set(named.values())), 6)
            for member, line in zip(members, canvas.axes[-1].lines):
                self.assertEqual(named[member["label"]], look(line), member)

    def test_labels_are_said_once_where_all_panels_say_the_same(self):
        for count in (3, 4, 7):
            axes = drawn(*(panel(series("a"), title=str(k), aspect="") for k in range(count))).axes
            columns = len({round(axis.get_subplotspec().colspan.start) for axis in axes})
            self.assertEqual([bool(axis.get_ylabel()) for axis in axes], [k % columns == 0 for k in range(count)])
            self.assertEqual([bool(axis.get_xlabel()) for axis in axes], [k + columns >= count for k in range(count)])
            self.assertEqual([axis.get_title(loc="left") for axis in axes], [str(k) for k in range(count)])
        axes = drawn(panel(series("a")), panel(series("a"), y_label="another", x_label="other")).axes
        self.assertEqual([(axis.get_xlabel(), axis.get_ylabel()) for axis in axes],
                         [("abscissa", "ordinate"), ("other", "another")])

    def test_a_long_curve_keeps_its_ends_and_the_extremes_of_every_stretch(self):
        x = numpy.arange(20000.0)
        y = numpy.sin(x / 500)
        y[[777, 7777, 15555]] = 9, -8, math.nan
        kept_x, kept_y = panels.thin(x, y)
        self.assertLessEqual(len(kept_x), panels.MANY)
        self.assertEqual((kept_x[0], kept_x[-1]), (0, 19999))
        numpy.testing.assert_array_equal(kept_y, y[kept_x.astype(int)])
        for start in range(0, 20000, 16):       # 1250 stretches
            inside = kept_y[(kept_x >= start) & (kept_x < start + 16)]
            self.assertEqual((numpy.nanmin(inside), numpy.nanmax(inside)),
                             (numpy.nanmin(y[start:start + 16]), numpy.nanmax(y[start:start + 16])))
        (axis,) = drawn(panel(series("a", x=x, y=y))).axes
        self.assertEqual(len(axis.lines[0].get_xdata()), len(kept_x))
        for values, all_of in zip(panels.thin(x[:panels.MANY], y[:panels.MANY]), (x, y)):
            numpy.testing.assert_array_equal(values, all_of[:panels.MANY])

    def test_a_stamp_has_the_numbers_and_no_text(self):
        shown = [panel(series("a", y=Y + k)) for k in range(8)]
        axes = drawn(*shown, small=True).axes
        self.assertEqual([points(axis.lines[0])[1] for axis in axes], [list(Y + k) for k in range(6)])
        self.assertEqual({axis.get_title(loc="left") + axis.get_xlabel() + axis.get_ylabel() for axis in axes}, {""})


class Axes(unittest.TestCase):
    def test_an_equal_aspect_gives_a_panel_its_height_within_a_page(self):
        def height(tall):
            return layout.height(panel(series("a", y=tall * (X - X[0])), aspect="equal"), 5.0, 2)
        self.assertAlmostEqual(height(0.5), (5 - 0.65) * 0.5 * 1.1 + 0.62)
        self.assertEqual([height(tall) for tall in (5, 500)], [6.5, 6.5])
        self.assertAlmostEqual(height(1e-3), 0.55 + 0.62)

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
