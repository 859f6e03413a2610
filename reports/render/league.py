"""Solvers beside each other: for every case that scored somebody else's result, error, cost and order.

What is compared, and at which settings, the records say (`standing`, reports/evidence/standing.hpp). The order is that
of the shown quantity in the series of sizes that was scored (`--sizes`).

`python3 -m render.league FOLDER... SOLVER=VERSION...` prints the results of folders of records as the table
reports/record/solvers.csv, from which the report shows, and `seiche score` ranks by, what is not in the evidence.
"""
import collections
import csv
import dataclasses
import pathlib
import sys
import types

from render import costs, files, records

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
    quantity: str = ""          # of the error, where not all have the same

    @property
    def missing(self):
        """Why there is no error."""
        if self.error is not None:
            return ""
        return "see its claims" if self.record.own else "not found"


@dataclasses.dataclass
class Table:
    """One case: its runs, our own first, then by solver."""
    case: object
    quantity: str
    runs: list
    costs: object = None        # costs.Costs, where somebody scored several sizes


def errors_of(record):
    return record.raw.get("standing", {}).get("errors", {})


def table(case):
    """Shows the first quantity that all others have; where there is none, of each its first."""
    others = [errors_of(record) for record in case.records if not record.own]
    quantity = next((name for name in others[0] if all(name in errors for errors in others)), "")
    runs = []
    for record in case.records:
        own = quantity or min(errors_of(record), default="")
        runs.append(Run(record, record.measurements.get("cell_size"), errors_of(record).get(own),
                        record.measurements.get(f"ladder_order_{own}"), "" if quantity else own))
    return Table(case, quantity, runs, costs.survey(case.records))


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
            wall_time=_number(row["seconds"]), measurements={"cell_size": _number(row["cell"])},
            raw={"standing": {"errors": {}}}))
        errors_of(one)[row["quantity"]] = _number(row["error"])
        one.measurements[f"ladder_order_{row['quantity']}"] = _number(row["order"])
    return {name: list(found.values()) for name, found in cases.items()}


def _number(text):
    return float(text) if text else None


def rows_of(record, versions):
    """A row for every quantity that is compared; our own are told apart by their scheme."""
    scheme = [str(p["value"]) for name, p in record.parameters.items() if name == "scheme"] if record.own else []
    told = record.provenance
    cell = record.measurements.get("cell_size", record.parameters.get("cell", {}).get("value"))
    for quantity, error in sorted(errors_of(record).items()):
        yield dict(zip(COLUMNS, (
            record.case, record.standing["settings"], quantity, " ".join([record.solver, *scheme]),
            versions.get(record.solver, told["version"]), _digits(cell), _digits(error),
            _digits(record.measurements.get(f"ladder_order_{quantity}")), _digits(record.wall_time or None),
            sum(claim.verdict == "pass" for claim in record.claims), len(record.claims),
            told["processor"] if record.wall_time else "",     # a run of others: nobody has told where
            told["date"][:10])))


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
