"""Marks that tell many solvers apart in drawings of points: colours first, then shapes."""

import dataclasses

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


def mark(number):
    """Of the solver with this number; alike again after 24."""
    return Mark(COLOURS[number % len(COLOURS)], LETTERS[number // len(COLOURS) % len(LETTERS)])
