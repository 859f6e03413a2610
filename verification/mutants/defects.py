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
import functools
import pathlib
import tomllib

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
FOLDER = ROOT / "verification/mutants/seeded"
NEEDED = {"what", "file", "text", "replacement", "check"}
NOTICING = {"claim", "test"}
OPTIONAL = {"set"}


class BadDefect(ValueError):
    """A table does not say what the planter needs."""


@dataclasses.dataclass(frozen=True)
class Check:
    """A test file of verification or a case with its parameters: what is run to see whether it notices."""

    file: str
    settings: tuple[str, ...] = ()

    @property
    def stem(self):
        return pathlib.PurePath(self.file).stem

    @property
    def is_case(self):
        return self.file.startswith("validation/")

    @property
    def target(self):
        """What Ninja calls the program that runs it."""
        return "seiche_command" if self.is_case else f"verify_{pathlib.PurePath(self.file).parts[1]}"

    def __str__(self):
        return " ".join([self.file, *self.settings])


@dataclasses.dataclass(frozen=True)
class Defect:
    name: str
    what: str
    file: str
    text: str
    replacement: str
    check: Check
    claim: str = ""
    test: str = ""

    @property
    def is_data(self):
        return self.file.startswith("reference_data/")

    @property
    def noticed_by(self):
        return self.claim or f"test: {self.test}"

    def broken(self):
        """The file with the defect. Throws BadDefect unless the text stands there exactly once, white space aside."""
        whole, wanted = _content(ROOT / self.file), "".join(self.text.split())
        ink = [i for i, sign in enumerate(whole) if not sign.isspace()]
        squeezed = "".join(whole[i] for i in ink)
        if squeezed.count(wanted) != 1:
            raise BadDefect(f"{self.name}: its text stands {squeezed.count(wanted)} times in {self.file}, not once")
        first = squeezed.index(wanted)
        return whole[:ink[first]] + self.replacement + whole[ink[first + len(wanted) - 1] + 1:]


@functools.cache
def _content(path):
    return path.read_text()


def defect(name, entries):
    """The defect of a table. Throws BadDefect where it says too little, too much or what is not so."""
    keys = set(entries)
    if NEEDED - keys or keys - NEEDED - NOTICING - OPTIONAL or len(keys & NOTICING) != 1:
        raise BadDefect(f"{name}: has {sorted(keys)}; needed: {sorted(NEEDED)}, and claim or test")
    rest = {key: entries[key] for key in keys - {"check", "set"}}
    one = Defect(name=name, check=Check(entries["check"], tuple(entries.get("set", ()))), **rest)
    for file in (one.file, one.check.file):
        if not (ROOT / file).is_file():
            raise BadDefect(f"{name}: {file} is not there")
    if one.check.settings and not one.check.is_case:
        raise BadDefect(f"{name}: only a case has parameters to set")
    if one.claim and len(one.claim.split(": ")) != 2:
        raise BadDefect(f"{name}: claim = {one.claim}; it is written record: id")
    if one.text == one.replacement:
        raise BadDefect(f"{name}: changes nothing")
    one.broken()
    return one


def all_defects():
    """Every defect, by room."""
    return [defect(f"{path.stem}/{name}", entries) for path in sorted(FOLDER.glob("*.toml"))
            for name, entries in tomllib.loads(path.read_text()).items()]
