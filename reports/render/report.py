"""Builds the whole report in an empty directory: read, draw, typeset, copy."""
import importlib.util
import pathlib
import shutil

from render import (atlas, badge, coverage, experiments, files, gallery, league, mutants, pages, records, seal,
                    sharpness, side_by_side, speed, trust)
from render.formulas import Formulas
from render.records import Broken
from render.store import MARKER, Store, user_cache
from render.text import Typesetter

_HERE = pathlib.Path(__file__).resolve().parent


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
    shared = {"has_others": bool(others), "title": options.title, "fonts": fonts, "surveys": surveys, "drawn": drawn}
    environment = pages.environment(typesetter)

    write = _Writer(environment, stage, shared)
    views = {}
    for position, case in enumerate(cases):
        view = pages.case_view(case, drawn, titles)
        around = {"before": cases[position - 1] if position else None,
                  "after": cases[position + 1] if position + 1 < len(cases) else None}
        try:
            write("case.html.j2", f"cases/{case.name}.html", "../", **view, **around)
            views[case.name] = view
        except Exception as error:      # a record that passed the check but cannot be set: shown, not hidden
            reason = f"{type(error).__name__}: {error}"
            write("broken.html.j2", f"cases/{case.name}.html", "../", case=case, reason=reason)
            broken += [Broken(record.file, [f"page not made: {reason}"]) for record in case.records]
    cases = [case for case in cases if case.name in views]
    summary = pages.overview(cases, broken, problems)
    counts = atlas.count(sources)
    whole = {"summary": summary, "kinds": pages.grouped(cases), "sources": sources, "counts": counts,
             "counts_in_words": atlas.in_words(counts), "has_junit": files.is_regular(evidence / "junit.xml"),
             "sharpness": sharpness.survey([record for case in cases for record in case.records if record.own]),
             "mutants": mutants.survey(mutants.read()), "experiments": experiments.survey(loaded),
             "models": side_by_side.survey(cases, drawn), "speed": speed.survey(speed.read(), speed.build_time()),
             "rooms": coverage.survey(coverage.read()), "wanted_lines": coverage.WANTED,
             "sharpness_limits": {"marginal": sharpness.MARGINAL, "loose": sharpness.LOOSE}}
    whole["trust"] = trust.survey(cases, whole["models"]["problems"], others)
    whole["scorable"] = trust.scorable(options.scorable, cases)
    whole["others"] = len(others)
    write("index.html.j2", "index.html", "", **whole)
    write("atlas.html.j2", "atlas.html", "", **whole)
    write("models.html.j2", "models.html", "", **whole)
    if others:
        write("league.html.j2", "league.html", "", league=others, **whole)
    write("sharpness.html.j2", "sharpness.html", "", **whole)
    write("mutants.html.j2", "mutants.html", "", **whole)
    write("speed.html.j2", "speed.html", "", **whole)
    write("coverage.html.j2", "coverage.html", "", **whole)
    write("experiments.html.j2", "experiments.html", "", **whole)
    write("reading.html.j2", "reading.html", "", **whole)
    if options.pdf:
        write("print.html.j2", "print.html", "", views=views, **whole)

    for asset in ("report.css", "report.js"):
        _copy(_HERE / "assets" / asset, stage / "assets" / asset)
    _copy_figures(loaded, drawn, stage)
    _copy_data(evidence, loaded, broken, stage / "data")
    badge.write(stage / "badge.json", cases, broken)
    (stage / MARKER).write_text("A report made by reports/render; replaced as a whole by its next run.\n")
    store.save()
    return (f"{pages.plural(summary['claims'], 'claim')} in {pages.plural(len(cases), 'case')}, "
            f"{summary['unexpected_count']} unexpected, {pages.plural(len(broken), 'broken record')}, "
            f"{counts['reproduced']} of {counts['all']} tiles reproduced, {counts['reduced']} at reduced size")


class _Writer:
    """Renders a template into a page."""

    def __init__(self, environment, stage, shared):
        self._environment, self._stage, self._shared = environment, stage, shared

    def __call__(self, template, name, root, **context):
        html = self._environment.get_template(template).render(root=root, page=name, **self._shared, **context)
        target = self._stage / name
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(html, encoding="utf-8")


def _problems(loaded, surveys, drawn, unknown, evidence):
    """Sentences about what the report itself could not show, each with its record."""
    found = []
    for record in loaded:
        if surveys[record.stem]["problem"]:
            found.append((record, surveys[record.stem]["problem"]))
        for figure in record.figures:
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
        for figure in record.figures:
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
