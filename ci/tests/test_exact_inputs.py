"""`seiche exact NAME --write SOLVER`: what other solvers start from, read back and compared with the solution."""

import pathlib
import re
import tempfile
import unittest

import numpy as np

from submitting import seiche

WAVE = ["--set", "amplitude=0.2,depth=1,gravity=1"]


def exact(name, *words):
    """Columns by name."""
    rows = [line for line in seiche("exact", name, *words).stdout.splitlines() if line and not line.startswith("#")]
    numbers = np.array([[float(entry) for entry in row.split(",")] for row in rows[1:]])
    return {entry.split(" ")[0]: numbers[:, k] for k, entry in enumerate(rows[0].split(","))}


class Inputs(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory(prefix="seiche-test-")
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)

    def written(self, name, form, *words):
        made = seiche("exact", name, "--write", form, "--out", self.folder, *words)
        self.assertEqual(made.returncode, 0, made.stdout + made.stderr)
        return [pathlib.Path(line) for line in made.stdout.split()]

    def refused(self, *words):
        made = seiche("exact", *words, "--out", self.folder)
        self.assertEqual(made.returncode, 2, made.stdout + made.stderr)
        self.assertEqual(len(made.stderr.strip().splitlines()), 1)
        return made.stderr

    def centres(self, x, up, axis="z"):
        points = [(a, 0.05, b) if axis == "z" else (a, b, 0.05) for b in up for a in x]
        (self.folder / "C").write_text(
            "FoamFile\n{\n    format      ascii;\n    class       volVectorField;\n}\n\ndimensions      [0 1 0 0 0 0 0];\n\n"
            f"internalField   nonuniform List<vector> \n{len(points)}\n(\n"
            + "".join("({:.9g} {:.9g} {:.9g})\n".format(*point) for point in points) + ")\n;\n\nboundaryField\n{\n}\n")
        return points

    def list_of(self, file):
        text = file.read_text()
        found = re.fullmatch(r"internalField   nonuniform List<(scalar|vector)>\n(\d+)\n\(\n(.*)\)\n;\n", text, re.DOTALL)
        rows = [[float(word) for word in line.strip("()").split()] for line in found[3].splitlines()]
        self.assertEqual(len(rows), int(found[2]))
        return np.array(rows)

    def test_openfoam_gets_shares_of_water_and_velocities(self):
        x, z = np.linspace(-6, 6, 25), np.linspace(0.05, 1.45, 15)
        for axis in ("z", "y"):
            points = self.centres(x + 10, z, axis)
            files = self.written("solitary", "openfoam", *WAVE, "--centres", self.folder / "C", "--origin", "10,1",
                                 "--up", axis)
            self.assertEqual([file.name for file in files], ["alpha.water.internalField", "U.internalField"])
            alpha, velocity = (self.list_of(file) for file in files)
            self.assertEqual((len(alpha), velocity.shape), (len(points), (len(points), 3)))
            water = alpha.reshape(len(z), len(x)).sum(axis=0) * 0.1
            eta = exact("solitary", *WAVE, "--grid", "x=-6:6:25,t=0")["eta"]
            np.testing.assert_allclose(water, 1 + eta, atol=1e-6)
            up = 2 if axis == "z" else 1
            self.assertTrue((velocity[:, 3 - up] == 0).all())
            inside = exact("solitary", *WAVE, "--at", "x=1,y=-0.45,t=0")
            cell = next(k for k, p in enumerate(points) if abs(p[0] - 11) < 1e-9 and abs(p[up] - 0.55) < 1e-9)
            np.testing.assert_allclose(velocity[cell, [0, up]], [inside["u"][0], inside["v"][0]], atol=1e-7)
            dry = alpha[:, 0] == 0
            self.assertTrue(dry.any() and (velocity[dry] == 0).all())

    def test_openfoam_says_what_is_missing(self):
        self.assertIn("--centres", self.refused("solitary", "--write", "openfoam"))
        self.centres([0, 1], [0.5])
        self.assertIn("one cell alone", self.refused("solitary", "--write", "openfoam", "--centres", self.folder / "C"))
        self.assertIn("cannot be read", self.refused("solitary", "--write", "openfoam", "--centres", self.folder / "no"))

    def test_geoclaw_gets_bed_surface_and_discharge(self):
        for name, words, depth in (("solitary", WAVE, 1), ("serre_solitary", [], None), ("riemann", [], None)):
            with self.subTest(name):
                files = self.written(name, "geoclaw", *words, "--grid", "x=-5:5:11,t=0", "--width", "2")
                self.assertEqual([file.name for file in files], ["topo.xyz", "eta.xyz", "hu.xyz"])
                bed, eta, hu = (np.loadtxt(file) for file in files)
                self.assertTrue((eta[:11, 1] == 2).all() and (eta[11:, 1] == 0).all())   # north first
                self.assertTrue((np.diff(eta[:11, 0]) > 0).all())
                self.assertTrue((eta[:, 2] >= bed[:, 2]).all())
                solution = exact(name, *words, "--grid", "x=-5:5:11,t=0")
                np.testing.assert_allclose(eta[11:, 2], solution.get("eta", solution.get("h")), atol=1e-14)
                if depth:
                    # Mass under a wave of permanent form: hu = c eta.
                    scalars = exact(name, *words, "--integrals")
                    np.testing.assert_allclose(hu[:11, 2], scalars["speed"][0] * eta[:11, 2], atol=1e-9)
        bowl = self.written("thacker", "geoclaw", "--grid", "x=0:3:7,t=0")
        self.assertTrue((np.diff(np.loadtxt(bowl[0])[:4, 2]) < 0).all())   # its bed is a bowl

    def test_dualsphysics_gets_the_motion_of_a_piston(self):
        file, = self.written("solitary", "dualsphysics", *WAVE)
        t, x = np.loadtxt(file, delimiter=";").T
        self.assertEqual((t[0], x[0]), (0, 0))
        self.assertTrue((np.diff(t) > 0).all() and (np.diff(x) >= 0).all())
        # It displaces the water of the wave, but for the ten thousandth at both ends.
        mass = exact("solitary", *WAVE, "--integrals")["mass"][0]
        self.assertAlmostEqual(x[-1] / mass, 1, 3)
        file, = self.written("wavemaker", "dualsphysics", "--set", "stroke=0.2,period=2,gravity=9.81", "--grid", "t=0:2:9")
        t, x = np.loadtxt(file, delimiter=";").T
        np.testing.assert_allclose(x, 0.1 * np.sin(np.pi * t), atol=1e-12)
        self.assertIn("has no piston", self.refused("riemann", "--write", "dualsphysics"))

    def test_vtk_gets_points_and_fields(self):
        file, = self.written("stokes", "vtk", "--set", "amplitude=0.1,depth=1", "--grid", "x=0:6:4,y=-1:0.2:3,t=0")
        lines = file.read_text().splitlines()
        self.assertEqual(lines[2:4], ["ASCII", "DATASET STRUCTURED_GRID"])
        self.assertEqual(lines[4:6], ["DIMENSIONS 4 1 3", "POINTS 12 double"])
        points = np.array([line.split() for line in lines[6:18]], float)
        self.assertEqual(points[1].tolist(), [2, 0, -1])
        at = lines.index("SCALARS u double 1")
        u = np.array(lines[at + 2:at + 14], float)
        self.assertTrue(np.isnan(u[-2]) or np.isfinite(u[-2]))
        solution = exact("stokes", "--set", "amplitude=0.1,depth=1", "--grid", "x=0:6:4,y=-1:0.2:3,t=0")
        np.testing.assert_array_equal(u, solution["u"])

    def test_csv_is_what_the_grid_prints(self):
        file, = self.written("riemann", "csv", "--grid", "x=-1:1:3,t=1")
        self.assertEqual(file.read_text(), seiche("exact", "riemann", "--grid", "x=-1:1:3,t=1").stdout)

    def test_bad_words_are_refused(self):
        self.assertIn("--grid", self.refused("riemann", "--write", "vtk"))
        self.assertIn("one instant", self.refused("riemann", "--write", "vtk", "--grid", "x=0:1:2,t=0:1:2"))
        self.assertIn("two points", self.refused("riemann", "--write", "geoclaw", "--grid", "x=0,t=0"))
        self.assertIn("surface over x", self.refused("hall_watts", "--write", "geoclaw", "--grid", "x=0:1:2"))
        self.assertIn("finite", self.refused("stokes", "--write", "geoclaw", "--grid", "x=0:1:2,t=0"))


if __name__ == "__main__":
    unittest.main()
