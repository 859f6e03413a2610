"""All figures of a report: looked up in the cache, the missing ones drawn by a pool of processes."""
import concurrent.futures
import dataclasses
import importlib.metadata
import multiprocessing

from render import arrays, files, seal
from render.store import digest, source_digest


@dataclasses.dataclass
class Drawn:
    """One figure of one record: where its SVG is, or why there is none."""
    path: object = None
    problem: str = ""
    thumb: object = None       # the same without text, for the atlas


def survey(directory, record, store):
    """Contents of the record's HDF5 file (arrays.survey), "problem" where it cannot be read, "files" that there are."""
    there = [name for name in (record.file, record.data, record.fields) if name and files.is_regular(directory / name)]
    empty = {"figures": {}, "arrays": [], "problem": "", "files": there}
    if not record.data:
        return empty
    path = directory / record.data
    try:
        if not path.exists():
            return {**empty, "problem": f"{record.data} cannot be read: there is no such file"}
        if not files.is_regular(path):
            return {**empty, "problem": f"{record.data} is not read: links and pipes are not followed"}
        stranger = seal.stranger_beside(directory, record.raw, record.data)
        if stranger:
            return {**empty, "problem": stranger}
        return {**empty, **store.memo("survey", files.content_digest(path), lambda: arrays.survey(path))}
    except Exception as error:      # HDF5 raises many types; a damaged file must not hide the rest of the report
        return {**empty, "problem": f"{record.data} cannot be read: {error}"}


def draw_all(directory, records, surveys, store, jobs):
    """Draws what the cache does not hold. Returns {(record stem, figure id): Drawn}."""
    sources = ("figures.py", "panels.py", "legends.py", "lattices.py", "scene.py", "surfaces.py", "looks.py",
               "arrays.py", "seiche.mplstyle")
    style = digest(source_digest(*sources), _version("matplotlib"))
    drawn, missing = {}, {}
    for record in records:
        held = surveys[record.stem]
        for figure in record.shown:
            place = (record.stem, figure["id"])
            if held["problem"]:
                drawn[place] = Drawn(problem=held["problem"])
            elif figure["id"] not in held["figures"]:
                drawn[place] = Drawn(problem=f"{record.data or 'the record'} holds no figure “{figure['id']}”")
            else:
                drawn[place] = Drawn()
                sizes = ("path", "thumb") if record.tiles else ("path",)
                for size in sizes:
                    key = digest(style, figure["drawing"], held["figures"][figure["id"]], size)
                    path = store.figure(key)
                    setattr(drawn[place], size, path)
                    if not path.exists():
                        missing.setdefault(key, (str(directory / record.data), figure["id"], figure["drawing"],
                                                 size == "thumb", key, str(path)))
    problems = _draw(list(missing.values()), jobs)
    for result in drawn.values():
        for path in (result.path, result.thumb):
            if path is not None and problems.get(path.stem):
                result.problem, result.path, result.thumb = problems[path.stem], None, None
                break
    return drawn


def _draw(tasks, jobs):
    """Draws the tasks; returns {key: problem}."""
    if not tasks:
        return {}
    from render import figures
    figures.prepare()
    problems = {}
    jobs = max(1, min(jobs, len(tasks)))
    if jobs == 1:
        return {task[4]: figures.draw(*task) for task in tasks}
    with concurrent.futures.ProcessPoolExecutor(jobs, mp_context=multiprocessing.get_context("fork")) as pool:
        waiting = {pool.submit(figures.draw, *task): task[4] for task in tasks}
        for future in concurrent.futures.as_completed(waiting):
            error = future.exception()
            problems[waiting[future]] = f"the drawing process ended: {error}" if error else future.result()
    return problems


def _version(package):
    try:
        return importlib.metadata.version(package)
    except importlib.metadata.PackageNotFoundError:
        return "none"
