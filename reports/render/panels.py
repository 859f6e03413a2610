"""The drawings: panels of series, each series with a role (what it is) and a style (how it is drawn); and films of them.

What a reader may ask of a figure has a name in its file (assets/figure.js): "panel-2", "series-3", its key in the
legend "key-3", what a film shows at an instant "frame-1". Series count as their labels in Looks do.
"""
import math

import matplotlib.lines
import matplotlib.pyplot
import matplotlib.ticker
import numpy

from render.lattices import colour_bar, kind, plan, share_heights
from render.layout import columns_of, given, height, ratio, share_limits
from render.legends import handles, labels, legend_columns, named_keys, own_legend, safe, shared_legend
from render.looks import Looks
from render.surfaces import surfaces

WIDTH = 7.4                     # inches: the width of the page's text block
MANY = 5000                     # points above which a series is thinned (lines) or rasterised (markers)


def panels(figure, small):
    """One or more panels; labels shared by all panels go into one legend below."""
    shown = figure["panels"]
    if not shown:
        raise ValueError("the figure has no panels")
    looks = Looks(shown)
    share_limits(shown)
    share_heights(shown)
    if small:
        return _stamp(shown, looks)
    columns = columns_of(shown)
    rows = math.ceil(len(shown) / columns)
    shared = shared_legend(shown)
    width = WIDTH
    heights = [max(height(panel, width / columns, len(shown)) for panel in shown[row * columns:(row + 1) * columns])
               for row in range(rows)]
    legend_lines = math.ceil(len(shared) / legend_columns(shared)) if shared else 0
    legend_height = 0.22 * legend_lines + (0.06 if shared else 0)
    below = [0.2 * math.ceil(len(labels(panel)) / 2) if not shared and len(labels(panel)) > 6 else 0
             for panel in shown]
    total = sum(heights) + legend_height + max(below)
    canvas = matplotlib.pyplot.figure(figsize=(width, total))
    axes = _axes(canvas, shown, rows, columns, height_ratios=heights)
    canvas.set_layout_engine("constrained", rect=(0, legend_height / total, 1, 1 - legend_height / total),
                             w_pad=0.06, h_pad=0.05, wspace=0.04, hspace=0.05)
    for number, (axis, panel) in enumerate(zip(axes, shown)):
        axis.set_gid(f"panel-{number}")
        _draw_panel(axis, panel, looks)
        _text(axis, panel)
        if not shared and labels(panel):
            own_legend(axis, panel, looks)
    for name in ("x_label", "y_label"):      # said once where all panels say the same
        if len({panel.get(name, "") for panel in shown}) == 1 and {kind(panel) for panel in shown} <= {"plain", "plan"}:
            for position, axis in enumerate(axes):
                if name == "y_label" and position % columns:
                    axis.set_ylabel("")
                if name == "x_label" and position + columns < len(shown):
                    axis.set_xlabel("")
    _colour_bars(canvas, axes, shown)
    if shared:
        named_keys(canvas.legend(*handles(shared, looks), loc="lower center", ncol=legend_columns(shared),
                                 bbox_to_anchor=(0.5, 0), borderaxespad=0.15), shared, looks)
    return canvas


def film(figure, small):
    """Panels one after the other in the same place; until the figure's script plays them, the last is seen."""
    shown = figure["panels"]
    looks = Looks(shown)
    share_limits(shown)
    share_heights(shown)
    if small:
        return _stamp(shown[-1:], looks)
    room = height(shown[0], WIDTH, 1) + 0.6
    canvas = matplotlib.pyplot.figure(figsize=(WIDTH, room))
    canvas.set_layout_engine("constrained", rect=(0, 0.3 / room, 1, 1 - 0.3 / room))
    (axis,) = _axes(canvas, shown[:1], 1, 1)
    axis.set_gid("panel-0")
    for number, panel in enumerate(shown):
        _draw_panel(axis, panel, looks, frame=f"frame-{number}")
        axis.text(0, 1.02, safe(panel["title"]), transform=axis.transAxes, gid=f"frame-{number}")
    _text(axis, {**shown[0], "title": ""})
    if labels(shown[-1]):
        own_legend(axis, shown[-1], looks)
    _colour_bars(canvas, [axis], shown[:1])
    return canvas


DRAWINGS = {"panels": panels, "film": film}     # by the name that a record gives


def _named(name, axis, draw, *what):
    """Draws on an axis and names what is drawn. A rasterised artist leaves its group before it paints: it gets its own."""
    before = set(axis.get_children())
    draw(axis, *what)
    for artist in set(axis.get_children()) - before:
        read = isinstance(artist, matplotlib.lines.Line2D) and artist.get_marker() != "_"      # no bar of an error
        own = name if read else f"{name} area-0".strip()
        artist.set_gid(own)
        if artist.get_rasterized():
            artist.draw = _grouped(artist.draw, own)


def _grouped(draw, name):
    def grouped(renderer):
        renderer.open_group("raster", name)
        draw(renderer)
        if getattr(renderer, "_rasterizing", False):
            renderer.stop_rasterizing()
            renderer._rasterizing = False
        renderer.close_group("raster")
    return grouped


def _axes(canvas, shown, rows, columns, **proportions):
    """Axes for the panels, row by row."""
    grid = canvas.add_gridspec(rows, columns, **proportions)
    return [canvas.add_subplot(grid[divmod(position, columns)]) for position in range(len(shown))]


def _colour_bars(canvas, axes, shown):
    """One colour bar for all plans of the same height and range."""
    ranges = {}
    for axis, panel in zip(axes, shown):
        if kind(panel) == "plan":
            ranges.setdefault((panel.get("z_label", ""), panel["z_min"], panel["z_max"]), []).append((axis, panel))
    for (label, _, _), plans in ranges.items():
        colour_bar(canvas, [axis for axis, _ in plans], plans[0][1], safe(label))


def _stamp(shown, looks):
    """The first panels without any text."""
    shown = shown[:6]
    columns = 3 if len(shown) > 4 else columns_of(shown)
    rows = math.ceil(len(shown) / columns)
    canvas = matplotlib.pyplot.figure(figsize=(3.0, 1.95))
    axes = _axes(canvas, shown, rows, columns)
    canvas.set_layout_engine("constrained", w_pad=0.03, h_pad=0.03, wspace=0.03, hspace=0.03)
    for axis, panel in zip(axes, shown):
        _draw_panel(axis, panel, looks, small=True)
        axis.tick_params(which="both", labelbottom=False, labelleft=False, length=1.5)
        axis.minorticks_off()
    return canvas


def _draw_panel(axis, panel, looks, small=False, frame=""):
    if kind(panel) == "surface":
        surfaces(axis, panel, small)
        return
    if panel.get("log_x"):
        axis.set_xscale("log")
    if panel.get("log_y"):
        axis.set_yscale("log")
    later = []
    for series in panel["series"]:
        if series.get("style") == "plan":
            _named(frame, axis, plan, panel, series)
            continue
        if series.get("style") == "fill" or (series.get("style") == "steps" and series.get("role") in ("water", "bed")):
            later.append(series)
        _named(f"{frame} series-{looks.number(series)}".strip(), axis, _draw_series, series, looks.of(series))
    _limits(axis, panel)
    base, top = axis.get_ylim()
    for series in later:
        _named(f"{frame} series-{looks.number(series)}".strip(), axis, _fill, series, looks.of(series), base)
    axis.set_ylim(base, top)
    equal = panel.get("aspect") == "equal" or kind(panel) == "plan"
    if equal and not (panel.get("log_x") or panel.get("log_y")):
        axis.set_aspect("equal", adjustable="box")
        shape = ratio(panel) or 1
        ticks = 2 if shape > 6 else 4
        axis.yaxis.set_major_locator(matplotlib.ticker.MaxNLocator(ticks, steps=[1, 2, 2.5, 5, 10]))
        if shape < 0.5:
            axis.xaxis.set_major_locator(matplotlib.ticker.MaxNLocator(2, steps=[1, 2, 5, 10]))
    if panel.get("log_x") or panel.get("log_y"):
        axis.grid(True, which="major")
        _log_ticks(axis, panel)


def _text(axis, panel):
    # The label of a surface's heights stands at the top of its panel, where the title would be.
    axis.set_title(safe(panel.get("title", "")), pad=18 if kind(panel) == "surface" else None)
    axis.set_xlabel(safe(panel.get("x_label", "")))
    axis.set_ylabel(safe(panel.get("y_label", "")))


def _draw_series(axis, series, look):
    style = series.get("style", "line")
    x, y = series["x"], series.get("y", numpy.empty(0))
    if style == "vertical":
        for place in x[numpy.isfinite(x)]:
            axis.axvline(place, color=look["color"], linewidth=0.8, linestyle=look["linestyle"], zorder=2.1)
        return
    if style == "steps":
        if len(x) != len(y) + 1:
            raise ValueError(f"steps “{series.get('label', '')}” "
                             f"need one edge more than values, not {len(x)} and {len(y)}")
        axis.plot(numpy.repeat(x, 2)[1:-1], numpy.repeat(y, 2), color=look["color"], linewidth=look["linewidth"],
                  linestyle=look["linestyle"], zorder=look["zorder"] + 0.01, solid_joinstyle="miter")
        return
    if len(x) != len(y):
        raise ValueError(f"series “{series.get('label', '')}” has {len(x)} x and {len(y)} y")
    if style == "points" and series.get("role") not in ("water", "bed", "guide"):
        _points(axis, series, look)
        return
    x, y = thin(x, y)
    axis.plot(x, y, color=look["color"], linewidth=look["linewidth"], linestyle=look["linestyle"],
              zorder=look["zorder"] + 0.01)


def _points(axis, series, look):
    x, y = series["x"], series["y"]
    size = 4.2 if len(x) <= 60 else 2.8 if len(x) <= 400 else 1.6 if len(x) <= 3000 else 0.8
    error = series.get("y_error")
    if error is not None and len(error) == len(y):
        error = numpy.where(numpy.isfinite(error), numpy.abs(error), 0)
    else:
        error = None
    filled = look["filled"] or len(x) > 400
    style = {"marker": look["marker"], "markersize": size, "linestyle": "none", "color": look["color"],
             "markerfacecolor": look["color"] if filled else "white", "markeredgewidth": 0.8 if len(x) <= 400 else 0,
             "zorder": look["zorder"] + 0.5}
    if error is not None:
        axis.errorbar(x, y, yerr=error, elinewidth=0.7, **style)
    else:
        axis.plot(x, y, rasterized=len(x) > MANY, **style)


def _fill(axis, series, look, base):
    x, y = series["x"], series["y"]
    if series.get("style") == "steps":
        axis.stairs(y, x, baseline=base, fill=True, color=look["face"], zorder=look["zorder"] - 0.1)
        if len(x) <= 250:
            tops = numpy.minimum(numpy.append(y, y[-1]), numpy.insert(y, 0, y[0])) if len(y) else y
            axis.vlines(x, base, tops, color=look["color"], linewidth=0.35, alpha=0.7, zorder=look["zorder"])
        return
    x, y = thin(x, y)
    axis.fill_between(x, y, base, color=look.get("face", look["color"]), linewidth=0,
                      alpha=None if "face" in look else 0.18, zorder=look["zorder"] - 0.1)


def _limits(axis, panel):
    low, high = axis.get_ylim()
    if kind(panel) == "plan":
        axis.margins(0)
    elif any(series.get("style") == "points" for series in panel["series"]):
        axis.margins(x=0.03)       # no marker is cut in half
    styled = [series for series in panel["series"] if series.get("role") in ("water", "bed")]
    if styled and not panel.get("log_y"):
        floor = min([low] + [value for series in styled for value in series.get("y", ()) if math.isfinite(value)])
        if any(series.get("role") == "bed" for series in styled):
            axis.set_ylim(floor - 0.07 * (high - floor), high)      # room below the bed for its fill
        else:
            axis.set_ylim(min(floor, 0), high)                      # water stands on its bottom
    for name, which in (("x_min", "left"), ("x_max", "right")):
        if given(panel.get(name)):
            axis.set_xlim(**{which: panel[name]})
    for name, which in (("y_min", "bottom"), ("y_max", "top")):
        if given(panel.get(name)):
            axis.set_ylim(**{which: panel[name]})


def _log_ticks(axis, panel):
    """Log axes that span less than a decade and a half get readable labels at 1, 2, 5."""
    for name, which in (("log_x", axis.xaxis), ("log_y", axis.yaxis)):
        if not panel.get(name):
            continue
        low, high = which.get_view_interval()
        decades = math.log10(high / low) if low > 0 and high > low else 9
        if decades < 1.6:
            which.set_major_locator(matplotlib.ticker.LogLocator(subs=(1, 2, 5)))
            which.set_minor_formatter(matplotlib.ticker.NullFormatter())
            if 1e-3 <= low and high <= 1e5:
                which.set_major_formatter(matplotlib.ticker.FuncFormatter(lambda v, _: f"{v:g}"))


def thin(x, y, limit=MANY):
    """At most about `limit` points of a curve, keeping the extremes of every stretch."""
    if len(x) <= limit:
        return x, y
    stretches = numpy.array_split(numpy.arange(len(x)), limit // 4)
    keep = set()
    for part in stretches:
        keep.update((part[0], part[-1]))
        finite = part[numpy.isfinite(y[part])]
        if len(finite):
            keep.update((finite[numpy.argmin(y[finite])], finite[numpy.argmax(y[finite])]))
    order = numpy.array(sorted(keep))
    return x[order], y[order]
