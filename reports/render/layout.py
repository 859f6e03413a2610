"""Where panels stand and how large they are: common limits, columns, proportions."""
import math

import numpy

from render.lattices import kind, thinned
from render.scene import scene


def share_limits(shown):
    """Panels of the same quantity over similar ranges, such as frames in time, get the same axes."""
    framed = all(kind(panel) in ("surface", "plan") for panel in shown)
    for axis in "xy":
        ranges = [span_of(panel, axis) for panel in shown]
        kinds = {(panel.get(f"{axis}_label"), panel.get(f"log_{axis}")) for panel in shown}
        limited = any(given(panel.get(f"{axis}_{end}")) for panel in shown for end in ("min", "max"))
        if len(shown) < 2 or len(kinds) > 1 or limited or shown[0].get(f"log_{axis}"):
            continue
        low, high = min(r[0] for r in ranges), max(r[1] for r in ranges)
        if not high - low <= 1.8 * max(r[1] - r[0] for r in ranges) or high == low:
            continue
        room = 0 if framed else (0.06 if axis == "y" else 0.015) * (high - low)
        grounded = any(series.get("role") in ("water", "bed") for panel in shown for series in panel["series"])
        for panel in shown:
            panel[f"{axis}_max"] = high + room
            if framed or not (axis == "y" and grounded):
                panel[f"{axis}_min"] = low - room


def span_of(panel, axis):
    """Smallest and largest finite coordinate of a panel's series, with their error bars."""
    values = [numpy.empty(0)]
    for series in panel["series"]:
        if axis not in series or (axis == "y" and series.get("style") == "vertical"):
            continue
        values.append(series[axis].ravel())
        if axis == "y" and "y_error" in series and len(series["y_error"]) == len(series["y"]):
            values += [series["y"] - series["y_error"], series["y"] + series["y_error"]]
    values = numpy.concatenate(values)
    values = values[numpy.isfinite(values)]
    return values.min(initial=math.inf), values.max(initial=-math.inf)


def given(value):
    return isinstance(value, (int, float)) and math.isfinite(value)


def columns_of(shown):
    """How many panels stand side by side."""
    count = len(shown)
    widest = max((ratio(panel) or 0) for panel in shown)
    if count == 1 or widest > 5:
        return 1
    kinds = [kind(panel) for panel in shown]
    if count % 2 == 0 and kinds[0] != kinds[1] and kinds == kinds[:2] * (count // 2):
        return 2                              # a surface and its plan at several times
    if count == 3 and widest < 1.6:
        return 3
    quantities = [panel.get("y_label", "") for panel in shown]
    if count % 2 == 0 and quantities[0] != quantities[1] and quantities == quantities[:2] * (count // 2):
        return 2                              # two quantities at several times: a row per time
    return 2 if count <= 6 else 3


def ratio(panel):
    """Width over height of what a panel of fixed proportions shows, or None."""
    if kind(panel) == "surface":
        left, right, bottom, top = scene(panel).extent([thinned(series, panel) for series in panel["series"]])
        return (right - left) / (top - bottom)
    if panel.get("aspect") != "equal" and kind(panel) != "plan":
        return None
    spans = []
    for axis in "xy":
        least, most = span_of(panel, axis)
        low = panel.get(f"{axis}_min") if given(panel.get(f"{axis}_min")) else least
        high = panel.get(f"{axis}_max") if given(panel.get(f"{axis}_max")) else most
        spans.append(high - low)
    room = 1.0 if kind(panel) == "plan" else 1.1
    return spans[0] / (room * spans[1]) if spans[0] > 0 and spans[1] > 0 else None


def height(panel, width, count):
    """Inches that a panel of this width needs."""
    proportion = ratio(panel)
    labels = 0.62 if count > 1 else 0.55
    if kind(panel) == "plan":
        width *= 0.9                          # the colour bar
    if proportion:
        return min(6.5, max(0.55, (width - 0.65) / proportion) + labels)
    return 3.7 if count == 1 else 0.72 * width if count <= 4 else 0.8 * width
