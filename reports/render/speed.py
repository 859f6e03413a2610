"""How fast the models are, beside what the machine can do, as the last run of ci/checks/benchmarks --table left it."""
import collections
import re

from render import files

MACHINE = "machine"     # the program that measures the limits


HOW_IT_RAN = re.compile(r"/iterations:\d+|/real_time")     # at the end of a benchmark's name


WORDS = ("program", "benchmark", "processor", "date")


def _number(text):
    try:
        return float(text) if text else None
    except ValueError:
        return None


def _numbers(row):
    numbers = {key: value if key in WORDS else _number(value) for key, value in row.items()}
    reason = row["of_peak"] if row["of_peak"] and numbers["of_peak"] is None else ""
    return {"bytes_per_item": None} | numbers | {"benchmark": HOW_IT_RAN.sub("", row["benchmark"]), "not_counted": reason}


def read(path=files.RECORD / "speed.csv"):
    """Rows of the record with numbers as such, None where nothing was counted, and the word that says why it was not."""
    return [_numbers(row) for row in files.table(path)]


def build_time(path=files.RECORD / "build_time.csv"):
    """How long building and running take, step by step with the aim, as ci/checks/time-build left it."""
    return [row | {"seconds": _number(row["seconds"]), "aim": _number(row["aim"])} for row in files.table(path)]


def survey(rows, build=()):
    """What the page shows: the benchmarks by program, the machine's own apart; the time of building."""
    programs = collections.defaultdict(list)
    for row in rows:
        programs[row["program"]].append(row)
    return {"machine": programs.pop(MACHINE, []), "build": list(build), "programs": dict(programs), "count": len(rows),
            "processors": sorted({row["processor"] for row in rows}), "dates": sorted({row["date"] for row in rows})}
