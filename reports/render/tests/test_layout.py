"""Where panels stand, what legends name and how series look; plans with their colours, contour lines and bars."""
import math
import unittest

import made  # noqa: F401  (finds render)
import numpy
from matplotlib.colors import to_hex, to_rgb

from render import figures, lattices, layout, legends, looks

figures.prepare()

from render import panels  # noqa: E402
from test_drawn import X, Y, drawn, panel, points, series  # noqa: E402
from test_lattices import framed, hill, panel as heights  # noqa: E402


def wide(ratio):
    """A panel of equal aspect, so much wider than high."""
    return panel(series("a", x=numpy.array([0.0, ratio * 1.1]), y=numpy.array([0.0, 1.0])), aspect="equal")


class Layout(unittest.TestCase):
    def test_columns_of_panels(self):
        plain, other = panel(series("a")), panel(series("a"), y_label="other")
        pair, surface, plan = [plain, other], heights(hill()), heights(hill(style="plan"))
        for shown, columns in (([plain], 1), ([plain, wide(5.1)], 1), ([plain, wide(4.9)], 2),
                               (2 * [framed(surface), framed(plan)], 2),
                               (3 * [plain], 3), (2 * [plain] + [wide(1.5)], 3), (2 * [plain] + [wide(1.7)], 2), (4 * pair, 2),
                               (6 * [plain], 2),
                               (7 * [plain], 3), (8 * [plain], 3), (3 * [plain] + [other], 2),
                               ([plain, other, other, plain] * 2, 3),
                               (4 * [framed(surface), framed(plan)], 2), (8 * [framed(plan)], 3)):
            self.assertEqual(layout.columns_of(shown), columns, len(shown))

    def test_heights_of_panels(self):
        plain = panel(series("a"))
        numpy.testing.assert_allclose([layout.height(plain, 5.0, count) for count in (1, 4, 5)], [3.7, 3.6, 4.0])
        self.assertAlmostEqual(layout.height(wide(2.0), 5.0, 1), 4.35 / 2 + 0.55)
        flat = framed(heights(hill(style="plan")))      # 21.5 by 15
        self.assertAlmostEqual(layout.height(flat, 5.0, 2), (4.5 - 0.65) * 15 / 21.5 + 0.62)

    def test_the_ratio_of_what_is_shown(self):
        self.assertIsNone(layout.ratio(panel(series("a"))))
        self.assertAlmostEqual(layout.ratio(wide(3.0)), 3)
        self.assertAlmostEqual(layout.ratio({**wide(3.0), "x_min": -3.3, "x_max": 9.9, "y_min": -1.0, "y_max": 3.0}), 3)
        self.assertIsNone(layout.ratio(panel(series("a", y=0 * X), aspect="equal")))
        self.assertIsNone(layout.ratio(panel(series("a", x=0 * X), aspect="equal")))
        self.assertAlmostEqual(layout.ratio(framed(heights(hill(style="plan")))), 21.5 / 15)
        surface = framed(heights(hill()))
        left, right, bottom, top = layout.scene(surface).extent([lattices.thinned(surface["series"][0], surface)])
        self.assertAlmostEqual(layout.ratio(surface), (right - left) / (top - bottom))

    def test_panels_of_like_ranges_share_their_limits(self):
        def shared(*shown):
            layout.share_limits(list(shown))
            return [[one.get(f"{axis}_{end}") for axis in "xy" for end in ("min", "max")] for one in shown]
        x, y = (0.5 - 0.015 * 3.5, 4 + 0.015 * 3.5), (-3 - 0.06 * 15, 12 + 0.06 * 15)
        both = [panel(series("a")), panel(series("a", y=Y + 1))]
        numpy.testing.assert_allclose(shared(*both), 2 * [[*x, *y]])
        none = [None] * 4
        self.assertEqual(shared(panel(series("a"))), [none])
        self.assertEqual(shared(panel(series("a")), panel(series("a"), x_label="x", y_label="y")), 2 * [none])
        far = shared(panel(series("a")), panel(series("a", x=X + 2.8, y=Y + 11.3)))      # 1.8 of the ranges, and more
        self.assertEqual([one[0] is None for one in far], [False, False])
        far = shared(panel(series("a")), panel(series("a", x=X + 2.9, y=Y + 11.1)))
        self.assertEqual([(one[0] is None, one[2] is None) for one in far], 2 * [(True, False)])
        self.assertEqual(shared(panel(series("a"), y_max=20.0), panel(series("a")))[1][2:], [None, None])
        logs = shared(*(panel(series("a"), log_x=1, log_y=1) for _ in range(2)))
        self.assertEqual(logs, 2 * [none])
        self.assertEqual(shared(*(panel(series("a", x=0 * X, y=0 * Y)) for _ in range(2))), 2 * [none])
        water = shared(*(panel(series("a", "water", "fill")) for _ in range(2)))
        self.assertEqual([(one[2], one[0] is None) for one in water], 2 * [(None, False)])
        plans = [framed(heights(hill(style="plan"))) for _ in range(2)]
        numpy.testing.assert_allclose(shared(*plans), 2 * [[-10, 11.5, 0, 15]])

    def test_a_span_is_of_finite_numbers_with_their_errors_and_without_vertical_lines(self):
        error = numpy.array([0.5, 1, math.nan, 5])
        one = panel(series("a", y_error=error), series("v", style="vertical", x=numpy.array([9.0]), y=numpy.array([77.0])))
        self.assertEqual([layout.span_of(one, axis) for axis in "xy"], [(0.5, 9), (-4, 16)])
        self.assertEqual(layout.span_of(panel(series("a", y_error=error[:2])), "y"), (-3, 11))
        self.assertEqual([layout.given(value) for value in (0, 1.5, None, math.nan, math.inf, "1")], [True, True, *4 * [False]])


class Legends(unittest.TestCase):
    def tearDown(self):
        panels.matplotlib.pyplot.close("all")

    def names(self, shown):
        return [one["label"] for one in legends.shared_legend(shown)]

    def test_labels_are_named_once_and_surfaces_are_not(self):
        one = panel(series("a"), series("a"), series("a", "exact"), series(" "), series("s", style="surface"),
                    series("p", style="plan"))
        self.assertEqual([(found["label"], found["role"]) for found in legends.labels(one)],
                         [("a", "computed"), ("a", "exact")])

    def test_a_legend_is_shared_where_panels_share_their_labels_or_one_cannot_hold_it(self):
        def of(names, **changes):
            return panel(*map(series, names), **changes)
        for shown, names in (([of("abcdef")], ""), ([of("abcdefg")], "abcdefg"), ([of("")], ""), ([of("ab"), of("ab")], "ab"),
                             ([of("ab"), of("cd")], ""), ([of("abc"), of("abcd"), of("")], "abcd"),
                             ([of("ab"), of("c"), of("abc"), of("bc"), of("a")], "abc"),
                             (2 * [of("abcdefghijkl")], "abcdefghijkl"), (2 * [of("abcdefghijklm")], ""), (2 * [of("")], ""),
                             ([of("abc"), of("cde")], "abcde"),
                             ([of("abcd"), of("de"), of("ab")], "")):
            self.assertEqual(self.names(shown), list(names))
        for ratio, names in ((1.9, []), (2.1, ["a"])):
            self.assertEqual(self.names([wide(ratio)]), names)

    def test_columns_of_a_legend_have_room_for_its_longest_label(self):
        for count, length, columns in ((3, 1, 3), (20, 1, 10), (20, 12, 5), (20, 26, 3), (4, 200, 1)):
            self.assertEqual(legends.legend_columns([{"label": "x"}, *({"label": length * "x"} for _ in range(count - 1))]),
                             columns)

    def test_a_legend_of_many_stands_below_its_panel_and_its_keys_have_numbers(self):
        shown = [panel(*(series(name) for name in "abcdefgh")), panel(*(series(name) for name in "ijklmno")),
                 panel(series("p"))]
        axes = drawn(*shown).axes
        self.assertEqual([(axis.get_legend()._loc, axis.get_legend()._ncols) for axis in axes],
                         [(9, 3), (9, 3), (0, 1)])     # upper centre, best
        self.assertEqual([[text.get_gid() for text in axis.get_legend().get_texts()] for axis in axes],
                         [[f"key-{k}" for k in range(8)], [f"key-{k}" for k in range(8, 15)], ["key-15"]])

    def test_a_handle_is_a_patch_a_marker_or_a_line(self):
        members = [series("w", "water", "fill"), series("s", "bed", "steps", x=numpy.append(X, 6)),
                   series("p", "data", "points"),
                   series("m", "data", "points", x=numpy.arange(401.0), y=numpy.arange(401.0)), series("g", "guide", "points"),
                   series("t", style="steps", x=numpy.append(X, 6)), series("f", style="fill")]
        own = looks.Looks([panel(*members)])
        water, bed, open_, full, guide, steps, fill = legends.handles(members, own)[0]
        self.assertEqual([to_hex(one.get_facecolor()) for one in (water, bed)], [looks.WATER, looks.BED])
        self.assertEqual([to_hex(one.get_edgecolor()) for one in (water, bed)], [looks.WATER_LINE, looks.BED_LINE])
        self.assertEqual(to_hex(fill.get_facecolor()), own.of(members[6])["color"].lower())
        self.assertEqual([one.get_markerfacecolor() for one in (open_, full)], ["white", "#3b3833"])
        self.assertEqual([one.get_marker() for one in (open_, full, guide, steps)], ["o", "s", "None", "None"])
        self.assertEqual([one.get_linestyle() == "None" for one in (open_, full, guide, steps)], [True, True, False, False])

    def test_labels_are_set_by_mathtext_or_printed(self):
        for text, wanted in (("$h^2$", "$h^2$"), ("$5 and $h$", r"\$5 and \$h\$"), ("m^2/s", "m$^{2}$/s"),
                             ("s^{-1}", "s$^{-1}$"), (12, "12"),
                             ("x^a", "x^a")):
            self.assertEqual(legends.safe(text), wanted)


class Looks(unittest.TestCase):
    def test_roles_have_their_colours_and_what_differs_in_colour_differs_in_dash_and_marker(self):
        def of(role, count=9):
            return [looks._look(role, k) for k in range(count)]
        self.assertEqual([one["color"] for one in of("computed")], [looks.COLOURS[k % 6] for k in range(9)])
        self.assertEqual([one["linestyle"] for one in of("computed", 12)],
                         [looks.DASHES[k] for k in (0, 1, 2, 3, 4, 5, 1, 2, 3, 4, 5, 0)])
        self.assertEqual([one["marker"] for one in of("computed")], [*looks.MARKERS, *looks.MARKERS[:2]])
        self.assertEqual([one["linestyle"] for one in of("peer", 6)], [*looks.DASHES[1:], looks.DASHES[1]])
        self.assertEqual([one["color"] for one in of("exact", 8)], 6 * [looks.INK] + looks.COLOURS[:2])
        self.assertEqual([one["filled"] for one in of("computed", 3) + of("data", 3)], [True, False, True, False, True, False])
        self.assertEqual([(one["color"], one["linestyle"]) for one in of("guide", 4)],
                         [(looks.GREY, looks.DASHES[k]) for k in (1, 2, 3, 1)])
        self.assertEqual({(one["color"], one["face"], one["linestyle"]) for one in of("water") + of("bed")},
                         {(looks.WATER_LINE, looks.WATER, "-"), (looks.BED_LINE, looks.BED, "-")})
        order = sorted(("water", "bed", "guide", "peer", "computed", "exact", "data"),
                       key=lambda role: looks._look(role, 0)["zorder"])
        self.assertEqual(order, ["water", "bed", "guide", "peer", "computed", "exact", "data"])

    def test_peers_go_on_where_what_was_computed_ends_and_each_label_has_one_look(self):
        own = looks.Looks([panel(series("a"), series("b", "peer"), series("c", "exact")),
                           panel(series("a"), series("d"), series("s", style="plan"))])
        colours = [own.of(series(*one))["color"] for one in (("a",), ("b", "peer"), ("d",))]
        self.assertEqual(colours, looks.COLOURS[:3])
        self.assertEqual((own.labels(), own.number(series("d"))), (list("abcd"), 3))


class Plans(unittest.TestCase):
    def tearDown(self):
        panels.matplotlib.pyplot.close("all")

    def test_colours_are_about_zero_where_both_signs_matter(self):
        for low, high, bounds, hues in ((-0.3, 1.0, (-1, 1), looks.SIGNED), (-2.0, 1.0, (-2, 2), looks.SIGNED),
                                        (-0.25, 1.0, (-0.25, 1), looks.DEPTHS),
                                        (-1.0, 0.0, (-1, 0), looks.DEPTHS), (0.0, 2.0, (0, 2), looks.DEPTHS),
                                        (1.0, 2.0, (1, 2), looks.DEPTHS)):
            shown = lattices.colours({"z_min": low, "z_max": high})
            self.assertEqual((shown.norm.vmin, shown.norm.vmax), bounds)
            self.assertEqual([to_hex(shown.to_rgba(end)) for end in bounds], [hues[0], hues[-1]])

    def test_heights_are_shared_by_their_label_and_without_the_bed(self):
        one, two = heights(hill()), heights(hill(z=hill()["z"] + 1, style="plan"),
                                            hill(role="bed", z=hill()["z"] - 9, style="plan"))
        other, plain = heights(hill(z=hill()["z"] * 9), z_label="u"), panel(series("a"))
        lattices.share_heights([one, two, other, plain])
        low, high = hill()["z"].min(), hill()["z"].max()
        self.assertEqual([(p.get("z_min"), p.get("z_max")) for p in (one, two, other, plain)],
                         [(low, high + 1), (low, high + 1), (9 * low, 9 * high), (None, None)])
        self.assertEqual([framed(heights(hill(z=0 * hill()["z"] + 3)))[end] for end in ("z_min", "z_max")], [3, 4])
        self.assertEqual([framed(heights(hill(role="bed")))[end] for end in ("z_min", "z_max")], [0, 1])
        for wrong in (math.nan, math.inf):
            self.assertEqual([lattices.kind(heights(*kinds)) for kinds in ((hill(), hill(style="plan")),
                                                                           (hill(style="plan"), series("a")), (series("a"),))],
                             ["surface", "plan", "plain"])
            with self.assertRaisesRegex(ValueError, "no finite height"):
                lattices.share_heights([heights(hill(z=numpy.full((31, 41), wrong)))])

    def test_every_kth_line_and_the_last_are_drawn(self):
        self.assertEqual([len(lattices._every(count)) for count in (2, 201, 202, 401, 402)], [2, 201, 102, 201, 135])
        for count in (2, 201, 202, 401, 402, 1001):
            kept = lattices._every(count)
            self.assertEqual((kept[0], kept[-1], len(set(numpy.diff(kept)[:-1]) | {numpy.diff(kept)[0]})), (0, count - 1, 1))

    def test_limits_keep_what_lies_on_them(self):
        one = hill(10, 15)
        one["x"] = one["x"] - 0.1 * one["y"]        # -10, -8, ...; 0, 1, ...
        x, y, z = lattices.thinned(one, {"x_min": -4.0, "x_max": 6.0, "y_min": 2.0, "y_max": 3.0})
        self.assertEqual((x[0].round(9).tolist(), y[:, 0].tolist()), ([-4, -2, 0, 2, 4, 6], [2, 3]))
        x, y, z = lattices.thinned(one, {"x_min": -3.9, "x_max": 6.1, "y_min": 1.9, "y_max": 3.1}, cut=False)
        self.assertEqual((x[0].round(9).tolist(), y[:, 0].tolist()), ([-4, -2, 0, 2, 4, 6, 8], [1, 2, 3, 4]))
        for limits in ({"x_min": 9.0}, {"y_max": 0.5}):
            with self.assertRaisesRegex(ValueError, "no cell within"):
                lattices.thinned(one, limits)
        with self.assertRaisesRegex(ValueError, "“water” needs x, y, z"):
            lattices.thinned({name: value[:1] if name in "xyz" else value for name, value in one.items()}, {})

    def test_ticks_are_round_and_within_the_range(self):
        for low, high, wanted in ((0, 1, [0, 0.2, 0.4, 0.6, 0.8, 1]), (-0.3, 0.3, [-0.3, -0.2, -0.1, 0, 0.1, 0.2, 0.3]),
                                  (0.05, 0.29, [0.05, 0.1, 0.15, 0.2, 0.25])):
            numpy.testing.assert_allclose(lattices.ticks({"z_min": low, "z_max": high}), wanted, atol=1e-12)

    def test_a_plan_has_the_colours_of_its_heights_and_lines_at_the_ticks_of_its_bar(self):
        one = framed(heights(hill(style="plan"), z_label="z^2"))
        canvas = drawn(one)
        axis, bar = canvas.axes
        mesh = next(part for part in axis.collections if hasattr(part, "_triangulation"))
        x, y, z = lattices.thinned(one["series"][0], one)
        numpy.testing.assert_array_equal((mesh._triangulation.x, mesh._triangulation.y), (x.ravel(), y.ravel()))
        numpy.testing.assert_allclose(mesh.get_facecolors(), lattices.colours(one).to_rgba(z.ravel()))
        self.assertEqual(len(mesh._triangulation.triangles), 2 * 40 * 30)
        lines = [part for part in axis.collections if part is not mesh]
        self.assertEqual(len(lines), 1 if hasattr(lines[0], "levels") else 5)
        levels = lines[0].levels if hasattr(lines[0], "levels") else [0.05, 0.1, 0.15, 0.2, 0.25]
        numpy.testing.assert_allclose(levels, [0.05, 0.1, 0.15, 0.2, 0.25])
        if len(lines) == 5:
            for line, level in zip(lines, levels):       # 0.3 / cosh(x / 2)^2, within a cell
                for path in line.get_paths():
                    at = path.vertices[:, 0] - 0.1 * path.vertices[:, 1]
                    numpy.testing.assert_allclose(0.3 / numpy.cosh(0.5 * at) ** 2, level, atol=0.01)
        self.assertEqual((bar.get_ylim(), bar.get_ylabel()), ((one["z_min"], one["z_max"]), "z$^{2}$"))
        numpy.testing.assert_allclose(bar.get_yticks(), lattices.ticks(one))
        self.assertEqual((axis.get_xlim(), axis.get_ylim(), axis.get_aspect()), ((-10, 11.5), (0, 15), 1))
        still = framed(heights(hill(style="plan", z=numpy.where(hill()["x"] < 5, 0.2, hill()["z"])), z_min=0.0, z_max=1.0))
        self.assertEqual(len(drawn(still).axes[0].collections), 1)     # at 0.2 it would trace noise
        gone = framed(heights(hill(style="plan", z=numpy.full((31, 41), math.nan)), hill(style="plan", z=hill()["z"])))
        self.assertGreater(len(drawn(gone).axes[0].collections), 1)

    def test_plans_of_one_height_share_a_bar(self):
        plans = [framed(heights(hill(style="plan"), **more)) for more in ({}, {}, {"z_label": "other"}, {"z_max": 2.0})]
        axes = drawn(*plans).axes
        self.assertEqual([axis.get_ylabel() for axis in axes[4:]], ["z / h", "other", "z / h"])
        self.assertEqual([axis.get_ylim()[1] for axis in axes[4:]], [plans[0]["z_max"], plans[2]["z_max"], 2.0])
        self.assertEqual([axis.get_gid() for axis in axes[:4]], [f"panel-{k}" for k in range(4)])


class Canvas(unittest.TestCase):
    def tearDown(self):
        panels.matplotlib.pyplot.close("all")

    def test_the_canvas_is_as_high_as_its_rows_and_its_legend(self):
        plain = [panel(series("a")) for _ in range(3)]
        third = 0.72 * panels.WIDTH / 3
        for shown, high in ((plain[:1], 3.7), (plain, third + 0.22 + 0.06),
                            (4 * [panel(series(""))], 2 * 0.72 * panels.WIDTH / 2),
                            ([panel(*map(series, "abcdefg"))], 3.7 + 0.22 + 0.06),
                            ([wide(1.0), wide(1.0)], (3.7 - 0.65) * 1.12 / 1.03 + 0.62 + 0.28),
                            ([panel(*map(series, "abcdefg")), panel(*map(series, "hijklmno"))], 0.72 * 3.7 + 0.8)):
            numpy.testing.assert_allclose(drawn(*shown).get_size_inches(), (7.4, high))
        with self.assertRaisesRegex(ValueError, "no panels"):
            drawn()

    def test_panels_go_row_by_row(self):
        axes = drawn(*(panel(series("a", y=Y + k), title=str(k)) for k in range(7))).axes
        places = [(axis.get_subplotspec().rowspan.start, axis.get_subplotspec().colspan.start) for axis in axes]
        self.assertEqual(places, [divmod(k, 3) for k in range(7)])
        for count, columns in ((1, 1), (2, 2), (4, 2), (5, 3), (9, 3)):
            axes = drawn(*(panel(series("a")) for _ in range(count)), small=True).axes
            self.assertEqual([axis.get_subplotspec().get_gridspec().ncols for axis in axes], min(count, 6) * [columns])
            self.assertEqual(axes[0].figure.get_size_inches().tolist(), [3, 1.95])

    def test_a_film_has_all_frames_in_one_place_and_as_a_stamp_the_last(self):
        frames = [panel(series("a", y=Y + k), title=f"t = {k}") for k in range(3)]
        (axis,) = panels.film({"panels": frames}, False).axes
        self.assertEqual([points(line)[1] for line in axis.lines], [list(Y + k) for k in range(3)])
        self.assertEqual([line.get_gid() for line in axis.lines], [f"frame-{k} series-0" for k in range(3)])
        self.assertEqual([(text.get_text(), text.get_gid()) for text in axis.texts],
                         [(f"t = {k}", f"frame-{k}") for k in range(3)])
        self.assertEqual((axis.get_title(loc="left"), axis.get_xlabel(), axis.get_ylabel(), axis.get_gid()),
                         ("", "abscissa", "ordinate", "panel-0"))
        self.assertEqual([text.get_text() for text in axis.get_legend().get_texts()], ["a"])
        self.assertEqual(len({one["y_max"] for one in frames}), 1)
        self.assertAlmostEqual(axis.figure.get_size_inches()[1], 3.7 + 0.6)
        (axis,) = panels.film({"panels": frames}, True).axes
        self.assertEqual(points(axis.lines[0])[1], list(Y + 2))
        canvas = panels.film({"panels": [heights(hill(style="plan", z=hill()["z"] + k)) for k in range(2)]}, False)
        self.assertEqual((len(canvas.axes), canvas.axes[1].get_ylim()[1]), (2, hill()["z"].max() + 1))

    def test_series_and_areas_have_their_names(self):
        (axis,) = drawn(panel(series("a"), series("w", "water", "fill"),
                              series("p", "data", "points", y_error=numpy.ones(4)))).axes
        self.assertEqual([line.get_gid() for line in axis.lines if line.get_marker() != "_"],
                         ["series-0", "series-1", "series-2"])
        self.assertEqual({part.get_gid() for part in axis.collections}, {"series-2 area-0", "series-1 area-0"})

    def test_ticks_of_equal_axes_are_few_where_room_is_short(self):
        for ratio, ticks in ((8.0, (0, 3)), (3.0, (0, 5)), (0.3, (2, 5))):
            (axis,) = drawn({**wide(ratio), "y_min": 0.0, "y_max": 1.0, "x_min": 0.0, "x_max": 1.1 * ratio}).axes
            for which, count in zip((axis.xaxis, axis.yaxis), ticks):
                low, high = which.get_view_interval()
                found = sum(low <= tick <= high for tick in which.get_ticklocs())
                self.assertTrue(found == count or not count and found > 3, (ratio, found))

    def test_wrong_lengths_are_said(self):
        for one, words in ((series("s", style="steps"), "steps “s” need one edge more than values, not 4 and 4"),
                           (series("l", y=Y[1:]), "series “l” has 4 x and 3 y"),
                           (series("p", style="points", y=Y[1:]), "series “p” has 4 x and 3 y")):
            with self.assertRaisesRegex(ValueError, words):
                drawn(panel(one))

    def test_filled_markers_and_areas_have_their_colours(self):
        members = [series("a", "data", "points"), series("b", "data", "points"), series("c", "computed", "fill")]
        (axis,) = drawn(panel(*members)).axes
        own = looks.Looks([panel(*members)])
        self.assertEqual([line.get_markerfacecolor() for line in axis.lines[:2]], ["white", "#3b3833"])
        self.assertEqual(axis.collections[0].get_facecolor()[0].tolist(), [*to_rgb(own.of(members[2])["color"]), 0.18])
        many = series("a", "data", "points", x=numpy.arange(401.0), y=numpy.arange(401.0))
        self.assertEqual((drawn(panel(many)).axes[0].lines[0].get_markerfacecolor(),
                          drawn(panel(many)).axes[0].lines[0].get_markeredgewidth()), ("#3b3833", 0))
        columns = [series("w", "water", "steps", x=numpy.arange(count + 1.0), y=numpy.ones(count)) for count in (249, 250)]
        self.assertEqual([len(drawn(panel(one)).axes[0].collections) for one in columns], [1, 0])

    def test_the_bed_has_room_below_it(self):
        (axis,) = drawn(panel(series("b", "bed", "fill"))).axes
        room = 0.06 * 14    # of the style
        self.assertAlmostEqual(axis.get_ylim()[0], -3 - room - 0.07 * (14 + 2 * room))
        (axis,) = drawn(panel(series("w", "water", "fill", y=Y + 5), log_y=1)).axes
        self.assertGreater(axis.get_ylim()[0], 0)


if __name__ == "__main__":
    unittest.main()
