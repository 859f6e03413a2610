"""Marks that tell many solvers apart in drawings of points: colours first, then shapes."""

import dataclasses
import math

from markupsafe import escape

from render.looks import COLOURS

LETTERS = "●■▲◆"


@dataclasses.dataclass(frozen=True)
class Mark:
    colour: str
    letter: str                     # in keys and tables

    def svg(self, x, y, radius, attributes="", inside=""):
        """An element of SVG about the place."""
        r = radius
        if self.letter == "●":
            tag, shape = "circle", f'cx="{x:.1f}" cy="{y:.1f}" r="{r:g}"'
        else:
            steps = {
                "■": f"m{-r:g} {-r:g}h{2 * r:g}v{2 * r:g}h{-2 * r:g}z",
                "▲": f"m0 {-1.2 * r:g}l{1.2 * r:g} {2.1 * r:g}h{-2.4 * r:g}z",
                "◆": f"m0 {-1.3 * r:g}l{1.3 * r:g} {1.3 * r:g}l{-1.3 * r:g} {1.3 * r:g}l{-1.3 * r:g} {-1.3 * r:g}z",
            }[self.letter]
            tag, shape = "path", f'd="M{x:.1f} {y:.1f}{steps}"'
        return f'<{tag} {shape} fill="{self.colour}"{" " * bool(attributes)}{attributes}>{inside}</{tag}>'


def axes(left, width, height, place, spans, *names):
    """Logarithmic axes with ticks and names, as parts of an SVG. @param place  (value, axis) -> coordinate; spans in decades"""
    parts = [f'<path d="M{left} 0V{height}H{left + width}" fill="none" stroke="currentColor" stroke-width=".6"/>']
    for axis, span in enumerate(spans):
        for tick in _ticks(*span):
            at = place(tick, axis)
            where = (f'x="{at:.1f}" y="{height + 15}" text-anchor="middle"' if axis == 0 else
                     f'x="{left - 5}" y="{at + 4:.1f}" text-anchor="end"')
            line = f"M{at:.1f} {height}v3" if axis == 0 else f"M{left} {at:.1f}h-3"
            parts.append(f'<path d="{line}" stroke="currentColor" stroke-width=".6"/>'
                         f'<text {where} font-size="12">{tick:g}</text>')
    return parts + [f'<text x="{left + width / 2}" y="{height + 34}" text-anchor="middle" font-size="13">{escape(names[0])}</text>'
                    f'<text x="12" y="{height / 2}" text-anchor="middle" font-size="13" '
                    f'transform="rotate(-90 12 {height / 2})">{escape(names[1])}</text>']


def _ticks(low, high):
    """1, 2 and 5 times powers of ten, or the powers alone over more than two decades."""
    steps = (1,) if high - low > 2 else (1, 2, 5)
    return [step * 10.0**power for power in range(math.floor(low), math.ceil(high) + 1) for step in steps
            if low <= math.log10(step * 10.0**power) <= high]


def mark(number):
    """Of the solver with this number; alike again after 24."""
    return Mark(COLOURS[number % len(COLOURS)], LETTERS[number // len(COLOURS) % len(LETTERS)])
