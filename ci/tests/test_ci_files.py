"""The files for CI systems: their form by schemas, and their shell steps by running them on a solver's result."""

import csv
import json
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import tempfile
import unittest

import jsonschema
import yaml

import junit

SEICHE = pathlib.Path(os.environ["SEICHE"])
SOURCE = pathlib.Path(os.environ["SEICHE_SOURCE"])
SCHEMAS = pathlib.Path(__file__).resolve().parent / "schemas"

WORKFLOWS = sorted((SOURCE / ".github/workflows").glob("*.yml"))
ACTION = SOURCE / "ci/score-action/action.yml"
GITLAB = [SOURCE / ".gitlab-ci.yml", SOURCE / "ci/gitlab/score.yml"]


class Loader(yaml.SafeLoader):
    """YAML 1.2 as the CI systems read it: only true and false are booleans, `on` is a word; no key comes twice."""

    yaml_implicit_resolvers = {first: [entry for entry in entries if entry[0] != "tag:yaml.org,2002:bool"]
                               for first, entries in yaml.SafeLoader.yaml_implicit_resolvers.items()}

    def construct_mapping(self, node, deep=False):
        keys = [key.value for key, _ in node.value]
        if len(keys) != len(set(keys)):
            raise yaml.YAMLError(f"a key comes twice: {keys}, {node.start_mark}")
        return super().construct_mapping(node, deep)


Loader.add_implicit_resolver("tag:yaml.org,2002:bool", re.compile("^(true|false)$"), "tf")


def read(path):
    return yaml.load(path.read_text(), Loader)


def schema(name, part=None):
    whole = json.loads((SCHEMAS / f"{name}.schema.json").read_text())
    return jsonschema.Draft202012Validator({**whole, "$ref": f"#/$defs/{part}"} if part else whole)


def faults(validator, document):
    return [f"{'/'.join(map(str, error.absolute_path))}: {error.message}" for error in validator.iter_errors(document)]


def shell_steps():
    """(file, shell text) of every step."""
    for path in WORKFLOWS:
        for job in read(path)["jobs"].values():
            yield from ((path, step["run"]) for step in job["steps"] if "run" in step)
    yield from ((ACTION, step["run"]) for step in read(ACTION)["runs"]["steps"] if "run" in step)
    for path in GITLAB:
        for job in read(path).values():
            yield from ((path, "\n".join(job[key])) for key in ("before_script", "script") if key in job)


def usage(path):
    """The example in the comment that opens a file."""
    comment = path.read_text().split("\n\n")[0].splitlines()
    return yaml.load("\n".join(line[4:] for line in comment if line.startswith("#   ")), Loader)


class Form(unittest.TestCase):
    def test_files_fit_their_schemas(self):
        for path in WORKFLOWS:
            self.assertEqual(faults(schema("github", "workflow"), read(path)), [], path)
        self.assertEqual(faults(schema("github", "action"), read(ACTION)), [])
        for path in GITLAB:
            self.assertEqual(faults(schema("gitlab-ci"), read(path)), [], path)

    def test_each_change_for_the_worse_is_found(self):
        for path, validator, before, after in [
                (WORKFLOWS[0], schema("github", "workflow"), "@v4", "@main"),
                (WORKFLOWS[0], schema("github", "workflow"), "run: .ci/run", "runs: .ci/run"),
                (WORKFLOWS[0], schema("github", "workflow"), "timeout-minutes", "timeout"),
                (WORKFLOWS[0], schema("github", "workflow"), "run: .ci/run", 'run: echo "${{ github.ref }}"'),
                (WORKFLOWS[1], schema("github", "workflow"), "17 2 * * 0", "weekly"),
                (ACTION, schema("github", "action"), "      shell: bash\n", ""),
                (ACTION, schema("github", "action"), "composite", "docker"),
                (GITLAB[0], schema("gitlab-ci"), "junit:", "unit:"),
                (GITLAB[0], schema("gitlab-ci"), "  script:", "  scripts:"),
                (GITLAB[1], schema("gitlab-ci"), "debian:bookworm", "debian")]:
            with self.subTest(path=path.name, before=before):
                text = path.read_text()
                self.assertIn(before, text)
                self.assertNotEqual(faults(validator, yaml.load(text.replace(before, after), Loader)), [])
        with self.assertRaises(yaml.YAMLError):
            yaml.load("a: 1\na: 2\n", Loader)

    def test_shell_steps_are_shell(self):
        steps = list(shell_steps())
        self.assertGreaterEqual(len(steps), 8)
        script = (SOURCE / "ci/score-files", (SOURCE / "ci/score-files").read_text())
        for path, text in [*steps, script]:
            with self.subTest(path=path.name, text=text):
                checks = [["bash", "-n"]]
                if shutil.which("shellcheck"):
                    checks.append(["shellcheck", "--shell=bash", "-"])
                for check in checks:
                    result = subprocess.run(check, input=text, capture_output=True, text=True)
                    self.assertEqual(result.returncode, 0, result.stdout + result.stderr)

    def test_what_a_step_calls_is_there(self):
        called = [word.replace("/usr/share/seiche/", "") for _, text in shell_steps() for line in text.splitlines()
                  for word in shlex.split(line, comments=True) if re.search(r"(^|/)\.?ci/", word)]
        self.assertLessEqual({".ci/run", "ci/report", "ci/checks/sanitize", "ci/checks/coverage", "ci/score-files"}, set(called))
        for word in called:
            self.assertTrue(os.access(SOURCE / word, os.X_OK), word)

    def test_inputs_are_declared_and_used(self):
        text = ACTION.read_text()
        declared = set(read(ACTION)["inputs"])
        self.assertEqual(set(re.findall(r"\binputs\.([a-z-]+)", text)), declared)
        for path in [*WORKFLOWS, ACTION]:
            for expression in re.findall(r"\$\{\{ (.*?) \}\}", path.read_text()):
                self.assertRegex(expression, r"^(inputs\.[a-z-]+|matrix\.what|!cancelled\(\))$")
        step = next(step for step in usage(ACTION)["jobs"]["waves"]["steps"] if "uses" in step)
        self.assertEqual(step["uses"].split("@")[0], "OWNER/seiche/ci/score-action")
        self.assertLessEqual(set(step["with"]), declared)
        required = {name for name, entry in read(ACTION)["inputs"].items() if entry.get("required")}
        self.assertLessEqual(required, set(step["with"]))

    def test_variables_of_the_gitlab_example_are_read(self):
        example = usage(GITLAB[1])
        job = read(GITLAB[1])[example["waves"]["extends"]]
        read_there = set(re.findall(r"SEICHE_[A-Z]+", (SOURCE / "ci/score-files").read_text() + json.dumps(job)))
        self.assertLessEqual(set(example["waves"]["variables"]), read_there)
        self.assertTrue(example["include"].endswith("ci/gitlab/score.yml"))

    def test_no_secrets(self):
        for path in [*WORKFLOWS, ACTION, *GITLAB]:
            self.assertNotRegex(path.read_text(), r"(?i)secrets\.|passw|token|BEGIN [A-Z ]*KEY")

    def test_container(self):
        text = (SOURCE / "ci/Containerfile").read_text().replace("\\\n", "")
        lines = [line for line in text.splitlines() if line and not line.startswith("#")]
        words = [line.split(maxsplit=1) for line in lines]
        self.assertEqual([word for word, _ in words], ["FROM", "COPY", "RUN", "WORKDIR", "ENTRYPOINT"])
        arguments = dict(words)
        self.assertRegex(arguments["FROM"], r"^debian:[a-z-]+$")
        self.assertEqual(json.loads(arguments["ENTRYPOINT"]), ["seiche"])
        result = subprocess.run(["bash", "-n"], input=arguments["RUN"], capture_output=True, text=True)
        self.assertEqual(result.returncode, 0, result.stderr)


class Steps(unittest.TestCase):
    """The shell steps for other projects, with an installed seiche; only apt-get, sudo and curl are stand-ins."""

    @classmethod
    def setUpClass(cls):
        scratch = tempfile.TemporaryDirectory(prefix="seiche-test-")
        cls.addClassCleanup(scratch.cleanup)
        cls.folder = pathlib.Path(scratch.name)
        cls.prefix = cls.folder / "usr"
        subprocess.run(["cmake", "--install", SEICHE.parent, "--prefix", cls.prefix], check=True, capture_output=True)
        stubs = cls.folder / "stubs"
        stubs.mkdir()
        for name, text in [("apt-get", f'echo "$*" >>{cls.folder}/apt-get.log\n'), ("sudo", 'exec "$@"\n'),
                           ("curl", 'while [ "$1" != -o ]; do shift; done\ncp "${3#file://}" "$2"\n')]:
            (stubs / name).write_text("#!/bin/sh\n" + text)
            (stubs / name).chmod(0o755)
        cls.path = f"{stubs}:{cls.prefix}/bin:{os.environ['PATH']}"
        (cls.folder / "seiche_0.1.0.deb").write_text("a package\n")
        cls.package = f"file://{cls.folder}/seiche_0.1.0.deb"
        template = subprocess.run([SEICHE, "score", "riemann", "--template"], check=True, capture_output=True,
                                  text=True).stdout
        rows = list(csv.reader(line for line in template.splitlines() if not line.startswith("#")))[1:]
        points = [word for row in rows for word in ("--at", f"x={row[0]},t=6")]
        exact = subprocess.run([SEICHE, "exact", "riemann", "--set", "jump=20", "--set", "right_depth=0.1", *points],
                               check=True, capture_output=True, text=True).stdout
        (cls.folder / "mine.csv").write_text(exact)
        (cls.folder / "bad.csv").write_text("x,h,u\n" + "".join(f"{row[0]},0.5,0\n" for row in rows))

    def run_steps(self, texts, variables, report):
        """Runs shell texts one after the other until one fails; the status, and what they said. A report is drawn where
        it is looked at."""
        if not report:
            variables = {**variables, "SEICHE_PYTHON": "true"}
        work = pathlib.Path(tempfile.mkdtemp(dir=self.folder))
        said = ""
        for text, of_step in texts:
            for place, here in [("/tmp/", f"{work}/"), ("/usr/share/", f"{self.prefix}/share/")]:
                text = text.replace(place, here)
            result = subprocess.run(
                ["bash", "-eo", "pipefail", "-c", text], cwd=work, capture_output=True, text=True,
                env={"PATH": self.path, "HOME": str(work), "XDG_CACHE_HOME": f"{self.folder}/cache", "RUNNER_TEMP": str(work),
                     **variables, **of_step})
            said += result.stdout + result.stderr
            if result.returncode:
                break
        return result.returncode, said, work

    def github(self, summary="", report=False, **given):
        action = read(ACTION)
        inputs = {name: entry.get("default", "") for name, entry in action["inputs"].items()}
        self.assertLessEqual(set(given), set(inputs))
        inputs.update(given, package=self.package)
        fill = lambda text: re.sub(r"\$\{\{ inputs\.([a-z-]+) \}\}", lambda match: inputs[match[1]], text)
        texts = [(step["run"], {name: fill(value) for name, value in step["env"].items()})
                 for step in action["runs"]["steps"] if "run" in step]
        return self.run_steps(texts, {"GITHUB_STEP_SUMMARY": summary} if summary else {}, report)

    def gitlab(self, report=False, **given):
        job = read(GITLAB[1])[".seiche-score"]
        variables = {**job["variables"], **{f"SEICHE_{name.upper()}": value for name, value in given.items()}}
        return self.run_steps([("\n".join(job["before_script"] + job["script"]), {})],
                              {**variables, "SEICHE_PACKAGE": self.package}, report)

    def published(self, work, color):
        """What a CI system would take: JUnit without faults, the report, the badge."""
        self.assertEqual(junit.faults(work / "seiche/junit.xml"), [])
        self.assertTrue((work / "seiche/report/index.html").is_file())
        badge = json.loads((work / "seiche/report/badge.json").read_text())
        self.assertEqual(faults(schema("badge"), badge), [])
        self.assertEqual(badge["color"], color, badge)

    def test_a_good_result(self):
        for steps in (self.github, self.gitlab):
            status, said, work = steps(case="riemann", data=str(self.folder / "mine.csv"), solver="mine",
                                       report=True)
            self.assertEqual(status, 0, said)
            self.published(work, "brightgreen")
            self.assertEqual((work / "seiche.deb").read_text(), "a package\n")
            installed = (self.folder / "apt-get.log").read_text()
            self.assertIn(f"install -q -y --no-install-recommends {work}/seiche.deb\n", installed)

    def test_a_wrong_result_fails_and_is_published(self):
        for steps in (self.github, self.gitlab):
            status, said, work = steps(case="riemann", data=str(self.folder / "bad.csv"), solver="bad", report=True)
            self.assertEqual(status, 1, said)
            self.published(work, "red")

    def test_options_reach_the_command(self):
        text = (self.folder / "bad.csv").read_text().replace("x,h,u", "place,depth,u")
        (self.folder / "other.csv").write_text(text)
        given = {"case": "riemann", "data": f"{self.folder}/other.csv\n", "solver": "mine", "map": "place=x,depth=h"}
        for steps in (self.github, self.gitlab):
            status, said, work = steps(**given, set="time=5", uncertainty="h=1%")
            self.assertEqual(status, 1, said)
            record = json.loads((work / "seiche/riemann.mine.json").read_text())
            self.assertEqual(record["parameters"]["time"]["value"], 5)
            status, said, _ = steps(**given, uncertainty="h=-1")
            self.assertEqual(status, 2, said)
            self.assertIn("h = -1", said)

    def too_deep(self, share, name):
        """The good result with a depth too large by that share."""
        names, *rows = csv.reader(line for line in (self.folder / "mine.csv").read_text().splitlines() if line[:1] != "#")
        at = next(k for k, column in enumerate(names) if column.split(" ")[0] == "h")
        for row in rows:
            row[at] = repr((1 + share) * float(row[at]))
        (self.folder / name).write_text("\n".join(",".join(row) for row in [names, *rows]) + "\n")
        return str(self.folder / name)

    def test_several_sizes_give_order_and_cost(self):
        files = [self.too_deep(0.02 * size, f"{size}.csv") for size in (4, 2, 1)]
        for steps in (self.github, self.gitlab):
            status, said, work = steps(case="riemann", data="\n".join(files), solver="mine", sizes="4,2,1", seconds="1,2,4",
                                       threads="2", report=True)
            self.assertIn("h: your order is 1 ", said)
            self.assertIn(status, (0, 1), said)
            record = json.loads((work / "seiche/riemann.mine.json").read_text())
            self.assertEqual((record["wall_time"], record["measurements"]["cell_size"]), (4, 1))
            self.assertEqual(record["measurements"]["threads"], 2)
            self.assertIn("Error against cost", (work / "seiche/report/cases/riemann.html").read_text())

    def test_a_baseline_is_made_only_where_that_is_said_and_kept(self):
        good, worse = self.too_deep(0.001, "good.csv"), self.too_deep(0.02, "worse.csv")
        for number, steps in enumerate((self.github, self.gitlab)):
            kept = self.folder / f"kept-{number}"
            given = {"case": "riemann", "solver": "mine", "baseline": str(kept)}
            status, said, _ = steps(**given, data=good)
            self.assertEqual(status, 2, said)
            self.assertIn("--bless", said)
            self.assertFalse(kept.exists())
            status, said, _ = steps(**given, data=good, bless="true")
            self.assertEqual(status, 0, said)
            first = (kept / "riemann.mine.json").read_bytes()
            status, said, work = steps(**given, data=worse, report=True)
            self.assertEqual(status, 1, said)
            self.assertIn("WORSE", said)
            self.assertTrue((work / "seiche/report/index.html").is_file())
            self.assertEqual((kept / "riemann.mine.json").read_bytes(), first)
            status, said, _ = steps(**given, data=good, bless="yes")
            self.assertEqual(status, 2, said)
            self.assertIn("true or false", said)

    def test_wrong_input_is_status_2(self):
        for given, word in [({"case": "rieman", "data": "mine.csv"}, "mine.csv"),
                            ({"case": "rieman", "data": str(self.folder / "mine.csv")}, "rieman")]:
            for steps in (self.github, self.gitlab):
                status, said, _ = steps(**given)
                self.assertEqual(status, 2, said)
                self.assertIn(word, said)

    def test_the_scores_are_in_the_summary(self):
        summary = self.folder / "summary.md"
        self.github(summary=str(summary), case="riemann", data=str(self.folder / "mine.csv"))
        self.assertEqual(summary.read_text().count("```"), 2)
        self.assertIn("pass", summary.read_text())


if __name__ == "__main__":
    unittest.main()
