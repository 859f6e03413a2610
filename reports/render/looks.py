"""How series look: colour, dash and marker by role.

Roles keep one look through the whole report: exact solutions are black lines, what was computed is coloured, other
solvers are coloured and dashed, measurements are dark markers, guides are thin grey. Within a role colour changes
together with dash or marker, so that series stay apart for the colour-blind and in grey print.
"""
import itertools

COLOURS = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9"]
DASHES = ["-", (0, (5, 1.6)), (0, (1.2, 1.4)), (0, (6, 1.6, 1.2, 1.6)), (0, (9, 2)), (0, (3, 1.2, 1.2, 1.2, 1.2, 1.2))]
MARKERS = ["o", "s", "^", "D", "v", "P", "X"]
INK, GREY = "#1d1d1b", "#8a867e"
WATER, WATER_LINE = "#d3e6f1", "#2f7ba8"
BED, BED_LINE = "#c9bfb2", "#6f6255"
DEPTHS = ["#eef5f8", "#bcdcec", "#7dbadb", "#3f8bb8", "#1f6093", "#123f66"]       # of heights, darker evenly
SIGNED = ["#7a3a06", "#d08a3e", "#f0d2a8", "#f6f6f3", "#a9d0e6", "#3b86b8", "#0f3f6b"]


class Looks:
    """Colour, dash and marker of every label of a figure, the same in all its panels."""

    def __init__(self, shown):
        self._looks, counters = {}, {}
        for panel in shown:
            for series in panel["series"]:
                role = series.get("role", "computed")
                key = self.key(series)
                if key in self._looks or series.get("style") in ("surface", "plan"):
                    continue
                # Peers continue the colours of what was computed; lines and markers of one role count together.
                family = {"peer": "computed"}.get(role, role)
                index = counters.setdefault(family, itertools.count())
                self._looks[key] = _look(role, next(index))

    @staticmethod
    def key(series):
        return series.get("role", "computed"), series.get("label", ""), series.get("style", "line")

    def of(self, series):
        return self._looks[self.key(series)]

    def number(self, series):
        return list(self._looks).index(self.key(series))

    def labels(self):
        """Of all series, as they are counted."""
        return [label for _, label, _ in self._looks]


def _look(role, index):
    turn = index // len(COLOURS)
    look = {"color": COLOURS[index % len(COLOURS)], "linestyle": DASHES[(index + turn) % len(DASHES)],
            "marker": MARKERS[index % len(MARKERS)], "linewidth": 1.4, "zorder": 3.0, "filled": index % 2 == 0}
    if role == "computed" and index == 0:
        look["linestyle"] = "-"
    if role == "peer":
        look["linestyle"] = DASHES[1:][index % (len(DASHES) - 1)]
        look["zorder"] = 2.8
    if role == "exact":
        look.update(color=INK if index < 6 else COLOURS[index % len(COLOURS)], linewidth=0.9, zorder=3.2)
    if role == "data":
        look.update(color="#3b3833", filled=index % 2 == 1, zorder=3.4)
    if role == "guide":
        look.update(color=GREY, linewidth=0.8, linestyle=DASHES[1:][index % 3], zorder=2.2)
    if role == "water":
        look.update(color=WATER_LINE, face=WATER, linewidth=1.1, linestyle="-", zorder=1.2)
    if role == "bed":
        look.update(color=BED_LINE, face=BED, linewidth=1.1, linestyle="-", zorder=1.6)
    return look
