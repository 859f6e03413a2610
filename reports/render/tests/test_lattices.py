"""Surfaces and plans on made-up lattices.

    /usr/bin/python3 reports/render/tests/test_lattices.py
"""
import math
import pathlib
import tempfile
import unittest

import h5py
import made  # noqa: F401  (finds render)
import numpy

from render import arrays, figures, lattices
from render.scene import scene

figures.prepare()


def hill(columns=40, rows=30, style="surface", **changes):
    """A solitary hill over a sheared lattice."""
    x, y = numpy.meshgrid(numpy.linspace(-10, 10, columns + 1), numpy.linspace(0, 15, rows + 1))
    z = 0.3 / numpy.cosh(0.5 * x) ** 2
    return {"label": "water", "role": "computed", "style": style, "x": x + 0.1 * y, "y": y, "z": z, **changes}


def panel(*series, **changes):
    return {"title": "t = 1", "x_label": "x / h", "y_label": "y / h", "z_label": "z / h", "log_x": 0, "log_y": 0,
            "aspect": "auto", "series": list(series), **changes}


def framed(one):
    """The panel with its range of heights, as the drawing sees it."""
    lattices.share_heights([one])
    return one


class Drawn(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))

    def draw(self, *panels, small=False, name="f"):
        """What went wrong, and the SVG."""
        file, target = self.folder / "data.h5", self.folder / f"{name}.svg"
        with h5py.File(file, "w") as store:
            figure = store.create_group("figures/f")
            for p, one in enumerate(panels):
                node = figure.create_group(f"panel_{p:02d}")
                node.attrs.update({key: value for key, value in one.items() if key != "series"})
                for s, series in enumerate(one["series"]):
                    group = node.create_group(f"series_{s:02d}")
                    for key, value in series.items():
                        if isinstance(value, numpy.ndarray):
                            group[key] = value
                        else:
                            group.attrs[key] = value
        problem = figures.draw(str(file), "f", "panels", small, "key", str(target))
        return problem, target.read_bytes() if target.exists() else b""

    def test_a_cell_is_split_along_its_flatter_diagonal(self):
        x, y = numpy.meshgrid([0.0, 1.0], [0.0, 1.0])
        for z, split in (([[2, 1], [3, 2]], [0, 3]), ([[1, 2], [2, 3]], [1, 2])):
            both = [set(corners) for corners in lattices.triangles(x, y, numpy.array(z, float)).tolist()]
            self.assertEqual(sorted(both[0] & both[1]), split)

    def test_surface_and_plan_side_by_side_and_as_a_stamp(self):
        for small in (False, True):
            problem, svg = self.draw(panel(hill()), panel(hill(style="plan")), small=small)
            self.assertEqual(problem, "")
            self.assertIn(b"<image", svg)

    def test_a_lattice_of_a_million_cells_is_a_small_figure(self):
        problem, svg = self.draw(panel(hill(1000, 1000)))
        self.assertEqual(problem, "")
        self.assertLess(len(svg), 600_000)

    def test_the_same_lattice_gives_the_same_bytes(self):
        drawn = [self.draw(panel(hill()), panel(hill(style="plan")), name=name) for name in "ab"]
        self.assertEqual(drawn[0], drawn[1])

    def test_water_over_a_bed_with_a_dry_hole(self):
        water, bed = hill(), hill(role="bed", label="bed")
        bed["z"] = bed["z"] - 0.5
        water["z"][10:15, 10:15] = numpy.nan
        self.assertEqual(self.draw(panel(water, bed))[0], "")
        self.assertEqual(self.draw(panel(hill(style="plan", z=water["z"])))[0], "")

    def test_lines_lie_over_a_plan(self):
        crest = {"label": "crest", "role": "exact", "style": "line", "x": numpy.arange(2.0), "y": numpy.arange(2.0)}
        self.assertEqual(self.draw(panel(hill(style="plan"), crest))[0], "")

    def test_what_cannot_be_drawn_is_said(self):
        line = {"label": "l", "role": "exact", "style": "line", "x": numpy.arange(3.0), "y": numpy.arange(3.0)}
        flat = numpy.arange(12.0)
        for wrong, words in ((panel(hill(), line), "nothing but surfaces"), (panel(hill(z=flat)), "two-dimensional"),
                             (panel(hill(x=flat, y=flat, z=flat)), "two-dimensional"),
                             (panel(hill(), x_min=50.0, x_max=60.0), "within the panel's limits"),
                             (panel(hill(z=numpy.full((31, 41), numpy.nan))), "no finite height")):
            self.assertIn(words, self.draw(wrong)[0])


class Lattices(unittest.TestCase):
    def test_rows_keep_their_shape_on_the_way_from_the_file(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "data.h5"
            with h5py.File(file, "w") as store:
                group = store.create_group("figures/f/panel_00/series_00")
                group.attrs["style"] = "plan"
                group["z"] = numpy.zeros((3, 4))
            self.assertEqual(arrays.read_figure(file, "f")["panels"][0]["series"][0]["z"].shape, (3, 4))

    def test_thinning_keeps_the_borders_and_200_cells(self):
        series = hill(1001, 333)
        x, y, z = lattices.thinned(series, {})
        self.assertEqual(x.shape, y.shape)
        self.assertLessEqual(max(z.shape), lattices.DRAWN + 1)
        for part, name in ((x, "x"), (y, "y"), (z, "z")):
            for corner in ((0, 0), (0, -1), (-1, 0), (-1, -1)):
                self.assertEqual(part[corner], series[name][corner])

    def test_limits_are_cut_before_thinning(self):
        series = hill(1000, 10)
        x, _, z = lattices.thinned(series, {"x_min": -2.0, "x_max": 2.0})
        self.assertGreater(z.shape[1], 100)
        self.assertTrue((numpy.abs(x[numpy.isfinite(z)]) <= 2 + 1e-6).all())

    def test_axes_cut_a_plan_and_find_points_on_either_side_of_their_limits(self):
        _, y, z = lattices.thinned(hill(10, 1000), {"y_min": 5.0, "y_max": 8.0}, cut=False)
        self.assertTrue(numpy.isfinite(z).all())
        self.assertTrue(5 - 0.03 < y.min() < 5 and 8 < y.max() < 8 + 0.03, (y.min(), y.max()))

    def test_cells_with_a_missing_corner_stay_open(self):
        series = hill(4, 3)
        x, y, z = (series[name].copy() for name in "xyz")
        self.assertEqual(len(lattices.triangles(x, y, z)), 2 * 4 * 3)
        z[1, 1] = numpy.nan
        self.assertEqual(len(lattices.triangles(x, y, z)), 2 * (4 * 3 - 4))

    def test_frames_share_their_heights_and_given_limits_stay(self):
        low, high = panel(hill()), panel(hill(style="plan", z=2 * hill()["z"]), z_max=5.0)
        lattices.share_heights([low, high])
        self.assertAlmostEqual(low["z_max"], 0.6)
        self.assertEqual((low["z_min"], high["z_max"]), (high["z_min"], 5.0))

    def test_still_water_has_a_range_too(self):
        still = framed(panel(hill(z=numpy.zeros((31, 41)))))
        self.assertLess(still["z_min"], still["z_max"])

    def test_heights_of_both_signs_are_coloured_about_zero(self):
        signed = framed(panel(hill(z=hill()["z"] - 0.15)))
        norm = lattices.colours(signed).norm
        self.assertAlmostEqual(norm.vmin, -norm.vmax)


class Scene(unittest.TestCase):
    def test_exaggeration_is_round_or_as_given(self):
        self.assertIn(scene(framed(panel(hill()))).exaggeration, (1, 2, 5, 10, 20, 50))
        self.assertEqual(scene(framed(panel(hill(), exaggeration=3.0))).exaggeration, 3.0)

    def test_higher_points_appear_higher_and_nearer_ones_lower(self):
        view = scene(framed(panel(hill())))
        self.assertGreater(view.project(0, 5, 0.3)[1], view.project(0, 5, 0.0)[1])
        nearest, left, right = view.edges()
        for corner in range(4):
            self.assertLessEqual(view.project(*view.corner(nearest))[1], view.project(*view.corner(corner))[1])
        self.assertLess(view.project(*view.corner(left))[0], view.project(*view.corner(right))[0])

    def test_the_extent_holds_every_point_that_is_known(self):
        view = scene(framed(panel(hill())))
        for x, y in ((400.0, 7.0), (-400.0, 7.0), (3.0, 900.0), (3.0, -900.0)):
            left, right, bottom, top = view.extent([tuple(numpy.array([[value, math.nan]]) for value in (x, y, 0.1))])
            across, up = view.project(x, y, 0.1)[:2]
            self.assertTrue(left <= across <= right and bottom <= up <= top, (x, y))

    def test_the_exaggeration_stands_on_the_panel(self):
        from render import panels
        drawn = panels.panels({"panels": [panel(hill(), exaggeration=7.0)]}, False)
        self.assertIn("heights × 7", [text.get_text() for text in drawn.axes[0].texts])


if __name__ == "__main__":
    unittest.main()
