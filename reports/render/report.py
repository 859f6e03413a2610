"""Builds the whole report in an empty directory: read, draw, typeset, copy."""
import importlib.util
import pathlib
import shutil

from markupsafe import Markup

from render import (atlas, badge, coverage, experiments, files, gallery, league, matrix, mutants, pages, printed,
                    records, seal, search, sharpness, speed)
from render.formulas import Formulas
from render.records import Broken
from render.store import MARKER, Store, user_cache
from render.text import Typesetter

PAGES = {"cases": "Cases and tests", "agreement": "Data agreement", "atlas": "Figures of the sources",
         "formulas": "Formulas as printed and as solved", "league": "Solvers", "deviations": "Known deviations",
         "quality": "Test quality", "reading": "How to read", "provenance": "Provenance"}
_HERE = pathlib.Path(__file__).resolve().parent
SHEET = 170_000    # bytes of tests on a page of the verification, beside its frame


def build(evidence, stage, out, options):
    """@param stage  empty directory to fill     @param out  where the report will be
    @returns one sentence for the terminal"""
    store = Store(user_cache(), out.resolve())
    loaded, broken = records.load(evidence, store.memo)
    surveys = {record.stem: gallery.survey(evidence, record, store) for record in loaded}
    drawn = gallery.draw_all(evidence, loaded, surveys, store, options.jobs)
    typesetter = Typesetter(store.memo, Formulas(store.memo).html)

    sources = atlas.read()
    unknown = atlas.fill(sources, loaded, drawn, atlas.kept_sets())
    titles = {tile.id: (source, tile) for source, members in sources for tile in members}
    cases = records.cases(loaded)
    problems = _problems(loaded, surveys, drawn, unknown, evidence)
    fonts = _fonts(stage)
    others = league.survey(cases)
    beside = league.survey(cases, league.stored())
    shared = {"title": options.title, "fonts": fonts, "surveys": surveys, "drawn": drawn,
              "with_data": options.with_data, "menu": _menu(bool(beside))}
    write = _Writer(pages.environment(typesetter, store.folder), stage, shared)
    sheets = _sheets(cases, write, broken)
    made = [case for case in cases if _made(case, cases, drawn, titles, write, broken)]
    kept = {case.name for case in made}
    cases = [case for case in cases if case.name in kept or case.first.kind != "validation"]
    counts = atlas.count(sources)
    whole = {"summary": pages.overview(cases, broken, problems), "kinds": pages.grouped(cases), "sources": sources,
             "counts": counts, "counts_in_words": atlas.in_words(counts), "strip": atlas.strip(sources),
             "has_junit": files.is_regular(evidence / "junit.xml"),
             "sharpness": sharpness.survey([record for case in cases for record in case.records if record.own]),
             "mutants": mutants.survey(mutants.read()), "experiments": experiments.survey(loaded),
             "speed": speed.survey(speed.read(), speed.build_time()),
             "rooms": coverage.survey(coverage.read()), "wanted_lines": coverage.WANTED, "LOOSEST": sharpness.SHOWN,
             "sharpness_limits": {"marginal": sharpness.MARGINAL, "loose": sharpness.LOOSE},
             "formulas": printed.survey(sources, cases),
             "matrix": matrix.survey(cases, drawn, others, beside), "scorable": matrix.scorable(options.scorable, cases),
             "others": len(others), "league": beside}
    write("index.html.j2", "index.html", "", **whole)
    for name, words in PAGES.items():
        if name != "league" or beside:
            write("page.html.j2", f"{name}.html", "", body=name, heading=words, **whole)
    for problem in whole["matrix"]["problems"]:
        write("page.html.j2", f"problems/{problem.id}.html", "../", body="problem", heading=problem.title, problem=problem, **whole)
    for model in whole["matrix"]["models"]:
        write("page.html.j2", f"models/{model['id']}.html", "../", body="model", heading=model["title"], model=model, **whole)
    for page, members in sheets.items():
        first = members[0][0]
        write("page.html.j2", page, "../", body="verification", heading=pages.capital(first.group) + first.sheet.replace("-", " "),
              claims=[claim for record, _ in members for claim in record.claims], members=members,
              siblings=[other for other, of in sheets.items() if of[0][0].group == first.group], **whole)
    if options.pdf:
        write("print.html.j2", "print.html", "", **whole)
    search.write(stage / "assets" / "search.js", whole["matrix"], cases)

    for asset in ("report.css", "report.js", "figure.js"):
        _copy(_HERE / "assets" / asset, stage / "assets" / asset)
    _copy_figures(loaded, drawn, stage)
    for tile in (tile for _, members in sources for tile in members if tile.plate):
        _copy(tile.plate, stage / "figures" / tile.plate.name)
    if options.with_data:
        _copy_data(evidence, loaded, broken, stage / "data")
    badge.write(stage / "badge.json", cases, broken)
    (stage / MARKER).write_text("A report made by reports/render; replaced as a whole by its next run.\n")
    store.save()
    return (f"{pages.plural(whole['summary']['claims'], 'claim')} in {pages.plural(len(cases), 'case')}, "
            f"{whole['summary']['unexpected_count']} unexpected, {pages.plural(len(broken), 'broken record')}, "
            f"of {counts['all']} figures {atlas.in_words(counts)}")


def _menu(others):
    """[(page, words)] of the links above every page."""
    return [("index.html", "Overview")] + [(f"{name}.html", words) for name, words in PAGES.items()
                                           if name not in ("provenance", "formulas") and (others or name != "league")]


def _sheets(cases, write, broken):
    """{page: [(record, its test as HTML)]} of the verification: a group begins a page, and goes on where one is full."""
    sheets = {}
    for _, members in dict(pages.grouped(cases)).get("verification", []):
        size, number = 0, 1
        for record in (record for case in members for record in case.records):
            part = write.part("verification_body.html.j2", record, broken)
            size += len(part.encode())
            if size > SHEET and size > len(part.encode()):
                size, number = len(part.encode()), number + 1
            record.sheet = f"-{number}" if number > 1 else ""
            sheets.setdefault(record.page, []).append((record, part))
    return sheets


def _made(case, cases, drawn, titles, write, broken):
    """Writes the page of a validation case; whether it could be: a record that passed the check but cannot be set is
    shown, not hidden."""
    if case.first.kind != "validation":
        return False
    position, own = cases.index(case), [one for one in cases if one.first.kind == "validation"]
    try:
        write("case.html.j2", case.first.page, "../", **pages.case_view(case, drawn, titles),
              before=own[position - 1] if position else None, after=own[position + 1] if position + 1 < len(own) else None)
        return True
    except Exception as error:
        reason = f"{type(error).__name__}: {error}"
        write("broken.html.j2", case.first.page, "../", case=case, reason=reason)
        broken += [Broken(record.file, [f"page not made: {reason}"]) for record in case.records]
        return False


class _Writer:
    """Renders a template into a page."""

    def __init__(self, environment, stage, shared):
        self._environment, self._stage, self._shared = environment, stage, shared

    def __call__(self, template, name, root, **context):
        html = self._environment.get_template(template).render(root=root, page=name, **self._shared, **context)
        target = self._stage / name
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(html, encoding="utf-8")

    def part(self, template, record, broken):
        """The test of one record as HTML; the reason where it cannot be set."""
        try:
            part = self._environment.get_template(template).make_module({"root": "../", "page": record.page, **self._shared})
            return part.test(record)
        except Exception as error:
            reason = f"page not made: {type(error).__name__}: {error}"
            broken.append(Broken(record.file, [reason]))
            return Markup("<p class=missing>{}</p>").format(reason)


def _problems(loaded, surveys, drawn, unknown, evidence):
    """Sentences about what the report itself could not show, each with its record."""
    found = []
    for record in loaded:
        if surveys[record.stem]["problem"]:
            found.append((record, surveys[record.stem]["problem"]))
        for figure in record.shown:
            problem = drawn[record.stem, figure["id"]].problem
            if problem and problem != surveys[record.stem]["problem"]:
                found.append((record, f"figure “{figure['id']}”: {problem}"))
        if record.fields and not files.is_regular(evidence / record.fields):
            found.append((record, f"{record.fields} is missing"))
        elif record.fields and (stranger := seal.stranger_beside(evidence, record.raw, record.fields)):
            found.append((record, stranger))
        if "digest" not in record.raw:
            found.append((record, "it carries no digest: a change after it was written would not be seen"))
    return found + [(record, f"no tile of the atlas is called “{name}”") for record, name in unknown]


def _fonts(stage):
    """Copies the STIX faces that come with matplotlib, so that text and formulas match; False where there are none."""
    spec = importlib.util.find_spec("matplotlib")
    if spec is None:
        return False
    places = [pathlib.Path(spec.origin).parent / "mpl-data", pathlib.Path("/usr/share/matplotlib/mpl-data")]
    for place in places:
        folder = place / "fonts" / "ttf"
        names = ("STIXGeneral.ttf", "STIXGeneralItalic.ttf", "STIXGeneralBol.ttf", "LICENSE_STIX")
        if all((folder / name).is_file() for name in names):
            for name in names:
                _copy(folder / name, stage / "assets" / name)
            return True
    return False


def _copy_figures(loaded, drawn, stage):
    for record in loaded:
        for figure in record.shown:
            result = drawn[record.stem, figure["id"]]
            if result.path is not None:
                folder = stage / "figures" / pages.slug(record.stem)
                _copy(result.path, folder / f"{figure['id']}.svg")
                if result.thumb is not None:
                    _copy(result.thumb, folder / f"{figure['id']}.thumb.svg")


def _copy_data(evidence, loaded, broken, target):
    """Records, arrays and fields, so that the report can be moved as one folder."""
    names = {record.file for record in loaded} | {entry.file for entry in broken} | {"junit.xml"}
    names |= {name for record in loaded for name in (record.data, record.fields) if name}
    target.mkdir(parents=True, exist_ok=True)
    for name in sorted(names):
        if files.is_regular(evidence / name):
            _copy(evidence / name, target / name)


def _copy(source, target):
    target.parent.mkdir(parents=True, exist_ok=True)
    shutil.copy2(source, target)
