"""The compiled part of the Python package: one target of the project's own CMake build."""
import os
import pathlib
import re
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = pathlib.Path(__file__).resolve().parent


class ByCMake(build_ext):
    def build_extension(self, ext):
        build = pathlib.Path(self.build_temp).resolve()
        subprocess.run(["cmake", "-G", "Ninja", "-S", ROOT, "-B", build, "-DSEICHE_MODULE_ALONE=ON", "-DBUILD_TESTING=OFF",
                        "-DCMAKE_UNITY_BUILD=ON",
                        f"-DPython3_EXECUTABLE={sys.executable}", f"-DPYTHON_EXECUTABLE={sys.executable}"], check=True)
        subprocess.run(["cmake", "--build", build, "--target", "seiche_python", "-j", str(os.cpu_count() or 1)], check=True)
        target = pathlib.Path(self.get_ext_fullpath(ext.name)).resolve().parent
        target.mkdir(parents=True, exist_ok=True)
        for made in (build / "python/seiche").iterdir():
            if made.is_file():
                self.copy_file(str(made), str(target / made.name))


setup(version=re.search(r"project\(seiche VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text())[1],
      ext_modules=[Extension("seiche._seiche", [])], cmdclass={"build_ext": ByCMake})
