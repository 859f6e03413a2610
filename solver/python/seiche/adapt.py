"""Turns what solvers write into the tables that `seiche score` asks for: fronts, surfaces, gauges.

    python3 -m seiche.adapt front   postProcessing/floor --field alpha.water --column 0.05715 > front.csv
    python3 -m seiche.adapt surface run_*.vtu --field alpha.water > surface.csv
    python3 -m seiche.adapt gauge   run.nc --field eta --at x=2.5 > gauge.csv

Read are: VTK, VTU, VTP and PVD (python3-vtk9; or meshio, without times), netCDF (xarray: CF, UGRID, ANUGA's .sww; its
units become m and s), MATLAB's .mat (scipy), the particles of PySPH (.hdf5), OpenFOAM's sampled sets (.xy) and surfaces
(.raw), and the folders of their times, Gerris' OutputLocation, and CSV with columns t and x. A time is the file's own,
or its folder's name; `--step 0.01` counts the files instead.

front    the farthest x at which the field falls below --level, or of the particles with four others within twice --near
surface  the highest crossing of --level in every column of points; a field of one value per column is taken as it is,
         and without --field the points themselves are on the surface
gauge    the surface at one x by straight lines, or at one x and y by triangles between points; NaN where it is dry
Nothing is smoothed, shifted or scaled else but by what is asked for: --column scales a front by the width of a column.
"""
import argparse
import collections
import csv
import io
import os
import pathlib
import re
import resource
import sys
import warnings

import numpy as np

MOST_NUMBERS = 50_000_000   # of one array
MOST_FILES = 100_000        # of a collection
MOST_MEMORY = 16 << 30      # [byte]
MOST_SECONDS = 600          # of processor time


class Unusable(Exception):
    """What is wrong, in one line."""


class Snapshot:
    """Points and fields at one time; y is the vertical, or 0 where there is none. A value may be NaN: there is none."""

    def __init__(self, time, x, y=None, fields=None):
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
        sets = {}
        for name in xs:
            # A coordinate y of the same points; where there is none, one along an axis of its own.
            along = next((y for y in ys if data[y].dims == data[name].dims and y != name), None)
            across = next((y for y in ys if data[name].ndim == data[y].ndim == 1 and data[y].dims != data[name].dims), None)
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
                yield Snapshot(None if np.isnan(time) else float(time), x.ravel(), None if y is None else y.ravel(), fields)
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
            if not isinstance(file[group].get(name, getlink=True), h5py.HardLink):
                raise Unusable(f"{path}: {name} is a link, must be in this file")
            values = file[group][name]
            if values.external or values.is_virtual or values.size > MOST_NUMBERS or values.dtype.kind not in "fiu":
                raise Unusable(f"{path}: {name}: must be numbers in this file, at most {MOST_NUMBERS}")
            if values.size:     # PySPH writes what it never filled as an array of none
                fields[name] = values[:]
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
            kinds = collections.Counter(p.suffix for p in known).most_common(1)
            yield from (p for p in known if p.suffix == kinds[0][0])
        else:
            raise Unusable(f"{path}: is not there")


def read(paths, step=None, field=None):
    snapshots = []
    for path in files_of(paths):
        if path.suffix not in READERS:
            raise Unusable(f"{path}: files *{path.suffix} are not known: only {', '.join(sorted(READERS))}")
        try:
            snapshots += READERS[path.suffix](path)
        except Unusable as wrong:
            raise wrong if str(path) in str(wrong) else Unusable(f"{path}: {wrong}") from None
        except (Exception, SystemExit) as broken:  # whatever a library says of a stranger's file
            said = " ".join(str(broken).split())[:200].removeprefix(f"{path}: ")
            raise Unusable(f"{path}: cannot be read: {said or type(broken).__name__}") from None
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
    return sorted(snapshots, key=lambda one: one.time)


# What is read off a snapshot.

def last_crossing(x, values, level):
    """The largest x at which values fall below the level, between points by a straight line; None where they do not."""
    order = np.argsort(x, kind="stable")
    x, above = x[order], values[order] - level
    inside = np.flatnonzero(above >= 0)
    if inside.size == 0:
        return None
    last = inside[-1]
    if last + 1 == x.size:
        return float(x[last])
    return float(x[last] + (x[last + 1] - x[last]) * above[last] / (above[last] - above[last + 1]))


def front(snapshot, field, level, near):
    if field is None:
        if near is None:
            raise Unusable("a front of particles needs --near, their spacing; one of a field --field")
        ahead = np.argsort(-snapshot.x)
        for k in ahead:
            apart = np.hypot(snapshot.x - snapshot.x[k], snapshot.y - snapshot.y[k])
            if np.count_nonzero(apart < 2 * near) > 4:  # four others
                return float(snapshot.x[k])
        return None
    x, y, values = snapshot.where_known(field)
    found = [last_crossing(x[row], values[row], 0.5 if level is None else level) for row in rows_of(y)]
    return max((x for x in found if x is not None), default=None)


def rows_of(values):
    """Which points share a coordinate, to a millionth of its range."""
    if values.size == 0:
        return []
    size = max(float(np.ptp(values)), 1e-300)
    whole = np.round((values - values.min()) / size * 1e6)
    order = np.argsort(whole, kind="stable")
    return np.split(order, np.flatnonzero(np.diff(whole[order])) + 1)


def surface(snapshot, field, level):
    """x and elevation of every column of points that has a surface; without a field all points are on it. A field of one
    value per column is NaN where it has none."""
    if field is None:
        columns = rows_of(snapshot.x)
        return (np.array([snapshot.x[c].mean() for c in columns]), np.array([snapshot.y[c].mean() for c in columns]))
    x, y, values = snapshot.where_known(field)
    if len(rows_of(snapshot.x)) == snapshot.x.size:
        order = np.argsort(snapshot.x)
        values = snapshot.field(field)[order]
        return snapshot.x[order], np.where(np.abs(values) < 1e20, values, np.nan)
    columns = rows_of(x)
    if level is None and values.size and not (values.min() > -0.5 and values.max() < 1.5):
        raise Unusable(f"field {field} is no share of water from 0 to 1: needs --level, or over a plan gauge --at x=NUMBER,y=NUMBER")
    at = [(float(x[c][0]), last_crossing(y[c], values[c], 0.5 if level is None else level)) for c in columns]
    at = [(x, y) for x, y in at if y is not None]
    return np.array([x for x, _ in at]), np.array([y for _, y in at])


def place_of(text):
    """x, and y or None, of --at."""
    place = dict(word.partition("=")[::2] for word in text.split(","))
    x, y = number_in(place.get("x", "")), number_in(place.get("y", "0"))
    if x is None or y is None or len(place) > 2 or set(place) - {"x", "y"}:
        raise Unusable(f"--at {text}: must be x=NUMBER or x=NUMBER,y=NUMBER")
    return x, y if "y" in place else None


def in_plan(snapshot, field, x, y):
    """The field at a place of the plan: of the point there, or between points by triangles; NaN where there is none."""
    if field is None:
        raise Unusable("a gauge at x and y needs --field")
    values = snapshot.field(field)
    apart_from = np.hypot(snapshot.x - x, snapshot.y - y)
    nearest = int(np.argmin(apart_from))
    if apart_from[nearest] <= 1e-9 * (np.ptp(snapshot.x) + np.ptp(snapshot.y)):
        return float(values[nearest])
    near = np.argsort(apart_from)[:256]
    interpolate = package("scipy.interpolate", "python3-scipy").LinearNDInterpolator
    try:
        return float(interpolate(np.column_stack([snapshot.x, snapshot.y])[near], values[near])(x, y))
    except Exception:  # points on one line have no triangles
        return np.nan


def rows_for(options, snapshots):
    """The header and the rows of the table."""
    if options.what == "front":
        found = [(one.time, front(one, options.field, options.level, options.near)) for one in snapshots]
        found = [(t, x) for t, x in found if x is not None]
        if options.column is None:
            return ["t [s]", "x [m]"], found
        unit = np.sqrt((1 if options.square else 2) * options.gravity / options.column)
        return ["T [1]", "X [1]"], [(t * unit, x / options.column) for t, x in found]
    if options.what == "surface":
        return ["t [s]", "x [m]", "eta [m]"], [(one.time, x, y) for one in snapshots
                                                for x, y in zip(*surface(one, options.field, options.level)) if np.isfinite(y)]
    if options.at is None:
        raise Unusable("gauge needs --at x=NUMBER")
    x, y = place_of(options.at)
    rows = []
    for one in snapshots:
        if y is None:
            at, values = surface(one, options.field, options.level)
            eta = float(np.interp(x, at, values, np.nan, np.nan)) if at.size else np.nan
        else:
            eta = in_plan(one, options.field, x, y)
        rows.append((x, one.time, eta) if y is None else (x, y, one.time, eta))
    if all(np.isnan(row[-1]) for row in rows):
        plan = y is None and any(np.ptp(one.y) > 0 for one in snapshots)
        raise Unusable(f"--at {options.at}: the surface is not known there" + ": over a plan it is at x=NUMBER,y=NUMBER" * plan)
    return ["x [m]", *(["y [m]"] if y is not None else []), "t [s]", "eta [m]"], rows


def main(words=None):
    parser = argparse.ArgumentParser(prog="python3 -m seiche.adapt", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", choices=["front", "surface", "gauge"])
    parser.add_argument("paths", nargs="+", metavar="PATH", help="files, or folders of them")
    parser.add_argument("--field", help="share of water, or an elevation")
    parser.add_argument("--level", type=float, help="of the field at the surface (default: 0.5)")
    parser.add_argument("--near", type=float, help="spacing of particles [m]")
    parser.add_argument("--at", help="x=NUMBER, or x=NUMBER,y=NUMBER over a plan, of a gauge [m]")
    parser.add_argument("--step", type=float, help="time between the files [s], where they do not say theirs")
    parser.add_argument("--column", type=float, metavar="WIDTH", help="of a collapsing column: front over it [m]")
    parser.add_argument("--gravity", type=float, default=9.81, help="[m/s^2] (default: 9.81)")
    parser.add_argument("--square", action="store_true", help="of a square column: T = t sqrt(g/a), not t sqrt(2g/a)")
    options = parser.parse_args(words)
    status, told = apart(lambda: table_for(options))
    if status != 0:
        print("seiche.adapt: " + "".join(c if c.isprintable() else "?" for c in told.strip()), file=sys.stderr)
        sys.exit(2)
    sys.stdout.write(told)


def table_for(options):
    header, rows = rows_for(options, read(options.paths, options.step, options.field))
    if not rows:
        raise Unusable(f"{options.paths[0]}: no {options.what} was found: is --level met?")
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(header)
    writer.writerows([f"{value:.10g}" for value in row] for row in rows)
    return text.getvalue()


def apart(work):
    """Status and text of work in a child process: libraries crash on some files, warn at length, or never end."""
    ours, theirs = os.pipe()
    child = os.fork()
    if child == 0:
        status = 2
        for chatter in (1, 2):
            os.dup2(os.open(os.devnull, os.O_WRONLY), chatter)
        for what, most in ((resource.RLIMIT_AS, MOST_MEMORY), (resource.RLIMIT_CPU, MOST_SECONDS)):
            allowed = resource.getrlimit(what)[1]
            least = most if allowed == resource.RLIM_INFINITY else min(most, allowed)
            resource.setrlimit(what, (least, least))
        warnings.simplefilter("ignore")
        try:
            told, status = work(), 0
        except BaseException as wrong:
            told = str(wrong) or type(wrong).__name__
        with open(theirs, "w", encoding="utf-8") as out:
            out.write(told)
        os._exit(status)
    os.close(theirs)
    with open(ours, encoding="utf-8", errors="replace") as answer:
        told = answer.read()
    status = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
    return status, told or f"reading was ended by signal {-status}: a damaged file, or one that takes more than {MOST_SECONDS} s"


if __name__ == "__main__":
    main()
