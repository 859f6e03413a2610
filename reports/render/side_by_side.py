"""Which model? Every free-surface model on the same problems, from the tables that the contests of validation write."""
import dataclasses
import math

TABLE = "side_by_side"      # of a record: a row per model and resolution, coarse to fine
FIGURE = "cost"
COLUMNS = ("model", "size of", "size", "error", "uncertainty", "processor time", "energy", "momentum", "lasted",
           "asked", "broke by")
WORDS = ("model", "size of", "broke by")


@dataclasses.dataclass
class Row:
    """One resolution of one model."""
    cells: dict

    @property
    def broke(self):
        return bool(self.cells["broke by"])

    @property
    def failed(self):
        """It broke down before its error could be taken."""
        return self.cells["error"] is None


@dataclasses.dataclass
class Problem:
    """One of the problems, with the models that the report's best record of it has."""
    id: str
    title: str
    case: str
    record: object = None
    reason: str = ""            # why there is no table
    units: dict = dataclasses.field(default_factory=dict)
    models: list = dataclasses.field(default_factory=list)      # [[Row, coarse to fine]]
    drawn: object = None

    @staticmethod
    def shown(rows):
        """The finest whose error could be taken, else the finest."""
        return next((row for row in reversed(rows) if not row.failed), rows[-1])


def problem(name, title, case, record, drawn):
    """The table of a record, or why there is none.

    @param drawn  {(record stem, figure id): gallery.Drawn}
    """
    problem = Problem(name, title, case, record)
    if record is None:
        problem.reason = "This report holds no record of the case."
        return problem
    table = next((table for table in record.tables if table["id"] == TABLE), None)
    if table is None:
        problem.reason = "The run did not finish." if record.status == "error" else "Its record has no such table."
        return problem
    if not _readable(table):
        problem.reason = "The table of its record has other columns."
        return problem
    problem.units = {column["name"]: column["unit"] for column in table["columns"]}
    models = {}
    for cells in table["rows"]:
        row = Row(dict(zip(COLUMNS, cells)))
        models.setdefault(row.cells["model"], []).append(row)
    problem.models = list(models.values())
    problem.drawn = drawn.get((record.stem, FIGURE))
    return problem


def _readable(table):
    return (tuple(column["name"] for column in table["columns"]) == COLUMNS
            and all(len(row) == len(COLUMNS) and all(_fits(name, cell) for name, cell in zip(COLUMNS, row))
                    for row in table["rows"]))


def _fits(name, cell):
    if name in WORDS:
        return isinstance(cell, str)
    return cell is None or (isinstance(cell, (int, float)) and not isinstance(cell, bool) and math.isfinite(cell))
