"""Surfaces in perspective: smoothly shaded, with lines of their lattice, as a block that stands in its axes.

Triangles and lines are painted from the back to the front in thin slices, which is exact enough for heights and also
serves several surfaces at once, such as water around an island.
"""
import math

import matplotlib.collections
import matplotlib.colors
import matplotlib.ticker
import matplotlib.tri
import numpy

from render.lattices import colours, flat, lattices, thinned, triangles
from render.legends import safe
from render.looks import BED, BED_LINE, GREY, INK, WATER, WATER_LINE
from render.scene import scene

BANDS = 100                    # slices from the back to the front
MESH = 40                      # lines of the lattice shown each way, at most
LIGHT = (-0.60, 0.28, 0.75)    # towards the light: right, to the eye, up
SHADE = (0.85, 0.68, 0.5)      # how much a lack of light takes of red, green and blue


def surfaces(axis, panel, small):
    """Draws the panel's surfaces and the box they stand in."""
    view = scene(panel)
    pieces, walls, lines = [], [], []
    shown = [(series, thinned(series, panel)) for series in lattices(panel, "surface")]
    beds = [lattice for series, lattice in shown if series.get("role") == "bed"]
    for series, lattice in shown:
        bed = series.get("role") == "bed"
        pieces.append((lattice, _shaded(lattice, view, panel, bed)))
        if bed or not beds:
            walls += _walls(lattice, numpy.full_like(lattice[2], view.low[2]), view, bed)
        elif beds[0][2].shape == lattice[2].shape:
            walls += _walls(lattice, beds[0][2], view, bed)
        tint = matplotlib.colors.to_rgba(*((BED_LINE, 0.5) if bed else (INK, 0.28)))
        lines.append((_mesh(lattice, MESH // 2 if small else MESH), tint))
    _paint(axis, view, pieces, walls, lines)
    left, right, bottom, top = view.extent([lattice for _, lattice in shown])
    axis.set_xlim(left - 0.01 * (right - left), right + 0.01 * (right - left))
    axis.set_ylim(bottom - 0.02 * (top - bottom), top + 0.02 * (top - bottom))
    axis.set_aspect("equal", anchor="C" if small else "N")
    axis.set_axis_off()
    _frame(axis, view, panel, right - left, small)


def _shaded(lattice, view, panel, bed):
    """Colours of the points: by height, lit from the left."""
    x, y, z = lattice
    along, across = ([numpy.gradient(part, axis=way) for part in (x, y, view.exaggeration * z)] for way in (1, 0))
    normal = numpy.cross(numpy.stack(along, axis=-1), numpy.stack(across, axis=-1)).reshape(-1, 3)
    normal *= numpy.where(normal[:, 2:] < 0, -1, 1)
    length = numpy.linalg.norm(normal, axis=1, keepdims=True)
    upright = ~(length > 0)                  # at a gap
    normal = numpy.where(upright, (0.0, 0.0, 1.0), normal / numpy.where(upright, 1, length))
    hues = (numpy.broadcast_to(matplotlib.colors.to_rgb(BED), (x.size, 3)) if bed
            else colours(panel).to_rgba(flat(z)[0])[:, :3])
    return _lit(hues, normal @ _light(view) - _light(view)[2])


def _light(view):
    """Unit vector towards the light."""
    turn = math.radians(view.azimuth)
    right, eye = (-math.sin(turn), math.cos(turn)), (math.cos(turn), math.sin(turn))
    light = numpy.array([LIGHT[0] * right[0] + LIGHT[1] * eye[0], LIGHT[0] * right[1] + LIGHT[1] * eye[1], LIGHT[2]])
    return light / numpy.linalg.norm(light)


def _lit(hues, excess):
    """Colours under more or less light than a horizontal surface gets."""
    excess = excess[:, None]
    bright = hues + (1 - hues) * numpy.clip(1.6 * excess, 0, 0.75)
    dark = hues * (1 + numpy.clip(excess, -0.75, 0) * SHADE)
    return numpy.where(excess > 0, bright, dark)


def _walls(lattice, below, view, bed):
    """The sides of the block under a surface that face the eye, each a lattice of one row with its colours."""
    walls = []
    dark, pale = (numpy.array(matplotlib.colors.to_rgb(hue))
                  for hue in ((BED_LINE, BED) if bed else (WATER_LINE, WATER)))
    turn, light = math.radians(view.azimuth), _light(view)
    for side in ((0, slice(None)), (-1, slice(None)), (slice(None), 0), (slice(None), -1)):
        x, y, z = (part[side] for part in lattice)
        normal = numpy.array([y[-1] - y[0], x[0] - x[-1]])
        normal /= numpy.linalg.norm(normal) or 1.0
        if normal @ (x.mean() - lattice[0].mean(), y.mean() - lattice[1].mean()) < 0:
            normal = -normal
        if normal @ (math.cos(turn), math.sin(turn)) > 0:
            wall = tuple(numpy.stack(pair) for pair in ((x, x), (y, y), (z, below[side])))
            hues = numpy.tile(0.7 * pale + 0.3 * dark, (2 * len(x), 1))
            walls.append((wall, _lit(hues, numpy.full(len(hues), 0.35 * (normal @ light[:2] - 0.25)))))
    return walls


def _mesh(lattice, count):
    """Segments between neighbours on some lines of the lattice, (n, 2, 3)."""
    points = numpy.stack(lattice, axis=-1)
    parts = []
    for held in (points, points.swapaxes(0, 1)):
        step = math.ceil((len(held) - 1) / count)
        held = held[numpy.unique(numpy.append(numpy.arange(0, len(held), step), len(held) - 1))]
        parts.append(numpy.stack((held[:, :-1], held[:, 1:]), axis=2).reshape(-1, 2, 3))
    segments = numpy.concatenate(parts)
    return segments[numpy.isfinite(segments).all(axis=(1, 2))]


def _paint(axis, view, pieces, walls, lines):
    """Triangles of all pieces and segments of all lines in slices from the back to the front."""
    corners, count = [], 0
    for lattice, _ in pieces + walls:
        corners.append(triangles(*lattice) + count)
        count += lattice[0].size
    standing = numpy.repeat([False] * len(pieces) + [True] * len(walls), [len(part) for part in corners])
    pieces, corners = pieces + walls, numpy.concatenate(corners)
    right, up, back = view.project(*(numpy.concatenate([flat(lattice[k])[0] for lattice, _ in pieces])
                                     for k in range(3)))
    hues = numpy.concatenate([hue for _, hue in pieces])
    depth = back[corners].mean(axis=1)
    segments = numpy.concatenate([segment for segment, _ in lines])
    tints = numpy.concatenate([numpy.tile(tint, (len(segment), 1)) for segment, tint in lines])
    places = numpy.stack(view.project(*numpy.moveaxis(segments, -1, 0)), axis=-1)
    edges = numpy.linspace(depth.max(initial=-math.inf), depth.min(initial=math.inf), BANDS + 1)
    # A line is painted one slice late, so that the triangles before it do not cover half of its width; a wall two.
    slices = numpy.clip(numpy.searchsorted(-edges, -depth) - 1 + 2 * standing, 0, BANDS - 1)
    turns = numpy.clip(numpy.searchsorted(-edges, -places[..., 2].mean(axis=1)), 0, BANDS - 1)
    for band in range(BANDS):
        inside = numpy.flatnonzero(slices == band)
        inside = inside[numpy.argsort(-depth[inside], kind="stable")]
        if len(inside):
            points = corners[inside].ravel()
            mesh = matplotlib.collections.TriMesh(
                matplotlib.tri.Triangulation(right[points], up[points], numpy.arange(len(points)).reshape(-1, 3)),
                rasterized=True, zorder=2)
            mesh.set_facecolors(hues[points])
            axis.add_collection(mesh, autolim=False)
        inside = turns == band
        if inside.any():
            axis.add_collection(matplotlib.collections.LineCollection(
                places[inside][..., :2], colors=tints[inside], linewidths=0.3, capstyle="round", rasterized=True,
                zorder=2), autolim=False)


def _frame(axis, view, panel, width, small):
    """The edges of the box that are next to the eye, with ticks and labels, and the exaggeration."""
    here, *sides = view.edges()
    floor = numpy.array([view.project(*view.corner(k))[:2] for k in range(5)])
    axis.plot(*floor.T, color=GREY, linewidth=0.4, zorder=1)
    for other in sides:
        kind = "x" if view.corner(other)[0] != view.corner(here)[0] else "y"
        _edge(axis, view, panel, view.corner(here), view.corner(other), kind, width, small)
    foot, post = view.corner(sides[0]), view.corner(sides[0], high=True)
    if all(series.get("role") != "bed" for series in panel["series"]):
        foot[2] = panel["z_min"]
    _edge(axis, view, panel, foot, post, "z", width, small)
    if not small:
        factor = view.exaggeration
        said = "true vertical scale" if factor == 1 else f"heights × {factor:.3g}"
        axis.text(1, 1, said, transform=axis.transAxes, ha="right", va="top", color=GREY, fontsize=9.5)


def _edge(axis, view, panel, start, end, kind, width, small):
    """One edge of the box as an axis."""
    way = "xyz".index(kind)
    middle = 0.5 * (view.low + view.high)
    low, high = sorted((start[way], end[way]))
    a, b = (numpy.array(view.project(*corner)[:2]) for corner in (start, end))
    axis.plot(*zip(a, b), color=INK, linewidth=0.6, zorder=3, solid_capstyle="round")
    if small:
        return
    outward = 0.5 * (a + b) - numpy.array(view.project(*middle)[:2])
    along = (b - a) / numpy.linalg.norm(b - a)
    outward -= along * (outward @ along)
    outward = numpy.array([-1.0, 0.0]) if kind == "z" else outward / numpy.linalg.norm(outward)
    inches = _inches(axis) * numpy.linalg.norm(b - a) / width
    for place in _places(low, high, inches / (0.2 if kind == "z" else 0.45)):
        point = start.copy()
        point[way] = place
        spot = numpy.array(view.project(*point)[:2])
        axis.plot(*zip(spot, spot + 0.008 * width * outward), color=INK, linewidth=0.6, zorder=3)
        axis.annotate(f"{place:.6g}".replace("-", "\N{MINUS SIGN}"), spot, 11 * outward, textcoords="offset points",
                      ha="right" if kind == "z" else "center", va="center", fontsize=9.5, color=INK,
                      annotation_clip=False)
    label = safe(panel.get(f"{kind}_label", ""))
    if kind == "z":
        axis.annotate(label, b, (4, 9), textcoords="offset points", ha="right", va="bottom", annotation_clip=False)
        return
    slope = math.degrees(math.atan2(along[1], along[0]))
    axis.annotate(label, 0.5 * (a + b), 25 * outward, textcoords="offset points", ha="center", va="center",
                  rotation=(slope + 90) % 180 - 90, rotation_mode="anchor", annotation_clip=False)


def _inches(axis):
    """Width of the panel in print, about."""
    return axis.figure.get_size_inches()[0] / axis.get_subplotspec().get_gridspec().ncols - 0.9


def _places(low, high, most):
    """Round numbers for ticks from low to high, so that about `most` labels would fill the axis."""
    room = 1e-9 * (high - low)
    places = matplotlib.ticker.MaxNLocator(max(2, min(6, int(most))), steps=[1, 2, 2.5, 5, 10]).tick_values(low, high)
    kept = []
    for place in places:
        if low - room <= place <= high + room and (not kept or (place - kept[-1]) * most > 0.8 * (high - low)):
            kept.append(place)
    return kept
