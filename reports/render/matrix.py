"""The first screen: the error of one headline quantity for every problem and model, as reports/problems.toml names it.

Errors, verdicts and times are those of the records; a claim that fails counts like any other.
"""
import dataclasses
import fnmatch
import math
import pathlib
import tomllib

from render import experiments, side_by_side

PROBLEMS = pathlib.Path(__file__).resolve().parent.parent / "problems.toml"
STEPS = (0.01, 0.05, 0.1, 0.25)     # of the error, between the shades of a cell
ENERGY = 0.05                       # a relative change of the energy that is said beside the error
UNITS = {"depth": "h", "width": "a"}
TIMES = {"sqrt(depth/g)": " √(h/g)", "sqrt(width/g)": " √(a/g)", "1/strain rate": "/\u2060α"}


@dataclasses.dataclass
class Cell:
    """One model on one problem. error and worst are None where nothing could be measured."""
    record: object
    anchor: str
    error: float | None
    worst: float | None
    readings: int
    uncertainty: float | None = None
    seconds: float | None = None
    flaws: list = dataclasses.field(default_factory=list)       # words: "exceeds limit", "stops at t = 12 √(h/g)", "energy −9 %"
    where: str = ""

    @property
    def shade(self):
        return sum(1 for step in STEPS if self.error is not None and self.error >= step)


@dataclasses.dataclass
class Problem:
    id: str
    title: str
    quantity: str
    evidence: str
    group: str
    words: str
    filters: dict               # {"problem": its family, "quantity": its kind}
    regime: dict
    cells: dict                 # {model id: Cell}
    contest: object             # side_by_side.Problem, or None
    cases: list
    yours: list                 # [league.Run] of other solvers
    stored: list                # [league.Table] of cases with stored results of other solvers
    films: list                 # cases whose films are shown
    longer: dict                # {model id: tier} where only a longer tier than these records' has a number

    @property
    def sorted_cells(self):
        """[(model id, Cell)], the smallest error first, those without a number last."""
        return sorted(self.cells.items(), key=lambda item: math.inf if item[1].error is None else item[1].error)


def regime(height=None, depth=1.0, length=None):
    """kh, H/h and Ursell number (H/h)(L/h)^2; None where undefined."""
    steep = height / depth if height is not None else None
    return {"kh": 2 * math.pi * depth / length if length else None, "H/h": steep,
            "Ur": steep * (length / depth) ** 2 if steep is not None and length else None}


def share(claim, over=None):
    """|measured - expected| over |expected|, or over `over` where that is given.

    None where there is no number, or a difference with a unit has nothing to be divided by."""
    measured, expected = claim.measured, claim.expected
    if measured is None or expected is None:
        return None
    if expected and over is None:
        return abs(measured - expected) / abs(expected)
    if over is None and claim.unit not in ("", "1"):
        return None
    return abs(measured - expected) / (over or 1.0)


def causes(path=PROBLEMS):
    """The causes of known deviations, in the order in which they are asked: title, claims."""
    return tomllib.loads(path.read_text(encoding="utf-8"))["cause"]


def survey(cases, drawn, others, beside=(), path=PROBLEMS):
    """What the first screen, the pages of problems and those of models show.

    @param drawn   {(record stem, figure id): gallery.Drawn}
    @param others  tables of league.survey(); beside  those with stored results too
    """
    said = tomllib.loads(path.read_text(encoding="utf-8"))
    own = {case.name: next((record for record in case.records if record.own), None) for case in cases}
    runs = {table.case.name: [run for run in table.runs if not run.record.own] for table in others}
    by_name = {model["name"]: model["id"] for model in said["model"]}
    problems = [_problem(about, cases, own, runs, beside, drawn, by_name) for about in said["problem"]]
    return {"models": said["model"], "problems": problems, "synonyms": said["synonyms"]}


def _problem(about, cases, own, runs, beside, drawn, by_name):
    cells, contest = {}, None
    if "contest" in about:
        contest = side_by_side.problem(about["id"], about["title"], about["contest"], own.get(about["contest"]), drawn)
        cells = {by_name[rows[-1].cells["model"]]: _of_contest(contest, rows) for rows in contest.models
                 if rows[-1].cells["model"] in by_name}
    for model, what in about.get("cells", {}).items():
        what = {"claims": what} if isinstance(what, str) else what
        case, _, pattern = what["claims"].partition(": ")
        if own.get(case):
            cells[model] = of_claims(own[case], pattern, _number(what.get("over"), own[case]))
    members = [case for case in cases if case.first.kind == "validation" and case.first.group == about["group"]]
    return Problem(about["id"], about["title"], about["quantity"], about["evidence"], about["group"],
                   about.get("words", ""), about["filters"], _regime(about.get("regime", {}), own),
                   {model: cell for model, cell in cells.items() if cell}, contest, members,
                   [run for case in members for run in runs.get(case.name, [])],
                   [table for table in beside if table.case.name in about.get("scored", [])], about.get("films", []),
                   {model: what["tier"] for model, what in about.get("cells", {}).items()
                    if isinstance(what, dict) and "tier" in what and not cells.get(model)})


def _number(value, record):
    """A number, or that of a parameter of the record; None where it has no such parameter."""
    return record.parameters.get(value, {}).get("value") if isinstance(value, str) else value


def _regime(said, own):
    record = own.get(said.get("case"))
    if "case" in said and record is None:
        return regime()
    sizes = {name: _number(said[name], record) for name in ("height", "depth", "length") if name in said}
    if None in sizes.values():
        return regime()
    if said.get("both"):        # an amplitude: from trough to crest it is two
        sizes["height"] *= 2
    return regime(**sizes)


def of_claims(record, pattern, over):
    """The root mean square of the claims that match, or of the readings of an experiment, whose one claim is that of all;
    and the worst; None where none does."""
    read = experiments.of_readings(record, pattern)
    claims = [claim for claim in record.claims if fnmatch.fnmatchcase(claim.id, "agreement" if read else pattern)]
    if not claims:
        return None
    errors = read or [share(claim, over) for claim in claims]
    known = [error for error in errors if error is not None]
    worst = max(known, default=None)
    shown = claims[errors.index(worst)] if known and not read else claims[0]
    cell = Cell(record, f"claim-{shown.id}", math.sqrt(math.fsum(e * e for e in known) / len(known)) if known else None,
                worst, len(errors), seconds=record.wall_time)
    failed = sum(1 for claim in claims if claim.verdict != "pass")
    if failed:
        cell.flaws.append("exceeds limit" if len(claims) == 1 else f"{failed} of {len(claims)} exceed")
    if record.status == "error":
        cell.flaws.append("did not finish")
    return cell


def _of_contest(contest, rows):
    """The finest resolution whose error could be taken."""
    row = contest.shown(rows)
    finest, cells = rows[-1], row.cells
    cell = Cell(contest.record, f"table-{side_by_side.TABLE}", cells["error"], cells["error"], len(rows),
                cells["uncertainty"], cells["processor time"],
                where=f"{cells['size of']} {cells['size']:.3g} {UNITS.get(contest.units['size'], contest.units['size'])}" if cells["size"] is not None else "")
    if finest.broke:
        unit, lasted = contest.units["lasted"], finest.cells["lasted"]
        time = f"t = {lasted:.2g}{TIMES.get(unit, f' {unit}')}".rstrip().replace(" ", "\u00a0") if lasted else ""
        cell.flaws.append(f"stops at {time}" if time else "stops")
    elif cells["energy"] is not None and abs(cells["energy"]) > ENERGY:
        cell.flaws.append(f"energy {100 * cells['energy']:+.0f}\u00a0%".replace("-", "−"))
    return cell


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
