"""Solvers beside each other: for every case that scored somebody else's result, error, cost and order.

The order is that of the shown quantity in the series of sizes that was scored (`--sizes`).

`python3 -m render.league FOLDER... SOLVER=VERSION...` prints the results of folders of records as the table
reports/record/solvers.csv, from which the report shows, and `seiche score` ranks by, what is not in the evidence.
"""
import collections
import csv
import dataclasses
import math
import pathlib
import re
import sys
import types

from render import costs, files, records

# Measurements that say how far a result is off, the first that all share; a suffix names the gauge or the time.
ERRORS = {r"rms_shifted": "rms of the front, shifted", r"(readings)_relative_l1": "relative difference that all {} share",
          r"(\w+?)_relative_l1(_.+)?": "relative L1 error of {}",
          r"(\w+?)_relative_l2(_.+)?": "relative L2 error of {}", r"(\w+?)_relative_error(_.+)?": "relative error of {}"}
STORED = files.RECORD / "solvers.csv"
COLUMNS = ("case", "settings", "quantity", "solver", "version", "cell", "error", "order", "seconds", "met", "claims", "machine",
           "date")


@dataclasses.dataclass
class Run:
    """One record as a row."""
    record: object
    cell: float | None
    error: float | None
    order: float | None


@dataclasses.dataclass
class Table:
    """One case: its runs, our own first, then by solver."""
    case: object
    quantity: str
    runs: list
    costs: object = None        # costs.Costs, where somebody scored several sizes


def measured(record):
    """Its measurements; of an experiment the difference that its readings share, for a curve holds the gate's time too."""
    shared = [] if isinstance(record.claims, str) else [claim for claim in record.claims if claim.id == "agreement"]
    return {"readings_relative_l1": shared[0].measured} if shared else record.measurements


def error_names(scored):
    """What the error is, the pattern of the measurements that say it, and the quantity: the first that all have."""
    for pattern, words in ERRORS.items():
        found = [[name for name in measured(record) if re.fullmatch(pattern, name)] for record in scored]
        if all(found):
            first = re.fullmatch(pattern, found[0][0])
            stem = first[1] if first.re.groups else None
            several = len(of_quantity(scored[0], pattern, stem)) > 1
            return ("largest " if several else "") + words.format(stem), pattern, stem
    return "", "", None


def of_quantity(record, pattern, stem):
    """Its errors, one per gauge or time."""
    return [value for name, value in measured(record).items()
            if (match := re.fullmatch(pattern, name)) and (stem is None or match[1] == stem)]


def error_of(record, pattern, stem):
    """The largest of them; None where one is missing."""
    values = of_quantity(record, pattern, stem)
    return max(map(abs, values)) if values and all(value is not None for value in values) else None


def table(case):
    words, pattern, quantity = error_names([record for record in case.records if not record.own])
    runs = [Run(record, record.measurements.get("cell_size"), error_of(record, pattern, quantity),
                record.measurements.get(f"ladder_order_{quantity}")) for record in case.records]
    return Table(case, words, runs, costs.survey(case.records))


def survey(cases, kept=None):
    """Tables of the cases that have a result of somebody else: a record, or one of those kept, as stored() has them."""
    shown = []
    for case in cases:
        known = {record.solver for record in case.records}
        more = [one for one in (kept or {}).get(case.name, ()) if one.solver not in known]
        if more or any(not record.own for record in case.records):
            shown.append(table(dataclasses.replace(case, records=case.records + more)))
    return shown


def stored(path=STORED):
    """{case: [what a record would say]} of the stored results."""
    cases = collections.defaultdict(dict)
    for row in files.table(path):
        by = f"{row['solver']} {row['version']}" + (f" ({row['settings']})" if row["settings"] else "")
        one = cases[row["case"]].setdefault(by, types.SimpleNamespace(
            own=False, solver=row["solver"], by=by, stem="", tables=[], claims=f"{row['met']} of {row['claims']} met",
            wall_time=_number(row["seconds"]), measurements={"cell_size": _number(row["cell"])}))
        one.measurements |= {f"{row['quantity']}_relative_l1": _number(row["error"]),
                             f"ladder_order_{row['quantity']}": _number(row["order"])}
    return {name: list(found.values()) for name, found in cases.items()}


def _number(text):
    return float(text) if text else None


def rows_of(record, versions):
    """A row for every quantity with a relative error: of a curve in L1, the largest over gauges and instants."""
    errors = collections.defaultdict(list)
    for name, value in measured(record).items():
        if found := re.fullmatch(r"(\w+?)_relative_(?:l1|error)(?:_.+)?", name):
            errors[found[1]].append(math.inf if value is None else abs(value))
    solver = record.solver
    settings = ""
    if record.own:      # of its own discretisation are the parameters, not of the problem
        solver = " ".join(["seiche", *(str(p["value"]) for name, p in record.parameters.items() if name == "scheme")])
    else:
        settings = ";".join(f"{name}={_setting(p['value'])}" for name, p in sorted(record.parameters.items())
                            if p["value"] != p["default"])
    told = record.provenance
    cell = record.measurements.get("cell_size", record.parameters.get("cell", {}).get("value"))
    for quantity, values in sorted(errors.items()):
        yield dict(zip(COLUMNS, (
            record.case, settings, quantity, solver, versions.get(record.solver, told["version"]),
            _digits(cell), _digits(max(values)),
            _digits(record.measurements.get(f"ladder_order_{quantity}")), _digits(record.wall_time),
            sum(claim.verdict == "pass" for claim in record.claims), len(record.claims), told["processor"],
            told["date"][:10])))


def _setting(value):
    """As `seiche score` writes it, which looks for results with the settings of its own."""
    return str(value).lower() if isinstance(value, bool) else str(value).removesuffix(".0")


def _digits(number):
    return "" if number is None else f"{number:.4g}"


def main(words):
    versions = dict(word.split("=") for word in words if "=" in word)
    loaded = [record for word in words if "=" not in word for record in records.load(pathlib.Path(word), lambda kind, key, ask: ask())[0]]
    writer = csv.DictWriter(sys.stdout, COLUMNS, lineterminator="\n")
    writer.writeheader()
    rows = (row for record in loaded for row in rows_of(record, versions))
    writer.writerows(sorted(rows, key=lambda row: [row[name] for name in ("case", "settings", "quantity", "solver")]))


if __name__ == "__main__":
    main(sys.argv[1:])
