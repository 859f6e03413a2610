"""Turns what solvers write into the tables that `seiche score` asks for: fronts, surfaces, gauges.

    python3 -m seiche.adapt front   postProcessing/floor --field alpha.water --column 0.05715 > front.csv
    python3 -m seiche.adapt surface run_*.vtu --field alpha.water > surface.csv
    python3 -m seiche.adapt gauge   run.nc --field eta --at x=2.5 > gauge.csv

Read are: VTK, VTU, VTP and PVD (python3-vtk9; or meshio, without times), netCDF (xarray), MATLAB's .mat (scipy), the
particles of PySPH (.hdf5), OpenFOAM's sampled sets (.xy) and surfaces (.raw), and the folders of their times,
Gerris' OutputLocation, and CSV with columns t and x. A time is the file's own, or its folder's name; `--step 0.01`
counts the files instead.

front    the farthest x at which the field falls below --level, or of the particles with four others within twice --near
surface  the highest crossing of --level in every column of points; a field of one value per column is taken as it is,
         and without --field the points themselves are on the surface
gauge    the surface at one x, by straight lines
Nothing is smoothed, shifted or scaled but by what is asked for: --column scales a front by the width of a column.
"""
import argparse
import collections
import csv
import pathlib
import re
import sys

import numpy as np


class Unusable(Exception):
    """What is wrong, in one line."""


class Snapshot:
    """Points and fields at one time; y is the vertical, or 0 where there is none."""

    def __init__(self, time, x, y=None, fields=None):
        self.time = time
        self.x = np.asarray(x, float)
        self.y = np.zeros_like(self.x) if y is None else np.asarray(y, float)
        self.fields = {name: np.asarray(values, float) for name, values in (fields or {}).items()}

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
    """The number that a name is, or None."""
    try:
        return float(text)
    except ValueError:
        return None


# Readers: a path gives snapshots.

def read_vtk(path):
    if path.suffix == ".pvd":
        entries = re.findall(r'timestep="([^"]+)"[^>]*file="([^"]+)"', path.read_text())
        if not entries:
            raise Unusable(f"{path}: no DataSet with timestep and file")
        for time, name in entries:
            for snapshot in read_vtk(path.parent / name):
                snapshot.time = float(time)
                yield snapshot
        return
    try:
        vtk = package("vtk", "python3-vtk9")
    except Unusable:
        yield from read_mesh(path)
        return
    from vtk.util.numpy_support import vtk_to_numpy
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
    mesh = package("meshio", "python3-vtk9, or python3-meshio").read(path)
    if mesh.cell_data:
        centres = np.concatenate([mesh.points[block.data].mean(axis=1) for block in mesh.cells])
        fields = {name: np.concatenate(values) for name, values in mesh.cell_data.items()}
    else:
        centres, fields = mesh.points, mesh.point_data
    yield Snapshot(None, centres[:, 0], centres[:, 1], {n: v for n, v in fields.items() if np.ndim(v) == 1})


def read_netcdf(path):
    xarray = package("xarray", "python3-xarray python3-netcdf4")
    with xarray.open_dataset(path, decode_times=False) as data:
        x_name = next((name for name in ("x", "X", "lon") if name in data.coords), None)
        t_name = next((name for name in ("t", "time", "Time") if name in data.dims), None)
        if x_name is None:
            raise Unusable(f"{path}: no coordinate x: there are {', '.join(map(str, data.coords))}")
        times = data[t_name].values if t_name and t_name in data.coords else np.array([np.nan])
        for k, time in enumerate(times):
            now = data.isel({t_name: k}) if t_name else data
            fields = {str(name): values.values for name, values in now.data_vars.items() if values.dims == (x_name,)}
            yield Snapshot(None if np.isnan(time) else float(time), data[x_name].values, None, fields)


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
    with package("h5py", "python3-h5py").File(path) as file:
        if "particles/fluid/arrays" not in file:
            raise Unusable(f"{path}: no particles/fluid/arrays: is not of PySPH, or its fluid has another name")
        time = float(file["solver_data"].attrs["t"])
        fields = {name: values[:] for name, values in file["particles/fluid/arrays"].items()}
    flat = {name: values for name, values in fields.items() if np.ndim(values) == 1}
    yield Snapshot(float(time), flat["x"], flat["y"], flat)


def read_set(path):
    fields = path.stem.replace("p_rgh", "p\0rgh").split("_")[1:]
    table = np.loadtxt(path, ndmin=2)
    if table.shape[1] != 1 + len(fields):
        return  # vectors, or three coordinates
    yield Snapshot(number_in(path.parent.name), table[:, 0], None,
                   {name.replace("\0", "_"): table[:, k + 1] for k, name in enumerate(fields)})


def read_raw(path):
    """A sampled surface: its points, and a field at them."""
    with open(path, encoding="utf-8") as file:
        header = [file.readline() for _ in range(2)][1].lstrip("# ").split()
    table = np.loadtxt(path, ndmin=2)
    if header[:3] != ["x", "y", "z"] or table.shape[1] != len(header):
        raise Unusable(f"{path}: must begin with two comments, the second '# x y z ...'")
    yield Snapshot(number_in(path.parent.name), table[:, 0], table[:, 1],
                   {name: table[:, k] for k, name in enumerate(header[3:], start=3)})


def snapshots_of(names, columns, path):
    """Rows with a time in each, in the order in which the times come."""
    if "t" not in names or "x" not in names:
        raise Unusable(f"{path}: needs columns t and x: there are {', '.join(names)}")
    table = {name: columns[:, k] for k, name in enumerate(names)}
    for time in dict.fromkeys(table["t"]):
        rows = table["t"] == time
        yield Snapshot(time, table["x"][rows], table["y"][rows] if "y" in table else None,
                       {name: values[rows] for name, values in table.items() if name not in "txyz"})


def read_text(path):
    with open(path, encoding="utf-8") as file:
        first = file.readline().lstrip("# ").strip()
    if first.startswith("1:t "):
        names = [word.split(":")[1] for word in first.split()]
        # Every location has the floor's y: a row of points, not a column.
        yield from snapshots_of(names, np.loadtxt(path, ndmin=2), path)
        return
    names = [word.split("[")[0].strip() for word in first.split(",")]
    yield from snapshots_of(names, np.loadtxt(path, delimiter=",", skiprows=1, ndmin=2), path)


READERS = {**dict.fromkeys((".vtu", ".vtp", ".vtk", ".vts", ".vti", ".pvd"), read_vtk), ".nc": read_netcdf,
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


def read(paths, step=None):
    snapshots = []
    for path in files_of(paths):
        if path.suffix not in READERS:
            raise Unusable(f"{path}: files *{path.suffix} are not known: only {', '.join(sorted(READERS))}")
        snapshots += READERS[path.suffix](path)
    if not snapshots:
        raise Unusable(f"{', '.join(map(str, paths))}: nothing to read")
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
    found = [last_crossing(snapshot.x[row], snapshot.field(field)[row], level) for row in rows_of(snapshot.y)]
    return max((x for x in found if x is not None), default=None)


def rows_of(values):
    """Which points share a coordinate, to a millionth of its range."""
    size = max(float(np.ptp(values)), 1e-300)
    whole = np.round((values - values.min()) / size * 1e6)
    return [whole == one for one in np.unique(whole)]


def surface(snapshot, field, level):
    """x and elevation of every column of points that has a surface; without a field all points are on it."""
    if field is None:
        columns = rows_of(snapshot.x)
        return (np.array([snapshot.x[c].mean() for c in columns]), np.array([snapshot.y[c].mean() for c in columns]))
    values = snapshot.field(field)
    columns = rows_of(snapshot.x)
    if len(columns) == values.size:
        order = np.argsort(snapshot.x)
        return snapshot.x[order], values[order]
    at = [(float(snapshot.x[c][0]), last_crossing(snapshot.y[c], values[c], level)) for c in columns]
    at = [(x, y) for x, y in at if y is not None]
    return np.array([x for x, _ in at]), np.array([y for _, y in at])


def place_of(text):
    name, _, value = text.partition("=")
    if name != "x" or number_in(value) is None:
        raise Unusable(f"--at {text}: must be x=NUMBER")
    return float(value)


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
                                                for x, y in zip(*surface(one, options.field, options.level))]
    if options.at is None:
        raise Unusable("gauge needs --at x=NUMBER")
    x = place_of(options.at)
    rows = []
    for one in snapshots:
        at, eta = surface(one, options.field, options.level)
        if at.size == 0 or not at[0] <= x <= at[-1]:
            raise Unusable(f"--at x={x:g}: the surface at t = {one.time:g} is not known there")
        rows.append((x, one.time, float(np.interp(x, at, eta))))
    return ["x [m]", "t [s]", "eta [m]"], rows


def main(words=None):
    parser = argparse.ArgumentParser(prog="python3 -m seiche.adapt", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", choices=["front", "surface", "gauge"])
    parser.add_argument("paths", nargs="+", metavar="PATH", help="files, or folders of them")
    parser.add_argument("--field", help="share of water, or an elevation")
    parser.add_argument("--level", type=float, default=0.5, help="of the field at the surface (default: 0.5)")
    parser.add_argument("--near", type=float, help="spacing of particles [m]")
    parser.add_argument("--at", help="x=NUMBER, of a gauge [m]")
    parser.add_argument("--step", type=float, help="time between the files [s], where they do not say theirs")
    parser.add_argument("--column", type=float, metavar="WIDTH", help="of a collapsing column: front over it [m]")
    parser.add_argument("--gravity", type=float, default=9.81, help="[m/s^2] (default: 9.81)")
    parser.add_argument("--square", action="store_true", help="of a square column: T = t sqrt(g/a), not t sqrt(2g/a)")
    options = parser.parse_args(words)
    try:
        header, rows = rows_for(options, read(options.paths, options.step))
        if not rows:
            raise Unusable(f"{options.paths[0]}: no {options.what} was found: is --level {options.level:g} met?")
    except (Unusable, OSError, ValueError, KeyError) as wrong:
        print(f"seiche.adapt: {wrong}".splitlines()[0], file=sys.stderr)
        sys.exit(2)
    writer = csv.writer(sys.stdout, lineterminator="\n")
    writer.writerow(header)
    writer.writerows([f"{value:.10g}" for value in row] for row in rows)


if __name__ == "__main__":
    main()
