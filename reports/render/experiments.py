"""Models against experiments over all laboratory cases: bias and relative scatter of every quantity, solver by solver.

After K. McGrattan, B. Toman, Quantifying the predictive uncertainty of complex numerical models, Metrologia 48 (2011)
173-180, as fire models are judged: with pairs of measured E and computed M, and the mean square s_E^2 of the relative
uncertainties of E,

    s^2 = variance of ln(M/E),    s_M^2 = s^2 - s_E^2,    bias = exp(mean of ln(M/E) + (s_M^2 - s_E^2)/2).

Where s is below s_E the experiments cannot tell the model's own scatter.
"""
import collections
import dataclasses
import fnmatch
import math
import statistics

from markupsafe import Markup, escape

from render.marks import Mark, axes, mark

TABLE = "laboratory-readings"
COLUMNS = 8      # of that table: another version's is left out
LEAST = 3       # pairs of which a bias and a scatter are given
SIZE, LEFT, BOTTOM = 250.0, 58.0, 40.0


@dataclasses.dataclass
class Pair:
    """A reading of an experiment and what a solver has for it."""
    record: object
    claim: str
    measured: float
    uncertainty: float
    computed: float


@dataclasses.dataclass
class Line:
    """One solver's pairs of one quantity, and what follows from them."""
    solver: str
    mark: Mark
    pairs: list
    left_out: int                   # of another sign, without a number, or too near zero to be a ratio
    errors: list                    # abs(M - E)/E of every reading with a number, of another sign as well
    bias: float | None = None
    scatter: float | None = None    # None: below that of the experiments, or too few pairs
    experimental: float | None = None

    @property
    def median(self):
        return statistics.median(self.errors) if self.errors else None

    @property
    def worst(self):
        return max(self.errors, default=None)

    @property
    def cases(self):
        return sorted({pair.record.case for pair in self.pairs})


def survey(records):
    """[(quantity, [Line])] of all records that hold readings; the misfit has no measured value and is left out."""
    pairs, errors, left_out = collections.defaultdict(list), collections.defaultdict(list), collections.Counter()
    for record in records:
        for table in tables(record):
            solver = table["title"] if record.own else record.solver
            for kind, reading, measured, uncertainty, computed, _, origin, _ in table["rows"]:
                if kind == "misfit":
                    continue
                error = relative(measured, uncertainty, computed, origin)
                if error is not None:
                    errors[kind, solver].append(error)
                pair = _pair(record, reading, measured, uncertainty, computed, origin)
                if pair is None:
                    left_out[kind, solver] += 1
                else:
                    pairs[kind, solver].append(pair)
    solvers = list(dict.fromkeys(solver for _, solver in list(pairs) + list(left_out)))
    lines = collections.defaultdict(list)
    for kind, solver in dict.fromkeys(list(pairs) + list(left_out)):
        lines[kind].append(line_of(solver, mark(solvers.index(solver)), pairs[kind, solver], left_out[kind, solver],
                                   errors[kind, solver]))
    return sorted(lines.items())


def tables(record):
    """Those of readings that a solver has answered: a record of the data alone has no solver in its title."""
    return [table for table in record.tables if table["id"] == TABLE and table["title"]
            and all(len(row) == COLUMNS for row in table["rows"])]


def of_readings(record, pattern):
    """abs(M - E)/E of the readings whose name matches, None where there is no number."""
    return [relative(measured, uncertainty, computed, origin) for table in tables(record)
            for _, reading, measured, uncertainty, computed, _, origin, _ in table["rows"]
            if fnmatch.fnmatchcase(reading, pattern)]


def relative(measured, uncertainty, computed, origin):
    """Counted from the origin; None without a number, or where the measured one is not known to a half."""
    if None in (measured, uncertainty, computed, origin) or not 2 * uncertainty <= abs(measured - origin):
        return None
    return abs(computed - measured) / abs(measured - origin)


def _pair(record, claim, measured, uncertainty, computed, origin):
    """Counted from the origin; None where there is no ratio of the two, or the measured one is not known to a half."""
    if relative(measured, uncertainty, computed, origin) is None:
        return None
    measured, computed = measured - origin, computed - origin
    return Pair(record, claim, abs(measured), uncertainty, abs(computed)) if measured * computed > 0 else None


def line_of(solver, own_mark, pairs, left_out, errors=()):
    """Bias and scatter; see above."""
    line = Line(solver, own_mark, pairs, left_out, list(errors))
    if len(pairs) < LEAST:
        return line
    logs = [math.log(pair.computed / pair.measured) for pair in pairs]
    mean = math.fsum(logs) / len(logs)
    variance = math.fsum((one - mean) ** 2 for one in logs) / (len(logs) - 1)
    experimental = math.fsum((pair.uncertainty / pair.measured) ** 2 for pair in pairs) / len(pairs)
    own = max(variance - experimental, 0.0)
    line.experimental = math.sqrt(experimental)
    line.scatter = math.sqrt(own) if own > 0 else None
    line.bias = math.exp(mean + (own - experimental) / 2)
    return line


def scatter_figure(lines):
    """Computed against measured, both on logarithmic axes; the line is agreement, the band twice the experiments'."""
    pairs = [pair for line in lines for pair in line.pairs]
    if not pairs:
        return Markup("")
    values = [value for pair in pairs for value in (pair.measured, pair.computed)]
    low, high = math.log10(min(values)) - 0.1, math.log10(max(values)) + 0.1

    def place(value, axis):
        at = SIZE * (math.log10(value) - low) / (high - low)
        return SIZE - at if axis else LEFT + at

    relative = math.sqrt(math.fsum((pair.uncertainty / pair.measured) ** 2 for pair in pairs) / len(pairs))
    offset = SIZE * math.log10(1 + 2 * relative) / (high - low)
    parts = axes(LEFT, SIZE, SIZE, place, [(low, high)] * 2, "measured", "computed")
    parts.append(f'<path d="M{LEFT} {SIZE}L{LEFT + SIZE} 0" stroke="currentColor" stroke-width=".8"/>')
    for shift in (offset, -offset):
        parts.append(f'<path d="M{LEFT + max(shift, 0):.1f} {SIZE + min(shift, 0):.1f}L{LEFT + SIZE + min(shift, 0):.1f} '
                     f'{max(shift, 0):.1f}" stroke="currentColor" stroke-width=".5" stroke-dasharray="3 3"/>')
    for line in lines:
        for pair in line.pairs:
            said = escape(f"{line.solver}, {pair.claim}: computed {pair.computed:.3g}, measured {pair.measured:.3g}")
            parts.append(line.mark.svg(place(pair.measured, 0), place(pair.computed, 1), 2.6, 'fill-opacity=".75"',
                                       f"<title>{said}</title>"))
    box = f"0 -6 {LEFT + SIZE + 8:g} {SIZE + BOTTOM + 6:g}"
    return Markup(f'<svg class="scatter" viewBox="{box}" width="340" role="img" aria-label="computed against measured" '
                  f'fill="currentColor">{"".join(parts)}</svg>')
