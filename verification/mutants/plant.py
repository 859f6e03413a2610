"""Plants defects in the code and asks of each whether the claim it names notices.

    plant.py --build DIR [DEFECT...] [--random N [--seed S]] [--jobs N] [--record FILE]

A defect counts as found only when its claim comes out otherwise than declared. One that does not compile, crashes or
runs out of time is not found, and neither is one whose claim is not as declared without it. A defect is a table of
verification/mutants/seeded (defects.py); how little of the build is made anew says programs.py. Status 1 if one is not found,
2 for wrong input.
"""

import argparse
import concurrent.futures
import csv
import dataclasses
import fcntl
import os
import pathlib
import random
import shutil
import sys
import tempfile
import time

from defects import FOLDER, BadDefect, all_defects
from noticing import Finding, NoAnswer, findings
from programs import Build, NotBuilt

COLUMNS = ("defect", "what", "file", "check", "claim", "measured", "limit", "verdict", "others")


@dataclasses.dataclass
class Result:
    """What became of a defect: its claim's finding, how many others noticed, or why it was not found."""

    defect: object
    finding: Finding | None = None
    others: int = 0
    trouble: str = ""
    seconds: float = 0

    @property
    def found(self):
        return not self.trouble


class Planter:
    def __init__(self, build, scratch):
        self.build = build
        self.scratch = scratch

    def sound(self, check):
        """What the check says of the program without a defect; a NoAnswer is returned, not thrown."""
        with tempfile.TemporaryDirectory(dir=self.scratch) as folder:
            try:
                return findings(check, self.build.program(check.target), pathlib.Path(folder) / "evidence")
            except NoAnswer as trouble:
                return trouble

    def try_out(self, defect, sound):
        """Plants one defect and looks."""
        begin = time.monotonic()
        result = Result(defect)
        # The same place each time: a compiler cache knows the object again.
        place = self.scratch / defect.name
        shutil.rmtree(place, ignore_errors=True)
        place.mkdir(parents=True)
        try:
            program = self.build.plant(defect, place)
            compare(result, sound, findings(defect.check, program, place / "evidence"))
        except (NotBuilt, NoAnswer) as trouble:
            result.trouble = str(trouble)
        finally:
            shutil.rmtree(place)
        result.seconds = time.monotonic() - begin
        return result


def compare(result, sound, broken):
    """Fills in what the claim said with the defect and without."""
    name = result.defect.noticed_by
    if isinstance(sound, NoAnswer):
        raise NoAnswer(f"without the defect: {sound}")
    if result.defect.claim and name not in sound:
        raise NoAnswer(f"{result.defect.check} makes no claim {name}; it has {', '.join(sorted(sound))}")
    already = {claim for claim, finding in sound.items() if finding.unexpected}
    if name in already:
        raise NoAnswer(f"{name} is not as declared without the defect")
    noticed = {claim for claim, finding in broken.items() if finding.unexpected} - already
    # A test that fails because its claims do says nothing more than they.
    claims = {claim for claim in noticed if not claim.startswith("test: ")}
    result.others = len((claims or noticed) - {name})
    result.finding = broken.get(name)
    if name in sound and name not in broken:
        result.trouble = f"{name} was not judged: its test ended by an exception"
    elif name not in noticed:
        result.trouble = f"not noticed by {name}" + (f", but by {', '.join(sorted(noticed))}" if noticed else "")


def chosen(defects, options):
    """The defects that the command line asks for."""
    if options.defects:
        by_name = {defect.name: defect for defect in defects}
        wanted = [[known for known in by_name if known == name or known.startswith(f"{name}/")] for name in options.defects]
        for name, some in zip(options.defects, wanted):
            if not some:
                raise BadDefect(f"defect {name} is not in {FOLDER}")
        defects = [by_name[name] for name in dict.fromkeys(sum(wanted, []))]
    if options.random:
        seed = options.seed if options.seed is not None else random.SystemRandom().randrange(10**6)
        print(f"a random {options.random} of {len(defects)} defects; the same again with --seed {seed}", flush=True)
        defects = random.Random(seed).sample(defects, min(options.random, len(defects)))
    return defects


def digits(value):
    return "" if value is None else f"{value:.3g}"


def report(number, total, result):
    """One line per defect, more where it was not found."""
    mark = "✓" if result.found else "✗"
    line = f"[{number:>3}/{total}] {mark} {result.defect.name:<52} {result.seconds:6.1f} s  {result.defect.noticed_by}"
    if result.found and result.finding.measured is not None:
        line += f" = {digits(result.finding.measured)}, limit {digits(result.finding.limit)}"
    if result.found and result.others:
        line += f"; {result.others} more"
    print(line if result.found else f"{line}\n{result.trouble}", flush=True)


def row(result):
    defect, finding = result.defect, result.finding or Finding("", False)
    entries = (defect.name, defect.what, defect.file, defect.check, defect.noticed_by,
               digits(finding.measured), digits(finding.limit), finding.verdict if result.found else "not found",
               result.others)
    return dict(zip(COLUMNS, map(str, entries)))


def write(path, results, known):
    """The record with the results of this run, whole or not at all; of other defects what it said before."""
    rows = {}
    if path.is_file():
        with path.open(newline="") as file:
            rows = {former["defect"]: former for former in csv.DictReader(file)}
    rows |= {result.defect.name: row(result) for result in results}
    path.parent.mkdir(parents=True, exist_ok=True)
    part = path.with_suffix(".part")
    with part.open("w", newline="") as file:
        table = csv.DictWriter(file, COLUMNS, lineterminator="\n")
        table.writeheader()
        table.writerows(rows[defect.name] for defect in known if defect.name in rows)
    part.replace(path)


def plant_all(planter, defects, jobs, keep):
    """Results in the order in which they come, each with what came before it handed to keep."""
    checks = list(dict.fromkeys(defect.check for defect in defects))
    results = []
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        sound = dict(zip(checks, pool.map(planter.sound, checks)))
        print(f"{len(checks)} checks without a defect: done", flush=True)
        runs = [pool.submit(planter.try_out, defect, sound[defect.check]) for defect in defects]
        for number, run in enumerate(concurrent.futures.as_completed(runs), 1):
            results.append(run.result())
            report(number, len(defects), results[-1])
            keep(results)
    return results


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("defects", nargs="*", metavar="DEFECT", help="names, or rooms; all if none is named")
    parser.add_argument("--build", type=pathlib.Path, required=True)
    parser.add_argument("--random", type=int, metavar="N", help="only so many of them, chosen at random")
    parser.add_argument("--seed", type=int, help="of the choice")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--record", type=pathlib.Path, help="CSV of what all defects came to; rows of this run are renewed")
    options = parser.parse_args()

    scratch = options.build.resolve() / "defects"
    scratch.mkdir(exist_ok=True)
    try:
        known = all_defects()
        defects = chosen(known, options)
    except (BadDefect, ValueError) as wrong:
        print(f"plant.py: {wrong}", file=sys.stderr)
        return 2
    keep = (lambda results: write(options.record, results, known)) if options.record else (lambda results: None)
    with (scratch / ".lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)  # two runs would plant in the same place
        results = plant_all(Planter(Build(options.build), scratch), defects, options.jobs, keep)
    missed = [result.defect.name for result in results if not result.found]
    print(f"{len(results) - len(missed)} of {len(results)} defects found")
    if missed:
        print(f"not found: {', '.join(sorted(missed))}")
    return 1 if missed else 0


if __name__ == "__main__":
    raise SystemExit(main())
