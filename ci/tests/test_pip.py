"""`pip install .` in a fresh environment with the system's packages: the exact solutions, compiled without the models."""
import importlib.util
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

SOURCE = pathlib.Path(os.environ["SEICHE_SOURCE"])
PROGRAM = "import seiche; wave = seiche.solitary(amplitude=0.3); print(seiche.__version__, wave(x=0.0)['eta'])"


class Pip(unittest.TestCase):
    def test_the_package_in_a_fresh_environment(self):
        folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory(prefix="seiche-test-")))
        made = subprocess.run([sys.executable, "-m", "venv", "--system-site-packages", folder / "venv"], capture_output=True)
        if made.returncode or importlib.util.find_spec("setuptools") is None:
            self.skipTest("needs python3-venv and python3-setuptools")
        shutil.copytree(SOURCE, folder / "source", ignore=shutil.ignore_patterns("build", ".git"))
        python = folder / "venv/bin/python"
        subprocess.run([python, "-m", "pip", "install", "-q", "--no-build-isolation", folder / "source"], check=True)
        said = subprocess.run([python, "-c", PROGRAM], cwd=folder, check=True, capture_output=True, text=True).stdout.split()
        self.assertIn(f"VERSION {said[0]}", (SOURCE / "CMakeLists.txt").read_text())
        self.assertAlmostEqual(float(said[1]), 0.3, delta=1e-14)


if __name__ == "__main__":
    unittest.main()
