"""Solvers beside each other: for every case that scored somebody else's result, error, cost and order.

The order is that of the shown quantity in the ladder of sizes that was scored. Runs with several cells may also be
records of several names, as in interFoam-16 and interFoam-32: where the numbers are those of the cells to one length,
what stands before them is the solver (interFoam-2206 and interFoam-2312 are two), and the order is the slope of
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

SAME_LENGTH = 0.05      # relative difference of number times cell: a cell is stated with two digits


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


def solvers_of(records):
    """The solver of each record: interFoam of interFoam-16 and interFoam-32 where number times cell is the same."""
    split = [None if record.own else re.fullmatch(r"(.+)[-_](\d+)", record.solver) for record in records]
    lengths = collections.defaultdict(list)
    for record, parts in zip(records, split):
        if parts:
            lengths[parts[1]].append(int(parts[2]) * (record.measurements.get("cell_size") or math.nan))
    sizes = {stem for stem, found in lengths.items()
             if all(abs(length - found[0]) <= SAME_LENGTH * found[0] for length in found)}
    return [record.by if record.own else parts[1] if parts and parts[1] in sizes else record.solver
            for record, parts in zip(records, split)]


def error_names(records):
    """What the error is, the measurements that say it, one per gauge or time, and the quantity: the first of all."""
    for pattern, words in ERRORS.items():
        found = [[name for name in record.measurements if re.fullmatch(pattern, name)] for record in records]
        if all(found):
            first = re.fullmatch(pattern, found[0][0])
            stem = first[1] if first.re.groups else None
            names = [name for name in found[0] if stem is None or re.fullmatch(pattern, name)[1] == stem]
            return words.format(stem), names, stem
    return "", [], None


def error_of(record, names):
    """The largest of them; None where one is missing."""
    values = [record.measurements.get(name) for name in names]
    return max(map(abs, values)) if values and all(value is not None for value in values) else None


def order_of(runs):
    """Of the runs; None for fewer than two sizes, or an error that is zero."""
    points = [(math.log(run.cell), math.log(run.error)) for run in runs if run.cell and run.error]
    mean_x, mean_y = (sum(p[k] for p in points) / max(len(points), 1) for k in (0, 1))
    spread = sum((x - mean_x) ** 2 for x, _ in points)
    return sum((x - mean_x) * (y - mean_y) for x, y in points) / spread if spread > 0 else None


def table(case):
    scored = [record for record in case.records if not record.own]
    words, names, quantity = error_names(scored)
    runs = [Run(record, solver, record.measurements.get("cell_size"), error_of(record, names),
                record.measurements.get(f"ladder_order_{quantity}"))
            for record, solver in zip(case.records, solvers_of(case.records))]
    by_solver = collections.OrderedDict()
    for run in runs:
        by_solver.setdefault(run.solver, []).append(run)
    ordered = []
    for members in by_solver.values():
        members.sort(key=lambda run: -(run.cell or math.inf))
        if all(run.order is None for run in members):
            members[-1].order = order_of(members)
        ordered += members
    return Table(case, "largest " + words if len(names) > 1 else words, ordered, costs.survey(case.records))


def survey(cases):
    """Tables of the cases that have a record of somebody else."""
    return [table(case) for case in cases if any(not record.own for record in case.records)]
