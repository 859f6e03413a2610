"""What a planted defect is: one TOML file verification/defects/<room>/<name>.toml.

    what = "the predictor takes a whole step"               # for the report
    of = "conservative step"                                # what of the room is broken
    file = "solver/seiche/mechanics/conservative_step.hpp"  # where
    text = "predict(model_, state.q, mean_, tau, next_)"    # stands there exactly once
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
FOLDER = ROOT / "verification/defects"
NEEDED = {"what", "of", "file", "text", "replacement", "check"}
NOTICING = {"claim", "test"}
OPTIONAL = {"set"}


class BadDefect(ValueError):
    """A defect's file does not say what the planter needs."""


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
    of: str
    file: str
    text: str
    replacement: str
    check: Check
    claim: str = ""
    test: str = ""

    @property
    def room(self):
        return self.name.split("/", maxsplit=1)[0]

    @property
    def is_data(self):
        return self.file.startswith("reference_data/")

    @property
    def noticed_by(self):
        return self.claim or f"test: {self.test}"

    def broken(self):
        """The file with the defect. Throws BadDefect unless the text stands there exactly once."""
        whole = _content(ROOT / self.file)
        if whole.count(self.text) != 1:
            raise BadDefect(f"{self.name}: its text stands {whole.count(self.text)} times in {self.file}, not once")
        return whole.replace(self.text, self.replacement)


@functools.cache
def _content(path):
    return path.read_text()


def read(path):
    """The defect of a file. Throws BadDefect where it says too little, too much or what is not so."""
    name = str(path.relative_to(FOLDER).with_suffix(""))
    entries = tomllib.loads(path.read_text())
    keys = set(entries)
    if NEEDED - keys or keys - NEEDED - NOTICING - OPTIONAL or len(keys & NOTICING) != 1:
        raise BadDefect(f"{name}: has {sorted(keys)}; needed: {sorted(NEEDED)}, and claim or test")
    check = Check(entries.pop("check"), tuple(entries.pop("set", ())))
    defect = Defect(name=name, check=check, **entries)
    for file in (defect.file, check.file):
        if not (ROOT / file).is_file():
            raise BadDefect(f"{name}: {file} is not there")
    if check.settings and not check.is_case:
        raise BadDefect(f"{name}: only a case has parameters to set")
    if defect.claim and len(defect.claim.split(": ")) != 2:
        raise BadDefect(f"{name}: claim = {defect.claim}; it is written record: id")
    if defect.text == defect.replacement:
        raise BadDefect(f"{name}: changes nothing")
    defect.broken()
    return defect


def all_defects():
    """Every defect, by name."""
    return [read(path) for path in sorted(FOLDER.rglob("*.toml"))]
