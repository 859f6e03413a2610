"""Surfaces read back: the box and the eye, light, walls, lines and ticks, each by a formula of its own."""
import math
import unittest

import made  # noqa: F401  (finds render)
import numpy
from matplotlib.colors import to_rgb

from render import figures, lattices, looks, scene, surfaces

figures.prepare()

from render import panels  # noqa: E402
from test_lattices import framed, hill, panel  # noqa: E402


def slope(rise_x=0.0, rise_y=0.0, columns=4, rows=3, **changes):
    """A plane over [0, 8] x [0, 6]."""
    x, y = numpy.meshgrid(numpy.linspace(0, 8, columns + 1), numpy.linspace(0, 6, rows + 1))
    return {"label": "water", "role": "computed", "style": "surface", "x": x, "y": y, "z": rise_x * x + rise_y * y, **changes}


def seen(azimuth=20.0, elevation=35.0, exaggeration=3.0):
    return scene.Scene(numpy.array([0.0, 0, -1]), numpy.array([8.0, 6, 2]), exaggeration, azimuth, elevation)


class Scene(unittest.TestCase):
    def test_a_point_appears_where_a_camera_would_have_it(self):
        for azimuth, elevation in ((20, 35), (-62, 30), (0, 10), (200, 80)):
            view, turn, lift = seen(azimuth, elevation), math.radians(azimuth), math.radians(elevation)
            eye = numpy.array([math.cos(turn) * math.cos(lift), math.sin(turn) * math.cos(lift), math.sin(lift)])
            right = numpy.array([-math.sin(turn), math.cos(turn), 0])
            for point in ((1.0, 5, 2), (7.0, 2, -1), (4.0, 3, 0.5)):
                from_middle = (numpy.array(point) - (4, 3, 0.5)) * (1, 1, 3)
                scale = 40 / (40 - from_middle @ eye)       # of four diagonals of the plan
                wanted = (from_middle @ right * scale, from_middle @ numpy.cross(eye, right) * scale,
                          -from_middle[:2] @ (math.cos(turn), math.sin(turn)))
                numpy.testing.assert_allclose(view.project(*point), wanted, atol=1e-12)

    def test_corners_go_round_and_the_nearest_faces_the_eye(self):
        view = seen()
        self.assertEqual([view.corner(k).tolist() for k in range(5)],
                         [[0, 0, -1], [8, 0, -1], [8, 6, -1], [0, 6, -1], [0, 0, -1]])
        self.assertEqual(view.corner(2, high=True).tolist(), [8, 6, 2])
        for azimuth, edges in ((20, (2, 1, 3)), (-62, (1, 0, 2)), (110, (3, 2, 4)), (200, (0, -1, 1))):
            self.assertEqual(seen(azimuth).edges(), edges)

    def test_the_extent_holds_the_floor_and_the_post_at_the_left(self):
        view = seen()
        corners = [view.project(*view.corner(k)) for k in range(4)] + [view.project(*view.corner(1, high=True))]
        right, up = ([corner[k] for corner in corners] for k in (0, 1))
        self.assertEqual(view.extent([]), (min(right), max(right), min(up), max(up)))

    def test_the_box_has_room_below_and_holds_the_bed(self):
        view = scene.scene(framed(panel(slope(0.1, 0.2))))       # heights 0 to 2
        self.assertEqual((view.low.tolist(), view.high.tolist()), ([0, 0, -0.5], [8, 6, 2]))
        self.assertEqual((view.azimuth, view.elevation, view.exaggeration), (-62, 30, 0.5))     # 0.15 * 8 * 1.25 / 2.5 = 0.6
        bed = slope(0.5, z=slope(0.5)["z"] - 1)        # -1 to 3
        view = scene.scene(framed(panel(slope(0.1, 0.2), {**bed, "role": "bed"})))
        numpy.testing.assert_allclose((view.low, view.high), ([0, 0, -1.32], [8, 6, 3]))
        self.assertEqual(view.exaggeration, 0.5)       # 0.15 * 8 * 2 / 4.32 = 0.56
        given = framed(panel(slope(0.1), x_min=-1.0, x_max=9.0, y_min=-2.0, y_max=22.0, azimuth=5.0, elevation=95.0))
        view = scene.scene(given)
        self.assertEqual((view.low[:2].tolist(), view.high[:2].tolist(), view.azimuth, view.elevation),
                         ([-1, -2], [9, 22], 5, 89))
        self.assertEqual(scene.scene({**given, "elevation": -5.0}).elevation, 1)
        self.assertEqual(view.exaggeration, 5)         # 0.15 * 24 * 1.25 / 1 = 4.5
        for wrong in ({"x_min": 9.0}, {"y_max": -2.0}, {"x_max": math.nan}):
            with self.assertRaisesRegex(ValueError, "no extent in x or y"):
                scene.scene({**given, **wrong})

    def test_a_round_factor_is_nearest_by_ratio(self):
        for value, wanted in ((1.4, 1), (1.42, 2), (3.1, 2), (3.2, 5), (7.0, 5), (7.1, 10), (0.032, 0.05), (140, 100)):
            self.assertAlmostEqual(scene._round(value), wanted)


class Light(unittest.TestCase):
    def test_it_comes_from_the_left_of_the_eye_and_above(self):
        for azimuth in (-62.0, 20.0):
            light, turn = surfaces._light(seen(azimuth)), math.radians(azimuth)
            size = math.sqrt(0.6**2 + 0.28**2 + 0.75**2)
            self.assertAlmostEqual(light @ (-math.sin(turn), math.cos(turn), 0), -0.6 / size)
            self.assertAlmostEqual(light @ (math.cos(turn), math.sin(turn), 0), 0.28 / size)
            self.assertAlmostEqual(light[2], 0.75 / size)

    def test_more_light_whitens_and_less_darkens_up_to_a_bound(self):
        hue = numpy.array([[0.2, 0.4, 0.6]])
        for excess, wanted in ((0, hue), (0.25, 0.6 * hue + 0.4), (1, 0.25 * hue + 0.75), (-0.5, hue * (0.575, 0.66, 0.75)),
                               (-2, hue * (0.3625, 0.49, 0.625))):
            numpy.testing.assert_allclose(surfaces._lit(hue, numpy.array([float(excess)])), wanted)

    def test_level_water_has_the_colour_of_its_height_and_a_slope_that_of_its_normal(self):
        view = seen()
        for rise in ((0.0, 0.0), (0.3, 0.0), (0.0, -0.2), (-0.1, 0.25)):
            one = framed(panel(slope(*rise)))
            for bed in (False, True):
                shaded = surfaces._shaded(lattices.thinned(one["series"][0], one), view, one, bed)
                normal = numpy.array([-3 * rise[0], -3 * rise[1], 1])
                excess = normal / numpy.linalg.norm(normal) @ surfaces._light(view) - surfaces._light(view)[2]
                z = one["series"][0]["z"].ravel()
                hues = numpy.tile(to_rgb(looks.BED), (20, 1)) if bed else lattices.colours(one).to_rgba(z)[:, :3]
                numpy.testing.assert_allclose(shaded, surfaces._lit(hues, numpy.full(20, excess)), atol=1e-12)
        flipped = {**one, "series": [{name: value[::-1] if isinstance(value, numpy.ndarray) else value
                                      for name, value in one["series"][0].items()}]}
        again = surfaces._shaded(lattices.thinned(flipped["series"][0], flipped), view, one, False)
        numpy.testing.assert_allclose(again.reshape(4, 5, 3)[::-1].reshape(-1, 3), surfaces._shaded(
            lattices.thinned(one["series"][0], one), view, one, False), atol=1e-12)
        gap = framed(panel(slope(0.3)))
        gap["series"][0]["z"][1, 1] = math.nan
        shaded = surfaces._shaded(lattices.thinned(gap["series"][0], gap), view, gap, False).reshape(4, 5, 3)
        numpy.testing.assert_allclose(shaded[0, 0], surfaces._shaded(lattices.thinned(slope(0.3), gap), view, gap, False)[0])
        self.assertTrue(numpy.isfinite(shaded).all())


class Walls(unittest.TestCase):
    def test_the_two_sides_that_face_the_eye_stand_from_below_to_the_surface(self):
        one = slope(0.1, 0.2)
        lattice = tuple(one[name] for name in "xyz")
        for azimuth, sides in ((20, [(8, None), (None, 6)]), (-62, [(None, 0), (8, None)]), (200, [(None, 0), (0, None)]),
                               (160, [(None, 6), (0, None)])):
            view = seen(azimuth)
            for bed, (dark, pale) in ((False, (looks.WATER_LINE, looks.WATER)), (True, (looks.BED_LINE, looks.BED))):
                walls = surfaces._walls(lattice, numpy.full((4, 5), -1.0), view, bed)
                self.assertEqual(len(walls), 2)
                for (wall, hues), (at_x, at_y) in zip(sorted(walls,
                                                             key=lambda w: -len(w[1]) if sides[0][0] is None else len(w[1])), sides):
                    x, y, z = wall
                    if at_x is not None:
                        numpy.testing.assert_array_equal(x, at_x)
                        numpy.testing.assert_array_equal(y, 2 * [[0, 2, 4, 6]])
                        out = numpy.array([1 if at_x else -1, 0])
                    else:
                        numpy.testing.assert_array_equal(y, at_y)
                        numpy.testing.assert_array_equal(x, 2 * [[0, 2, 4, 6, 8]])
                        out = numpy.array([0, 1 if at_y else -1])
                    numpy.testing.assert_allclose(z[0], 0.1 * x[0] + 0.2 * y[0])
                    numpy.testing.assert_array_equal(z[1], -1)
                    hue = 0.7 * numpy.array(to_rgb(pale)) + 0.3 * numpy.array(to_rgb(dark))
                    wanted = surfaces._lit(hue[None], numpy.array([0.35 * (out @ surfaces._light(view)[:2] - 0.25)]))
                    numpy.testing.assert_allclose(hues, numpy.tile(wanted, (x.size, 1)))

    def test_lines_of_the_lattice_join_neighbours_and_the_last_is_always_there(self):
        one = slope(columns=8, rows=6)          # of 2 lines each way: 0, 4, 8 and 0, 3, 6
        segments = surfaces._mesh(tuple(one[name] for name in "xyz"), 2)
        self.assertEqual(segments.shape, (3 * 8 + 3 * 6, 2, 3))
        along = segments[segments[:, 0, 1] == segments[:, 1, 1]]
        self.assertEqual(sorted(set(along[:, 0, 1])), [0, 3, 6])
        numpy.testing.assert_array_equal(along[:, 1, 0] - along[:, 0, 0], 1)
        across = segments[segments[:, 0, 0] == segments[:, 1, 0]]
        self.assertEqual(sorted(set(across[:, 0, 0])), [0, 4, 8])
        one["z"][0, 0] = math.nan
        self.assertEqual(len(surfaces._mesh(tuple(one[name] for name in "xyz"), 2)), 40)
        self.assertEqual(len(surfaces._mesh(tuple(slope(columns=7, rows=6)[name] for name in "xyz"), 2)), 3 * 7 + 3 * 6)


class Drawn(unittest.TestCase):
    def tearDown(self):
        panels.matplotlib.pyplot.close("all")

    def drawn(self, *series, small=False, **changes):
        one = framed(panel(*series, **changes))
        (axis,) = panels.panels({"panels": [one]}, small).axes
        return one, scene.scene(one), axis

    def test_the_axes_hold_the_extent_with_a_margin(self):
        for small, anchor in ((False, "N"), (True, "C")):
            one, view, axis = self.drawn(hill(), small=small)
            left, right, bottom, top = view.extent([lattices.thinned(one["series"][0], one)])
            numpy.testing.assert_allclose(axis.get_xlim(), (left - 0.01 * (right - left), right + 0.01 * (right - left)))
            numpy.testing.assert_allclose(axis.get_ylim(), (bottom - 0.02 * (top - bottom), top + 0.02 * (top - bottom)))
            self.assertEqual((axis.get_aspect(), axis.get_anchor(), axis.axison), (1, anchor, False))
            self.assertEqual(bool(axis.texts), not small)

    def test_slices_hold_every_triangle_and_line_once_from_the_back_to_the_front(self):
        one, view, axis = self.drawn(slope(0.1, 0.2))
        meshes = [part for part in axis.collections if hasattr(part, "_triangulation")]
        tops, floor, colours = [], [], {}
        for mesh in meshes:
            own = mesh._triangulation
            for place, hue in zip(zip(own.x.round(9), own.y.round(9)), mesh.get_facecolors()):
                colours.setdefault(place, set()).add(tuple(hue[:3].round(6)))
            tops += [len(own.triangles)]
        self.assertEqual(sum(tops), 2 * 4 * 3 + 2 * 4 + 2 * 3)      # of the surface and the two walls that face the eye
        lattice = lattices.thinned(one["series"][0], one)
        right, up, back = (part.ravel() for part in view.project(*lattice))
        shaded = surfaces._shaded(lattice, view, one, False)
        for place, hue in zip(zip(right.round(9), up.round(9)), shaded):
            self.assertIn(tuple(hue.round(6)), colours[place])
        behind = numpy.array([own.x[own.triangles].mean() for own in [mesh._triangulation for mesh in meshes]])
        self.assertEqual(len(behind), len(meshes))
        lines = [part for part in axis.collections if not hasattr(part, "_triangulation")]
        segments = numpy.concatenate([part.get_segments() for part in lines])
        self.assertEqual(len(segments), 4 * 4 + 5 * 3)      # of 4 and of 5 lines of the lattice
        depths = dict(zip(zip(right.round(6), up.round(6)), back))
        middle = [numpy.mean([depths[tuple(end.round(6))] for segment in part.get_segments() for end in segment]) for part in lines]
        self.assertEqual(middle, sorted(middle, reverse=True))
        order = list(axis.collections)
        for line in lines:      # no triangle of the surface that is painted later lies behind a line
            front = min(depths[tuple(end.round(6))] for segment in line.get_segments() for end in segment)
            for mesh in meshes:
                if order.index(mesh) > order.index(line):
                    places = [depths.get(place) for place in zip(mesh._triangulation.x.round(6),
                                                                 mesh._triangulation.y.round(6))]
                    if None not in places:
                        self.assertLess(numpy.mean(places), front + 2)

    def test_water_over_a_bed_stands_on_it(self):
        bed = {**slope(0.05), "role": "bed"}
        bed["z"] = bed["z"] - 2
        counts = []
        for series in ((slope(0.1),), (slope(0.1), bed), (slope(0.1, columns=6), bed)):
            _, view, axis = self.drawn(*series)
            meshes = [part._triangulation for part in axis.collections if hasattr(part, "_triangulation")]
            counts.append(sum(len(mesh.triangles) for mesh in meshes))
            foot = {**series[-1], "z": 0 * bed["z"] + view.low[2]}      # below the sides that face the eye: y = 0 and x = 8
            facing = (foot["y"] == 0) | (foot["x"] == 8)
            wanted = [tuple(part[name].ravel() for name in "xyz") for part in series] + [tuple(foot[name][facing] for name in "xyz")]
            wanted = {tuple(place) for lattice in wanted for place in numpy.transpose(view.project(*lattice)[:2]).round(6)}
            self.assertEqual({place for mesh in meshes for place in zip(mesh.x.round(6), mesh.y.round(6))}, wanted)
        self.assertEqual(counts, [24 + 14, 2 * (24 + 14), 36 + 24 + 14])     # of another lattice the water has no walls

    def test_ticks_stand_at_their_numbers_on_the_edges_next_to_the_eye(self):
        one, view, axis = self.drawn(slope(0.1, 0.2), x_label="east", y_label="north", z_label="height")
        texts = {}
        for text in axis.texts:
            texts.setdefault(text.get_text(), []).append(text)
        self.assertIn("heights × 0.5", texts)
        near, left, right = (view.corner(k) for k in view.edges())       # at azimuth -62: corners 1, 0, 2
        self.assertEqual([corner.tolist() for corner in (near, left, right)], [[8, 0, -0.5], [0, 0, -0.5], [8, 6, -0.5]])
        def at(text, point):
            return any(numpy.allclose(one.xy, view.project(*point)[:2]) for one in texts.get(text, ()))
        for number in (0, 2, 4, 6, 8):
            self.assertTrue(at(str(number), (number, 0, -0.5)), number)
        for number in (0, 2, 4, 6):
            self.assertTrue(at(str(number), (8, number, -0.5)), number)
        heights = [text for text in axis.texts if text.get_ha() == "right" and hasattr(text,
                                                                                       "xy") and text.get_text() != "height"]
        for text in heights:        # on the post at the left, from the lowest water up
            value = float(text.get_text())
            self.assertGreaterEqual(value, 0)
            numpy.testing.assert_allclose(text.xy, view.project(0, 0, value)[:2], atol=1e-12)
        self.assertGreaterEqual(len(heights), 3)
        numpy.testing.assert_allclose(texts["height"][0].xy, view.project(0, 0, 2)[:2])
        for name, ends in (("east", (near, left)), ("north", (near, right))):
            a, b = (numpy.array(view.project(*end)[:2]) for end in ends)
            numpy.testing.assert_allclose(texts[name][0].xy, 0.5 * (a + b))
            way = math.degrees(math.atan2(*(b - a)[::-1]))
            self.assertAlmostEqual(math.sin(math.radians(texts[name][0].get_rotation() - way)), 0)
            self.assertLessEqual(abs((texts[name][0].get_rotation() + 180) % 360 - 180), 90)
            middle = numpy.array(view.project(4, 3, 0.75)[:2])
            offset = numpy.array(texts[name][0].xyann)      # away from the box, across the edge
            self.assertAlmostEqual(offset @ (b - a), 0)
            self.assertGreater(offset @ (0.5 * (a + b) - middle), 0)
            self.assertAlmostEqual(numpy.linalg.norm(offset), 25)
        corners = [view.project(*view.corner(k))[:2] for k in (0, 1, 2, 3, 0)]
        numpy.testing.assert_allclose(numpy.transpose(axis.lines[0].get_data()), corners)
        marks = [numpy.transpose(line.get_data()) for line in axis.lines[1:]]
        long = [numpy.linalg.norm(a - b) > 0.5 for a, b in marks]
        edges = [mark for mark, is_long in zip(marks, long) if is_long]
        left, right, *_ = view.extent([lattices.thinned(one["series"][0], one)])
        for a, b in (mark for mark, is_long in zip(marks, long) if not is_long):
            self.assertAlmostEqual(numpy.linalg.norm(a - b), 0.008 * (right - left))
            self.assertTrue(any(numpy.allclose(text.xy, a) for text in axis.texts if hasattr(text, "xy")))
        wanted = [((8, 0, -0.5), (0, 0, -0.5)), ((8, 0, -0.5), (8, 6, -0.5)), ((0, 0, 0), (0, 0, 2))]
        numpy.testing.assert_allclose(edges, [[view.project(*end)[:2] for end in ends] for ends in wanted])
        self.assertIn("true vertical scale", [text.get_text() for text in self.drawn(slope(0.1), exaggeration=1.0)[2].texts])

    def test_places_of_ticks_are_round_and_leave_room(self):
        for low, high, most, wanted in ((0, 8, 9, [0, 2, 4, 6, 8]), (0.1, 2.0, 4.2, [0.5, 1, 1.5, 2]), (-1, 1, 1, [-1, 1]),
                                        (0, 1, 2.5, [0, 0.5, 1]),
                                        (0.3, 0.7, 3, [0.4, 0.6])):
            numpy.testing.assert_allclose(surfaces._places(low, high, most), wanted, err_msg=f"{low} to {high}, {most}")


if __name__ == "__main__":
    unittest.main()
