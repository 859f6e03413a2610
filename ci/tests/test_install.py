"""`cmake --install` yields a whole product: moved, in the hands of another user, without the checkout."""
import gzip
import os
import pathlib
import re
import shutil
import stat
import subprocess
import tempfile
import unittest

from somebody_else import BUILD, SOURCE, SomebodyElse, cache, use

PYTHON = os.environ["PYTHON"]
SCRATCH = pathlib.Path(tempfile.mkdtemp(prefix="seiche-test-"))
FIRST_PREFIX = SCRATCH / "first"
PREFIX = SCRATCH / "moved"
LIBRARY = SCRATCH / "library"  # the component development alone


def setUpModule():
    unittest.addModuleCleanup(shutil.rmtree, SCRATCH, ignore_errors=True)
    SCRATCH.chmod(0o755)
    subprocess.run(["cmake", "--install", BUILD, "--prefix", FIRST_PREFIX], check=True, stdout=subprocess.DEVNULL,
                   umask=0o022)
    FIRST_PREFIX.rename(PREFIX)
    for component in ("development", "distributed"):
        subprocess.run(["cmake", "--install", BUILD, "--prefix", LIBRARY, "--component", component], check=True,
                       stdout=subprocess.DEVNULL, umask=0o022)


def files():
    return [path for path in PREFIX.rglob("*") if path.is_file()]


class InstalledTest(unittest.TestCase):
    def setUp(self):
        self.somebody = SomebodyElse(SCRATCH / self.id(), PREFIX)


class Command(InstalledTest):
    def test_another_user_runs_and_scores_and_reports(self):
        use(self, self.somebody, PREFIX, PYTHON)

    def test_checkout_is_out_of_the_users_sight(self):
        if not self.somebody.hide:
            self.skipTest("no mount namespaces here: the checkout stays in sight, only what is installed is searched")
        for path in (SOURCE / "reports", BUILD / "seiche"):
            self.assertNotEqual(self.somebody.run("ls", path).returncode, 0, path)

    def test_another_interpreter_can_be_named(self):
        (self.somebody.home / "evidence").mkdir(mode=0o777)
        (self.somebody.home / "evidence/a.json").write_text("{}")
        result = self.somebody.run("seiche", "report", "evidence", SEICHE_PYTHON="/nowhere/python3")
        self.assertEqual(result.returncode, 3)
        self.assertIn("/nowhere/python3", result.stderr)

    def test_python_module(self):
        if cache("SEICHE_PYTHON_MODULE") != "ON":
            self.skipTest("built without the Python module")
        module, = PREFIX.rglob("seiche/_seiche.*.so")
        example = PREFIX / "share/doc/seiche/examples/exact_solutions/particles.py"
        result = self.somebody.run(PYTHON, example, PYTHONPATH=str(module.parent.parent))
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertGreater(len(result.stdout.splitlines()), 10)

    def test_completion_knows_commands_options_and_cases(self):
        script = 'source "$1"; shift; COMP_WORDS=(seiche "$@"); COMP_CWORD=$#; _seiche; echo "${COMPREPLY[@]}"'
        completion = PREFIX / "share/bash-completion/completions/seiche"
        for words, expected in ((["re"], "report"), (["sc"], "score"), (["run", "--re"], "--resume"),
                                (["run", "--tier", "q"], "quick"), (["run", "riem"], "riemann"),
                                (["score", "riem"], "riemann"), (["exact", "soli"], "solitary")):
            result = self.somebody.run("bash", "-c", script, "bash", completion, *words)
            self.assertIn(expected, result.stdout.split(), f"{words}: {result.stderr}")


class Files(unittest.TestCase):
    def test_everybody_can_read_what_was_installed(self):
        for path in [PREFIX, *PREFIX.rglob("*")]:
            executable = path.is_dir() or path.suffix == ".sh" or path.parent.name == "bin"
            wanted = 0o755 if executable else 0o644
            self.assertEqual(stat.S_IMODE(path.stat().st_mode) & wanted, wanted, path)

    def test_nothing_names_a_folder_of_the_build(self):
        if cache("CMAKE_BUILD_TYPE") != "Release":
            self.skipTest("debugging information names the source, and shall")
        for path in files():
            content = path.read_bytes()
            for folder in (SOURCE, BUILD, FIRST_PREFIX):
                self.assertNotIn(bytes(folder), content, path)

    def test_an_install_is_whole_or_does_not_begin(self):
        """Of a build without the manual, which is one of the last things copied, nothing is installed."""
        script, prefix = SCRATCH / "cmake_install.cmake", SCRATCH / "not begun"
        script.write_text((BUILD / "cmake_install.cmake").read_text().replace("/manual/seiche.1", "/manual/none.1"))
        result = subprocess.run(["cmake", f"-DCMAKE_INSTALL_PREFIX={prefix}", "-P", script], capture_output=True, text=True)
        self.assertNotEqual(result.returncode, 0)
        self.assertIn("none.1.gz is not built", " ".join(result.stderr.split()))
        self.assertFalse(prefix.exists())

    def test_nothing_of_the_tests_is_installed(self):
        for path in files():
            self.assertFalse({"tests", "__pycache__"} & set(path.relative_to(PREFIX).parts), path)


class Manual(InstalledTest):
    """The manuals say what --help says, and are well formed."""

    def pages(self):
        pages = list((PREFIX / "share/man/man1").iterdir())
        self.assertIn("seiche.1.gz", [page.name for page in pages])
        return pages

    def test_names_every_command_and_option_of_the_help(self):
        for page in self.pages():
            program = page.name.removesuffix(".1.gz")
            text = re.sub(r"\\f[BIR]", "", gzip.decompress(page.read_bytes()).decode()).replace("\\-", "-")
            help_of = lambda *words: self.somebody.run(program, *words, "--help").stdout
            # Sections of commands end where the next one begins.
            sections = {name: section for name, section in re.findall(rf"\.SS {program} (\w+)\n(.*?)(?=\n\.S)", text,
                                                                      re.DOTALL)}
            commands = re.findall(r"^  ([a-z]\w*)", help_of().partition("Run and report:")[2], re.MULTILINE)
            self.assertEqual(commands, list(sections))
            for command in commands:
                own = set(re.findall(r"^  (?:-\w,)?(--[\w-]+)", help_of(command), re.MULTILINE)) - {"--help"}
                for option in own:
                    self.assertIn(option, sections[command], f"{program} {command}")
            for option in re.findall(r"^  (?:-\w,)?(--[\w-]+)", help_of(), re.MULTILINE):
                self.assertIn(option, text)
            self.assertRegex(text, rf"(?s)\.SH NAME\n{program} - \w.*\.SH EXIT STATUS\n\.TP\n\.B 0\n.*\.B 3\n")

    def test_well_formed(self):
        checks = {"man": ["man", "--warnings", "-E", "UTF-8", "-Tutf8", "-Z", "-l"],
                  "mandoc": ["mandoc", "-Tlint", "-Wwarning"]}
        present = [words for name, words in checks.items() if shutil.which(name)]
        if not present:
            self.skipTest("neither man nor mandoc is here")
        for page in self.pages():
            for words in present:
                result = subprocess.run([*words, page], capture_output=True, text=True,
                                        env={**os.environ, "MANROFFSEQ": "", "MANWIDTH": "80"})
                said = result.stderr + (result.stdout if words[0] == "mandoc" else "")
                # Pages carry a version and no date: the same program gives the same bytes.
                complaints = [line for line in said.splitlines() if "missing date" not in line]
                self.assertEqual(complaints, [], f"{words[0]} {page.name}")


class FindPackage(InstalledTest):
    """Projects of users, with the checkout out of sight. More of them: ci.front_door"""

    def build(self, source, *options):
        configured = self.somebody.run("cmake", "-S", source, "-B", "build", f"-DCMAKE_PREFIX_PATH={LIBRARY}", *options,
                                       CXXFLAGS=cache("SEICHE_OUTSIDERS_FLAGS"))
        if configured.returncode != 0:
            return configured
        return self.somebody.run("cmake", "--build", "build")

    def project(self, find, link, program):
        """The folder of a project with one program."""
        folder = self.somebody.home / "project"
        folder.mkdir(mode=0o777)
        (folder / "CMakeLists.txt").write_text(
            "cmake_minimum_required(VERSION 3.25)\nproject(consumer LANGUAGES CXX)\n"
            f"find_package(seiche {find})\nadd_executable(consumer consumer.cpp)\n"
            f"target_link_libraries(consumer PRIVATE {link})\n")
        (folder / "consumer.cpp").write_text(program)
        return folder

    def test_library(self):
        built = self.build(PREFIX / "share/doc/seiche/examples/exact_solutions")
        self.assertEqual(built.returncode, 0, built.stdout + built.stderr)
        self.assertEqual(self.somebody.run("build/particles").returncode, 0)

    DISTRIBUTED = """
        #include <distributed/decomposition.hpp>
        int main(int argc, char** argv) {
          const seiche::distributed::Runtime runtime(argc, argv);
          const seiche::distributed::Decomposition cells({8, 6}, 3, 1);
          return cells.patch().lattice.columns == 8 ? 0 : 1;
        }
        """

    def test_distributed_library(self):
        built = self.build(self.project("REQUIRED COMPONENTS distributed", "seiche::seiche_distributed",
                                        self.DISTRIBUTED))
        if cache("SEICHE_WITH_PETSC") != "ON":
            self.assertNotEqual(built.returncode, 0)
            self.assertIn("no component distributed", built.stderr)
            self.skipTest("built without PETSc: find_package says so")
        self.assertEqual(built.returncode, 0, built.stdout + built.stderr)
        result = self.somebody.run("build/consumer")
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)


if __name__ == "__main__":
    unittest.main()
