"""How surfaces are seen: the box around them, the eye, and where a point appears."""
import dataclasses
import math

import numpy

from render.lattices import lattices, span

AZIMUTH, ELEVATION = -62.0, 30.0
DISTANCE = 4.0                 # of the eye, in diagonals of the plan
RISE = 0.15                    # height of the surface over the longer side of its plan, about, where none is given


@dataclasses.dataclass
class Scene:
    """The box around the surfaces of a panel and the eye that sees it."""
    low: numpy.ndarray         # corner of the box; its height is the foot of the block that is drawn
    high: numpy.ndarray
    exaggeration: float
    azimuth: float
    elevation: float

    def project(self, x, y, z):
        """Where points appear, to the right and up, in units of the plan, and how far back they stand.

        What hides a point of a surface stands before it in the plan: heights do not count in the last number.
        """
        middle = 0.5 * (self.low + self.high)
        x, y, z = x - middle[0], y - middle[1], (z - middle[2]) * self.exaggeration
        turn, lift = math.radians(self.azimuth), math.radians(self.elevation)
        right = -math.sin(turn) * x + math.cos(turn) * y
        back = -math.cos(turn) * x - math.sin(turn) * y
        up = math.cos(lift) * z + math.sin(lift) * back
        far = math.cos(lift) * back - math.sin(lift) * z
        reach = DISTANCE * numpy.hypot(*(self.high - self.low)[:2])
        scale = reach / (reach + far)
        return right * scale, up * scale, back

    def corner(self, k, high=False):
        """Corner k = 0 ... 3 of the box, counter-clockwise from the smallest x and y."""
        x = (self.low, self.high, self.high, self.low)[k % 4][0]
        y = (self.low, self.low, self.high, self.high)[k % 4][1]
        return numpy.array([x, y, (self.high if high else self.low)[2]])

    def edges(self):
        """The corner of the box next to the eye, and its neighbours to the left and right."""
        here = min(range(4), key=lambda k: self.project(*self.corner(k))[2])
        return here, *sorted((here - 1, here + 1), key=lambda k: self.project(*self.corner(k))[0])

    def extent(self, lattices_drawn):
        """Least and largest coordinate of what is drawn: left, right, bottom, top."""
        parts = [self.project(*self.corner(k)) for k in range(4)]
        parts.append(self.project(*self.corner(self.edges()[1], high=True)))
        parts += [self.project(*(part[numpy.isfinite(z)] for part in (x, y, z))) for x, y, z in lattices_drawn]
        right, up = (numpy.concatenate([numpy.atleast_1d(part[k]) for part in parts]) for k in (0, 1))
        return right.min(), right.max(), up.min(), up.max()

def scene(panel):
    """The box, the eye and the vertical exaggeration of a panel of surfaces."""
    surfaces = lattices(panel, "surface")
    if len(surfaces) != len(panel["series"]):
        raise ValueError("a panel with a surface holds nothing but surfaces")
    low, high = [], []
    for name in "xy":
        spans = [span(series[name]) for series in surfaces]
        low.append(panel.get(f"{name}_min", min(span[0] for span in spans)))
        high.append(panel.get(f"{name}_max", max(span[1] for span in spans)))
    if not all(numpy.isfinite(low + high)) or not all(numpy.less(low, high)):
        raise ValueError("a surface has no extent in x or y")
    beds = [span(series["z"]) for series in surfaces if series.get("role") == "bed"]
    foot = panel["z_min"] - 0.25 * (panel["z_max"] - panel["z_min"])
    top = max([panel["z_max"]] + [bed[1] for bed in beds])
    if beds:
        foot = min(bed[0] for bed in beds) - 0.08 * (top - min(bed[0] for bed in beds))
    rise = RISE * max(high[0] - low[0], high[1] - low[1])
    given = panel.get("exaggeration", 0)
    exaggeration = given if given > 0 else _round(rise * (2 if beds else 1.25) / (top - foot))
    return Scene(numpy.array([*low, foot]), numpy.array([*high, top]), exaggeration,
                 panel.get("azimuth", AZIMUTH), min(max(panel.get("elevation", ELEVATION), 1.0), 89.0))


def _round(value):
    """The nearest of 1, 2, 5 times a power of ten."""
    power = 10.0 ** math.floor(math.log10(value))
    return min((1, 2, 5, 10), key=lambda digit: abs(math.log(value / (digit * power)))) * power
