"""Solvers beside each other: for every case that scored somebody else's result, error, cost and order.

The order is that of the ladder of sizes that was scored. Runs with several cells may also be records of several names,
as in interFoam-16 and interFoam-32: what stands before the last number is the solver, and the order is the slope of
log(error) over log(cell), by least squares. It says how far the error falls with the cells that were used, not what it
would do in the limit.
"""
import collections
import dataclasses
import math
import re

from render import costs

# Measurements that say how far a result is off, the first that all share; a suffix names the gauge or the time.
ERRORS = {r"rms_shifted": "rms of the front, shifted", r"(\w+?)_relative_l1(_\w+)?": "relative L1 error of {}",
          r"(\w+?)_relative_l2(_\w+)?": "relative L2 error of {}", r"(\w+?)_relative_error": "relative error of {}"}


@dataclasses.dataclass
class Run:
    """One record as a row."""
    record: object
    solver: str
    cell: float | None
    error: float | None
    order: float | None = None


@dataclasses.dataclass
class Table:
    """One case: its runs, our own first, then by solver and from coarse to fine."""
    case: object
    quantity: str
    runs: list
    costs: object = None        # costs.Costs, where somebody scored several sizes


def solver_of(name):
    """interFoam of interFoam-32."""
    return re.sub(r"[-_]\d+$", "", name)


def error_names(records):
    """What the error is, and the measurements that say it, one per gauge or time: of the first quantity of all."""
    for pattern, words in ERRORS.items():
        found = [[name for name in record.measurements if re.fullmatch(pattern, name)] for record in records]
        if all(found):
            first = re.fullmatch(pattern, found[0][0])
            stem = first[1] if first.re.groups else None
            names = [name for name in found[0] if stem is None or re.fullmatch(pattern, name)[1] == stem]
            return words.format(stem), names
    return "", []


def error_of(record, names):
    """The largest of them; None where one is missing."""
    values = [record.measurements.get(name) for name in names]
    return max(map(abs, values)) if values and all(value is not None for value in values) else None


def order_of(runs):
    """Of the finest's ladder, or of the runs; None for fewer than two sizes, or an error that is zero."""
    of_ladder = costs.of(runs[-1].record, "order")
    if of_ladder is not None:
        return of_ladder
    points = [(math.log(run.cell), math.log(run.error)) for run in runs if run.cell and run.error]
    mean_x, mean_y = (sum(p[k] for p in points) / max(len(points), 1) for k in (0, 1))
    spread = sum((x - mean_x) ** 2 for x, _ in points)
    return sum((x - mean_x) * (y - mean_y) for x, y in points) / spread if spread > 0 else None


def table(case):
    scored = [record for record in case.records if not record.own]
    quantity, names = error_names(scored)
    runs = [Run(record, record.by if record.own else solver_of(record.solver), record.measurements.get("cell_size"),
                error_of(record, names)) for record in case.records]
    by_solver = collections.OrderedDict()
    for run in runs:
        by_solver.setdefault(run.solver, []).append(run)
    ordered = []
    for members in by_solver.values():
        members.sort(key=lambda run: -(run.cell or 0))
        members[-1].order = order_of(members)
        ordered += members
    return Table(case, "largest " + quantity if len(names) > 1 else quantity, ordered,
                 costs.survey(case.records))


def survey(cases):
    """Tables of the cases that have a record of somebody else."""
    return [table(case) for case in cases if any(not record.own for record in case.records)]
