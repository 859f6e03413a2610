"""The general drawing: panels of series, each series with a role (what it is) and a style (how it is drawn)."""
import math
import re

import matplotlib.pyplot
import matplotlib.ticker
import numpy
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from render.figures import drawing
from render.looks import Looks

WIDTH = 7.4                     # inches: the width of the page's text block
MANY = 5000                     # points above which a series is thinned (lines) or rasterised (markers)


@drawing("panels")
def panels(figure, small):
    """One or more panels; labels shared by all panels go into one legend below."""
    shown = figure["panels"]
    if not shown:
        raise ValueError("the figure has no panels")
    looks = Looks(shown)
    _share_limits(shown)
    if small:
        return _stamp(shown, looks)
    columns = _columns(shown)
    rows = math.ceil(len(shown) / columns)
    shared = _shared_legend(shown)
    width = WIDTH
    heights = [max(_height(panel, width / columns, len(shown)) for panel in shown[row * columns:(row + 1) * columns])
               for row in range(rows)]
    legend_lines = math.ceil(len(shared) / _legend_columns(shared)) if shared else 0
    legend_height = 0.22 * legend_lines + (0.06 if shared else 0)
    below = [0.2 * math.ceil(len(_labels(panel)) / 2) if not shared and len(_labels(panel)) > 6 else 0
             for panel in shown]
    total = sum(heights) + legend_height + max(below)
    canvas, axes = matplotlib.pyplot.subplots(rows, columns, figsize=(width, total), squeeze=False,
                                              gridspec_kw={"height_ratios": heights})
    canvas.set_layout_engine("constrained", rect=(0, legend_height / total, 1, 1 - legend_height / total),
                             w_pad=0.06, h_pad=0.05, wspace=0.04, hspace=0.05)
    for axis in axes.flat[len(shown):]:
        axis.set_visible(False)
    for axis, panel in zip(axes.flat, shown):
        _draw_panel(axis, panel, looks)
        _text(axis, panel)
        if not shared and _labels(panel):
            _own_legend(axis, panel, looks)
    for name in ("x_label", "y_label"):      # said once where all panels say the same
        if len({panel.get(name, "") for panel in shown}) == 1:
            for position, axis in enumerate(axes.flat[:len(shown)]):
                if name == "y_label" and position % columns:
                    axis.set_ylabel("")
                if name == "x_label" and position + columns < len(shown):
                    axis.set_xlabel("")
    if shared:
        canvas.legend(*_handles(shared, looks), loc="lower center", ncol=_legend_columns(shared),
                      bbox_to_anchor=(0.5, 0), borderaxespad=0.15)
    return canvas


def _stamp(shown, looks):
    """The first panels without any text."""
    shown = shown[:6]
    columns = 3 if len(shown) > 4 else _columns(shown)
    rows = math.ceil(len(shown) / columns)
    canvas, axes = matplotlib.pyplot.subplots(rows, columns, figsize=(3.0, 1.95), squeeze=False)
    canvas.set_layout_engine("constrained", w_pad=0.03, h_pad=0.03, wspace=0.03, hspace=0.03)
    for axis in axes.flat[len(shown):]:
        axis.set_visible(False)
    for axis, panel in zip(axes.flat, shown):
        _draw_panel(axis, panel, looks)
        axis.tick_params(which="both", labelbottom=False, labelleft=False, length=1.5)
        axis.minorticks_off()
    return canvas


def _share_limits(shown):
    """Panels of the same quantity over similar ranges, such as frames in time, get the same axes."""
    for axis in "xy":
        ranges = [_range(panel, axis) for panel in shown]
        kinds = {(panel.get(f"{axis}_label"), panel.get(f"log_{axis}")) for panel in shown}
        given = any(_finite(panel.get(f"{axis}_{end}")) for panel in shown for end in ("min", "max"))
        if len(shown) < 2 or len(kinds) > 1 or given or shown[0].get(f"log_{axis}"):
            continue
        low, high = min(r[0] for r in ranges), max(r[1] for r in ranges)
        if not high - low <= 1.8 * max(r[1] - r[0] for r in ranges) or high == low:
            continue
        room = (0.06 if axis == "y" else 0.015) * (high - low)
        grounded = any(series.get("role") in ("water", "bed") for panel in shown for series in panel["series"])
        for panel in shown:
            panel[f"{axis}_max"] = high + room
            if not (axis == "y" and grounded):
                panel[f"{axis}_min"] = low - room


def _range(panel, axis):
    """Smallest and largest finite coordinate of a panel's series."""
    values = numpy.concatenate([series[axis] for series in panel["series"]
                                if axis in series and not (axis == "y" and series.get("style") == "vertical")]
                               or [numpy.empty(0)])
    values = values[numpy.isfinite(values)]
    return values.min(initial=math.inf), values.max(initial=-math.inf)


def _draw_panel(axis, panel, looks):
    if panel.get("log_x"):
        axis.set_xscale("log")
    if panel.get("log_y"):
        axis.set_yscale("log")
    later = []
    for series in panel["series"]:
        if series.get("style") == "fill" or (series.get("style") == "steps" and series.get("role") in ("water", "bed")):
            later.append(series)
        _draw_series(axis, series, looks.of(series))
    _limits(axis, panel)
    base = axis.get_ylim()[0]
    limits = axis.get_xlim(), axis.get_ylim()
    for series in later:
        _fill(axis, series, looks.of(series), base)
    axis.set_xlim(limits[0])
    axis.set_ylim(limits[1])
    if panel.get("aspect") == "equal" and not (panel.get("log_x") or panel.get("log_y")):
        axis.set_aspect("equal", adjustable="box")
        ticks = 2 if (_ratio(panel) or 1) > 6 else 4
        axis.yaxis.set_major_locator(matplotlib.ticker.MaxNLocator(ticks, steps=[1, 2, 2.5, 5, 10]))
    if panel.get("log_x") or panel.get("log_y"):
        axis.grid(True, which="major")
        _log_ticks(axis, panel)


def _text(axis, panel):
    axis.set_title(safe(panel.get("title", "")))
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
    axis.autoscale_view()
    low, high = axis.get_ylim()
    if any(series.get("style") == "points" for series in panel["series"]):
        axis.margins(x=0.03)       # no marker is cut in half
        axis.autoscale_view()
    styled = [series for series in panel["series"] if series.get("role") in ("water", "bed")]
    if styled and not panel.get("log_y"):
        floor = min([low] + [value for series in styled for value in series.get("y", ()) if math.isfinite(value)])
        if any(series.get("role") == "bed" for series in styled):
            axis.set_ylim(min(low, floor - 0.07 * (high - floor)), high)      # room below the bed for its fill
        else:
            axis.set_ylim(min(low, floor, 0), high)                           # water stands on its bottom
    for name, which in (("x_min", "left"), ("x_max", "right")):
        if _finite(panel.get(name)):
            axis.set_xlim(**{which: panel[name]})
    for name, which in (("y_min", "bottom"), ("y_max", "top")):
        if _finite(panel.get(name)):
            axis.set_ylim(**{which: panel[name]})


def _finite(value):
    return isinstance(value, (int, float)) and math.isfinite(value)


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


def _labels(panel):
    """Labelled series of a panel, each label and look once."""
    unique = {}
    for series in panel["series"]:
        if series.get("label", "").strip():
            unique.setdefault(Looks.key(series), series)
    return list(unique.values())


def _shared_legend(shown):
    """Labelled series for one legend below, when panels share most of their labels or a single one cannot hold it."""
    if len(shown) == 1:
        labels = _labels(shown[0])
        return labels if len(labels) > 6 or (labels and (_ratio(shown[0]) or 0) > 2) else []
    sets = [frozenset(map(Looks.key, _labels(panel))) for panel in shown]
    union = frozenset().union(*sets)
    if not union or len(union) > 12 or sum(map(len, sets)) < 0.6 * len(union) * len([s for s in sets if s]):
        return []
    unique = {}
    for panel in shown:
        for series in _labels(panel):
            unique.setdefault(Looks.key(series), series)
    return list(unique.values())


def _legend_columns(series):
    longest = max(len(one["label"]) for one in series)
    return max(1, min(len(series), int(105 / (longest + 9))))


def _handles(series, looks):
    return [_handle(one, looks.of(one)) for one in series], [safe(one["label"]) for one in series]


def _handle(series, look):
    style = series.get("style", "line")
    if style == "fill" or (style == "steps" and "face" in look):
        return Patch(facecolor=look.get("face", look["color"]), edgecolor=look["color"], linewidth=0.8)
    if style == "points" and series.get("role") != "guide":
        filled = look["filled"] or len(series["x"]) > 400
        return Line2D([], [], linestyle="none", marker=look["marker"], markersize=4.2, color=look["color"],
                      markerfacecolor=look["color"] if filled else "white", markeredgewidth=0.8)
    return Line2D([], [], color=look["color"], linewidth=look["linewidth"], linestyle=look["linestyle"])


def _own_legend(axis, panel, looks):
    labelled = _labels(panel)
    if len(labelled) > 6:
        axis.legend(*_handles(labelled, looks), loc="upper center", bbox_to_anchor=(0.5, -0.17),
                    ncol=min(3, _legend_columns(labelled)))
    else:
        axis.legend(*_handles(labelled, looks), loc="best")


def _columns(shown):
    count = len(shown)
    widest = max((_ratio(panel) or 0) for panel in shown)
    if count == 1 or widest > 5:
        return 1
    if count == 3 and widest < 1.6:
        return 3
    quantities = [panel.get("y_label", "") for panel in shown]
    if count % 2 == 0 and quantities[0] != quantities[1] and quantities == quantities[:2] * (count // 2):
        return 2                              # two quantities at several times: a row per time
    return 2 if count <= 6 else 3


def _ratio(panel):
    """Width over height of the data of an equal-aspect panel, or None."""
    if panel.get("aspect") != "equal":
        return None
    spans = []
    for axis in "xy":
        least, most = _range(panel, axis)
        low = panel.get(f"{axis}_min") if _finite(panel.get(f"{axis}_min")) else least
        high = panel.get(f"{axis}_max") if _finite(panel.get(f"{axis}_max")) else most
        spans.append(high - low)
    return spans[0] / (1.1 * spans[1]) if spans[0] > 0 and spans[1] > 0 else None


def _height(panel, width, count):
    ratio = _ratio(panel)
    labels = 0.62 if count > 1 else 0.55
    if ratio:
        return min(6.5, max(0.55, (width - 0.65) / ratio) + labels)
    return 3.7 if count == 1 else 0.72 * width if count <= 4 else 0.8 * width


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


def safe(text):
    """A label that mathtext can set: formulas are kept when they parse, dollars are printed otherwise."""
    text = str(text)
    if "$" in text:
        try:
            from matplotlib.mathtext import MathTextParser
            MathTextParser("path").parse(text)
            return text
        except Exception:                     # mathtext raises many types
            return text.replace("$", r"\$")
    return re.sub(r"\^\{?([-+]?\d+)\}?", r"$^{\1}$", text)
