"""Records: read, checked against the schema, and what follows from their verdicts.

A file that cannot be read or breaks the schema becomes a `Broken` entry; the report shows it, it never disappears.
"""
import dataclasses
import functools
import hashlib
import json
import pathlib
import re

import jsonschema

from render import files, seal
from render.store import digest

SCHEMA = pathlib.Path(__file__).resolve().parent.parent / "schema" / "record.schema.json"
KINDS = ("roundoff", "order", "bound", "uncertainty", "qualitative")
VERDICTS = ("pass", "fail", "inconclusive", "error")
OWN_SOLVER = "seiche"
TIERS = ("quick", "full", "paper")


def slug(text):
    """A name for files and anchors; distinct texts keep distinct slugs."""
    plain = re.sub(r"[^A-Za-z0-9_.-]+", "-", text)
    return plain if plain == text else f"{plain}-{digest(text)[:6]}"


@dataclasses.dataclass(frozen=True)
class Broken:
    """A file that should have been a record."""
    file: str
    reasons: list


@dataclasses.dataclass
class Claim:
    """One claim of a record, with what its verdict means."""
    raw: dict

    def __getattr__(self, name):
        return self.raw[name]

    @property
    def kind(self):
        return self.raw["criterion"]["kind"]

    @property
    def unexpected(self):
        """Another verdict than declared, or a declared failure of another size."""
        return not self.raw["as_declared"]

    @property
    def declared_failure(self):
        """Verdict other than pass that was declared beforehand, with its reason."""
        return not self.unexpected and self.raw["verdict"] != "pass"


class Record:
    """One run of one case by one solver."""

    def __init__(self, file, raw):
        self.file = file
        self.raw = raw
        self.stem = pathlib.PurePath(file).stem      # names the files that belong to it; unique in the directory
        self.claims = [Claim(claim) for claim in raw["claims"]]
        self.sheet = ""         # of a verification: what its page is called beside its group, "-2" of the second

    def __getattr__(self, name):
        if name.startswith("__") or name == "raw":
            raise AttributeError(name)
        return self.raw[name]

    @property
    def own(self):
        return self.raw["solver"] == OWN_SOLVER

    @property
    def page(self):
        """Where the report shows it: validation case by case, verification by group."""
        if self.raw["kind"] == "validation":
            return f"cases/{self.raw['case']}.html"
        return f"verification/{slug(self.raw['group'])}{self.sheet}.html"

    @property
    def shown(self):
        """Its figures that the report draws: of a verification those where a claim fails or an order is fitted, and tiles."""
        tells = self.raw["kind"] == "validation" or any(c.verdict != "pass" or c.kind == "order" for c in self.claims)
        return [figure for figure in self.raw["figures"] if tells or figure["atlas"]]

    @property
    def by(self):
        """Whose it is, where a page shows several: the solver, and the published set or the tier if not the quick one."""
        which = self.raw["set"] or (self.raw["tier"] if self.raw["tier"] != TIERS[0] else "")
        return self.raw["solver"] + (f", {which}" if which else "")

    @property
    def standard(self):
        """Every parameter has the tier's default, or a published set's value."""
        return bool(self.raw["set"]) or all(p["value"] == p["default"] for p in self.raw["parameters"].values())

    def published_set(self, tile):
        """The parameters of the source for a tile, as the record names them; None where it names none."""
        return next((one for one in self.raw["published"] if tile in one["tiles"]), None)

    @property
    def at_source(self):
        """It ran with the parameters of a source."""
        return any(one["here"] for one in self.raw["published"])

    @property
    def tiles(self):
        named = list(self.raw["atlas"])
        for part in self.raw["figures"] + self.raw["tables"]:
            named += part["atlas"]
        return list(dict.fromkeys(named))

    @property
    def worst(self):
        """Verdict of the whole record: the worst of its claims; error when it did not finish."""
        if self.raw["status"] == "error":
            return "error"
        order = ("pass", "inconclusive", "fail", "error")
        return max((claim.verdict for claim in self.claims), key=order.index, default="none")

    @property
    def unexpected(self):
        return self.raw["status"] == "error" or any(claim.unexpected for claim in self.claims)


@dataclasses.dataclass
class Case:
    """All records of one case: the suite's own first, the best of them before others (with the parameters of a source,
    of the longest tier), then other solvers by name."""
    name: str
    records: list

    @property
    def first(self):
        return self.records[0]

    @property
    def peers(self):
        return len(self.records) > 1


def _refuse_constant(text):
    raise ValueError(f"{text} is not JSON: a number that is not finite is written as null")


@functools.cache
def _validator():
    return jsonschema.Draft202012Validator(json.loads(SCHEMA.read_text(encoding="utf-8")))


def violations(raw):
    """Sentences naming where `raw` breaks the schema; empty when it does not."""
    found = []
    for error in _validator().iter_errors(raw):
        place = "/".join(str(step) for step in error.absolute_path) or "record"
        message = error.message if len(error.message) < 300 else error.message[:300] + " …"
        found.append(f"{place}: {message}")
    return sorted(found)


def load(directory, memo):
    """All records of a directory.

    @param memo  memo(kind, key, function) keeps the verdict of the schema between runs
    @returns     (records sorted by case and solver, broken files)
    """
    schema = hashlib.sha256(SCHEMA.read_bytes()).hexdigest()
    records, broken, taken = [], [], {}
    for path in sorted(pathlib.Path(directory).glob("*.json")):
        try:
            text = files.read_text(path)
            raw = json.loads(text, parse_constant=_refuse_constant)
            json.dumps(raw, ensure_ascii=False).encode("utf-8")     # half a surrogate pair is no text
            key = hashlib.sha256(text.encode("utf-8")).hexdigest() + schema
            reasons = memo("schema", key, lambda: violations(raw))
            if not reasons and "digest" in raw and not seal.is_sealed(text):
                reasons = ["changed after it was written: its digest differs"]
        except (OSError, ValueError, RecursionError) as error:
            broken.append(Broken(path.name, [f"{type(error).__name__}: {error}"]))
            continue
        if not reasons:
            owner = taken.setdefault((raw["case"], raw["solver"], raw["tier"], raw["set"]), path.name)
            if owner != path.name:
                reasons = [f"{owner} is already the {raw['set'] or raw['tier']} record of case {raw['case']} by "
                           f"solver {raw['solver']}"]
        if reasons:
            broken.append(Broken(path.name, reasons))
        else:
            records.append(Record(path.name, raw))
    return records, broken


def cases(records):
    """Records gathered by case; validation before verification, groups by name, cases by name."""
    gathered = {}
    for record in records:
        gathered.setdefault(record.case, []).append(record)
    result = []
    for name, members in gathered.items():
        result.append(Case(name, sorted(members, key=lambda record: (
            not record.own, record.solver, not record.at_source, -TIERS.index(record.tier), record.set))))
    return sorted(result, key=lambda case: (case.first.kind, case.first.group, case.name))
