"""Somebody else, with an installed seiche and nothing of the checkout: another folder, account and umask."""
import os
import pathlib
import re
import subprocess

SOURCE = pathlib.Path(os.environ["SEICHE_SOURCE"])
BUILD = pathlib.Path(os.environ["SEICHE_BUILD"])
NOBODY = 65534


def cache(name):
    """An entry of the build's CMakeCache.txt; empty if there is none."""
    found = re.search(rf"^{name}:\w+=(.*)$", (BUILD / "CMakeCache.txt").read_text(), re.MULTILINE)
    return found[1] if found else ""


# In a mount namespace of its own an empty file system covers the folders; nobody else notices.
HIDE = 'while [ "$1" != -- ]; do mount -t tmpfs -o mode=755 none "$1"; shift; done; shift; exec "$@"'


class SomebodyElse:
    """A folder to work in and a PATH that begins with the programs of `prefix`."""

    def __init__(self, home, prefix):
        self.home = pathlib.Path(home)
        self.home.mkdir(parents=True)
        self.environment = {"PATH": f"{prefix}/bin:/usr/bin:/bin", "HOME": str(self.home), "LANG": "C.UTF-8",
                            "MPLCONFIGDIR": str(self.home / "matplotlib"), "OMP_NUM_THREADS": "1"}
        self.account = []
        if os.geteuid() == 0:
            os.chown(self.home, NOBODY, NOBODY)
            self.account = ["setpriv", f"--reuid={NOBODY}", f"--regid={NOBODY}", "--clear-groups"]
        namespace = ["unshare", "--mount", *([] if os.geteuid() == 0 else ["--map-root-user"])]
        hidden = [str(folder) for folder in dict.fromkeys([SOURCE, BUILD]) if not covered(folder)]
        self.hide = [*namespace, "sh", "-c", HIDE, "sh", *hidden, "--"]
        if subprocess.run([*self.hide, "true"], capture_output=True).returncode != 0:
            self.hide = []

    def run(self, *words, **environment):
        return subprocess.run([*self.hide, *self.account, "sh", "-c", 'umask 077; exec "$@"', "sh", *map(str, words)],
                              cwd=self.home, env={**self.environment, **environment}, capture_output=True, text=True,
                              timeout=600)


def covered(folder):
    """A build tree within the source goes out of sight with it."""
    return folder != SOURCE and SOURCE in folder.parents


def use(test, somebody, prefix, python, walk=True):
    """What a new user does first; `test` is the unittest.TestCase that judges it. Installed examples go the whole way:
    run, score, compare, report; without `walk` one record goes into a report."""
    def succeeds(*words, **environment):
        result = somebody.run(*words, **environment)
        test.assertEqual(result.returncode, 0, f"{words}\n{result.stdout}{result.stderr}")
        return result.stdout

    test.assertIn("riemann", succeeds("seiche", "list"))
    test.assertIn("eta", succeeds("seiche", "exact", "solitary", "--set", "amplitude=0.3", "--at", "x=0,y=-0.5,t=0"))
    succeeds("seiche", "run", "wall_run_up_exact", "--out", "evidence")  # reads a reference table
    example = pathlib.Path(prefix) / "share/doc/seiche/examples/score_your_solver/run.sh"
    evidence = somebody.home / "evidence"
    if walk:
        succeeds(example, "scored", PYTHON=python)
        evidence = somebody.home / "scored/evidence"
        test.assertIn("textbook-rusanov", (evidence / "report/cases/riemann.html").read_text())
    else:
        succeeds("seiche", "report", "evidence")
    test.assertIn("Frank (1994)", (evidence / "report/atlas.html").read_text())
