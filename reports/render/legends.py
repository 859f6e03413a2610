"""Legends: one below for panels that share their labels, else one in each panel; and labels that mathtext can set."""
import re

from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from render.layout import ratio
from render.looks import Looks


def labels(panel):
    """Labelled series of a panel, each label and look once."""
    unique = {}
    for series in panel["series"]:
        if series.get("label", "").strip() and series.get("style") not in ("surface", "plan"):
            unique.setdefault(Looks.key(series), series)
    return list(unique.values())


def shared_legend(shown):
    """Labelled series for one legend below, when panels share most of their labels or a single one cannot hold it."""
    if len(shown) == 1:
        own = labels(shown[0])
        return own if len(own) > 6 or (own and (ratio(shown[0]) or 0) > 2) else []
    sets = [frozenset(map(Looks.key, labels(panel))) for panel in shown]
    union = frozenset().union(*sets)
    if not union or len(union) > 12 or sum(map(len, sets)) < 0.6 * len(union) * len([s for s in sets if s]):
        return []
    unique = {}
    for panel in shown:
        for series in labels(panel):
            unique.setdefault(Looks.key(series), series)
    return list(unique.values())


def legend_columns(series):
    longest = max(len(one["label"]) for one in series)
    return max(1, min(len(series), int(105 / (longest + 9))))


def handles(series, looks):
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


def own_legend(axis, panel, looks):
    labelled = labels(panel)
    below = {"loc": "upper center", "bbox_to_anchor": (0.5, -0.17), "ncol": min(3, legend_columns(labelled))}
    named_keys(axis.legend(*handles(labelled, looks), **(below if len(labelled) > 6 else {"loc": "best"})), labelled, looks)


def named_keys(legend, labelled, looks):
    for text, series in zip(legend.get_texts(), labelled):
        text.set_gid(f"key-{looks.number(series)}")


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
