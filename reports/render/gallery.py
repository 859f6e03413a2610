"""All figures of a report: looked up in the cache, the missing ones drawn by a pool of processes."""
import concurrent.futures
import dataclasses
import importlib.metadata
import multiprocessing

from render import arrays
from render.store import digest, source_digest


@dataclasses.dataclass
class Drawn:
    """One figure of one record: where its SVG is, or why there is none."""
    path: object = None
    problem: str = ""


def survey(directory, record, store):
    """Contents of the record's HDF5 file (arrays.survey), "problem" where it cannot be read, "files" that there are."""
    there = [name for name in (record.file, record.data, record.fields) if name and (directory / name).is_file()]
    empty = {"figures": {}, "arrays": [], "problem": "", "files": there}
    if not record.data:
        return empty
    path = directory / record.data
    try:
        status = path.stat()
        key = f"{path.resolve()} {status.st_size} {status.st_mtime_ns}"
        return {**empty, **store.memo("survey", key, lambda: arrays.survey(path))}
    except (OSError, KeyError, ValueError, RuntimeError) as error:
        return {**empty, "problem": f"{record.data} cannot be read: {error}"}


def draw_all(directory, records, surveys, store, jobs):
    """Draws what the cache does not hold. Returns {(record stem, figure id): Drawn}."""
    style = digest(source_digest("figures.py", "panels.py", "arrays.py", "seiche.mplstyle"), _version("matplotlib"))
    drawn, missing = {}, {}
    for record in records:
        held = surveys[record.stem]
        for figure in record.figures:
            place = (record.stem, figure["id"])
            if held["problem"]:
                drawn[place] = Drawn(problem=held["problem"])
            elif figure["id"] not in held["figures"]:
                drawn[place] = Drawn(problem=f"{record.data or 'the record'} holds no figure “{figure['id']}”")
            else:
                key = digest(style, figure["drawing"], held["figures"][figure["id"]])
                path = store.figure(key)
                drawn[place] = Drawn(path=path)
                if not path.exists():
                    missing.setdefault(key, (str(directory / record.data), figure["id"], figure["drawing"], key, str(path)))
    problems = _draw(list(missing.values()), jobs)
    for result in drawn.values():
        if result.path is not None and problems.get(result.path.stem):
            result.problem, result.path = problems[result.path.stem], None
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
        return {task[3]: figures.draw(*task) for task in tasks}
    with concurrent.futures.ProcessPoolExecutor(jobs, mp_context=multiprocessing.get_context("fork")) as pool:
        waiting = {pool.submit(figures.draw, *task): task[3] for task in tasks}
        for future in concurrent.futures.as_completed(waiting):
            error = future.exception()
            problems[waiting[future]] = f"the drawing process ended: {error}" if error else future.result()
    return problems


def _version(package):
    try:
        return importlib.metadata.version(package)
    except importlib.metadata.PackageNotFoundError:
        return "none"
