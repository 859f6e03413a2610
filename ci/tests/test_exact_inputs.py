"""What `seiche exact` writes: every solution by every writer, read back and compared with the solution, or refused."""

import json
import pathlib
import re
import subprocess
import sys
import unittest

import h5py
import numpy as np

from submitting import SEICHE, Scratch, columns_of, exact, printed, seiche

WAVE = ["--set", "amplitude=0.2,depth=1,gravity=1"]
# What other solvers start from: the elevation of the bed (None: infinitely deep), where, and with which parameters.
WATER = {"riemann": (0, "-2:2", []), "bore_reflection": (0, "3:8", []), "simple_wave": (0, "3:9", []),
         "steady_bump": ("z", "7:13", []), "macdonald": ("z", "100:900", []), "thacker": ("z", "0.4:3.6", []),
         "thacker_radial": ("z", "-0.7:0.9", []), "thacker_planar": ("z", "-0.7:0.9", []),
         "airy": (-2, "0:6", ["--set", "depth=2,amplitude=0.1"]), "serre_solitary": (-1, "-3:3", WAVE),
         "serre_cnoidal": (-1, "0:6", []), "solitary_asymptotic": (-1, "-3:3", WAVE), "solitary": (-1, "-3:3", WAVE),
         "stokes": ("mean_depth", "0:6", ["--set", "conformal_depth=1.5"]),
         "standing": (-1.5, "0:6", ["--set", "depth=1.5"]), "gerstner": (None, "0:6", [])}
IN_PLAN = {"thacker_radial", "thacker_planar"}
NO_VELOCITY = {"wavemaker", "wavemaker_start"}
CURVES = {"overturning_wave", "pressure_forced_wave", "waves_in_tank"}
PISTONS = {"solitary", "solitary_asymptotic", "wavemaker"}
# Computations of seconds; that of slope_runup takes a minute and is printed as that of wall_load is.
QUICKER = {"overturning_wave": ["--set", "markers=64,last_time=0.5"],
           "pressure_forced_wave": ["--set", "markers=192,last_time=0.5"],
           "wall_load": ["--set", "markers=128,amplitude=0.1"], "wall_runup": ["--set", "markers=128,amplitude=0.1"]}


def at(name, words, points, time):
    """Columns of a solution at (x, across, height) or, without heights, at the surface; t where it has one."""
    asked = []
    for x, across, height in points:
        y = across if name in IN_PLAN else height
        asked += ["--at", f"x={x:.17g}" + ("" if y is None else f",y={y:.17g}") + time]
    return exact(name, *words, *asked)


def catalogue():
    """Inputs by solution."""
    inputs = {}
    for line in seiche("exact", "list").stdout.splitlines():
        if re.match(r"[a-z_]+: ", line):
            inputs[name := line.split(":")[0]] = []
        elif line.startswith("    --at"):
            inputs[name].append(line.split()[1])
    return inputs


def grid_of(inputs):
    ranges = {"t": "0.25", "y": "-0.5:0.3:4", "k": "1:2:3", "n": "1:2:2"}
    return ",".join(f"{name}={ranges.get(name, '0.25:1.75:3')}" for name in inputs)


def for_every_solution(check):
    def checks(self):
        for name, inputs in CATALOGUE.items():
            with self.subTest(name):
                self.out = self.folder / f"out-{name}"
                check(self, name, inputs)
    return checks


class Inputs(Scratch):
    def written(self, name, form, *words):
        made = seiche("exact", name, "--write", form, "--out", self.out, *words)
        self.assertEqual(made.returncode, 0, made.stdout + made.stderr)
        return {pathlib.Path(line).name: pathlib.Path(line) for line in made.stdout.split()}

    def refused(self, *words):
        made = seiche("exact", *words, "--out", self.out)
        self.assertEqual((made.returncode, made.stdout), (2, ""), made.stdout + made.stderr)
        self.assertEqual(len(made.stderr.strip().splitlines()), 1)
        self.assertFalse(self.out.exists(), "something was written")
        return made.stderr

    def centres(self, points, axis="z"):
        """(x, across, height) as OpenFOAM's field C."""
        self.assertIn(axis, "yz")
        places = [(x, y, z) if axis == "z" else (x, z, -y) for x, y, z in points]
        (self.folder / "C").write_text(
            "FoamFile\n{\n    format      ascii;\n    class       volVectorField;\n}\n\ndimensions      [0 1 0 0 0 0 0];\n\n"
            f"internalField   nonuniform List<vector> \n{len(places)}\n(\n"
            + "".join("({:.17g} {:.17g} {:.17g})\n".format(*place) for place in places)
            + ")\n;\n\nboundaryField\n{\n}\n")
        return ["--centres", self.folder / "C", "--up", axis]

    def list_of(self, file):
        text = file.read_text()
        found = re.fullmatch(r"internalField   nonuniform List<(scalar|vector)>\n(\d+)\n\(\n(.*)\)\n;\n", text, re.DOTALL)
        rows = [[float(word) for word in line.strip("()").split()] for line in found[3].splitlines()]
        self.assertEqual(len(rows), int(found[2]))
        return np.array(rows)

    def columns_of(self, name):
        """Places (x, across), bed, surface, time of the columns of water that are compared."""
        bed, along, words = WATER[name]
        time = ",t=0.25" if "t" in CATALOGUE[name] else ""
        places = [(x, y) for y in ([-0.3, 0.1, 0.5] if name in IN_PLAN else [0.0])
                  for x in np.linspace(*map(float, along.split(":")), 5).tolist()]
        water = at(name, words, [(*place, None) for place in places], time)
        if bed == "mean_depth":
            bed = -exact(name, *words, "--integrals")["mean_depth"][0]
        low = water.get(bed, np.full(len(places), -np.inf if bed is None else bed))
        return words, places, low, water["eta"] if "eta" in water else low + water["h"], time

    @for_every_solution
    def test_openfoam(self, name, _):
        if name not in WATER:
            told = self.refused(name, "--write", "openfoam", *self.centres([(0, 0, 0), (0, 0, 1)]))
            self.assertIn("has no velocity field" if name in NO_VELOCITY else "does not define the free surface", told)
            return
        words, places, low, surface, time = self.columns_of(name)
        low = np.maximum(low, -2.6)
        each = 1.2 * (surface - low).max() / 8  # cells of water, of air, and of both
        points, share, middle = [], [], []
        for (x, y), bottom, top in zip(places, low, surface):
            for k in range(8):
                foot = bottom + k * each
                points.append((x, y, foot + 0.5 * each))
                share.append(np.clip((top - foot) / each, 0, 1))
                middle.append((x, y, 0.5 * (foot + min(foot + each, max(top, foot)))))
        wet = np.array(share) > 1e-9
        heights = "y" in CATALOGUE[name] and name not in IN_PLAN
        inside = at(name, words, [(x, y, z if heights else None) for (x, y, z), w in zip(middle, wet) if w], time)
        expected = np.zeros((len(points), 3))
        expected[wet, 0] = inside["u"]
        if "v" in inside:
            expected[wet, 2 if heights else 1] = inside["v"]
        self.assertGreater(np.abs(expected).max(), 0)
        for axis in "zy":
            files = self.written(name, "openfoam", *words, *self.centres(points + np.array([10, 0, 1]), axis),
                                 "--origin", "10,1", *(["--at", time[1:]] if time else []))
            self.assertEqual(list(files), ["alpha.water.internalField", "U.internalField"])
            alpha, velocity = (self.list_of(file) for file in files.values())
            np.testing.assert_allclose(alpha[:, 0], share, atol=1e-9)
            turned = velocity if axis == "z" else velocity[:, [0, 2, 1]] * [1, -1, 1]
            np.testing.assert_allclose(turned[wet], expected[wet], atol=1e-9 * np.abs(expected).max())
            self.assertTrue((velocity[alpha[:, 0] == 0] == 0).all())

    @for_every_solution
    def test_geoclaw(self, name, _):
        node, weight = np.polynomial.legendre.leggauss(24)
        if name not in WATER or WATER[name][0] is None:
            told = self.refused(name, "--write", "geoclaw", "--grid", "x=0:1:2,t=0" if name == "gerstner"
                                else grid_of(CATALOGUE[name]) or "x=0:1:2")
            self.assertIn("has no velocity field" if name in NO_VELOCITY else "finite depth" if name in WATER else
                          "does not define the free surface", told)
            return
        words, places, low, surface, time = self.columns_of(name)
        files = self.written(name, "geoclaw", *words, "--origin", "10,1", "--width", "2", "--grid",
                             f"x={WATER[name][1]}:5" + (",y=-0.3:0.5:3" if name in IN_PLAN else "") + time)
        plan = ["hv.xyz"] if name in IN_PLAN else []
        self.assertEqual(list(files), ["topo.xyz", "eta.xyz", "hu.xyz", *plan])
        # North first; a strip has the same row twice.
        order = np.lexsort((np.array(places)[:, 0], -np.array(places)[:, 1]))
        order = order if plan else np.concatenate([order, order])
        if "y" in CATALOGUE[name] and not plan:
            heights = [(x, 0, b + 0.5 * (s - b) * (1 + n)) for (x, _), b, s in zip(places, low, surface)
                       for n in node]
            hu = at(name, words, heights, time)["u"].reshape(-1, len(node)) @ weight * 0.5 * (surface - low)
            hv = None
        else:
            flow = at(name, words, [(*place, None) for place in places], time)
            hu, hv = ((surface - low) * flow[one] if one in flow else None for one in "uv")
        for file, expected in zip(files.values(), (low + 1, surface + 1, hu, hv)):
            read = np.loadtxt(file)
            np.testing.assert_allclose(read[:, 0] - 10, np.array(places)[order, 0], atol=1e-12)
            np.testing.assert_allclose(read[:, 1], np.array(places)[order, 1] if plan else [2] * 5 + [0] * 5,
                                       atol=1e-12)
            np.testing.assert_allclose(read[:, 2], expected[order], atol=1e-8 * np.abs(expected).max())

    @for_every_solution
    def test_vtk(self, name, inputs):
        words = QUICKER.get(name, [])
        if not inputs or name in CURVES:
            told = self.refused(name, "--write", "vtk", *words, *(["--grid", "t=0.25"] if inputs else []))
            self.assertIn("is a curve" if inputs else "--grid is missing", told)
            return
        file, = self.written(name, "vtk", *words, "--grid", grid_of(inputs)).values()
        lines = file.read_text().splitlines()
        self.assertEqual(lines[2:4], ["ASCII", "DATASET STRUCTURED_GRID"])
        solution = exact(name, *words, "--grid", grid_of(inputs))
        count = len(next(iter(solution.values())))
        self.assertEqual(lines[5], f"POINTS {count} double")
        self.assertEqual(np.prod([int(word) for word in lines[4].split()[1:]]), count)
        points = np.array([line.split() for line in lines[6:6 + count]], float)
        axes = [axis for axis in inputs if axis != "t"]
        for k, axis in enumerate(axes):
            height = axis == "y" and name in WATER and name not in IN_PLAN
            np.testing.assert_array_equal(points[:, 2 if height else k], solution[axis])
        for field in set(solution) - set(inputs):
            begin = lines.index(f"SCALARS {field} double 1") + 2
            np.testing.assert_array_equal(np.array(lines[begin:begin + count], float), solution[field])

    @for_every_solution
    def test_csv_json_and_hdf5(self, name, inputs):
        words = [*QUICKER.get(name, []), *(["--grid", grid_of(inputs)] if inputs else [])]
        text = printed("exact", name, *words)
        file, = self.written(name, "csv", *words).values()
        self.assertEqual(file.read_text(), text)
        self.assertEqual(seiche("exact", name, *words, "--format", "hdf5", "--out", self.out / "h5").returncode, 0)
        table = json.loads(seiche("exact", name, *words, "--format", "json").stdout)
        with h5py.File(self.out / "h5") as hdf5:
            for k, (column, values) in enumerate(columns_of(text).items()):
                self.assertEqual(table["columns"][k]["name"], column)
                np.testing.assert_array_equal(np.array([row[k] for row in table["rows"]], float), values)
                np.testing.assert_array_equal(hdf5[column][:], values)

    @for_every_solution
    def test_dualsphysics(self, name, _):
        if name not in PISTONS:
            self.assertIn("has no piston", self.refused(name, "--write", "dualsphysics"))
            return
        words = ["--set", "stroke=0.2,period=2,gravity=9.81"] if name == "wavemaker" else WAVE
        file, = self.written(name, "dualsphysics", *words).values()
        t, x = np.loadtxt(file, delimiter=";").T
        step = t[1]
        np.testing.assert_allclose(np.diff(t), step, atol=1e-11 * t[-1])
        self.assertEqual((t[0], x[0]), (0, 0))
        # Differences of second order and of twelve digits; what the paddle runs at by its third differences.
        rounding = np.abs(np.diff(x, 3)).max() / step / 6 + 1e-12 / step
        rate = (x[2:] - x[:-2]) / (2 * step)
        self.assertLess(abs(x[1]) / step, 1e-3 * np.abs(rate).max(), "it does not start from rest")
        if name == "wavemaker":
            settled = t > 2
            np.testing.assert_allclose(x[settled], 0.1 * np.sin(np.pi * t[settled]), atol=1e-12)
            return
        # It moves with the water behind it, c eta/(d + eta), and displaces that of the wave but for both ends.
        scalars = exact(name, *words, "--integrals")
        speed = scalars["speed"][0]
        self.assertAlmostEqual(x[-1] / scalars["mass"][0], 1, 3)
        ahead = exact(name, *words, "--grid", "x=1:41:4001,t=0")
        start = ahead["x"][np.argmax(ahead["eta"] <= 1e-4 * 0.2)] / speed
        some = np.arange(1, len(t) - 1, 8)
        asked = [word for k in some for word in ("--at", f"x={x[k]:.17g},t={t[k] - start:.17g}")]
        eta = exact(name, *words, *asked)["eta"]
        np.testing.assert_allclose(rate[some - 1], speed * eta / (1 + eta), atol=rounding)

    def test_what_is_missing_or_wrong_is_said(self):
        openfoam = ["solitary", "--write", "openfoam"]
        self.assertIn("--centres", self.refused(*openfoam))
        self.assertIn("one cell alone", self.refused(*openfoam, *self.centres([(0, 0, 0.5), (1, 0, 0.5)])))
        self.assertIn("cannot be read", self.refused(*openfoam, "--centres", self.folder / "no"))
        self.assertIn("below the bed", self.refused(*openfoam, *self.centres([(0, 0, -0.5), (0, 0, -1.5)])))
        self.assertIn("--grid", self.refused("riemann", "--write", "vtk"))
        self.assertIn("one instant", self.refused("riemann", "--write", "vtk", "--grid", "x=0:1:2,t=0:1:2"))
        self.assertIn("two points", self.refused("riemann", "--write", "geoclaw", "--grid", "x=0,t=0"))
        for name, words in (("stokes", []), ("airy", ["--set", "depth=inf"])):
            self.assertIn("finite", self.refused(name, *words, "--write", "geoclaw", "--grid", "x=0:1:2,t=0"))
        for times in ("t=5", "t=1:2:3", "t=-1:2:3"):
            for name in PISTONS:
                self.assertIn("from rest", self.refused(name, "--write", "dualsphysics", "--grid", times))
        self.assertIn("--format", self.refused("riemann", "--write", "csv", "--format", "hdf5", "--grid", "x=0:1:2,t=1"))
        # A point asked for by itself lies in the water, with a grid beside it or without.
        outside = ["solitary", *WAVE, "--at", "x=0,y=1,t=0"]
        self.assertIn("above the surface", self.refused(*outside))
        self.assertEqual(self.refused(*outside, "--grid", "x=0:1:2,t=0"), self.refused(*outside))
        for depth in (1e-200, 1e-40):
            self.assertIn("right_depth", self.refused("riemann", "--set", f"right_depth={depth}", "--at", "x=0,t=1"))

    def test_a_column_is_there_where_any_row_has_a_number(self):
        table = exact("solitary", *WAVE, "--at", "x=0,t=0", "--at", "x=0,y=-0.5,t=0")
        np.testing.assert_array_equal(table["y"], [np.nan, -0.5])
        self.assertLess(table["u"][1], table["u"][0])
        self.assertNotIn("y", exact("solitary", *WAVE, "--at", "x=0,t=0"))

    def test_ahead_of_all_waves_nothing_is_computed(self):
        for x in ("1e6", "1e12"):
            self.assertEqual(exact("wavemaker_start", "--at", f"x={x},t=1")["eta"], 0)


CATALOGUE = catalogue()
CATALOGUE.pop("slope_runup")

# Prints what the module says of each solution as JSON: scalars, and outputs at a point, by name.
MODULE = """import json, sys, numpy, seiche
known = lambda value: value if numpy.isfinite(value) else None
said = {}
for name, given in json.loads(sys.argv[1]).items():
    solution = seiche.exact(name, **given["parameters"])
    said[name] = {key: known(numpy.ravel(value)[0]) for key, value in solution(**given["point"]).items()}, {
        key: known(value) for key, value in solution.scalars.items()}
print(json.dumps(said))"""
POINT = {"x": 0.7, "z": 0.4, "t": 0.3}  # on the surface where there is one; 1 for other coordinates


@unittest.skipUnless(list((pathlib.Path(SEICHE).parent / "python/seiche").glob("*.so")), "the module is not built")
class Module(unittest.TestCase):
    def test_each_number_is_that_of_the_command_by_name(self):
        asked = {}
        for name, inputs in catalogue().items():
            if name != "slope_runup":
                words = [word.split("=") for word in (QUICKER.get(name) or ["", ""])[1].split(",") if word]
                asked[name] = {"parameters": {key: float(value) for key, value in words},
                               "point": {key: POINT.get(key, 1) for key in inputs if key != "y"}}
        ended = subprocess.run([sys.executable, "-c", MODULE, json.dumps(asked)], capture_output=True, text=True, check=True,
                               env={"PYTHONPATH": str(pathlib.Path(SEICHE).parent / "python")})
        for name, (outputs, scalars) in json.loads(ended.stdout).items():
            with self.subTest(name=name):
                point = ",".join(f"{key}={value}" for key, value in asked[name]["point"].items())
                made = json.loads(seiche("exact", name, *QUICKER.get(name, []), *(["--at", point] if point else []),
                                         "--integrals", "--format", "json").stdout)
                columns = dict(zip([column["name"] for column in made.get("columns", [])], made.get("rows", [[]])[0]))
                numbers = made.get("scalars", {})
                np.testing.assert_equal(outputs, {key: {**numbers, **columns}[key] for key in outputs})
                np.testing.assert_equal(scalars, {key: numbers[key] for key in scalars})

if __name__ == "__main__":
    unittest.main()
