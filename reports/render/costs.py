"""Error against cost, solver by solver: from the ladders of sizes that were scored, and from single runs."""
import dataclasses
import math

from markupsafe import Markup, escape

from render.marks import axes, mark

TABLE = "ladder"                # of a record: a row per size, from coarse to fine; the errors, and the times if stated
WIDTH, HEIGHT, LEFT, BOTTOM = 330.0, 210.0, 58.0, 40.0
ROOM = 0.12                     # decades around the points


@dataclasses.dataclass
class Curve:
    """One solver: what each of its sizes took, and how far it was off."""
    solver: str
    points: list                # [(cost, error)], both positive


@dataclasses.dataclass
class Costs:
    """What a case's solvers paid for their errors."""
    quantity: str
    cost: str                   # what was paid: time [s], or cell [m] where no time was stated
    curves: list


def of(record, what):
    """wall_time [s], threads or a measurement of a record; None where it does not say."""
    if what == "wall_time":
        return record.wall_time or None
    if what == "threads" and record.own:
        return record.provenance["threads"]
    return record.measurements.get(what)


def survey(records):
    """The costs of a case's records; None where no record has a ladder, or the ladders share no quantity."""
    ladders = {record.stem: table for record in records for table in record.tables
               if table["id"] == TABLE and _readable(table)}
    if not ladders:
        return None
    common = [column["name"] for column in next(iter(ladders.values()))["columns"][1:] if column["name"] != "time"
              and all(column["name"] in _names(table) for table in ladders.values())]
    if not common:
        return None
    quantity = common[0]
    timed = any("time" in _names(table) for table in ladders.values())
    cost = "time" if timed else "size"
    curves = []
    for record in records:
        table = ladders.get(record.stem)
        if table is None:
            paid = record.wall_time if timed else record.measurements.get("cell_size")
            points = [(paid, record.measurements.get(f"{quantity}_relative_l2"))]
        elif cost in _names(table):
            points = [(row[_names(table).index(cost)], row[_names(table).index(quantity)]) for row in table["rows"]]
        else:
            points = []
        points = [(x, y) for x, y in points if _positive(x) and _positive(y)]
        if points:
            curves.append(Curve(record.by, points))
    return Costs(quantity, "time [s]" if timed else "cell [m]", curves) if curves else None


def _names(table):
    return [column["name"] for column in table["columns"]]


def _readable(table):
    return (len(table["columns"]) > 1 and table["columns"][0]["name"] == "size"
            and all(len(row) == len(table["columns"]) for row in table["rows"]))


def _positive(value):
    return isinstance(value, (int, float)) and not isinstance(value, bool) and math.isfinite(value) and value > 0


def figure(costs):
    """The curves on logarithmic axes; further down is nearer, further left is cheaper, or coarser where cells are shown."""
    spans = []
    for axis in (0, 1):
        values = [math.log10(point[axis]) for curve in costs.curves for point in curve.points]
        low, high = min(values) - ROOM, max(values) + ROOM
        spans.append((low, high))

    def place(value, axis):
        low, high = spans[axis]
        share = (math.log10(value) - low) / (high - low)
        return LEFT + WIDTH * share if axis == 0 else HEIGHT * (1 - share)

    parts = axes(LEFT, WIDTH, HEIGHT, place, spans, costs.cost, f"error of {costs.quantity}")
    for number, curve in enumerate(costs.curves):
        own = mark(number)
        places = [(place(x, 0), place(y, 1)) for x, y in curve.points]
        if len(places) > 1:
            path = "M" + "L".join(f"{x:.1f} {y:.1f}" for x, y in places)
            parts.append(f'<path d="{path}" fill="none" stroke="{own.colour}" stroke-width="1.4"/>')
        for (x, y), point in zip(places, curve.points):
            said = escape(f"{curve.solver}: {point[1]:.3g} for {point[0]:.3g}")
            parts.append(own.svg(x, y, 3.4, inside=f"<title>{said}</title>"))
    key = "".join(f'<span><b style="color: {mark(number).colour}">{mark(number).letter}</b> {escape(curve.solver)}</span> '
                  for number, curve in enumerate(costs.curves))
    box = f"0 -6 {LEFT + WIDTH + 8:g} {HEIGHT + BOTTOM + 6:g}"
    return Markup(f'<svg class="costs" viewBox="{box}" width="400" role="img" aria-label="error of '
                  f'{escape(costs.quantity)} against {escape(costs.cost)}" fill="currentColor">{"".join(parts)}</svg>'
                  f'<p class="costs">{key}</p>')
