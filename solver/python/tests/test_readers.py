"""Readers of what solvers write: distinct values in every column, each found at its own place.

vtk, meshio and xarray are stand-ins with what the readers ask of them: tests here run where they are not installed."""

import pathlib
import sys
import types

import h5py
import numpy
import pytest

from seiche import readers
from seiche.readers import Snapshot, Unusable

X, Y, H, V = (numpy.array(values) for values in ([1.0, 2, 4], [8.0, 16, 32], [0.5, 0.25, 0.125], [64.0, 128, 256]))


def same(snapshot, time, x, y=(0, 0, 0), /, **fields):
    assert snapshot.time == time
    for found, wanted in ((snapshot.x, x), (snapshot.y, y)):
        numpy.testing.assert_array_equal(found, wanted)
    assert snapshot.fields.keys() == fields.keys()
    for name, values in fields.items():
        numpy.testing.assert_array_equal(snapshot.fields[name], values)


def refused(words, call, *arguments, **options):
    with pytest.raises(Unusable, match=words):
        given = call(*arguments, **options)
        list(given)


# Points and names.

@pytest.mark.parametrize("text,number", [("0.5", 0.5), ("-2e3", -2000), ("inf", None), ("nan", None), ("0.orig", None),
                                         ("", None)])
def test_a_name_is_a_finite_number_or_none(text, number):
    assert readers.number_in(text) == number


def test_a_snapshot_has_as_many_finite_x_as_y():
    for x, y in (([], None), ([[1.0]], [[1.0]]), ([1.0, 2], [1.0]), (1.0, 1.0)):
        refused("no points, or not as many x as y", Snapshot, 0, x, y)
    for x, y in (([1, numpy.nan], [1.0, 2]), ([1.0, 2], [numpy.inf, 1])):
        refused("not a finite number", Snapshot, 0, x, y)
    assert [Snapshot(0, X, y, plan=plan).level for y, plan in ((None, False), (Y, False), (Y, True))] == [True, False, True]


def test_points_without_a_value_are_left_out():
    one = Snapshot(0, X, Y, {"h": [0.5, numpy.nan, -1e20], "short": [1.0, 2]})
    assert [list(values) for values in one.where_known("h")] == [[1], [8], [0.5]]
    assert [list(values) for values in Snapshot(0, [1.0], None, {"h": [9e19]}).where_known("h")] == [[1], [0], [9e19]]
    refused("field short has 2 values for 3 points", one.where_known, "short")
    refused("no field u: there are h, short", one.field, "u")
    refused("there are none", Snapshot(0, X).field, "u")


# Files of one kind each.

def test_a_set_of_openfoam_has_its_fields_in_its_name(tmp_path):
    folder = tmp_path / "0.75"
    folder.mkdir()
    file = folder / "line_alpha.water_p_rgh_p.xy"
    numpy.savetxt(file, numpy.column_stack([X, Y, H, V]))
    same(*readers.read_set(file), 0.75, X, **{"alpha.water": Y, "p_rgh": H, "p": V})
    assert list(readers.read_set(file.rename(folder / "line_U.xy"))) == []    # three components


def test_a_sampled_surface_has_a_header(tmp_path):
    file = tmp_path / "surface.raw"
    numpy.savetxt(file, numpy.column_stack([X, Y, 7 * X, H, V]), header="x y z alpha p")
    same(*readers.read_raw(file), None, X, Y, alpha=H, p=V)
    numpy.savetxt(file, numpy.column_stack([Y, X, H]), header="y x z")
    refused("needs a header '# x y z ...': there are y, x, z", readers.read_raw, file)


def test_rows_of_a_text_file_are_gathered_by_their_time(tmp_path):
    file = tmp_path / "rows.csv"
    file.write_text("Time,x,y,z,h,u\n2,1,8,9,0.5,64\n1,4,32,9,0.125,256\n2,2,16,9,0.25,128\n")
    two, one = readers.read_text(file)
    same(two, 2, X[:2], Y[:2], h=H[:2], u=V[:2])
    same(one, 1, X[2:], Y[2:], h=H[2:], u=V[2:])
    file.write_text("t,x,y,h\n2,1,8,0.5\n2,2,8,0.25\n")       # a floor, not a column
    same(*readers.read_text(file), 2, X[:2], [0, 0], h=H[:2])
    for header in ("s,x,h", "t,y,h"):
        file.write_text(f"{header}\n1,2,3\n")
        refused(f"needs columns t and x: there are {header.replace(',', ', ')}", readers.read_text, file)


def test_matlab_names_and_either_order_of_the_axes(tmp_path):
    io, file = pytest.importorskip("scipy.io"), tmp_path / "run.mat"
    field = numpy.outer([1, 10], X)
    for x, t in (("x", "t"), ("X", "T"), ("Xp", "time"), ("x", "Tsec")):
        io.savemat(file, {x: X, t: [5.0, 6.0], "rows": field, "columns": field.T, "other": Y})
        for k, one in enumerate(readers.read_matlab(file)):
            same(one, 5 + k, X, rows=field[k], columns=field[k])
    io.savemat(file, {"x": X, "t": 7.0, "h": field[:1]})
    same(*readers.read_matlab(file), 7, X)
    for wrong in ({"x": X, "h": X}, {"t": X, "h": X}, {"x": field, "t": X}):
        io.savemat(file, wrong)
        refused(f"needs vectors x and t: there are {', '.join(sorted(wrong))}", readers.read_matlab, file)


def particles(path, time=0.5, group="particles/fluid/arrays", **arrays):
    with h5py.File(path, "w") as file:
        file.create_group("solver_data").attrs["t"] = time
        for name, values in arrays.items():
            file[f"{group}/{name}"] = values


def test_particles_of_pysph(tmp_path):
    file = tmp_path / "a.hdf5"
    particles(file, x=X, y=Y, h=H, never=numpy.array([]))
    same(*readers.read_particles(file), 0.5, X, Y, x=X, y=Y, h=H)
    particles(file, x=X, y=Y, pair=numpy.ones((3, 2)))
    same(*readers.read_particles(file), 0.5, X, Y, x=X, y=Y)
    for wrong in ({"x": X, "h": H}, {"y": Y}, {"x": X, "y": Y, "h": H[:2]}, {"x": X[:0], "y": Y[:0]}, {"x": [X], "y": [Y]}):
        particles(file, **wrong)
        refused("needs x and y of the particles, as long as the other arrays", readers.read_particles, file)
    particles(file, group="particles/water/arrays", x=X)
    refused("no particles/fluid/arrays", readers.read_particles, file)
    refused("pickled objects", readers.read_particles, tmp_path / "a.npz")
    with h5py.File(file, "w") as made:
        made["elsewhere/arrays/x"] = X
        made["particles/fluid"] = h5py.SoftLink("/elsewhere")
    refused("no particles/fluid/arrays", readers.read_particles, file)


def test_arrays_of_hdf5_are_numbers_in_the_file(tmp_path, monkeypatch):
    with h5py.File(tmp_path / "a.h5", "w") as file:
        file["x"], file["words"] = X, b"abc"
        file["link"], file["group/inside"] = h5py.SoftLink("/x"), X
        file.create_dataset("outside", (3,), external=[("raw.bin", 0, 24)], dtype=float)
        layout = h5py.VirtualLayout((3,), float)
        layout[:] = h5py.VirtualSource("other.h5", "x", (3,))
        file.create_virtual_dataset("virtual", layout)
        numpy.testing.assert_array_equal(readers.numbers_of(file, "x", "a.h5"), X)
        refused("a.h5: link is a link", readers.numbers_of, file, "link", "a.h5")
        for name in ("words", "group", "outside", "virtual"):
            refused(f"a.h5: {name}: must be numbers in this file", readers.numbers_of, file, name, "a.h5")
        monkeypatch.setattr(readers, "MOST_NUMBERS", 3)
        assert len(readers.numbers_of(file, "x", "a.h5")) == 3
        monkeypatch.setattr(readers, "MOST_NUMBERS", 2)
        refused("at most 2", readers.numbers_of, file, "x", "a.h5")


class Grid:
    """A data set as vtk has them: points, and arrays of points or of cells."""

    def __init__(self, points, fields, time=None, cells=None):
        self.points, self.fields, self.time, self.cells = points, fields, time, cells

    def GetNumberOfPoints(self):
        return len(self.points)

    def GetFieldData(self):
        return types.SimpleNamespace(GetArray=lambda name: types.SimpleNamespace(GetValue=[self.time].__getitem__)
                                     if name == "TimeValue" and self.time is not None else None)

    def GetCellData(self):
        return types.SimpleNamespace(GetNumberOfArrays=lambda: len(self.cells.fields) if self.cells else 0)

    def GetPoints(self):
        return types.SimpleNamespace(GetData=lambda: self.points)

    def GetPointData(self):
        names = list(self.fields)
        return types.SimpleNamespace(GetNumberOfArrays=lambda: len(names), GetArrayName=names.__getitem__,
                                     GetArray=lambda k: self.fields[names[k]])


@pytest.fixture
def vtk(monkeypatch):
    """Readers by their names, which give the Grid of a file's name; and the centres of cells."""
    grids = {}

    class Filter:
        def __init__(self, kind=None):
            self.kind, self.output = kind, None

        def SetFileName(self, path):
            self.path = pathlib.Path(path)

        def SetInputData(self, grid):
            self.grid = grid

        def Update(self):
            self.output = self.grid.cells if self.kind is None else grids.get((self.kind, self.path.name))

        def GetOutput(self):
            return self.output

    names = {"XMLUnstructuredGrid": ".vtu", "XMLPolyData": ".vtp", "DataSet": ".vtk", "XMLStructuredGrid": ".vts",
             "XMLImageData": ".vti"}
    silent = types.SimpleNamespace(GlobalWarningDisplayOff=lambda: None)
    module = types.SimpleNamespace(vtkObject=silent, vtkCellCenters=Filter, **{
        f"vtk{name}Reader": lambda kind=kind: Filter(kind) for name, kind in names.items()})
    for name, made in (("vtk", module), ("vtk.util", module),
                       ("vtk.util.numpy_support", types.SimpleNamespace(vtk_to_numpy=numpy.asarray))):
        monkeypatch.setitem(sys.modules, name, made)
    return grids


POINTS = numpy.column_stack([X, Y, 7 * X])


@pytest.mark.parametrize("kind", [".vtu", ".vtp", ".vtk", ".vts", ".vti"])
def test_points_and_cells_of_vtk(vtk, tmp_path, kind):
    file = tmp_path / f"a{kind}"
    refused("is not there", readers.read_vtk, file)
    file.touch()
    refused("holds no points", readers.read_vtk, file)
    vtk[kind, file.name] = Grid(POINTS[:0], {})
    refused("holds no points", readers.read_vtk, file)
    vtk[kind, file.name] = Grid(POINTS, {"h": H, "U": POINTS, "p": V}, 0.75)
    same(*readers.read_vtk(file), 0.75, X, Y, h=H, p=V)
    vtk[kind, file.name] = Grid(POINTS, {"h": H}, cells=Grid(2 * POINTS, {"p": V}))
    same(*readers.read_vtk(file), None, 2 * X, 2 * Y, p=V)


def test_a_collection_of_vtk_gives_the_times_of_its_parts(vtk, tmp_path, monkeypatch):
    (tmp_path / "parts").mkdir()
    for k, name in enumerate(("a.vtu", "b.vtu")):
        (tmp_path / "parts" / name).touch()
        vtk[".vtu", name] = Grid((1 + k) * POINTS, {"h": H}, 77.0)
    file = tmp_path / "run.pvd"
    entry = '<DataSet timestep="{}" part="0" file="{}"/>'.format
    file.write_text(f'<VTKFile>{entry(0.5, "parts/b.vtu")}<DataSet part="0"/>{entry(1.5, "parts/a.vtu")}</VTKFile>')
    first, second = readers.read_vtk(file)
    same(first, 0.5, 2 * X, 2 * Y, h=H)
    same(second, 1.5, X, Y, h=H)
    for wrong in (entry(0, "../a.vtu"), entry(0, "run.pvd"), entry(0, "run.csv"), entry(0, tmp_path.parent / "a.vtu")):
        file.write_text(wrong)
        refused("below the collection's own folder", readers.read_vtk, file)
    file.write_text(2 * entry(0, "parts/a.vtu"))
    monkeypatch.setattr(readers, "MOST_FILES", 2)
    assert len(list(readers.read_vtk(file))) == 2
    monkeypatch.setattr(readers, "MOST_FILES", 1)
    for wrong in (2 * entry(0, "parts/a.vtu"), "", entry("x", "parts/a.vtu")):
        file.write_text(wrong)
        refused("needs 1 to 1 DataSets", readers.read_vtk, file)


def test_without_vtk_meshio_reads_points_and_centres_of_cells(tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "vtk", None)
    monkeypatch.setitem(sys.modules, "meshio", None)
    for kind, words in ((".vtu", "package meshio: apt install python3-vtk9, or python3-meshio"), (".vtp", "package vtk")):
        file = tmp_path / f"a{kind}"
        file.touch()
        refused(words, readers.read_vtk, file)
    mesh = types.SimpleNamespace(points=POINTS, cell_data={}, point_data={"h": H, "U": POINTS})
    monkeypatch.setitem(sys.modules, "meshio", types.SimpleNamespace(read=lambda path: mesh))
    for kind in (".vtk", ".vtu"):
        (tmp_path / f"a{kind}").touch()
        same(*readers.read_vtk(tmp_path / f"a{kind}"), None, X, Y, h=H)
    mesh.cells = [types.SimpleNamespace(data=numpy.array(corners)) for corners in ([[0, 1], [1, 2]], [[0, 1, 2]])]
    mesh.cell_data = {"p": [V[:2], V[2:]]}
    same(*readers.read_vtk(tmp_path / "a.vtu"), None, [1.5, 3, 7 / 3], [12, 24, 56 / 3], p=V)


class Variable:
    """Of a netCDF file, as xarray has them."""

    def __init__(self, dims, values, **attrs):
        self.dims, self.values, self.attrs = tuple(dims.split()), numpy.asarray(values), attrs
        self.dtype, self.ndim, self.size, self.shape = (getattr(self.values,
                                                                name) for name in ("dtype", "ndim", "size", "shape"))

    def transpose(self, _, *last):
        first = [name for name in self.dims if name not in last]
        return Variable(" ".join([*first, *last]), self.values.transpose([self.dims.index(name) for name in [*first, *last]]),
                        **self.attrs)

    def isel(self, places):
        kept = [name for name in self.dims if name not in places]
        return Variable(" ".join(kept), self.values[tuple(places.get(name, slice(None)) for name in self.dims)], **self.attrs)

    def ravel(self):
        return self.values.ravel()


@pytest.fixture
def netcdf(monkeypatch):
    """Reads a file of these variables."""
    class Dataset(dict):
        variables = property(lambda self: self)
        data_vars = property(lambda self: {name: one for name, one in self.items() if name != one.dims[0]})
        __enter__, __exit__ = (lambda self: self), (lambda self, *_: None)

    def read(**variables):
        def open_dataset(path, decode_times):
            assert not decode_times
            return Dataset(variables)
        monkeypatch.setitem(sys.modules, "xarray", types.SimpleNamespace(open_dataset=open_dataset))
        return list(readers.read_netcdf(pathlib.Path("run.nc")))
    return read


ETA = numpy.outer([1.0, 10], X)
UNITS = {"m": 1, "metres": 1, "s": 1, "cm": 0.01, "mm": 1e-3, "km": 1000, "ft": 0.3048, "feet": 0.3048, "ms": 1e-3, "us": 1e-6,
         "ns": 1e-9, "min": 60, "minutes since 2001-01-01": 60, "h": 3600, "hours": 3600, "days since 1970-01-01": 86400,
         "d": 86400, "furlong": 1, "": 1}


@pytest.mark.parametrize("unit", UNITS)
def test_units_of_netcdf(unit):
    numpy.testing.assert_array_equal(readers.in_si(Variable("x", X, units=unit)), UNITS[unit] * X)


@pytest.mark.parametrize("axis,name,attributes,values,wanted", [
    *((axis, name, {}, X, axis == "xy"[k // 6]) for axis in "xy" for k, name in enumerate((
        "x", "X", "globalx", "station_x_coordinate", "mesh2d_face_x", "lon", "y", "Y", "globaly", "station_y_coordinate",
        "node_y",
        "lat"))),
    ("x", "east", {"axis": "X"}, X, True), ("y", "east", {"axis": "X"}, X, False), ("y", "north", {"axis": "Y"}, X, True),
    ("x", "a", {"standard_name": "projection_x_coordinate"}, X, True), ("y", "a", {"standard_name": "latitude"}, X, True),
    ("x", "a", {"standard_name": "latitude"}, X, False), ("x", "xx", {}, X, False), ("x", "x", {}, numpy.array(["a"]), False),
    ("x", "x", {}, numpy.array(1.0), False), ("x", "x", {}, ETA, True), ("x", "x", {}, ETA[None], False)])
def test_coordinates_of_netcdf(axis, name, attributes, values, wanted):
    one = types.SimpleNamespace(attrs=attributes, dtype=values.dtype, ndim=values.ndim)
    assert readers.is_coordinate(name, one, axis) == wanted


@pytest.mark.parametrize("time", ["t", "time", "Time", "globaltime"])
def test_netcdf_along_one_axis(netcdf, time):
    first, second = netcdf(x=Variable("x", 100 * X, units="cm"), eta=Variable("x t", 1000 * ETA.T, units="mm"),
                           bed=Variable("x", V), other=Variable("n", [1.0]), words=Variable("x", ["a", "b", "c"]),
                           **{time: Variable("t", [1.0, 2], units="minutes since 2001-01-01")})
    same(first, 60, X, eta=ETA[0], bed=V)
    same(second, 120, X, eta=ETA[1], bed=V)
    assert first.level


def test_netcdf_at_points_on_two_axes_and_on_curved_ones(netcdf):
    points = {"x": Variable("n", X), "y": Variable("n", Y), "time": Variable("t", [1.0, 2])}
    for k, one in enumerate(netcdf(**points, h=Variable("t n", ETA))):
        same(one, 1 + k, X, Y, h=ETA[k])
    x, y = numpy.meshgrid(X, Y[:2])
    field = 10 * x + y
    alone = {"x": Variable("x", X), "y": Variable("y", Y[:2])}
    for values in (Variable("y x", field), Variable("x y", field.T)):
        same(*netcdf(**alone, h=values), None, x.ravel(), y.ravel(), h=field.ravel())
    same(*netcdf(lon=Variable("a b", x), lat=Variable("a b", y), h=Variable("a b", field)), None, x.ravel(), y.ravel(),
         h=field.ravel())
    same(*netcdf(y=Variable("n", X, axis="X"), b=Variable("m", Y), h=Variable("n", H)), None, X, h=H)     # an x that is called y
    # Nodes beside faces: each field at its own.
    nodes, faces = netcdf(node_x=Variable("n", X), node_y=Variable("n", Y), face_x=Variable("f", V[:2]),
                          face_y=Variable("f", H[:2]),
                          h=Variable("n", 3 * X), u=Variable("f", 5 * H[:2]))
    same(nodes, None, X, Y, h=3 * X)
    same(faces, None, V[:2], H[:2], u=5 * H[:2])
    assert nodes.level


def test_what_netcdf_lacks_is_said(netcdf, monkeypatch):
    for wrong in ({"x": Variable("x", X), "h": Variable("n", Y)}, {"h": Variable("n", Y)}):
        with pytest.raises(Unusable, match=f"no field at points with a coordinate x: there are {', '.join(wrong)}"):
            netcdf(**wrong)
    monkeypatch.setattr(readers, "MOST_NUMBERS", 3)
    assert netcdf(x=Variable("x", X), h=Variable("n x", [Y])) == []
    with pytest.raises(Unusable, match="more than 3 numbers"):
        netcdf(x=Variable("x", X), h=Variable("n x", ETA))


# Folders, times, and series.

def text(folder, name, time, value=0.5):
    folder.mkdir(exist_ok=True, parents=True)
    (folder / name).write_text(f"t,x,h\n{time},1,{value}\n")


def test_a_folder_is_read_by_its_times_or_by_its_commonest_kind(tmp_path):
    for name in ("10", "9", "0.5", "constant"):
        text(tmp_path / "run" / name, "a.csv", 1)
    assert [path.parent.name for path in readers.files_of([tmp_path / "run"])] == ["0.5", "9", "10"]
    for name in ("a.csv", "b.csv", "c.xy", "d.log"):
        text(tmp_path / "flat", name, 1)
    assert [path.name for path in readers.files_of([tmp_path / "flat", tmp_path / "flat/c.xy"])] == ["a.csv", "b.csv", "c.xy"]
    refused("nowhere: is not there", readers.files_of, [tmp_path / "nowhere"])
    (tmp_path / "empty").mkdir()
    refused("empty: nothing to read", readers.read, [tmp_path / "empty"])


def test_snapshots_come_in_the_order_of_their_times(tmp_path):
    text(tmp_path, "a.csv", 3, 30)
    text(tmp_path, "b.csv", 2, 20)
    assert [(one.time, one.fields["h"][0]) for one in readers.read([tmp_path])] == [(2, 20), (3, 30)]
    assert [(one.time, one.fields["h"][0]) for one in readers.read([tmp_path], step=0.5)] == [(0, 30), (0.5, 20)]
    (tmp_path / "b.csv").write_text("t,x,u\n2,1,7\n")
    assert [one.time for one in readers.read([tmp_path], field="u")] == [2]
    assert [one.time for one in readers.read([tmp_path], field="p")] == [2, 3]
    (tmp_path / "c.raw").write_text("# x y z h\n1 2 3 4\n")
    refused("does not say its time: say how far the files are apart by --step", readers.read, [tmp_path / "c.raw"])


@pytest.mark.parametrize("first,counts", [(0, 0), (366 * 86400, 366 * 86400), (366 * 86400 + 1, 0), (-366 * 86400 - 1, 0)])
def test_times_of_more_than_a_year_count_from_the_first(tmp_path, first, counts):
    for k in range(2):
        text(tmp_path, f"{k}.csv", first + k)
    assert [one.time for one in readers.read([tmp_path])] == [counts, counts + 1]


def test_what_a_library_says_against_a_file_is_one_line():
    def says(error):
        def reader(path):
            raise error
        return reader
    path = pathlib.Path("a.xy")
    for error, words in ((Unusable("a.xy: bad"), "^a.xy: bad$"), (Unusable("bad"), "^a.xy: bad$"),
                         (OSError("no\n way"), "^a.xy: cannot be read: no way$"),
                         (ValueError(), "^a.xy: cannot be read: ValueError$"),
                         (SystemExit("x" * 300), f"^a.xy: cannot be read: {200 * 'x'}$"),
                         (OSError("a.xy: gone"), "^a.xy: cannot be read: gone$")):
        refused(words, readers.guarded, path, {".xy": says(error)})
    refused(r"files \*.xy are not known: only .csv, .vtu", readers.guarded, path, {".vtu": 1, ".csv": 2})


def test_series_of_two_solvers(tmp_path):
    with h5py.File(tmp_path / "a.h5", "w") as file:
        file["time"], file["wall"] = [2.0, 1, 3], 10 * X
        file["pair"], file["short"] = numpy.column_stack([Y, V]), [1.0]
    times, levels = readers.read_series(tmp_path / "a.h5")
    numpy.testing.assert_array_equal(times, [1, 2, 3])
    assert {name: list(values) for name, values in levels.items()} == {
        "wall": [20, 10, 40], "pair_0": [16, 8, 32], "pair_1": [128, 64, 256]}
    file = tmp_path / "fort.61"
    file.write_text("run\n9 2 60 30 1\n 30.0 30\n1 0.25\n2 -99999\n 60.0 60\n1 0.5\n2 -99998\n")
    times, levels = readers.read_series(file)
    numpy.testing.assert_array_equal(times, [30, 60])
    numpy.testing.assert_array_equal(levels["1"], [0.25, 0.5])
    numpy.testing.assert_array_equal(levels["2"], [numpy.nan, -99998])
    for wrong in ("run\n9 2 60 30 1\n30 1\n2 0.25\n1 0.5\n", "run\n9 0\n30 1\n", "run\n9 -1\n30 1\n", "run\n"):
        file.write_text(wrong)
        refused("fort.61", readers.read_series, file)
    for time, wall in (([1, numpy.inf], [1.0, 2]), ([1.0, 2], [1.0])):
        with h5py.File(tmp_path / "a.h5", "w") as made:
            made["time"], made["wall"] = numpy.array(time, float), numpy.array(wall, float)
        refused("times that are finite numbers, and a gauge", readers.read_series, tmp_path / "a.h5")
