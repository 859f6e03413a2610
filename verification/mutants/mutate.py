"""Changes the code at random, one small fault at a time, and asks whether a check notices.

    mutate.py --build DIR [--record FILE] [--seed S] [--count N] [--rooms ROOM...] [--files GLOB] [--changed COMMIT]
    mutate.py --build DIR [--record FILE] --seeded [FAULT...]

A room is drawn in turn, of it a file by its lines, of that a line that an operator (operators.py) can change, and one of
its changes. Of the checks that decide the file (fingerprints) the cheapest run first, until one notices:

    killed             a claim came out otherwise than declared, a test failed, or the program crashed or hung
    record only        no claim or test notices, but the evidence of record differs
    survived           nothing notices; says how many of the checks ran before --budget was spent
    equivalent         as survived; marked by hand, with a reason, in the record

A change that does not compile is drawn anew. From forty on, changes are compiled together (together.py). Results go to
the record one by one; the same seed goes on where it ended.
With --seeded, the faults of seeded/*.toml are tried, each against the one claim that must notice. Status 1 if a seeded
fault survives, or a change of --changed; 2 for wrong input.
"""

import argparse
import csv
import dataclasses
import fnmatch
import json
import pathlib
import random
import re
import shutil
import subprocess
import sys
import tempfile
from collections import Counter
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor
from itertools import repeat

import operators
from checks import PROJECT, Check, NoAnswer, findings
from programs import ROOT, Build, Changed, NotBuilt, processor_time
from seeded import BadFault, all_faults
from together import Together

ROOMS = {
    "exact solutions": ["solver/seiche/exact/"],
    "linear solvers": ["solver/seiche/linear/"],
    "mechanics": ["solver/seiche/mechanics/"],
    "mesh models": ["solver/seiche/models/lagrangian_mesh", "solver/seiche/models/dispersive", "solver/seiche/plan_lattice/",
                       "solver/seiche/lattice/"],
    "shallow water": ["solver/seiche/models/shallow_water", "solver/seiche/shallow_water/"],
    "particle models": ["solver/seiche/models/", "solver/seiche/free_lagrangian/"],
    "geometry and files": ["solver/seiche/geometry/", "solver/seiche/io/", "solver/seiche/"],
    "claims and cases": ["reports/evidence/", "validation/case/", "verification/check."],
    "scoring and readers": ["validation/scoring/", "validation/command/"],
    "instruments and studies": ["validation/instruments/", "validation/studies/", "validation/laboratory/"],
    "report": ["reports/render/"],
    "Python module": ["solver/python/"],
}
LEFT_OUT = re.compile(r"/(tests|distributed|benchmarks?)/")
COLUMNS = ("seed", "number", "room", "file", "line", "change", "outcome", "by", "seconds", "commit", "reason")
COMPILING = 5  # seconds of a source
MAKING = 5  # times --budget that a change may take to compile and link, beside what its checks take
TOGETHER = 40  # changes from which on one build of all that are C++ costs less than one of each
UNKNOWN = {True: 20, False: 2}  # seconds of a case and of a test that have not run yet


def room_of(file):
    return next((room for room, places in ROOMS.items() if file.startswith(tuple(places))), None)


class Pool:
    """The code that is changed."""

    def __init__(self, arguments, changed=None, glob="*"):
        self.arguments = arguments
        self.kept = {}
        self.rooms = {room: {} for room in ROOMS}
        files = subprocess.run(["git", "-C", ROOT, "ls-files", "*.cpp", "*.hpp", "*.py"], check=True, capture_output=True,
                               text=True).stdout.split()
        for file in files:
            room = room_of(file)
            if room and fnmatch.fnmatch(file, glob) and not LEFT_OUT.search(file) and (changed is None or file in changed):
                text = (ROOT / file).read_text().splitlines()
                lines = changed[file] if changed else range(1, len(text) + 1)
                code = [n for n in lines if n <= len(text) and not re.match(r"\s*(//|#|\"\"\"|$)", text[n - 1])]
                if code:
                    self.rooms[room][file] = code

    def changes(self, file):
        if file not in self.kept:
            self.kept[file] = operators.changes(file, ROOT, self.arguments)
        return self.kept[file]

    def file(self, room, chance):
        files = self.rooms[room]
        return chance.choices(list(files), [len(lines) for lines in files.values()])[0]

    def read(self, files, jobs):
        """Reads files ahead, some at a time."""
        with ProcessPoolExecutor(jobs) as workers:
            self.kept |= zip(files, workers.map(operators.changes, files, repeat(ROOT), repeat(self.arguments)))

    def draw(self, room, word):
        """A change, the same for the same word; none where the file drawn has no line to change."""
        chance, files = random.Random(word), self.rooms[room]
        file = self.file(room, chance)
        possible = [change for change in self.changes(file) if change.line in set(files[file])]
        if not possible:
            return None
        line = chance.choice(sorted({change.line for change in possible}))
        here = [change for change in possible if change.line == line]
        kind = chance.choice(sorted({change.operator for change in here}))
        return chance.choice([change for change in here if change.operator == kind])


class Judge:
    """The checks, what they cost, and what they say of a change."""

    def __init__(self, build, scratch, budget):
        self.build, self.scratch, self.budget = build, scratch, budget
        sources = build.sources
        tests = json.loads((build.folder / "verification/fingerprints.json").read_text())
        self.deciding = {Check(file): frozenset(sources.deciding(file)) for file in [*tests, *sorted(sources.cases)]}
        self.seconds = {}
        kept = build.folder / "verification/kept.json"
        for file, entry in json.loads(kept.read_text()).items() if kept.is_file() else ():
            self.seconds[Check(file)] = entry["seconds"]
        for check in self.deciding:
            record = build.folder / "evidence" / f"{check.stem}.json"
            if check.is_case and record.is_file():
                self.seconds[check] = json.loads(record.read_text())["wall_time"] or 0
        self.sound_ones = {}

    def cost(self, check):
        return self.seconds.get(check, UNKNOWN[check.is_case])

    def of(self, changed):
        """The checks that decide a changed file, the cheapest and those that decide little else first; the cost is that of the
        check and of compiling what it needs anew."""
        file, found = changed.change.file, []
        for check in [check for check, files in self.deciding.items() if file in files]:
            try:
                cost = self.cost(check) + COMPILING * changed.to_compile(check)
            except NotBuilt:
                continue
            found.append((cost * len(self.deciding[check]), check.file, check))
        return [check for *_, check in sorted(found)] + [Check(name) for place, names in PROJECT.items()
                                                         if file.startswith(place) for name in names]

    def limit(self, check):
        """A program that takes ten times its time hangs."""
        return 30 + 10 * self.cost(check)

    def sound(self, check, change):
        """What the check says of the program without a change, which is put where the changed one is unless it is compiled:
        names that are unexpected; None of a check that breaks, and of one in Python that fails, which names its first alone."""
        if check not in self.sound_ones:
            with tempfile.TemporaryDirectory(dir=self.scratch) as folder:
                same = Changed(self.build, dataclasses.replace(change, end=change.begin, text=""), pathlib.Path(folder) / "same")
                program, tree = (self.build.program(check.target), ROOT) if same.compiled else (same.program(check), same.tree)
                try:
                    said = findings(check, program, pathlib.Path(folder) / "evidence", tree, self.limit(check))
                    names = {name for name, finding in said.items() if finding.unexpected}
                    self.sound_ones[check] = None if names and check.is_python else names
                except NoAnswer:
                    self.sound_ones[check] = None
        return self.sound_ones[check]

    def noticed(self, check, changed, evidence):
        """The names that are unexpected with the change alone; none of a check that breaks without it too."""
        try:
            said = findings(check, changed.program(check), evidence, changed.tree, self.limit(check))
            names = {name for name, finding in said.items() if finding.unexpected}
        except NoAnswer as trouble:
            names = {f"{check.stem}: {str(trouble).splitlines()[0]}"}
        if not names or self.sound(check, changed.change) is None:
            return []
        names -= self.sound_ones[check]
        # A test that fails because its claims do says nothing more than they.
        return sorted(names, key=lambda name: (name.startswith("test: "), name))

    def try_out(self, change):
        """(outcome, by) of a change. Throws NotBuilt where it does not compile."""
        place = self.scratch / "changed"
        shutil.rmtree(place, ignore_errors=True)
        begin, ran = processor_time(), 0
        try:
            changed = Changed(self.build, change, place)
            checks = self.of(changed)
            for check in checks:
                used = processor_time() - begin - changed.making
                try:
                    making = changed.making + COMPILING * changed.to_compile(check)
                    if ran and (used + self.cost(check) > self.budget or making > MAKING * self.budget):
                        continue
                    names = self.noticed(check, changed, place / "evidence")
                except NotBuilt as trouble:
                    if " is not made from " in str(trouble):
                        continue
                    raise
                if names:
                    return "killed", names[0]
                ran += self.sound_ones.get(check, ()) is not None
            by = f"{ran} of {len(checks)} checks"
            return ("record only" if self.differs(place / "evidence") else "survived"), by
        finally:
            shutil.rmtree(place, ignore_errors=True)

    def differs(self, evidence):
        """Whether the evidence of record notices."""
        if not any(evidence.glob("*.json")):
            return False
        return subprocess.run([self.build.program("seiche_command"), "compare", evidence, "--record"],
                              capture_output=True).returncode == 1

    def try_fault(self, fault):
        """(outcome, by) of a seeded fault: noticed by the claim that it names, or not."""
        place = self.scratch / "changed"
        shutil.rmtree(place, ignore_errors=True)
        try:
            changed = Changed(self.build, fault.change, place)
            names = self.noticed(fault.check, changed, place / "evidence")
            return ("killed", fault.noticed_by) if fault.noticed_by in names else ("survived", ", ".join(names[:3]))
        except NotBuilt as trouble:
            return "survived", str(trouble).splitlines()[0]
        finally:
            shutil.rmtree(place, ignore_errors=True)


class Trials:
    """Changes that were compiled together, each on the checks of this code."""

    def __init__(self, judge, together, scratch, jobs):
        self.judge, self.together, self.scratch, self.jobs = judge, together, scratch, jobs
        files = {change.file for change in together.inside.values()}
        checks = [check for check, deciding in judge.deciding.items() if deciding & files]
        checks += [Check(name) for name in dict.fromkeys(name for place, names in PROJECT.items() for name in names
                                                         if any(file.startswith(place) for file in files))]
        with ThreadPoolExecutor(jobs) as pool:
            looked = list(pool.map(lambda check: self.run(check, -1), checks))
        self.seconds = {check: seconds for check, (_, seconds, _) in zip(checks, looked)}
        self.sound = {check: names for check, (names, _, _) in zip(checks, looked) if names is not None}
        self.coming_to = {number: [check for check, (_, _, come_to) in zip(checks, looked)
                                   if come_to[number] and check in self.sound] for number in together.inside}
        self.width = Counter(check for found in self.coming_to.values() for check in found)

    def run(self, check, number):
        """(unexpected names, or none where it breaks; seconds of the processor; the changes come to) of a check."""
        seconds = []
        with tempfile.TemporaryDirectory(dir=self.scratch) as folder:
            come_to = pathlib.Path(folder) / "come_to"
            extra = self.together.environment(number, come_to)
            limit = 30 + 10 * self.seconds[check] if number >= 0 else self.judge.budget
            try:
                said = findings(check, self.together.programs.program(check.target), pathlib.Path(folder) / "evidence",
                                self.together.tree, limit, extra, seconds.append)
                names = {name for name, finding in said.items() if finding.unexpected}
            except NoAnswer as trouble:
                names = {f"{check.stem}: {str(trouble).splitlines()[0]}"} if number >= 0 else None
            return names, sum(seconds), come_to.read_bytes()

    def try_out(self, number):
        """(outcome, by, seconds) of a change."""
        # Cheap ones first, and those that come to few changes: they are about this one.
        checks = sorted(self.coming_to[number], key=lambda check: (max(self.seconds[check], 0.3) * self.width[check], check.file))
        ran = used = 0
        for check in checks:
            if ran and used + self.seconds[check] > self.judge.budget:
                continue
            names, seconds, _ = self.run(check, number)
            ran, used = ran + 1, used + seconds
            if news := sorted(names - self.sound[check], key=lambda name: (name.startswith("test: "), name)):
                return "killed", news[0], used
        return "survived", f"{ran} of {len(checks)} checks of this code", used


class Record:
    """reports/record/mutation.csv: a row per change, appended whole."""

    def __init__(self, path):
        self.path, self.rows = path, []
        if path and path.is_file():
            with path.open(newline="") as file:
                self.rows = list(csv.DictReader(file))
        self.commit = subprocess.run(["git", "-C", ROOT, "rev-parse", "--short=8", "HEAD"], capture_output=True,
                                     text=True).stdout.strip()

    def add(self, seed, number, room, change, outcome, by, seconds):
        shown = change.operator if seed == "seeded" else change.shown((ROOT / change.file).read_bytes())
        row = dict(zip(COLUMNS, map(str, (seed, number, room, change.file, change.line, shown, outcome, by,
                                          round(seconds), self.commit, ""))))
        print(f"{number:>4} {outcome:<12} {seconds:5.0f} s  {room}: {change.file}:{change.line}  {shown}  [{by}]", flush=True)
        self.rows = [kept for kept in self.rows if (kept["seed"], kept["number"]) != (row["seed"], row["number"])] + [row]
        if self.path:
            part = self.path.with_suffix(".part")
            with part.open("w", newline="") as file:
                table = csv.DictWriter(file, COLUMNS, lineterminator="\n")
                table.writeheader()
                table.writerows(self.rows)
            part.replace(self.path)


def lines_of_change(base):
    """file -> the lines that differ from a commit's."""
    found, file = {}, None
    said = subprocess.run(["git", "-C", ROOT, "diff", "-U0", base, "--"], check=True, capture_output=True, text=True).stdout
    for line in said.splitlines():
        if line.startswith("+++ "):
            file = line[6:]
        elif hunk := re.match(r"@@ -\S+ \+(\d+)(?:,(\d+))? @@", line):
            first, count = int(hunk[1]), int(hunk[2] or 1)
            found.setdefault(file, []).extend(range(first, first + count))
    return found


def at_random(options, judge, record):
    """Draws and tries; the rows of this seed."""
    pool = Pool(judge.build.parsing(), lines_of_change(options.changed) if options.changed else None, options.files)
    rooms = [room for room, files in pool.rooms.items() if files and (not options.rooms or room in options.rooms)]
    if not rooms:
        raise BadFault("no line of the rooms is changed")
    seed = str(options.seed if options.seed is not None else random.SystemRandom().randrange(10**8))
    print(f"seed {seed}: {options.count} changes of {len(rooms)} rooms", flush=True)
    done = {row["number"] for row in record.rows if row["seed"] == seed}

    def room_of_number(number):
        return list(ROOMS)[number % len(ROOMS)] if len(rooms) == len(ROOMS) else rooms[number % len(rooms)]

    def drawn(number):
        """The changes of a number, in their order."""
        changes = (pool.draw(room_of_number(number), f"{seed} {number} {attempt}") for attempt in range(40))
        return filter(None, changes)

    to_do = [number for number in range(options.count) if str(number) not in done]
    many = len(to_do) >= TOGETHER
    if many:
        pool.read(sorted({pool.file(room_of_number(number), random.Random(f"{seed} {number} 0"))
                          for number in range(options.count)}), options.jobs)
    compiled = {number: change for number in range(options.count) if (change := next(drawn(number), None)) and
                change.file.endswith((".cpp", ".hpp"))} if many else {}
    if compiled:
        together = Together(compiled, ROOT / "build/mutants" / f"{seed}-{record.commit}")
        trials = Trials(judge, together, judge.scratch, options.jobs)
        trying = [number for number in to_do if number in together.inside]
        with ThreadPoolExecutor(options.jobs) as workers:
            for number, (outcome, by, seconds) in zip(trying, workers.map(trials.try_out, trying)):
                record.add(seed, number, room_of_number(number), compiled[number], outcome, by, seconds)
        to_do = [number for number in to_do if number not in together.inside]

    for number in to_do:
        for change in drawn(number):
            begin = processor_time()
            try:
                record.add(seed, number, room_of_number(number), change, *judge.try_out(change), processor_time() - begin)
                break
            except NotBuilt:
                continue
    return [row for row in record.rows if row["seed"] == seed]


def by_hand(options, judge, record):
    """Tries the seeded faults that are named, or all."""
    faults = {fault.name: fault for fault in all_faults()}
    names = [known for known in faults if not options.seeded
             or any(known == name or known.startswith(f"{name}/") for name in options.seeded)]
    if unknown := [name for name in options.seeded if not any(known == name or known.startswith(f"{name}/") for known in names)]:
        raise BadFault(f"no seeded fault {unknown[0]}")

    record.rows = [row for row in record.rows if row["seed"] != "seeded" or row["number"] in faults]
    for name in names:
        begin = processor_time()
        outcome, by = judge.try_fault(faults[name])
        record.add("seeded", name, name.split("/")[0], faults[name].change, outcome, by, processor_time() - begin)
    return [row for row in record.rows if row["number"] in names]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, required=True)
    parser.add_argument("--record", type=pathlib.Path, help="CSV of what all changes came to")
    parser.add_argument("--seed", type=int)
    parser.add_argument("--count", type=int, default=20)
    parser.add_argument("--rooms", nargs="*", choices=list(ROOMS), metavar="ROOM")
    parser.add_argument("--files", default="*", metavar="GLOB", help="only these: '*.py' needs no compiler")
    parser.add_argument("--changed", metavar="COMMIT", help="only lines that differ from this commit's")
    parser.add_argument("--seeded", nargs="*", metavar="FAULT", help="the seeded faults named, or rooms of them, or all")
    parser.add_argument("--jobs", type=int, default=2, help="checks at a time, of changes that are compiled together")
    parser.add_argument("--budget", type=float, default=30,
                        help="processor seconds of a change; a check that would take more is left out")
    options = parser.parse_args()
    try:
        record = Record(options.record)
        with tempfile.TemporaryDirectory(prefix="seiche-mutants-") as scratch:
            judge = Judge(Build(options.build), pathlib.Path(scratch), options.budget)
            if options.seeded is not None:
                rows = by_hand(options, judge, record)
            else:
                rows = at_random(options, judge, record)
    except (BadFault, OSError, subprocess.CalledProcessError) as trouble:
        print(trouble, file=sys.stderr)
        return 2
    survived = sum(row["outcome"] in ("survived", "record only") for row in rows)
    print(f"{survived} of {len(rows)} changes survive")
    return 1 if survived and (options.changed or options.seeded is not None) else 0


if __name__ == "__main__":
    raise SystemExit(main())
