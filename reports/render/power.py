"""What a case can tell apart, as `ci/tests/test_resolving_power.py --record` left it: a table for its page."""
import collections
import functools

from render import files

SIZED = ("amplitude", "datum", "shift", "dilation", "smoothing", "gravity")


@functools.cache
def read():
    """{case: [row]}"""
    cases = collections.defaultdict(list)
    for row in files.table(files.RECORD / "resolving_power.csv"):
        cases[row["case"]].append(row)
    return cases


def size(row):
    """"4 % (0.02 m)" from which on a change is detected; "not detected"."""
    if not row["by"]:
        return "not detected"
    percent = f"{100 * float(row['smallest']):.2g} %"
    return percent if row["unit"] == "1" else f"{percent} ({float(row['amount']):.2g} {row['unit']})"


def table(rows):
    """A row for every quantity, a column for every kind of change that has a size; the others in the caption."""
    sized, shapes = collections.defaultdict(dict), collections.defaultdict(list)
    for row in rows:
        if row["change"] in SIZED:
            sized[row["table"], row["quantity"]][row["change"]] = size(row)
        elif row["table"] and row["by"] != "same":
            shapes["detected" if row["by"] else "not detected"].append(f"{row['change']} ({row['table']})")
    kinds = [kind for kind in SIZED if any(kind in found for found in sized.values())]
    caption = "The smallest change of the reference that a claim detects. Changes without a size: " + "; ".join(
        f"{verdict}: {', '.join(names)}" for verdict, names in sorted(shapes.items())) + "."
    return {"title": "Resolving power", "caption": caption,
            "columns": [{"name": name, "unit": "1"} for name in ("table", "quantity", *kinds)],
            "rows": [[*where, *(found.get(kind, "") for kind in kinds)] for where, found in sized.items()]}
