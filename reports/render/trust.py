"""How far each model can be trusted with a phenomenon: what was tried, how wrong it was, what it took, where it breaks.

Everything is of the records: parameters, claims, times, and the tables of models side by side. Only which model a case
computes with is read from reports/models.toml.
"""
import dataclasses
import math
import pathlib
import statistics
import tomllib

from render import side_by_side

MODELS = pathlib.Path(__file__).resolve().parent.parent / "models.toml"
SHOWN = 3           # parameters that are shown unasked
COMPARISONS = ("bound", "uncertainty")      # kinds of claims that compare with something
FINE = 0.25         # of what is expected: a claim that allows more bounds something, it tells no error


@dataclasses.dataclass(frozen=True)
class Tried:
    """A parameter, or the size of a model's cells, with the least and the largest value that ran."""
    name: str
    unit: str
    least: float
    most: float


@dataclasses.dataclass
class Comparison:
    """What one claim is off by, as a share of what is expected."""
    record: object
    claim: object
    error: float


@dataclasses.dataclass
class Contest:
    """What the finest resolution of a model did on one of the problems that all models are set."""
    problem: object
    row: object
    sizes: Tried


@dataclasses.dataclass
class Trust:
    """One model on one phenomenon."""
    model: str
    own: bool
    records: list = dataclasses.field(default_factory=list)
    claims: list = dataclasses.field(default_factory=list)          # [(record, claim)]
    contests: list = dataclasses.field(default_factory=list)
    scored: list = dataclasses.field(default_factory=list)          # [(quantity, league.Run)] of somebody else's

    @property
    def tried(self):
        """Parameters with their ranges: first those that were varied, then those with a unit, in the cases' order."""
        ranges = {}
        for record in self.records:
            for name, parameter in record.parameters.items():
                value = parameter["value"]
                if isinstance(value, bool) or not isinstance(value, (int, float)) or not math.isfinite(value):
                    continue
                unit = parameter["unit"]
                least, most = ranges.get((name, unit), (value, value))
                ranges[name, unit] = min(least, value), max(most, value)
        all_of_them = [Tried(name, unit, least, most) for (name, unit), (least, most) in ranges.items()]
        return [contest.sizes for contest in self.contests] + sorted(
            all_of_them, key=lambda one: (one.least == one.most, one.unit in ("", "1")))

    @property
    def comparisons(self):
        """The largest error first; claims that fail, as declared or not, are among the limits."""
        found = [Comparison(record, claim, error) for record, claim in self.claims
                 if claim.verdict == "pass" and claim.kind in COMPARISONS and not claim.id.endswith("-coverage")
                 and (error := share(claim)) is not None]
        return sorted(found, key=lambda one: -one.error)

    @property
    def typical(self):
        return statistics.median(one.error for one in self.comparisons)

    @property
    def kept(self):
        """Laws that hold to round-off."""
        return sum(1 for _, claim in self.claims if claim.kind == "roundoff" and claim.verdict == "pass")

    @property
    def seconds(self):
        """Least and largest time of a run; () where nobody said."""
        times = [record.wall_time for record in self.records if record.wall_time]
        times += [contest.row.cells["processor time"] for contest in self.contests
                  if contest.row.cells["processor time"]]
        return (min(times), max(times)) if times else ()

    @property
    def limits(self):
        """Claims that do not hold, the surprising ones first."""
        return sorted(((record, claim) for record, claim in self.claims if claim.verdict != "pass"),
                      key=lambda one: not one[1].unexpected)

    @property
    def crashed(self):
        return [record for record in self.records if record.status == "error"]

    @property
    def broken(self):
        return [contest for contest in self.contests if contest.row.broke]


def share(claim):
    """|measured - expected| over |expected|; what is expected to be none, if it has no dimension, is a share itself.

    None where it cannot be said, for counts, whose limit is none, and where more than a share FINE is allowed."""
    measured, expected, limit = claim.measured, claim.expected, claim.criterion["limit"]
    if measured is None or expected is None or not limit or not (expected or claim.unit in ("", "1")):
        return None
    whole = abs(expected) or 1.0
    error = abs(measured - expected) / whole
    return error if limit < FINE * whole and math.isfinite(error) else None


class Models:
    """Which model a case computes with, as reports/models.toml says."""

    def __init__(self, path=MODELS):
        names = tomllib.loads(path.read_text(encoding="utf-8"))
        self._words, self._cases = names["words"], names["cases"]
        self._several, self._claims = names["several"]["cases"], names["several"]["claims"]
        self._none = names["none"]["cases"]

    def of_case(self, case):
        """Its name; "" for what several models compute, or none; None for a case that nobody told of."""
        if case in self._several or case in self._none:
            return ""
        words = case.split("_")
        return self._cases.get(case) or next((self._words[word] for word in words if word in self._words), None)

    def is_several(self, case):
        return case in self._several

    def of_claim(self, claim):
        """Of a case of several: the model that the claim's name begins with; "" where it is about all of them."""
        return next((model for word, model in self._claims.items() if claim.startswith(f"{word}-")), "")


def survey(cases, contests, others, models=None):
    """[(phenomenon, [Trust])] of the validations: our models by name, then other solvers.

    @param contests  the problems of side_by_side.survey()
    @param others    the tables of league.survey()
    """
    models = models or Models()
    runs = {run.record.stem: (table.quantity, run) for table in others for run in table.runs}
    groups = {}

    def of(group, model, own):
        return groups.setdefault(group, {}).setdefault((not own, model), Trust(model, own))

    for case in cases:
        for record in case.records:
            if record.kind != "validation":
                continue
            several = record.own and models.is_several(record.case)
            model = record.solver if not record.own else models.of_case(record.case)
            if model is None:
                model = case.first.title
            if model:
                one = of(record.group, model, record.own)
                one.records.append(record)
                if not record.own:
                    one.scored += [runs[record.stem]] if record.stem in runs else []
                one.claims += [(record, claim) for claim in record.claims]
            elif several:
                for claim in record.claims:
                    if name := models.of_claim(claim.id):
                        of(record.group, name, True).claims.append((record, claim))
    for problem in contests:
        for rows in problem.models:
            row = side_by_side.Problem.shown(rows)
            sizes = [one.cells["size"] for one in rows if one.cells["size"] is not None]
            if sizes:
                tried = Tried(row.cells["size of"], problem.units["size"], min(sizes), max(sizes))
                of(problem.record.group, row.cells["model"], True).contests.append(Contest(problem, row, tried))
    return [(group, [trusts[key] for key in sorted(trusts)]) for group, trusts in sorted(groups.items())]


@dataclasses.dataclass(frozen=True)
class Scorable:
    """A case that judges others."""
    phenomenon: str
    name: str
    case: object        # the report's own page of it, if any


def scorable(listed, cases):
    """[(phenomenon, [Scorable])]. @param listed  "phenomenon/case,...", as the command says it"""
    known = {case.name: case for case in cases}
    groups = {}
    for entry in filter(None, listed.split(",")):
        phenomenon, _, name = entry.partition("/")
        groups.setdefault(phenomenon, []).append(Scorable(phenomenon, name, known.get(name)))
    return sorted(groups.items())
