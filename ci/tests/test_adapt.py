"""`python -m seiche.adapt`: fronts, surfaces and gauges off what solvers write, as files of their own or made here."""

import contextlib
import io
import os
import subprocess
import sys
import types
import unittest
import unittest.mock

import h5py
import numpy as np

PACKAGE = os.environ["SEICHE_PYTHON_PATH"]  # with the compiled module
sys.path.insert(0, PACKAGE)
from seiche import adapt  # noqa: E402
from submitting import SOURCE, Scoring, printed, rows_of  # noqa: E402

WRITTEN = SOURCE / "ci/tests/solver_output"  # by real solvers, see its README.md
COLUMN = ("--column", "0.05715")


def has(module):
    try:
        __import__(module)
    except ImportError:
        return False
    return True


class Adapt(Scoring):
    def adapt(self, *words):
        """As the command does it: files are read in a process apart, which finds the libraries loaded."""
        out, err, status = io.StringIO(), io.StringIO(), 0
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
            try:
                adapt.main([*map(str, words)])
            except SystemExit as ended:
                status = ended.code
        return types.SimpleNamespace(returncode=status, stdout=out.getvalue(), stderr=err.getvalue())

    def rows(self, *words):
        made = self.adapt(*words)
        self.assertEqual(made.returncode, 0, made.stderr)
        names, rows = rows_of(made.stdout)
        return names, np.array([[float(word) for word in row] for row in rows])

    def refuses(self, made, *words):
        self.assertEqual((made.returncode, made.stdout), (2, ""))
        self.assertEqual(len(made.stderr.strip().splitlines()), 1, made.stderr)
        for word in words:
            self.assertIn(word, made.stderr)

    def test_fronts_of_three_solvers_as_written(self):
        """At T = 3.7, t = 0.2 s, Martin and Moyce measured X/a = 4.5 to 4.9 with a start that is late by 0.2."""
        for words in (("interFoam/floor", "--field", "alpha.water"), ("gerris/floor.txt", "--field", "T"),
                      ("pysph", "--near", 0.005715)):
            names, front = self.rows("front", WRITTEN / words[0], *words[1:], *COLUMN)
            self.assertEqual(names, ["T [1]", "X [1]"])
            self.assertTrue((np.diff(front, axis=0) > 0).all(), front)
            at = np.interp(3.7056, front[:, 0], front[:, 1])
            self.assertTrue(4.2 < at < 5.4, (words, at))

    def test_front_is_scored(self):
        front = self.adapt("front", WRITTEN / "interFoam/floor", "--field", "alpha.water", *COLUMN).stdout
        scored = self.score("dam_break_sph", "--data", self.write(front), "--set", "scored_to=8", "--dx", 0.00714375)
        self.accepted(scored, 1)
        verdicts = self.verdicts("dam_break_sph.mine")
        self.assertEqual((verdicts["shift"], verdicts["rms"]), ("pass", "pass"))
        self.assertNotIn("another origin", scored.stdout)

    def test_surface_and_gauge_as_written(self):
        """Half a period of the standing wave is 1.15 s: at x = 0 the surface falls from 0.05 m to its lowest."""
        names, surface = self.rows("surface", WRITTEN / "interFoam/surface")
        self.assertEqual(names, ["t [s]", "x [m]", "eta [m]"])
        self.assertAlmostEqual(surface[:, 1].max(), np.pi, delta=1e-6)
        names, gauge = self.rows("gauge", WRITTEN / "interFoam/surface", "--at", "x=0")
        self.assertEqual(names, ["x [m]", "t [s]", "eta [m]"])
        self.assertEqual(gauge[:, 1].tolist(), [0.5, 1.15])
        self.assertTrue(-0.055 < gauge[1, 2] < -0.04, gauge)

    def test_spray_is_no_front(self):
        folder = self.folder / "run"
        folder.mkdir()
        with h5py.File(folder / "a.hdf5", "w") as file:
            file.create_group("solver_data").attrs["t"] = 0.5
            x, y = np.meshgrid(np.arange(5) * 0.1, np.arange(3) * 0.1)
            file["particles/fluid/arrays/x"] = np.append(x.ravel(), 2.0)
            file["particles/fluid/arrays/y"] = np.append(y.ravel(), 0.0)
            file["particles/fluid/arrays/rho0"] = np.array([])    # never filled
        _, front = self.rows("front", folder, "--near", 0.1)
        np.testing.assert_allclose(front, [[0.5, 0.4]])

    def test_pickled_objects_are_not_read(self):
        """A stranger's .npz runs what it wants where it is unpickled."""
        class Bait:
            def __reduce__(self):
                return os.mkdir, (str(bait),)

        bait = self.folder / "bait"
        np.savez(self.folder / "a.npz", particles=np.array(Bait()), solver_data=np.array({"t": 0}))
        made = self.adapt("front", self.folder / "a.npz", "--near", 0.1)
        self.assertFalse(bait.exists())
        self.refuses(made, "a.npz", "pickled")

    def test_hostile_files_end_in_one_line(self):
        """Collections that name themselves or what is above them, damage, links out of the file, and sizes that only a
        header claims."""
        def collection(entry):
            return f'<VTKFile type="Collection"><Collection><DataSet {entry}/></Collection></VTKFile>'

        bomb = '<!DOCTYPE x [<!ENTITY a "' + "x" * 99 + '">]><VTKFile type="UnstructuredGrid"><x>&a;</VTKFile>'
        for name, content in {
                "self.pvd": collection('timestep="0" file="self.pvd"'), "up.pvd": collection('timestep="0" file="../up.vtu"'),
                "root.pvd": collection('timestep="0" file="/etc/passwd"'), "time.pvd": collection('timestep="x" file="a.vtu"'),
                "none.pvd": "<VTKFile/>", "bytes.pvd": bytes(range(256)), "bomb.vtu": bomb, "a.vtu": b"\0" * 99,
                "huge.vtk": "# vtk DataFile Version 3.0\nx\nASCII\nDATASET STRUCTURED_GRID\nDIMENSIONS 99999 99999 9\n",
                "a.nc": b"CDF\1" + b"\xff" * 99, "b.nc": b"\x89HDF\r\n\x1a\n" + b"\xff" * 99, "a.mat": b"MATLAB 5.0 MAT-file" * 9,
                "a.hdf5": b"\x89HDF\r\n\x1a\n" + bytes(200), "a.xy": "1 2\nx y\n", "a.raw": "", "a.csv": "t,x,h\n1,2\n",
                "b.csv": bytes(range(256)), "c.csv": "t,x,h\nnan,0,1\n", "d.csv": "", "a.npz": b"PK\3\4", "b.dat": "x\n" * 9,
        }.items():
            path = self.write(content, name)
            with self.subTest(name):
                made = self.adapt("surface", path, "--field", "h", "--step", 1)
                # Without the library that reads the format, it is the library that is named.
                missing = "needs the Python package" in made.stderr
                self.refuses(made, "needs the Python package" if missing else name)
                if missing:
                    self.assertRegex(made.stderr, r"package (vtk|meshio|xarray|netCDF4|scipy\S*): apt install python3-")

    def test_limits_of_a_batch_system_stay(self):
        command = ["prlimit", "--cpu=10", sys.executable, "-m", "seiche.adapt", "front", WRITTEN / "gerris/floor.txt",
                   "--field", "T"]
        made = subprocess.run(command, capture_output=True, text=True, env={**os.environ, "PYTHONPATH": PACKAGE})
        self.assertEqual((made.returncode, made.stderr), (0, ""))

    def test_a_link_out_of_particles_is_not_followed(self):
        self.hdf5("secret.h5", x=np.arange(3.0))
        with h5py.File(self.folder / "a.hdf5", "w") as file:
            file.create_group("solver_data").attrs["t"] = 0.5
            file["particles/fluid/arrays/y"] = np.zeros(3)
            file["particles/fluid/arrays/x"] = h5py.ExternalLink(str(self.folder / "secret.h5"), "/x")
        self.refuses(self.adapt("front", self.folder / "a.hdf5", "--near", 1), "x is a link")

    ADCIRC = ("run  id  grid\n 2  {}  60.0  30  1\n 30.0  30\n 1  0.25\n 2  -99999.0\n 60.0  60\n 1  0.5E+00\n 2  0.125\n")

    def test_series_of_gauges_that_a_solver_wrote(self):
        self.hdf5("thetis.hdf5", time=np.array([[60.0], [30.0]]), wall=np.array([[0.5], [0.25]]),
                  shoal=np.array([[0.125, 3], [-0.125, 4]]), comment=np.arange(3.0))
        for file, names, rows in (
                ("thetis.hdf5", ["t [s]", "shoal_0 [m]", "shoal_1 [m]", "wall [m]"], [[30, -0.125, 4, 0.25], [60, 0.125, 3, 0.5]]),
                (self.write(self.ADCIRC.format(2), "fort.61").name, ["t [s]", "1 [m]", "2 [m]"], [[30, 0.25, np.nan], [60, 0.5, 0.125]])):
            found, values = self.rows("series", self.folder / file)
            self.assertEqual(found, names)
            np.testing.assert_array_equal(values, rows)
        for file, content in (("a.61", self.ADCIRC.format(3)), ("b.61", "run\n"), ("c.61", self.ADCIRC.format(2).replace("0.25", "x")),
                              ("d.61", self.ADCIRC.format(0)), ("e.hdf5", b"\x89HDF"), ("f.csv", "t,1\n0,1\n")):
            self.refuses(self.adapt("series", self.write(content, file)), file)
        self.hdf5("g.h5", wall=np.arange(3.0))
        self.refuses(self.adapt("series", self.folder / "g.h5"), "no time: there are wall")
        self.hdf5("h.h5", time=np.array([0, np.nan]), wall=np.arange(2.0))
        self.refuses(self.adapt("series", self.folder / "h.h5"), "finite numbers")
        self.refuses(self.adapt("series", self.folder / "g.h5", self.folder / "g.h5"), "one file")

    def test_series_are_scored_by_the_numbers_of_gauges(self):
        _, rows = rows_of(printed("score", "island_gauges", "--template", "--table", "gauges"))
        times = np.unique([float(row[1]) for row in rows])
        records = "".join(f"{t} 1\n1 {0.01 * np.sin(t)}\n2 {0.02 * np.sin(t)}\n" for t in times)
        made = self.adapt("series", self.write(f"run\n{len(times)} 2 0.1 1 1\n{records}", "fort.61"))
        scored = self.score("island_gauges", "--data", self.write(made.stdout), "--gauges", "1=6,2=9")
        self.assertIn("2 of 8 given, without gauge = 1, 2, 3, 4, 16, 22", scored.stdout, scored.stderr)

    def test_what_is_missing_is_named(self):
        self.refuses(self.adapt("front", self.folder / "nothing.vtu"), "is not there")
        self.refuses(self.adapt("front", self.write("t,x,h\n0,0,1\n"), "--field", "eta"), "no field eta", "h")
        self.refuses(self.adapt("gauge", self.folder / "mine.csv", "--field", "h"), "--at x=NUMBER")
        self.refuses(self.adapt("gauge", self.folder / "mine.csv", "--field", "h", "--at", "x=7"), "x=7", "not known")
        for header in ("s,x,h", "t,s,h"):
            self.refuses(self.adapt("front", self.write(f"{header}\n0,0,1\n"), "--field", "h"),
                         "needs columns t and x", header.replace(",", ", "))
        with unittest.mock.patch.dict(sys.modules, xarray=None):
            self.refuses(self.adapt("front", self.write("", "run.nc")), "needs the Python package xarray",
                         "apt install python3-xarray")

    @unittest.skipUnless(has("vtk"), "python3-vtk9 is not installed")
    def test_vtk_contour_of_a_fraction(self):
        import vtk
        from vtk.util.numpy_support import numpy_to_vtk
        grid = vtk.vtkImageData()
        grid.SetDimensions(11, 21, 2)
        grid.SetSpacing(0.1, 0.05, 1)
        x, y = (np.arange(10) + 0.5) * 0.1, (np.arange(20) + 0.5) * 0.05
        eta = 0.5 + 0.1 * x
        share = 0.5 + eta[None, :] - y[:, None]  # linear: lines between centres meet the surface exactly
        values = numpy_to_vtk(share.ravel(), deep=True)
        values.SetName("alpha.water")
        grid.GetCellData().AddArray(values)
        writer = vtk.vtkXMLImageDataWriter()
        writer.SetFileName(str(self.folder / "run.vti"))
        writer.SetInputData(grid)
        writer.Write()
        words = ("surface", self.folder / "run.vti", "--field", "alpha.water")
        self.refuses(self.adapt(*words), "does not say its time", "--step")
        _, surface = self.rows(*words, "--step", 1)
        np.testing.assert_allclose(surface[:, 1:], np.column_stack([x, eta]), atol=1e-9)

    @unittest.skipUnless(has("xarray") and has("netCDF4"), "python3-xarray or python3-netcdf4 is not installed")
    def test_netcdf_gauge(self):
        import xarray
        x, t = np.linspace(0, 1, 11), np.array([0.0, 0.5])
        eta = np.add.outer(t, 2 * x)
        xarray.Dataset({"eta": (("time", "x"), eta)}, coords={"x": x, "time": t}).to_netcdf(self.folder / "run.nc")
        _, gauge = self.rows("gauge", self.folder / "run.nc", "--field", "eta", "--at", "x=0.25")
        np.testing.assert_allclose(gauge, [[0.25, 0, 0.5], [0.25, 0.5, 1.0]])
        self.refuses(self.adapt("gauge", self.folder / "run.nc", "--at", "x=0.25"), "needs --field: there are eta")
        self.netcdf("alone.nc", eta=("other", t), x=("x", x))
        self.refuses(self.adapt("gauge", self.folder / "alone.nc", "--field", "eta", "--at", "x=0.25"), "no field at points")
        self.netcdf("late.nc", eta=(("time", "x"), eta), x=("x", x),
                    time=("time", 1577836800 + t, {"units": "seconds since 1970-01-01"}))
        _, gauge = self.rows("gauge", self.folder / "late.nc", "--field", "eta", "--at", "x=0.25")
        np.testing.assert_allclose(gauge, [[0.25, 0, 0.5], [0.25, 0.5, 1.0]])
        # As CF and UGRID say it: coordinates by their attributes, points of a mesh, and no value where it is dry.
        mesh = xarray.Variable((), 0, {"cf_role": "mesh_topology", "node_coordinates": "node_lon node_h"})
        dry = np.where(x > 0.7, np.nan, eta)
        xarray.Dataset({"mesh": mesh, "eta": (("time", "node"), dry), "node_lon": ("node", x), "node_h": ("node", 0 * x)},
                       coords={"time": t}).to_netcdf(self.folder / "mesh.nc", encoding={"eta": {"_FillValue": -9999.0}})
        _, gauge = self.rows("gauge", self.folder / "mesh.nc", "--field", "eta", "--at", "x=0.25")
        np.testing.assert_allclose(gauge, [[0.25, 0, 0.5], [0.25, 0.5, 1.0]])
        self.refuses(self.adapt("gauge", self.folder / "mesh.nc", "--field", "eta", "--at", "x=0.9"), "not known there")

    @unittest.skipUnless(has("xarray") and has("netCDF4") and has("scipy"), "a package of netCDF is not installed")
    def test_netcdf_over_a_plan(self):
        """As ANUGA, XBeach and Delft3D FM lay it out: points, curved axes, faces beside nodes, stations; units of the file."""
        import netCDF4
        (x, y), t = np.meshgrid(np.linspace(0, 10, 21), np.arange(3.0)), np.array([0.0, 0.5])
        eta = np.array([2 * x + 3 * y + one for one in t])
        with netCDF4.Dataset(self.folder / "a.sww", "w", format="NETCDF3_64BIT") as file:
            for name, size in (("points", x.size), ("times", t.size)):
                file.createDimension(name, size)
            for name, of, values in (("x", ("points",), x), ("y", ("points",), y), ("elevation", ("points",), 0 * x),
                                     ("time", ("times",), t), ("stage", ("times", "points"), eta)):
                file.createVariable(name, "f8", of)[:] = values.reshape([file.dimensions[one].size for one in of])
        self.netcdf("b.nc", zs=(("globaltime", "ny", "nx"), eta), globalx=(("ny", "nx"), x), globaly=(("ny", "nx"), y),
                    globaltime=("globaltime", t))
        faces = {"node_x": ("nodes", x[0]), "node_y": ("nodes", y[0]), "face_x": ("faces", x.ravel()),
                 "face_y": ("faces", y.ravel())}
        self.netcdf("c.nc", s1=(("time", "faces"), eta.reshape(2, -1)), **faces,
                    time=("time", t / 60, {"units": "minutes since 2001-01-01 00:00:00"}))
        self.netcdf("d.nc", level=(("time", "stations"), 100 * eta[:, 0, [5, 6]], {"units": "cm"}), time=("time", t),
                    station_x_coordinate=("stations", x[0, [5, 6]]), station_y_coordinate=("stations", y[0, [5, 6]]))
        for name, field, place in (("a.sww", "stage", (2.3, 0.5)), ("b.nc", "zs", (2.3, 0.5)), ("c.nc", "s1", (2.3, 0.5)),
                                   ("d.nc", "level", (2.5, 0))):
            with self.subTest(name):
                words = ("gauge", self.folder / name, "--field", field, "--at")
                names, gauge = self.rows(*words, f"x={place[0]},y={place[1]}")
                self.assertEqual(names, ["x [m]", "y [m]", "t [s]", "eta [m]"])
                wanted = 2 * place[0] + 3 * place[1]
                np.testing.assert_allclose(gauge, [[*place, 0, wanted], [*place, 0.5, wanted + 0.5]], atol=1e-12)
                self.refuses(self.adapt(*words, "x=2.3,y=77"), "not known there")
        self.refuses(self.adapt("gauge", self.folder / "b.nc", "--field", "zs", "--at", "x=2.3"), "x=NUMBER,y=NUMBER")
        # Times that xarray wrote as dates.
        self.netcdf("e.nc", eta=(("time", "x"), eta[:, 0]), x=("x", x[0]),
                    time=("time", np.datetime64("2001-01-01", "ns") + (t * 1e9).astype("timedelta64[ns]")))
        _, gauge = self.rows("gauge", self.folder / "e.nc", "--field", "eta", "--at", "x=2.5")
        np.testing.assert_allclose(gauge, [[2.5, 0, 5], [2.5, 0.5, 5.5]])

    def netcdf(self, name, **variables):
        import xarray
        xarray.Dataset(variables).to_netcdf(self.folder / name)


if __name__ == "__main__":
    unittest.main()
