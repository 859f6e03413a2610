"""Every command that the READMEs show is run as it stands there, in its order, by a newcomer: in a copy of the files
that git knows, beside the finished build, with nothing in the environment that the text does not put there.

What is not run is named in NOT_RUN with the reason; nothing else is left out, and nothing is named that is not there.
ci/checks/time-build runs this after a cold ci/report alone.
"""

import csv
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

SEICHE = pathlib.Path(os.environ["SEICHE"])
SOURCE = pathlib.Path(os.environ["SEICHE_SOURCE"])
BUILD = SEICHE.parent

DOCUMENTS = [SOURCE / "README.md", SOURCE / "CONTRIBUTING.md", *sorted(SOURCE.glob("examples/*/README.md")),
             *sorted(SOURCE.glob("ci/docs_pages/guide/*.md"))]

DOCS = "ctest ci.docs runs it"
WHOLE_BUILD = "sets up and builds everything; ci/checks/time-build and CI run it (.ci/run, .github/workflows)"
LONG = "a tier of an hour or more"
MUTANTS = "builds first; ctest ci.mutate does the same with two faults"
PETSC = "needs PETSc and MPI"
PATTERN = "a pattern, its words are to be replaced"
INSTALLS = "installs packages"
PACKAGES = "builds everything and makes packages of it; ctest ci.packages looks into them"
CTEST = "a part of ctest, which runs this test"
SOLVERS = "installs solvers and runs them for minutes; ctest ci.solvers runs the coarsest of those that are there"
RELEASE = "makes a release"
ADAPT = "the name of a program; its --help is run in passing"

NOT_RUN = {
    "README.md": {
        "ci/report": WHOLE_BUILD,
        "ci/test": WHOLE_BUILD,
        "ci/setup": INSTALLS,
        "ci/mutate": LONG,
        "ci/checks/fuzz": "millions of inputs; ctest robustness damages a hundred thousand",
        "ci/checks/long full": LONG,
        "ci/checks/long paper": LONG,
        "ctest -L full": LONG,
        "ctest -L paper": LONG,
        "seiche report DIR --pdf report.pdf": PATTERN,
        "ci/docs": DOCS,
        "seiche report": "the name of a subcommand",
        "seiche score": "the name of a subcommand",
        "python3 -m seiche.adapt": ADAPT,
        "seiche exact": "the name of a subcommand",
        "ci/package": PACKAGES,
        "ci/package --test": PACKAGES,
        "apt install ./build/packages/*.deb": INSTALLS,
        "ci/checks/petsc": PETSC,
        "ci/checks/solvers": SOLVERS,
        "ci/checks/sanitize thread": WHOLE_BUILD,
        "ci/checks/coverage": WHOLE_BUILD,
        "ci/checks/tidy": WHOLE_BUILD,
    },
    "CONTRIBUTING.md": {
        "ci/build release seiche_command": WHOLE_BUILD,
        "ci/checks/verify evidence": WHOLE_BUILD,
        "ci/checks/verify --tier full": LONG,
        "ci/checks/time-build": WHOLE_BUILD,
        "ci/test": WHOLE_BUILD,
        "ci/checks/tidy": WHOLE_BUILD,
        "ci/docs": DOCS,
        "ci/mutate": LONG,
        "ci/mutate --seed 20261126 --count 600": LONG,
        "ci/mutate --changed origin/main": MUTANTS,
        "ci/mutate --seeded linear": MUTANTS,
        "ci/checks/sanitize": WHOLE_BUILD,
        "ci/setup": INSTALLS,
        "ci/setup clang-format": INSTALLS,
        "seiche compare EVIDENCE --record": PATTERN,
        "seiche run CASE --as sph-fig-6": PATTERN,
        "ci/checks/record quick": WHOLE_BUILD,
        "ci/checks/record full": LONG,
        "ci/checks/record paper": LONG,
        "ctest --preset release -R '^bore.moving_bore'": CTEST,
        "ctest --preset release -R '^evidence:'": CTEST,
        "ctest --preset release -R 'every reference table'": CTEST,
        "clang-format -i $(git ls-files '*.cpp' '*.hpp')": "changes the sources",
        "version=$(sed -nE 's/^project\\(seiche VERSION ([0-9.]+).*/\\1/p' CMakeLists.txt)": RELEASE,
    },
    "examples/cluster/README.md": {
        "ci/checks/petsc": PETSC,
        "cmake --preset petsc && cmake --build --preset petsc --target seiche_parallel": PETSC,
        "mpirun -n 4 build/petsc/seiche-parallel hump --columns 800 --rows 400 --time 20 --every 5 --out run": PETSC,
        "mpirun -n 4 build/petsc/seiche-parallel reflection --amplitude 0.3 --angle 30 --time 600 --step 0.25 --out run":
            PETSC,
        "mpirun -n 4 build/petsc/seiche-parallel island --amplitude 0.096 --spacing 0.5 --time 40 --out run": PETSC,
        "seiche run mach_reflection --set angle=... --set amplitude=...": PATTERN,
        "import h5py": "reads the fields of a run that needs PETSc",
        "#!/bin/bash": "a job of a cluster; its syntax is checked",
    },
    "ci/docs_pages/guide/verdicts.md": {
        "seiche score": "the name of a subcommand",
    },
    "examples/solvers/README.md": {
        "python3 -m seiche.adapt": ADAPT,
        "ci/checks/solvers": SOLVERS,
    },
    "examples/coupling/README.md": {
        "ci/build release seiche_c": "ctest compiles and runs both programs",
        "[~, text] = system('seiche exact solitary --set amplitude=0.3,gravity=9.81 --grid x=-10:10:401,t=0 --format json');":
            "needs MATLAB or Octave",
        "using JSON": "needs Julia",
    },
    "examples/score_your_solver/README.md": {
        "./run.sh": "ctest ci.install runs it",
        "ci/build release": WHOLE_BUILD,
        "seiche score CASE --data coarse.csv --data medium.csv --data fine.csv --sizes 0.1,0.05,0.025 --seconds 2,15,130":
            PATTERN,
    },
}


def fill_in_template(folder):
    """What the reader's own solver would do to mine.csv: here, the exact solution at the template's points."""
    lines = [line for line in (folder / "mine.csv").read_text().splitlines() if not line.startswith("#")]
    points = [word for row in csv.reader(lines[1:]) for word in ("--at", f"x={row[0]},t=6")]
    exact = subprocess.run([SEICHE, "exact", "riemann", "--set", "jump=20", "--set", "right_depth=0.1", *points],
                           check=True, capture_output=True, text=True)
    (folder / "mine.csv").write_text(exact.stdout)


def other_evidence(folder):
    """As if from another day: the same records."""
    shutil.copytree(folder / "evidence", folder / "other_evidence", dirs_exist_ok=True)


def openfoam_folder(folder):
    """What a run of examples/solvers/openfoam has written."""
    shutil.copytree(SOURCE / "ci/tests/solver_output/shallowWaterFoam", folder / "run/postProcessing", dirs_exist_ok=True)


def textbook_result(folder):
    program = SOURCE / "examples/score_your_solver/textbook_finite_volume.py"
    subprocess.run([sys.executable, program, "--flux", "rusanov", "--order", "1", "--output", "rusanov.csv"],
                   cwd=folder, check=True, capture_output=True)


def three_sizes(folder):
    program = SOURCE / "examples/score_your_solver/textbook_finite_volume.py"
    for name, cells in (("a.csv", "50"), ("b.csv", "100"), ("c.csv", "200")):
        subprocess.run([sys.executable, program, "--flux", "hll", "--order", "2", "--cells", cells, "--output", name],
                       cwd=folder, check=True, capture_output=True)


def centres(folder):
    """What OpenFOAM writes of a mesh of 40 by 8 cells."""
    cells = [f"({x:g} 0.05 {z:g})" for z in (0.05, 0.15, 0.25, 0.35, 0.45, 0.55, 0.65, 0.75) for x in range(40)]
    (folder / "0").mkdir(exist_ok=True)
    (folder / "0/C").write_text("format ascii;\ninternalField nonuniform List<vector>\n"
                                f"{len(cells)}\n(\n" + "\n".join(cells) + "\n)\n;\nboundaryField {}\n")


# What must be there before a command, because the text says that the reader has it. (`./seiche` counts as `seiche`.)
BEFORE = {
    "seiche exact solitary --write openfoam --centres 0/C --origin 10,0.4 --out 0": centres,
    "seiche score riemann --data a.csv --data b.csv --data c.csv --sizes 1,0.5,0.25": three_sizes,
    "seiche compare evidence other_evidence": other_evidence,
    "seiche score riemann --data rusanov.csv --solver textbook-rusanov --out evidence": textbook_result,
    "seiche score riemann --data run/postProcessing/profile --map U_x=u --dx 1 --solver shallowWaterFoam --out evidence":
        openfoam_folder,
    "seiche score riemann --data mine.csv --solver mine --out evidence": fill_in_template,
}

# What a text says in passing, as somebody does it who follows it.
PYTHON_LINES = ["python3 -c \"import seiche; print(seiche.exact('solitary', amplitude=0.3, gravity=9.81).scalars)\"",
                "python3 -m seiche.adapt --help"]
IN_PASSING = {"README.md": PYTHON_LINES + [f"PYTHONPATH=build/release/python {line}" for line in PYTHON_LINES]}

SHELL_STATE = ("cd ", "export ")
PROGRAMS = ("seiche", "./seiche", "build/release/seiche", "./run.sh", "cmake", "ctest", "mpirun", "clang-format",
            "sha256sum", "apt", "python3")


def is_command(line):
    first = line.split(maxsplit=1)[0]
    return first in PROGRAMS or re.fullmatch(r"\.?ci/(checks/)?[a-z-]+", first)


def kind_of(block):
    """What a block of code is in; shell when every line begins with a command."""
    if block.startswith(">>> "):
        return "dialogue"
    if block.startswith("#!/bin/bash"):
        return "script"
    if block.startswith("#include"):
        return "c++"
    if block.startswith("import "):
        return "python"
    if re.match(r"[a-z_/]+/ {2,}\S", block):
        return "layout"
    if all(line == "..." or line.startswith(SHELL_STATE) or is_command(line) for line in commands_in(block)):
        return "shell"
    return None


def commands_in(block):
    """Lines of a shell block, continued lines joined, comments gone."""
    joined = re.sub(r"\\\n\s*", "", block)
    lines = [re.sub(r"(^|\s+)# .*", "", line).strip() for line in joined.splitlines()]
    return [line for line in lines if line]


def snippets(path):
    """(kind, text) of every block of code and of every command in running text, in the document's order."""
    text = path.read_text()
    pattern = re.compile(r"^```(?P<language>\w*)\n(?P<fenced>(?:.*\n)*?)```$"
                         r"|(?<=\n\n)(?P<indented>(?: {4}.*\n|\n(?= {4}))+)"
                         r"|`(?P<inline>[^`]+)`", re.M)
    for match in pattern.finditer(text):
        if match["inline"]:
            inline = " ".join(match["inline"].split())
            if is_command(inline) and (" " in inline or "/" in inline):
                yield "inline", inline
        elif match["fenced"] is not None and match["language"] not in ("", "sh", "bash"):
            yield match["language"], match["fenced"]
        else:
            block = match["fenced"] or re.sub(r"^ {4}", "", match["indented"], flags=re.M)
            yield kind_of(block), block


# For systems without manuals: finds a page where man would, beside the folders of programs.
MAN = '#!/bin/sh\nIFS=:\nfor at in $PATH; do test -f "$at/../share/man/man1/$1.1.gz" && exit; done\nexit 16\n'


def check_out(folder):
    """The files that git knows."""
    known = subprocess.run(["git", "-c", "safe.directory=*", "ls-files", "-z"], cwd=SOURCE, check=True,
                           capture_output=True).stdout
    subprocess.run(["xargs", "-0", "cp", "--parents", "-t", folder], cwd=SOURCE, check=True, input=known)


class Place:
    """A checkout with a fresh build as the text speaks of it; what commands write stays in it."""

    def __init__(self, folder, checkout):
        self.folder = folder
        self.checkout = checkout
        self.directory = self.checkout
        release = self.checkout / "build/release"
        shutil.rmtree(release, ignore_errors=True)
        release.mkdir(parents=True)
        for entry in BUILD.iterdir():
            if entry.name not in ("evidence", "Testing"):
                (release / entry.name).symlink_to(entry)
        for name in ("home", "tmp", "bin"):
            (folder / name).mkdir()
        (folder / "bin/seiche").symlink_to(SEICHE)
        (folder / "bin/python3").symlink_to(sys.executable)
        if not shutil.which("man"):
            (folder / "bin/man").write_text(MAN)
            (folder / "bin/man").chmod(0o755)
        self.environment = {**os.environ, "HOME": str(folder / "home"), "PATH": f"{folder}/bin:{os.environ['PATH']}",
                            "XDG_CACHE_HOME": str(checkout.parent / "cache")}
        self.environment.pop("PYTHONPATH", None)

    def run(self, *words, **options):
        return subprocess.run(words, cwd=self.directory, env=self.environment, capture_output=True, text=True,
                              timeout=300, **options)

    def shell(self, command):
        command = command.replace("/tmp/", f"{self.folder}/tmp/")
        if not command.startswith(SHELL_STATE):
            return self.run("bash", "-c", command)
        result = self.run("bash", "-c", f"{command} && pwd && env -0")
        if result.returncode == 0:
            directory, _, variables = result.stdout.partition("\n")
            self.directory = pathlib.Path(directory)
            self.environment = dict(entry.split("=", 1) for entry in variables.split("\0") if entry)
        return result


class Readme(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.checkout = pathlib.Path(cls.enterClassContext(tempfile.TemporaryDirectory(prefix="seiche-test-")), "seiche")
        cls.checkout.mkdir()
        check_out(cls.checkout)

    def setUp(self):
        folder = self.enterContext(tempfile.TemporaryDirectory(prefix="seiche-test-"))
        self.place = Place(pathlib.Path(folder), self.checkout)

    def succeed(self, what, result):
        self.assertEqual(result.returncode, 0, f"{what}\n{result.stdout}{result.stderr}")

    def check(self, path):
        """Runs a document; returns the names of what it left out."""
        not_run = NOT_RUN.get(str(path.relative_to(SOURCE)), {})
        left_out = set()
        for kind, text in snippets(path):
            first = text.strip().splitlines()[0]
            if kind == "script":
                self.succeed(text, self.place.run("bash", "-n", input=text))
            if kind in ("shell", "inline"):
                left_out |= self.run_commands(kind, commands_in(text) if kind == "shell" else [text], not_run)
            elif kind == "output":
                self.is_said(text)
            elif first in not_run:
                left_out.add(first)
            elif kind == "python":
                program = f"export PYTHONPATH={self.place.checkout}/build/release/python\npython3 - <<'END'\n{text}\nEND"
                self.succeed(text, self.place.run("bash", "-c", program))
            elif kind == "c++":
                self.succeed(text, self.compile(text))
            elif kind == "cpp":
                self.succeed(text, self.place.run("g++", "-std=c++20", "-fsyntax-only", f"-I{SOURCE}/solver",
                                                  f"-I{SOURCE}", "-isystem/usr/include/eigen3", "-xc++", "-",
                                                  input=text))
            elif kind == "layout":
                for entry in re.findall(r"^([a-z_/]+/) ", text, re.M):
                    self.assertTrue((SOURCE / entry).is_dir(), entry)
            elif kind != "dialogue":
                self.fail(f"{path}: neither run nor left out:\n{text}")
        self.place.directory = self.place.checkout
        if re.search("^    >>> ", path.read_text(), re.M):
            self.succeed(path, self.place.run("env", f"PYTHONPATH={self.place.checkout}/build/release/python", "python3",
                                              "-m", "doctest", path))
        for command in IN_PASSING.get(str(path.relative_to(SOURCE)), []):
            self.succeed(command, self.place.shell(command))
        return left_out

    def is_said(self, text):
        """What a text shows of a score is what the walk-through's command says."""
        data = SOURCE / "ci/tests/solver_output/shallowWaterFoam/profile"
        scored = self.place.run(SEICHE, "score", "riemann", "--data", data, "--map", "U_x=u", "--dx", "1", "--solver",
                                "shallowWaterFoam", "--out", self.place.folder / "tmp/shown")
        self.succeed(text, scored)
        self.assertIn(" ".join(text.split()), " ".join(scored.stdout.split()))

    def test_the_readme_names_the_cases_that_score_others(self):
        listed = json.loads(self.place.run(SEICHE, "list", "--json").stdout)["cases"]
        section = (SOURCE / "README.md").read_text().split("## Example: a score of OpenFOAM")[1].split("\n## ")[0]
        named = re.findall(r"\w+", " ".join(re.findall(r"^\|.*?\|(.*)\|$", section, re.M)[1:]))
        self.assertEqual(sorted(named), sorted(one["name"] for one in listed if one["scores"]))

    def prepare(self, command):
        name = command.removeprefix("./")
        if name in BEFORE:
            BEFORE[name](self.place.directory)

    def run_commands(self, kind, commands, not_run):
        directory = self.place.directory
        if kind == "inline":
            self.place.directory = self.place.checkout
        left_out = set()
        for command in commands:
            if command in not_run:
                left_out.add(command)
            elif command != "...":
                self.prepare(command)
                with self.subTest(command=command):
                    self.succeed(command, self.place.shell(command))
        if kind == "inline":
            self.place.directory = directory
        return left_out

    def compile(self, snippet):
        """A snippet's includes, and its statements in a function."""
        lines = snippet.splitlines()
        includes = [line for line in lines if line.startswith("#include")]
        program = "\n".join([*includes, "int main() {", *(line for line in lines if line not in includes), "}\n"])
        return self.place.run("g++", "-std=c++20", "-fsyntax-only", f"-I{SOURCE}/solver", "-isystem/usr/include/eigen3",
                              "-xc++", "-", input=program)

    def help_examples(self):
        for command in ("run", "score", "exact"):
            said = self.place.run(SEICHE, "help", command).stdout
            examples = re.findall(r"^ +(seiche .*?)(?: +# .*)?$", said.partition("Example")[2], re.M)
            self.assertTrue(examples, said)
            yield examples

    def test_help_examples(self):
        for examples in self.help_examples():
            for example in examples:
                self.prepare(example)
                self.succeed(example, self.place.shell(example))

    def test_reasons_and_preparations_are_of_this_project(self):
        tests = (SOURCE / "ci/CMakeLists.txt").read_text()
        for reasons in NOT_RUN.values():
            for name in re.findall(r"ctest ci\.(\w+)", " ".join(reasons.values())):
                self.assertTrue(f"ci.{name}" in tests or (SOURCE / f"ci/tests/test_{name}.py").exists(), name)
        shown = {command.removeprefix("./") for path in DOCUMENTS for _, text in snippets(path)
                 for command in commands_in(text)}
        self.assertLessEqual(set(BEFORE), shown.union(*self.help_examples()))


def document_test(path):
    def test(self):
        left_out = self.check(path)
        self.assertEqual(left_out, set(NOT_RUN.get(str(path.relative_to(SOURCE)), {})), "left out, but no longer there")
    return test


for document in DOCUMENTS:
    name = re.sub(r"\W+", "_", str(document.relative_to(SOURCE).with_suffix("")))
    setattr(Readme, f"test_{name}", document_test(document))


if __name__ == "__main__":
    unittest.main()
