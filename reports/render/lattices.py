"""Heights over deformed lattices: what surfaces and plans share, and the plan with its colours and contour lines.

A lattice is a series with two-dimensional arrays x, y, z of the same shape. At most DRAWN x DRAWN of its cells are
drawn: of larger ones every second (third, ...) row or column, and always the last. Shaded triangles are rasterised, so
that a figure stays small; axes, contour lines and text are not.
"""
import math

import matplotlib.cm
import matplotlib.collections
import matplotlib.colors
import matplotlib.ticker
import matplotlib.tri
import numpy

from render.looks import DEPTHS, INK, SIGNED

DRAWN = 200                    # cells along each side of a drawn lattice


def kind(panel):
    """What a panel is: "surface", "plan" or "plain"."""
    styles = {series.get("style") for series in panel["series"]}
    return next((style for style in ("surface", "plan") if style in styles), "plain")


def lattices(panel, style):
    """The panel's series of that style."""
    return [series for series in panel["series"] if series.get("style") == style]


def share_heights(shown):
    """Panels of the same height, such as a surface and its plan or frames in time, get the same range of z."""
    kinds = {}
    for panel in shown:
        if kind(panel) in ("surface", "plan"):
            kinds.setdefault(panel.get("z_label", ""), []).append(panel)
    for panels in kinds.values():
        heights = [span(series["z"]) for panel in panels for series in panel["series"]
                   if "z" in series and series.get("role") != "bed"]
        low, high = min((h[0] for h in heights), default=0.0), max((h[1] for h in heights), default=0.0)
        if not (math.isfinite(low) and math.isfinite(high)):
            raise ValueError("a surface has no finite height")
        for panel in panels:
            panel.setdefault("z_min", low)
            panel.setdefault("z_max", high if high > panel["z_min"] else panel["z_min"] + 1.0)


def span(values):
    values = values[numpy.isfinite(values)]
    return values.min(initial=math.inf), values.max(initial=-math.inf)


def colours(panel):
    """Colours of the panel's heights: deeper with height, or blue above and brown below where both signs matter."""
    low, high = panel["z_min"], panel["z_max"]
    if low < 0 < high and -low > 0.25 * high:
        bound = max(-low, high)
        norm, hues = matplotlib.colors.Normalize(-bound, bound), SIGNED
    else:
        norm, hues = matplotlib.colors.Normalize(low, high), DEPTHS
    return matplotlib.cm.ScalarMappable(norm, matplotlib.colors.LinearSegmentedColormap.from_list("heights", hues))


def thinned(series, panel, cut=True):
    """x, y, z of the rows and columns that are drawn, NaN outside the panel's limits unless axes cut there."""
    shape = series["x"].shape
    if len(shape) != 2 or min(shape) < 2 or any(series.get(name, numpy.empty(0)).shape != shape for name in "yz"):
        raise ValueError(f"“{series.get('label', '')}” needs x, y, z of one two-dimensional shape, 2 x 2 or more")
    inside = numpy.ones(shape, bool)
    for name in "xy":
        room = 1e-9 * numpy.subtract(*span(series[name])[::-1])
        inside &= ~(series[name] < panel.get(f"{name}_min", -math.inf) - room)
        inside &= ~(series[name] > panel.get(f"{name}_max", math.inf) + room)
    rows, columns = (numpy.flatnonzero(inside.any(axis=way)) for way in (1, 0))
    if min(len(rows), len(columns)) < 2:
        raise ValueError(f"“{series.get('label', '')}” has no cell within the panel's limits")
    if not cut:
        rows, columns = (numpy.arange(max(line[0] - 1, 0), min(line[-1] + 2, count))
                         for line, count in zip((rows, columns), shape))
    kept = numpy.ix_(rows[_every(len(rows))], columns[_every(len(columns))])
    x, y, z = (series[name][kept] for name in "xyz")
    return x, y, numpy.where(inside[kept], z, numpy.nan) if cut else z


def _every(count):
    """Indices 0 ... count - 1 in even steps so that at most DRAWN intervals are left."""
    step = math.ceil((count - 1) / DRAWN)
    return numpy.append(numpy.arange(0, count - 1, step), count - 1)


def triangles(x, y, z):
    """Corners of the triangles of all cells whose corners are finite, each cell split along its flatter diagonal."""
    index = numpy.arange(x.size).reshape(x.shape)
    a, b, c, d = (index[:-1, :-1].ravel(), index[:-1, 1:].ravel(), index[1:, 1:].ravel(), index[1:, :-1].ravel())
    height, there = z.ravel(), numpy.isfinite(x + y + z).ravel()
    whole = there[a] & there[b] & there[c] & there[d]
    a, b, c, d = a[whole], b[whole], c[whole], d[whole]
    across = numpy.abs(height[a] - height[c]) > numpy.abs(height[b] - height[d])
    first = numpy.where(across[:, None], numpy.column_stack((a, b, d)), numpy.column_stack((a, b, c)))
    second = numpy.where(across[:, None], numpy.column_stack((b, c, d)), numpy.column_stack((a, c, d)))
    return numpy.concatenate((first, second))


def plan(axis, panel, series):
    """Colours of z, shaded smoothly, and contour lines at the ticks of the colour bar."""
    x, y, z = thinned(series, panel, cut=False)
    hues = colours(panel)
    corners = triangles(x, y, z)
    if len(corners):
        mesh = matplotlib.collections.TriMesh(matplotlib.tri.Triangulation(*flat(x, y), corners), rasterized=True,
                                              zorder=1)
        mesh.set_facecolors(hues.to_rgba(flat(z)[0]))
        axis.add_collection(mesh)
    axis.update_datalim(numpy.column_stack(flat(x, y)))
    rest = numpy.median(z[numpy.isfinite(z)]) if numpy.isfinite(z).any() else 0
    quiet = 0.03 * (panel["z_max"] - panel["z_min"])     # a contour line there would trace noise
    lowest, highest = (numpy.nanmin(z), numpy.nanmax(z)) if numpy.isfinite(z).any() else (0, 0)
    levels = [level for level in ticks(panel) if abs(level - rest) > quiet and lowest < level < highest]
    if levels and numpy.isfinite(x + y).all():
        axis.contour(x, y, numpy.ma.masked_invalid(z), levels=levels, colors=INK, linewidths=0.35, linestyles="solid",
                     alpha=0.55, zorder=1.1)


def flat(*arrays):
    return [numpy.nan_to_num(array.ravel(), nan=0.0, posinf=0.0, neginf=0.0) for array in arrays]


def ticks(panel):
    """Round heights within the panel's range."""
    low, high = panel["z_min"], panel["z_max"]
    places = matplotlib.ticker.MaxNLocator(6, steps=[1, 2, 2.5, 5, 10]).tick_values(low, high)
    room = 1e-9 * (high - low)
    return [place for place in places if low - room <= place <= high + room]


def colour_bar(canvas, axes, panel, label):
    """One bar for the plans in `axes`."""
    hues = colours(panel)
    bar = canvas.colorbar(hues, ax=axes, aspect=24, fraction=0.05, pad=0.015, shrink=0.86, ticks=ticks(panel))
    bar.ax.set_ylim(panel["z_min"], panel["z_max"])
    bar.outline.set_linewidth(0.4)
    bar.ax.tick_params(which="both", length=2.5)
    bar.set_label(label)
