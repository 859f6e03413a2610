"""Converts solver output to the tables of `seiche score`: fronts, surfaces, gauges, series.

    python3 -m seiche.adapt front   postProcessing/floor --field alpha.water --column 0.05715 > front.csv
    python3 -m seiche.adapt surface run_*.vtu --field alpha.water > surface.csv
    python3 -m seiche.adapt gauge   run.nc --field eta --at x=2.5 > gauge.csv
    python3 -m seiche.adapt series  fort.61 > gauges.csv

Formats: VTK, VTU, VTP and PVD (python3-vtk9; or meshio, without times), netCDF (xarray: CF, UGRID, ANUGA's .sww; its
units become m and s), MATLAB's .mat (scipy), the particles of PySPH (.hdf5), OpenFOAM's sampled sets (.xy) and surfaces
(.raw), and the folders of their times, Gerris' OutputLocation, and CSV with columns t and x. The time comes from the file,
or from the name of its folder; `--step 0.01` counts the files instead.

front    the farthest x at which the field falls below --level, or of the particles with four others within twice --near
surface  the highest crossing of --level in every column of points; a field of one value per column is the elevation,
         and without --field the points themselves are the surface
gauge    the surface at one x by linear interpolation, or at one x and y by triangles between points; NaN where dry
series   gauges written by the solver, a column each: Thetis' detectors (.hdf5) and ADCIRC's stations (fort.61)
Values are not smoothed, shifted or scaled, except by --column, which divides a front by the column width.
Times above one year, such as seconds since 1970, count from the first one.
"""
import argparse
import csv
import io
import os
import resource
import sys
import warnings

import numpy as np

from seiche.readers import Unusable, number_in, package, read, read_series

MOST_MEMORY = 16 << 30      # [byte]
MOST_SECONDS = 600          # of processor time


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
        if snapshot.level:
            raise Unusable(f"needs --field: there are {', '.join(sorted(snapshot.fields)) or 'none'}")
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


def rows_for(options):
    """The header and the rows of the table."""
    if options.what == "series":
        if len(options.paths) != 1:
            raise Unusable("series needs one file")
        times, levels = read_series(options.paths[0])
        return ["t [s]", *(f"{name} [m]" for name in levels)], np.column_stack([times, *levels.values()])
    snapshots = read(options.paths, options.step, options.field)
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
    parser.add_argument("what", choices=["front", "surface", "gauge", "series"])
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
    header, rows = rows_for(options)
    if len(rows) == 0:
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
