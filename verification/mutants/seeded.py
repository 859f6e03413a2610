"""Seeded faults: verification/mutants/seeded/<room>.toml, one table each.

    [predictor_of_a_whole_step]
    what = "the predictor takes a whole step"               # for the report
    file = "solver/seiche/mechanics/conservative_step.hpp"
    text = "predict(model_, state.q, mean_, tau, next_)"    # stands there exactly once; white space does not count
    replacement = "predict(model_, state.q, mean_, 2 * tau, next_)"
    check = "verification/conservation/conservative_step_test.cpp"    # a test file, or a case with `set = ["a=1"]`
    claim = "conservative_step_chain: energy"               # record: id of the claim that must notice

What the judge itself does wrong cannot be left to its verdicts: there `test = "name of the Catch2 test"` stands
instead of `claim`, and an assertion of that test must fail.
"""

import dataclasses
import pathlib
import tomllib

from checks import Check
from operators import Change

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
FOLDER = ROOT / "verification/mutants/seeded"
NEEDED = {"what", "file", "text", "replacement", "check"}
NOTICING = {"claim", "test"}
OPTIONAL = {"set"}


class BadFault(ValueError):
    """A table does not say what is needed."""


@dataclasses.dataclass(frozen=True)
class Fault:
    name: str
    change: Change
    check: Check
    noticed_by: str


def located(name, file, text, replacement, what):
    """The change. Throws BadFault unless the text stands in the file exactly once, white space aside."""
    whole, wanted = (ROOT / file).read_text(), "".join(text.split())
    ink = [i for i, sign in enumerate(whole) if not sign.isspace()]
    squeezed = "".join(whole[i] for i in ink)
    if squeezed.count(wanted) != 1:
        raise BadFault(f"{name}: its text stands {squeezed.count(wanted)} times in {file}, not once")
    first = squeezed.index(wanted)
    begin, end = (len(whole[:i].encode()) for i in (ink[first], ink[first + len(wanted) - 1] + 1))
    return Change(file, begin, end, replacement, what, whole.count("\n", 0, ink[first]) + 1)


def fault(name, entries):
    """The fault of a table. Throws BadFault where it says too little, too much or what is not so."""
    keys = set(entries)
    if NEEDED - keys or keys - NEEDED - NOTICING - OPTIONAL or len(keys & NOTICING) != 1:
        raise BadFault(f"{name}: has {sorted(keys)}; needed: {sorted(NEEDED)}, and claim or test")
    check = Check(entries["check"], tuple(entries.get("set", ())))
    for file in (entries["file"], check.file):
        if not (ROOT / file).is_file():
            raise BadFault(f"{name}: {file} is not there")
    if check.settings and not check.is_case:
        raise BadFault(f"{name}: only a case has parameters to set")
    if len(entries.get("claim", "a: b").split(": ")) != 2:
        raise BadFault(f"{name}: claim = {entries['claim']}; it is written record: id")
    if entries["text"] == entries["replacement"]:
        raise BadFault(f"{name}: changes nothing")
    change = located(name, entries["file"], entries["text"], entries["replacement"], entries["what"])
    return Fault(name, change, check, entries.get("claim") or f"test: {entries['test']}")


def all_faults():
    """Every fault, by room."""
    return [fault(f"{path.stem}/{name}", entries) for path in sorted(FOLDER.glob("*.toml"))
            for name, entries in tomllib.loads(path.read_text()).items()]
