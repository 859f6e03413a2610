"""What a check says of a program: which claims came out otherwise than declared, which tests failed."""

import dataclasses
import json
import os
import pathlib
import subprocess
import xml.etree.ElementTree as xml

LONGEST = 300  # seconds; a check takes a few


class NoAnswer(RuntimeError):
    """The check crashed, ran out of time or ended by an exception: nothing was noticed, something broke."""


@dataclasses.dataclass
class Finding:
    """What a claim measured, what it was allowed, and its verdict; of a test that is no claim the verdict alone."""

    verdict: str
    unexpected: bool
    measured: float | None = None
    limit: float | None = None


def command(check, program, folder):
    if check.is_case:
        settings = [word for setting in check.settings for word in ("--set", setting)]
        return [program, "run", check.stem, *settings, "--jobs", "1", "--out", folder]
    return [program, "--filenames-as-tags", f"[#{check.stem}]", "-r", "junit", "-o", folder / "tests.xml"]


def of_record(path):
    """"record: claim" -> Finding; none of a run that did not finish."""
    record = json.loads(path.read_text())
    if record["status"] != "finished":
        return {}
    return {f"{record['case']}: {claim['id']}": Finding(claim["verdict"], not claim["as_declared"], claim["measured"],
                                                        claim["criterion"]["limit"])
            for claim in record["claims"]}


def of_tests(path):
    """"test: name" -> Finding, of Catch2's JUnit file; the sections of a test count as the test."""
    findings = {}
    for case in xml.parse(path).getroot().iter("testcase"):
        name = f"test: {case.get('name').split('/')[0]}"
        if case.find("error") is not None:
            findings[name] = Finding("error", True)
        elif case.find("failure") is not None:
            findings.setdefault(name, Finding("fail", True))
    return findings


def findings(check, program, folder):
    """Runs a check with a program; what was measured and which tests failed. Throws NoAnswer."""
    folder.mkdir(parents=True)
    environment = {**os.environ, "SEICHE_EVIDENCE": str(folder), "OMP_NUM_THREADS": "1"}
    try:
        ended = subprocess.run(command(check, program, folder), env=environment, cwd=folder, capture_output=True,
                               text=True, timeout=LONGEST)
    except subprocess.TimeoutExpired:
        raise NoAnswer(f"takes more than {LONGEST} s") from None
    said = (ended.stdout + ended.stderr)[-2000:]
    if ended.returncode < 0:
        raise NoAnswer(f"crashes, signal {-ended.returncode}:\n{said}")
    found = {}
    for record in sorted(folder.glob("*.json")):
        found |= of_record(record)
    if (folder / "tests.xml").is_file():
        found |= of_tests(folder / "tests.xml")
    if not found:
        # Tests that are no claims and all pass leave nothing behind; so do tests that did not run.
        if check.is_case or ended.returncode != 0 or not ran_tests(folder / "tests.xml"):
            raise NoAnswer(f"says nothing, status {ended.returncode}:\n{said}")
    return found


def ran_tests(path):
    return pathlib.Path(path).is_file() and any(True for _ in xml.parse(path).getroot().iter("testcase"))
