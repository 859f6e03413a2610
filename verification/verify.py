"""Runs the tests whose code changed since they last ran, several at once, and keeps the evidence of the others.

    verify.py --build DIR --evidence DIR [--tier full] [--rooms ROOM...] [--jobs N]

A test file runs as a process of its room's program, its tests with the tag [full] as another, in that tier alone. It
counts as done while its fingerprint (ci/cmake/fingerprints.py), the reference tables and the records it wrote are the
same. Status 1 if a test fails; it runs again the next time.
"""

import argparse
import concurrent.futures
import hashlib
import json
import os
import pathlib
import shutil
import subprocess
import tempfile
import time

FULL, QUICK = "[full]", "~[full]"  # tests of that tier have the tag


def digest_of_tables(folder):
    digest = hashlib.sha256()
    for file in sorted(folder.rglob("*")):
        if file.is_file():
            digest.update(str(file.relative_to(folder)).encode() + file.read_bytes())
    return digest.hexdigest()


def sibling(path, directory):
    """A folder beside the evidence, on the same file system: what is whole there is renamed into it."""
    directory.mkdir(parents=True, exist_ok=True)
    return tempfile.TemporaryDirectory(prefix=f".{path}-", dir=directory.parent)


def checks_of(fingerprints, rooms):
    """The test files that have tests of the tier quick, and with the tag those of the tier full: what is run with what tag."""
    root = pathlib.Path(__file__).resolve().parent.parent
    for file, code in fingerprints.items():
        if not rooms or pathlib.PurePath(file).parts[1] in rooms:
            text = (root / file).read_text()
            if text.count("TEST_CASE(") > text.count(FULL):
                yield file, code
            if FULL in text:
                yield f"{file} {FULL}", code


def run(check, options):
    """The tests of a file in one tier: what became of them, and the records they wrote."""
    file, _, tag = check.partition(" ")
    room, name = pathlib.PurePath(file).parts[-2:]
    stem = pathlib.PurePath(name).stem
    program = options.build / "verification" / f"verify_{room}"
    begin = time.monotonic()
    with sibling(stem, options.evidence) as scratch:
        ended = subprocess.run([program, "--filenames-as-tags", f"[#{stem}]{tag or QUICK}"],
                               capture_output=True, text=True,
                               env={**os.environ, "SEICHE_EVIDENCE": scratch, "OMP_NUM_THREADS": "1"})
        records = sorted(file.name for file in pathlib.Path(scratch).iterdir())
        # The arrays before the record that names them.
        for record in sorted(records, key=lambda record: record.endswith(".json")):
            shutil.move(pathlib.Path(scratch) / record, options.evidence / record)
    output = ended.stdout + ended.stderr
    # Catch2 2 ends with status 0 where no test has the file's tag: what did not run has not passed.
    status = 1 if "No tests ran" in output else ended.returncode
    return {"status": status, "seconds": time.monotonic() - begin, "records": records, "output": output}


class Kept:
    """What earlier runs found, one entry per test file."""

    def __init__(self, file):
        self.file = file
        self.entries = json.loads(file.read_text()) if file.exists() else {}

    def holds(self, check, fingerprint, evidence):
        entry = self.entries.get(check, {})
        return (entry.get("fingerprint") == fingerprint and entry["status"] == 0
                and all((evidence / record).exists() for record in entry["records"]))

    def seconds(self, check, otherwise):
        return self.entries.get(check, {}).get("seconds", otherwise)

    def keep(self, check, fingerprint, found):
        entry = {key: found[key] for key in ("status", "seconds", "records")}
        self.entries[check] = {"fingerprint": fingerprint, **entry}
        part = self.file.with_suffix(".part")
        part.write_text(json.dumps(self.entries, indent=1))
        part.replace(self.file)


def remove_stale(evidence, kept, checks):
    """Records of tests that are no longer there: they are no evidence of anything."""
    rooms = {pathlib.PurePath(check).parts[1] for check in checks}
    current = {record for check in checks for record in kept.entries.get(check, {}).get("records", [])}
    for file in sorted(evidence.glob("*.json")):
        record = json.loads(file.read_text())
        if record["kind"] == "verification" and record["group"] in rooms and file.name not in current:
            for name in filter(None, (file.name, record["data"], record["fields"])):
                (evidence / name).unlink(missing_ok=True)
            print(f"verification: {file.name} removed, no test writes it any more", flush=True)


def left(seconds, jobs):
    return f"about {max(1, round(seconds / jobs))} s left"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, required=True)
    parser.add_argument("--evidence", type=pathlib.Path, required=True)
    parser.add_argument("--tier", choices=("quick", "full", "paper"), default="quick")
    parser.add_argument("--rooms", nargs="*", help="of verification; all if none is named")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    options = parser.parse_args()

    tables = digest_of_tables(pathlib.Path(__file__).resolve().parent.parent / "reference_data")
    fingerprints = json.loads((options.build / "verification/fingerprints.json").read_text())
    known = {check: hashlib.sha256((code + tables).encode()).hexdigest()
             for check, code in checks_of(fingerprints, options.rooms)}
    wanted = {check: code for check, code in known.items() if options.tier == "full" or not check.endswith(FULL)}
    kept = Kept(options.build / "verification/kept.json")
    todo = [check for check in wanted if not kept.holds(check, wanted[check], options.evidence)]
    todo.sort(key=lambda check: -kept.seconds(check, 1e9))  # the longest first, those never run before them
    remaining = {check: kept.seconds(check, 1.2) for check in todo}
    print(f"verification: {len(wanted) - len(todo)} test files unchanged, {len(todo)} to run", flush=True)

    failed = []
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        runs = {pool.submit(run, check, options): check for check in todo}
        for number, done in enumerate(concurrent.futures.as_completed(runs), 1):
            check, found = runs[done], done.result()
            kept.keep(check, wanted[check], found)
            del remaining[check]
            mark = "✓" if found["status"] == 0 else "✗"
            name = check.removeprefix("verification/").replace("_test.cpp", "")
            print(f"[{number:>3}/{len(todo)}] {mark} {name:<52} {found['seconds']:6.2f} s  "
                  f"{left(sum(remaining.values()), options.jobs) if remaining else ''}", flush=True)
            if found["status"] != 0:
                failed.append(name)
                print(found["output"], flush=True)
    if not options.rooms:
        remove_stale(options.evidence, kept, known)
    if failed:
        print(f"verification: {len(failed)} test files failed: {', '.join(sorted(failed))}")
    return 1 if failed else 0


if __name__ == "__main__":
    raise SystemExit(main())
