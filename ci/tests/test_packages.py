"""The Debian packages: what they say of themselves, lintian, and their content used from another place than /usr."""
import gzip
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

from made_packages import field, packages
from somebody_else import SOURCE, SomebodyElse, cache, use

sys.path.insert(0, str(SOURCE / "ci/debian"))
import changelog  # noqa: E402

SCRATCH = pathlib.Path(tempfile.mkdtemp(prefix="seiche-test-"))
PACKAGES = {}


def setUpModule():
    unittest.addModuleCleanup(shutil.rmtree, SCRATCH, ignore_errors=True)
    SCRATCH.chmod(0o755)
    PACKAGES.update(packages(SCRATCH / "packages"))
    for file in PACKAGES.values():
        subprocess.run(["dpkg-deb", "--extract", file, SCRATCH / "root"], check=True)


class Packages(unittest.TestCase):
    def test_one_version_from_one_place(self):
        wanted = {"seiche": True, "libseiche-dev": True, "python3-seiche": cache("SEICHE_PYTHON_MODULE") == "ON",
                  "seiche-parallel": cache("SEICHE_WITH_PETSC") == "ON",
                  "libseiche-distributed-dev": cache("SEICHE_WITH_PETSC") == "ON"}
        self.assertEqual({name for name, made in wanted.items() if made}, set(PACKAGES))
        version = cache("CMAKE_PROJECT_VERSION")
        program = subprocess.run([SCRATCH / "root/usr/bin/seiche", "--version"], capture_output=True, text=True).stdout
        self.assertEqual(program.strip(), version)
        for name, file in PACKAGES.items():
            self.assertEqual(field(file, "Version"), f"{version}-1", name)
            changes = SCRATCH / f"root/usr/share/doc/{name}/changelog.Debian.gz"
            said = subprocess.run(["dpkg-parsechangelog", "-l", "-", "-S", "Version"], capture_output=True, text=True,
                                  input=gzip.decompress(changes.read_bytes()).decode())
            self.assertEqual((said.stdout.strip(), said.stderr), (f"{version}-1", ""), name)

    def test_depend_on_what_is_used(self):
        needs = {"seiche": ["libc6", r"libhdf5-cpp-\S+", r"libgsl\d+", r"libcholmod\d+", "libopenblas0-serial",
                            "python3-numpy", "python3-matplotlib"],
                 "python3-seiche": ["libc6", r"libgsl\d+", r"python3 \(<< [\d.]+\)", "python3-numpy"],
                 "libseiche-dev": ["libeigen3-dev", "libhdf5-dev", "libsuitesparse-dev"]}
        for name, wanted in needs.items():
            if name not in PACKAGES:
                continue
            depends = field(PACKAGES[name], "Depends")
            for pattern in wanted:
                self.assertRegex(depends, rf"(^|, ){pattern}(?![\w.+-])", name)

    def test_depend_on_packages_that_exist(self):
        """What this build used is installed here: a name that is not is a misspelt one."""
        for name, file in PACKAGES.items():
            for alternatives in field(file, "Depends").split(", "):
                names = [entry.split()[0] for entry in alternatives.split("|")]
                status = [subprocess.run(["dpkg-query", "-W", "-f", "${db:Status-Status}", entry], text=True,
                                         capture_output=True).stdout for entry in names if entry not in PACKAGES]
                self.assertIn("installed", status or ["installed"], f"{name}: {alternatives}")

    def test_describe_themselves(self):
        for name, file in PACKAGES.items():
            summary, *rest = field(file, "Description").splitlines()
            self.assertLessEqual(len(summary), 80, name)
            self.assertGreater(len(rest), 3, name)
            self.assertTrue(field(file, "Section") and field(file, "Maintainer"), name)
            self.assertTrue((SCRATCH / f"root/usr/share/doc/{name}/copyright").exists(), name)

    def test_belong_to_root_and_to_everybody_to_read(self):
        for name, file in PACKAGES.items():
            listing = subprocess.run(["dpkg-deb", "--contents", file], check=True, capture_output=True, text=True).stdout
            for line in listing.splitlines():
                self.assertRegex(line, r"^(drwxr-xr-x|-rwxr-xr-x|-rw-r--r--) root/root ", name)

    def test_lintian_finds_no_error(self):
        if not shutil.which("lintian"):
            self.skipTest("lintian is not here: ci/setup lintian installs it")
        result = subprocess.run(["lintian", "--fail-on", "error", *PACKAGES.values()], capture_output=True, text=True)
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)

    def test_used_from_another_place_than_usr(self):
        prefix = SCRATCH / "root/usr"
        somebody = SomebodyElse(SCRATCH / "home", prefix)
        use(self, somebody, prefix, "/usr/bin/python3", walk=False)
        if "python3-seiche" not in PACKAGES:
            return
        module = "import seiche; print(seiche.solitary(amplitude=0.3).scalars['speed'])"
        result = somebody.run("/usr/bin/python3", "-c", module, PYTHONPATH=str(prefix / "lib/python3/dist-packages"))
        self.assertEqual(result.returncode, 0, result.stderr)


class Changelog(unittest.TestCase):
    """CHANGELOG.md as the packages' changelog."""
    TEXT = ("# Changelog\n\n## Unreleased\n\n- Not out yet.\n\n## [0.2.0] - 2026-05-01\n\n### Added\n\n"
            "- A [link](https://localhost) and\n  a second line\n- `code`\n\n## 0.1.0 - 2026-04-01\n\n- First.\n")

    def test_points_of_every_version_newest_first(self):
        found = changelog.with_version(changelog.releases(self.TEXT), "0.2.0")
        self.assertEqual([(name, date) for name, date, _ in found], [("0.2.0", "2026-05-01"), ("0.1.0", "2026-04-01")])
        self.assertEqual(found[0][2], ["Not out yet.", "A [link](https://localhost) and a second line", "`code`"])
        self.assertEqual(changelog.plain(found[0][2][1]), "A link and a second line")

    def test_version_that_is_not_written_down_yet(self):
        self.assertEqual(changelog.with_version(changelog.releases(self.TEXT), "0.3.0")[0],
                         ("0.3.0", None, ["Not out yet."]))
        self.assertEqual(changelog.with_version([], "0.1.0"), [("0.1.0", None, [])])

    def test_entry(self):
        text = changelog.entry("0.2.0", "2026-05-01", ["x" * 30 + " " + "y" * 60], "1", "A <a@b>", 0)
        self.assertEqual(text, "seiche (0.2.0-1) unstable; urgency=medium\n\n  * " + "x" * 30 + "\n    " + "y" * 60
                         + "\n\n -- A <a@b>  Fri, 01 May 2026 12:00:00 +0000\n")


if __name__ == "__main__":
    unittest.main()
