"""Readers of what solvers write: a path gives snapshots (points with fields at a time), or the series of gauges by name.

Which kinds: READERS and SERIES below, and the text of seiche.adapt, whose command calls this in a process of its own.
"""
import collections
import pathlib
import re

import numpy as np

MOST_NUMBERS = 50_000_000   # of one array
MOST_FILES = 100_000        # of a collection


class Unusable(Exception):
    """What is wrong, in one line."""


class Snapshot:
    """Points and fields at one time; y is the vertical, or 0 where there is none, or over a plan the other axis. A value
    may be NaN: there is none."""

    def __init__(self, time, x, y=None, fields=None, plan=False):
        self.level = plan or y is None  # the points do not tell where the surface is
        self.time = time
        self.x = np.asarray(x, float)
        self.y = np.zeros_like(self.x) if y is None else np.asarray(y, float)
        self.fields = {name: np.asarray(values, float) for name, values in (fields or {}).items()}
        if self.x.ndim != 1 or self.x.size == 0 or self.y.shape != self.x.shape:
            raise Unusable("there are no points, or not as many x as y")
        if not (np.isfinite(self.x).all() and np.isfinite(self.y).all()):
            raise Unusable("a position is not a finite number")

    def where_known(self, name):
        """The points at which a field has a value, with it."""
        values = self.field(name)
        if values.shape != self.x.shape:
            raise Unusable(f"field {name} has {values.size} values for {self.x.size} points")
        known = np.isfinite(values) & (np.abs(values) < 1e20)
        return self.x[known], self.y[known], values[known]

    def field(self, name):
        if name not in self.fields:
            raise Unusable(f"there is no field {name}: there are {', '.join(sorted(self.fields)) or 'none'}")
        return self.fields[name]


def package(module, debian):
    """An optional package, or one line that says how to get it."""
    try:
        return __import__(module, fromlist=["_"])
    except ImportError:
        raise Unusable(f"this file needs the Python package {module}: apt install {debian}") from None


def number_in(text):
    """The finite number that a name is, or None."""
    try:
        number = float(text)
    except ValueError:
        return None
    return number if np.isfinite(number) else None


# Readers: a path gives snapshots.

def read_vtk(path):
    if path.suffix == ".pvd":
        entries = [(re.search(r'\btimestep="([^"]*)"', tag), re.search(r'\bfile="([^"]*)"', tag))
                   for tag in re.findall(r"<DataSet\b[^>]*>", path.read_text(errors="replace"))]
        entries = [(number_in(time[1]), name[1]) for time, name in entries if time and name]
        if not 0 < len(entries) <= MOST_FILES or any(time is None for time, _ in entries):
            raise Unusable(f"{path}: needs 1 to {MOST_FILES} DataSets, each with a number for timestep and a file")
        for time, name in entries:
            part = (path.parent / name).resolve()
            if path.parent.resolve() not in part.parents or part.suffix not in VTK or part.suffix == ".pvd":
                raise Unusable(f"{path}: names {name!r}: must be a VTK file below the collection's own folder")
            for snapshot in read_vtk(part):
                snapshot.time = time
                yield snapshot
        return
    if not path.is_file():
        raise Unusable(f"{path}: is not there")
    try:
        vtk = package("vtk", "python3-vtk9")
    except Unusable:
        yield from read_mesh(path)
        return
    from vtk.util.numpy_support import vtk_to_numpy
    vtk.vtkObject.GlobalWarningDisplayOff()
    kinds = {".vtu": vtk.vtkXMLUnstructuredGridReader, ".vtp": vtk.vtkXMLPolyDataReader,
             ".vtk": vtk.vtkDataSetReader, ".vts": vtk.vtkXMLStructuredGridReader, ".vti": vtk.vtkXMLImageDataReader}
    reader = kinds[path.suffix]()
    reader.SetFileName(str(path))
    reader.Update()
    data = reader.GetOutput()
    if data is None or data.GetNumberOfPoints() == 0:
        raise Unusable(f"{path}: holds no points, or cannot be read")
    times = data.GetFieldData().GetArray("TimeValue")
    time = None if times is None else times.GetValue(0)
    if data.GetCellData().GetNumberOfArrays() > 0:
        centres = vtk.vtkCellCenters()
        centres.SetInputData(data)
        centres.Update()
        data = centres.GetOutput()
    points = vtk_to_numpy(data.GetPoints().GetData())
    arrays = data.GetPointData()
    fields = {arrays.GetArrayName(k): vtk_to_numpy(arrays.GetArray(k)) for k in range(arrays.GetNumberOfArrays())}
    yield Snapshot(time, points[:, 0], points[:, 1], {n: v for n, v in fields.items() if v.ndim == 1})


def read_mesh(path):
    if path.suffix not in (".vtk", ".vtu"):
        raise Unusable(f"{path}: needs the Python package vtk: apt install python3-vtk9")
    mesh = package("meshio", "python3-vtk9, or python3-meshio").read(path)
    if mesh.cell_data:
        centres = np.concatenate([mesh.points[block.data].mean(axis=1) for block in mesh.cells])
        fields = {name: np.concatenate(values) for name, values in mesh.cell_data.items()}
    else:
        centres, fields = mesh.points, mesh.point_data
    yield Snapshot(None, centres[:, 0], centres[:, 1], {n: v for n, v in fields.items() if np.ndim(v) == 1})


UNITS = {**dict.fromkeys(("m", "meter", "metre", "meters", "metres", "s", "sec", "second", "seconds"), 1),
         **dict.fromkeys(("cm", "centimeter", "centimetre", "centimeters", "centimetres"), 0.01), "km": 1000, "ft": 0.3048,
         **dict.fromkeys(("mm", "millimeter", "millimetre", "ms", "millisecond", "milliseconds"), 0.001), "feet": 0.3048,
         **dict.fromkeys(("us", "microsecond", "microseconds"), 1e-6), **dict.fromkeys(("ns", "nanoseconds"), 1e-9),
         **dict.fromkeys(("min", "minute", "minutes"), 60), **dict.fromkeys(("h", "hr", "hour", "hours"), 3600),
         **dict.fromkeys(("d", "day", "days"), 86400)}


def in_si(values):
    """Numbers of a CF variable in metres or seconds; others, and those without a unit, as they are."""
    unit = str(values.attrs.get("units", "")).partition(" since ")[0].strip()
    return values.values * UNITS[unit] if UNITS.get(unit, 1) != 1 else values.values


def is_coordinate(name, values, axis):
    """By its attributes as CF says them, or by what it is called: x, globalx, station_x_coordinate, mesh2d_face_x."""
    standard = {"x": ("projection_x_coordinate", "longitude"), "y": ("projection_y_coordinate", "latitude")}[axis]
    named = re.fullmatch(rf"(global|.*_)?({axis}|{'lon' if axis == 'x' else 'lat'})(_coordinate)?", str(name), re.IGNORECASE)
    return (values.attrs.get("axis") == axis.upper() or values.attrs.get("standard_name") in standard
            or named is not None) and values.dtype.kind in "fiu" and values.ndim in (1, 2)


def read_netcdf(path):
    """Snapshots for every set of points that has fields: nodes, faces, stations, or the crossings of two axes."""
    xarray = package("xarray", "python3-xarray python3-netcdf4")
    with xarray.open_dataset(path, decode_times=False) as data:
        if max((values.size for values in data.variables.values()), default=0) > MOST_NUMBERS:
            raise Unusable(f"{path}: a variable of more than {MOST_NUMBERS} numbers")
        t_name = next((name for name in ("t", "time", "Time", "globaltime") if name in data.variables), None)
        t_dims = data[t_name].dims if t_name else ()
        times = np.atleast_1d(in_si(data[t_name])) if t_name else np.array([np.nan])
        xs, ys = ([name for name, values in data.variables.items() if is_coordinate(name, values, axis)] for axis in "xy")
        ys = [name for name in ys if name not in xs]
        sets = {}
        for name in xs:
            # A coordinate y of the same points; where there is none, one along an axis of its own.
            along = next((y for y in ys if data[y].dims == data[name].dims), None)
            across = next((y for y in ys if data[name].ndim == data[y].ndim == 1), None)
            sets.setdefault(data[name].dims, (name, along))
            if along is None and across is not None:
                sets.setdefault((*data[across].dims, *data[name].dims), (name, across))
        for places, (x_name, y_name) in sets.items():
            names = [name for name, values in data.variables.items() if name not in xs and name not in ys
                     and name != t_name and values.dtype.kind in "fiu" and set(values.dims) - set(t_dims) == set(places)]
            x, y = in_si(data[x_name]), None if y_name is None else in_si(data[y_name])
            if len(places) == 2 and x.ndim == 1:
                x, y = np.meshgrid(x, y)
            for k, time in enumerate(times if names else ()):
                fields = {}
                for name in names:
                    values = data[name].transpose(..., *places)
                    fields[str(name)] = in_si(values.isel({d: k for d in t_dims if d in values.dims})).ravel()
                yield Snapshot(None if np.isnan(time) else float(time), x.ravel(), None if y is None else y.ravel(), fields, plan=True)
        if not any(set(places) <= set(values.dims) for places in sets for values in data.data_vars.values()):
            raise Unusable(f"{path}: no field at points with a coordinate x: there are {', '.join(map(str, data.variables))}")


def read_matlab(path):
    arrays = package("scipy.io", "python3-scipy").loadmat(path, squeeze_me=True)
    names = {name: np.asarray(values) for name, values in arrays.items() if not name.startswith("__")}
    x = next((names[name] for name in ("x", "X", "Xp") if name in names and names[name].ndim == 1), None)
    t = next((np.atleast_1d(names[name]) for name in ("t", "T", "time", "Tsec") if name in names), None)
    if x is None or t is None:
        raise Unusable(f"{path}: needs vectors x and t: there are {', '.join(sorted(names))}")
    for k, time in enumerate(t):
        fields = {}
        for name, values in names.items():
            if values.shape == (t.size, x.size):
                fields[name] = values[k]
            elif values.shape == (x.size, t.size):
                fields[name] = values[:, k]
        yield Snapshot(float(time), x, None, fields)


def numbers_of(group, name, path):
    """An array of an HDF5 group; what would reach outside of the file is refused."""
    if not isinstance(group.get(name, getlink=True), package("h5py", "python3-h5py").HardLink):
        raise Unusable(f"{path}: {name} is a link, must be in this file")
    values = group[name]
    if (not hasattr(values, "dtype") or values.external or values.is_virtual or values.size > MOST_NUMBERS
            or values.dtype.kind not in "fiu"):
        raise Unusable(f"{path}: {name}: must be numbers in this file, at most {MOST_NUMBERS}")
    return values[:]


def read_particles(path):
    if path.suffix == ".npz":
        raise Unusable(f"{path}: PySPH's .npz hold pickled objects, which run commands of whoever wrote them when they are "
                       "read: with h5py installed PySPH writes .hdf5")
    h5py = package("h5py", "python3-h5py")
    with h5py.File(path) as file:
        group = "particles/fluid/arrays"
        linked = [name for name in ("particles", "particles/fluid", group)
                  if name in file and not isinstance(file.get(name, getlink=True), h5py.HardLink)]
        if group not in file or linked:
            raise Unusable(f"{path}: no particles/fluid/arrays: is not of PySPH, or its fluid has another name")
        time = float(file["solver_data"].attrs["t"])
        fields = {}
        for name in file[group]:
            values = numbers_of(file[group], name, path)
            if values.size:     # PySPH writes what it never filled as an array of none
                fields[name] = values
    flat = {name: values for name, values in fields.items() if np.ndim(values) == 1}
    if not {"x", "y"} <= set(flat) or len({values.size for values in flat.values()}) != 1:
        raise Unusable(f"{path}: needs x and y of the particles, as long as the other arrays")
    yield Snapshot(time, flat["x"], flat["y"], flat)


def table_of(path):
    """Columns of a text file by name, as `seiche score` reads it."""
    from seiche import read_table
    return read_table(path)


def read_set(path):
    fields = path.stem.replace("p_rgh", "p\0rgh").split("_")[1:]
    table = np.loadtxt(path, ndmin=2)
    if table.shape[1] != 1 + len(fields):
        return  # vectors, or three coordinates
    yield Snapshot(number_in(path.parent.name), table[:, 0], None,
                   {name.replace("\0", "_"): table[:, k + 1] for k, name in enumerate(fields)})


def read_raw(path):
    """A sampled surface: its points, and a field at them."""
    table = table_of(path)
    if list(table)[:3] != ["x", "y", "z"]:
        raise Unusable(f"{path}: needs a header '# x y z ...': there are {', '.join(table)}")
    yield Snapshot(number_in(path.parent.name), table["x"], table["y"], dict(list(table.items())[3:]))


def read_text(path):
    """Rows with a time in each, in the order in which the times come."""
    table = {"t" if name.lower() == "time" else name: values for name, values in table_of(path).items()}
    if "t" not in table or "x" not in table:
        raise Unusable(f"{path}: needs columns t and x: there are {', '.join(table)}")
    # Gerris' locations have the floor's y: a row of points, not a column.
    for time in dict.fromkeys(table["t"]):
        rows = table["t"] == time
        yield Snapshot(time, table["x"][rows], table["y"][rows] if "y" in table and np.ptp(table["y"]) > 0 else None,
                       {name: values[rows] for name, values in table.items() if name not in ("t", "x", "y", "z")})


VTK = (".vtu", ".vtp", ".vtk", ".vts", ".vti", ".pvd")
READERS = {**dict.fromkeys(VTK, read_vtk), **dict.fromkeys((".nc", ".nc4", ".sww"), read_netcdf),
           ".mat": read_matlab, ".hdf5": read_particles, ".npz": read_particles, ".xy": read_set, ".raw": read_raw,
           ".csv": read_text, ".txt": read_text, ".dat": read_text}


def files_of(paths):
    """Files as they are; of a folder what is in its folders of times, or else its own files of the commonest kind."""
    for path in map(pathlib.Path, paths):
        if path.is_file():
            yield path
        elif path.is_dir():
            times = sorted((p for p in path.iterdir() if p.is_dir() and number_in(p.name) is not None),
                           key=lambda p: float(p.name))
            known = [p for folder in times or [path] for p in sorted(folder.iterdir()) if p.suffix in READERS]
            kinds = collections.Counter(p.suffix for p in known).most_common()
            yield from (p for p in known if p.suffix == kinds[0][0])
        else:
            raise Unusable(f"{path}: is not there")


def guarded(path, readers):
    """What the reader of this kind of file gives; whatever it or a library says against the file is one line."""
    if path.suffix not in readers:
        raise Unusable(f"{path}: files *{path.suffix} are not known: only {', '.join(sorted(readers))}")
    try:
        given = readers[path.suffix](path)
        return given if isinstance(given, tuple) else list(given)
    except Unusable as wrong:
        raise wrong if str(path) in str(wrong) else Unusable(f"{path}: {wrong}") from None
    except (Exception, SystemExit) as broken:
        said = " ".join(str(broken).split())[:200].removeprefix(f"{path}: ")
        raise Unusable(f"{path}: cannot be read: {said or type(broken).__name__}") from None


def counted(times):
    """Times of more than a year count from somewhere else: from the first on."""
    return times - times[0] if abs(times[0]) > 366 * 86400 else times


def read(paths, step=None, field=None):
    """Snapshots of files or folders in the order of their times; of several sets of points in a file those with the field."""
    snapshots = []
    for path in files_of(paths):
        snapshots += guarded(path, READERS)
    if not snapshots:
        raise Unusable(f"{', '.join(map(str, paths))}: nothing to read")
    # Of several sets of points in a file, those that have the field.
    snapshots = [one for one in snapshots if field in one.fields] or snapshots
    if step is not None:
        for k, one in enumerate(snapshots):
            one.time = k * step
    for one in snapshots:
        if one.time is None:
            raise Unusable(f"{paths[0]}: does not say its time: say how far the files are apart by --step")
    snapshots.sort(key=lambda one: one.time)
    for one, time in zip(snapshots, counted(np.array([one.time for one in snapshots]))):
        one.time = time
    return snapshots


# Series of gauges by name.

def series_of_hdf5(path):
    """Thetis' detectors and time series: an array `time`, and for every gauge one with as many rows."""
    h5py = package("h5py", "python3-h5py")
    with h5py.File(path) as file:
        found = {name: numbers_of(file, name, path) for name in file}
    if "time" not in found:
        raise Unusable(f"{path}: no time: there are {', '.join(sorted(found)) or 'none'}")
    times = found.pop("time").ravel()
    found = {name: values.reshape(len(values), -1) for name, values in found.items() if len(values) == times.size}
    return times, {name if values.shape[1] == 1 else f"{name}_{k}": values[:, k]
                   for name, values in found.items() for k in range(values.shape[1])}


def series_of_adcirc(path):
    """fort.61: a line of the run, one with the number of stations second; per record a time, and the stations' numbers and
    elevations. -99999 is dry."""
    lines = path.read_text(errors="replace").splitlines()
    try:
        stations = int(lines[1].split()[1])
        records = range(2, len(lines) - stations, stations + 1) if stations > 0 else []
        times = np.array([float(lines[k].split()[0]) for k in records])
        table = np.array([[line.split() for line in lines[k + 1:k + 1 + stations]] for k in records], float)
        levels = np.where(table[:, :, 1] < -99998, np.nan, table[:, :, 1])
        if not (table[:, :, 0] == 1 + np.arange(stations)).all():
            raise ValueError
    except (IndexError, ValueError):
        raise Unusable(f"{path}: is no fort.61 of ADCIRC with one elevation a station") from None
    return times, {str(1 + k): levels[:, k] for k in range(stations)}


SERIES = {".hdf5": series_of_hdf5, ".h5": series_of_hdf5, ".61": series_of_adcirc}


def read_series(path):
    """Times, and the levels at every gauge by its name; times that ascend."""
    path = pathlib.Path(path)
    times, levels = guarded(path, SERIES)
    if not (levels and np.isfinite(times).all()):
        raise Unusable(f"{path}: needs times that are finite numbers, and a gauge with a value at each")
    order = np.argsort(times, kind="stable")
    return counted(times[order]), {name: values[order] for name, values in levels.items()}
