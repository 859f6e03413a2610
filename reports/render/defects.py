"""Planted defects: what was broken on purpose, and which claim noticed, as the last run of ci/checks/defects left it."""
import collections
import csv
import dataclasses
import pathlib

RECORD = pathlib.Path(__file__).resolve().parent.parent / "record" / "defects.csv"


@dataclasses.dataclass
class Planted:
    """A row of the record, with the claim it names where this report holds it."""
    row: dict
    record: object = None
    claim: object = None

    @property
    def found(self):
        return self.row["verdict"] != "not found"

    @property
    def measured(self):
        return float(self.row["measured"]) if self.row["measured"] else None

    @property
    def limit(self):
        return float(self.row["limit"]) if self.row["limit"] else None


def read(path=RECORD):
    """Rows of the record; none where there is no such file."""
    if not path.is_file():
        return []
    with path.open(encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def survey(rows, records):
    """What the page shows: the defects by room, each with its claim in our own record.

    @param records  sorted by file: the first of a case is that of its shortest tier
    """
    by_name = {record.case: record for record in reversed(records) if record.own}
    rooms = collections.defaultdict(list)
    for row in rows:
        name, _, claim_id = row["claim"].partition(": ")
        record = by_name.get(name)
        claim = next((one for one in record.claims if one.id == claim_id), None) if record else None
        rooms[row["defect"].split("/")[0]].append(Planted(row, record, claim))
    planted = [one for members in rooms.values() for one in members]
    return {"rooms": rooms, "count": len(planted), "found": sum(one.found for one in planted),
            "claims": len({one.row["claim"] for one in planted if one.found})}
