"""Checks: what runs against a changed program, and what it says."""

import dataclasses
import json
import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import threading
import xml.etree.ElementTree as xml

PROJECT = {  # what else decides a file, by its path: programs of ci.* and of the report, the cheapest first
    "reports/render/atlas": ["ci/tests/test_command.py"],
    "reports/render/": ["reports/render/tests"],
    "solver/python/module": ["solver/python/tests"],
    "solver/python/seiche/adapt": ["ci/tests/test_adapt.py"],
    "solver/python/seiche/readers": ["ci/tests/test_adapt.py"],
    "solver/python/seiche/": ["solver/python/tests"],
    "solver/seiche/exact/": ["solver/python/tests"],
    "reports/evidence/": ["ci/tests/test_junit.py", "ci/tests/test_command.py"],
    "validation/case/": ["ci/tests/test_command.py", "ci/tests/test_interruptions.py"],
    "validation/laboratory/": ["ci/tests/test_command.py"],
    "validation/command/": ["ci/tests/test_options.py", "ci/tests/test_score_gates.py", "ci/tests/test_command.py",
                            "ci/tests/test_score.py", "ci/tests/test_exact_inputs.py", "ci/tests/test_wrong_results.py"],
    "validation/scoring/": ["ci/tests/test_options.py", "ci/tests/test_parts_of_results.py",
                            "ci/tests/test_solver_files.py", "ci/tests/test_score.py", "ci/tests/test_score_gates.py",
                            "ci/tests/test_wrong_results.py",
                            "ci/tests/test_resolving_power.py"],
}


class NoAnswer(RuntimeError):
    """The check crashed, ran out of time or ended by an exception."""


@dataclasses.dataclass(frozen=True)
class Check:
    """A test file of verification, a case with its parameters, or tests in Python: a file or a folder of them."""

    file: str
    settings: tuple[str, ...] = ()

    @property
    def stem(self):
        return pathlib.PurePath(self.file).stem

    @property
    def is_case(self):
        return self.file.startswith("validation/")

    @property
    def is_python(self):
        return not self.file.endswith(".cpp")

    @property
    def target(self):
        """What Ninja calls the program that runs it."""
        if self.file.startswith("solver/python") or self.file == "ci/tests/test_adapt.py":
            return "seiche_python"
        return f"verify_{pathlib.PurePath(self.file).parts[1]}" if self.file.startswith("verification/") else "seiche_command"

    def command(self, program, folder, tree):
        if self.is_python:
            if self.file.startswith("solver/python"):
                return [sys.executable, "-Bm", "pytest", "-qx", "-p", "no:cacheprovider", tree / self.file]
            if self.file.endswith(".py"):
                return [sys.executable, "-B", tree / self.file, "-f"]
            return [sys.executable, "-Bm", "unittest", "discover", "-f", "-s", tree / self.file]
        if self.is_case:
            settings = [word for setting in self.settings for word in ("--set", setting)]
            return [program, "run", self.stem, *settings, "--jobs", "1", "--out", folder]
        return [program, "--filenames-as-tags", f"[#{self.stem}]~[full]", "-r", "junit", "-o", folder / f"{self.stem}.xml"]

    def __str__(self):
        return " ".join([self.file, *self.settings])


@dataclasses.dataclass
class Finding:
    """What a claim measured, what it was allowed, and its verdict; of a test that is no claim the verdict alone."""

    verdict: str
    unexpected: bool


def of_record(path):
    """"record: claim" -> Finding; none of a run that did not finish."""
    record = json.loads(path.read_text())
    if record["status"] != "finished":
        return {}
    return {f"{record['case']}: {claim['id']}": Finding(claim["verdict"], not claim["as_declared"])
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


def ended(command, environment, folder, seconds):
    """(status, what it said, seconds of the processor) of a command; after so many of these it is stopped."""
    with tempfile.TemporaryFile("w+", errors="replace") as said:
        process = subprocess.Popen(["prlimit", f"--cpu={round(seconds)}", *command], env=environment, cwd=folder, stdout=said,
                                   stderr=subprocess.STDOUT)
        waits_for_ever = threading.Timer(30 * seconds, process.kill)
        waits_for_ever.start()
        _, status, used = os.wait4(process.pid, 0)
        waits_for_ever.cancel()
        process.returncode = os.waitstatus_to_exitcode(status)
        said.seek(0)
        return process.returncode, said.read(), used.ru_utime + used.ru_stime


def findings(check, program, folder, tree, seconds, extra={}, spent=lambda seconds: None):
    """Runs a check; what was measured and which tests failed. Throws NoAnswer.

    @param folder   where records go; those of other checks may be there
    @param tree     the sources with the change, as far as programs in Python read them
    @param seconds  of the processor, after which it is stopped
    @param extra    environment
    @param spent    is told the seconds of the processor that it took
    """
    folder.mkdir(parents=True, exist_ok=True)
    before = set(folder.glob("*.json"))
    package = str(program.parent.parent)  # of the module: the command lies beside it
    command = program.parents[2] / "seiche" if check.target == "seiche_python" else program
    environment = {**os.environ, "SEICHE_EVIDENCE": str(folder), "OMP_NUM_THREADS": "1", "SEICHE": str(command),
                   "SEICHE_SOURCE": str(tree), "PYTHON": sys.executable, "PYTHONPATH": package, "SEICHE_PYTHON_PATH": package}
    status, whole, used = ended(check.command(program, folder, tree), environment | extra, folder, seconds)
    spent(used)
    said = whole[-2000:]
    if status == -signal.SIGTERM:
        raise InterruptedError(f"{check} was stopped from outside")
    if status < 0:
        raise NoAnswer(f"crashes, signal {-status}:\n{said}")
    if check.is_python:
        failed = re.search(r"^(?:FAIL|ERROR|FAILED):? (.*)", whole, re.M)
        return {f"test: {failed[1] if failed else check.stem}": Finding("fail", True)} if status else {}
    found = {}
    for record in sorted(set(folder.glob("*.json")) - before):
        found |= of_record(record)
    tests = folder / f"{check.stem}.xml"
    if tests.is_file():
        found |= of_tests(tests)
    if not found and (check.is_case or status or not any(True for _ in xml.parse(tests).getroot().iter("testcase"))):
        # Tests that are no claims and all pass leave nothing behind; so do tests that did not run.
        raise NoAnswer(f"says nothing, status {status}:\n{said}")
    return found
