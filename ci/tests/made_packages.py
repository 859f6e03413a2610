"""The Debian packages of a build: those in SEICHE_PACKAGES, or else made from SEICHE_BUILD by CPack."""
import os
import pathlib
import shutil
import subprocess
import unittest

from somebody_else import BUILD, cache


def packages(folder):
    """{name: file}; made in `folder` if need be."""
    given = os.environ.get("SEICHE_PACKAGES")
    if not given:
        if cache("CMAKE_BUILD_TYPE") != "Release":
            raise unittest.SkipTest("packages are made of release builds")
        for program in ("dpkg-deb", "dpkg-shlibdeps"):
            if not shutil.which(program):
                raise unittest.SkipTest(f"{program} is not here: ci/setup dpkg-dev installs it on Debian")
        config = BUILD / "CPackConfig.cmake"
        if not config.exists():
            raise unittest.SkipTest("this build makes no packages: configured for another Python than the system's")
        made = subprocess.run(["cpack", "--config", config, "-B", folder, "-D", "CPACK_DEBIAN_COMPRESSION_TYPE=gzip"],
                              capture_output=True, text=True, umask=0o022)
        if made.returncode != 0:
            raise RuntimeError(f"cpack: {made.stdout}{made.stderr}")
    files = pathlib.Path(given or folder).glob("*.deb")
    return {field(file, "Package"): file for file in sorted(files)}


def field(file, name):
    """A field of the package's control file, empty if absent."""
    return subprocess.run(["dpkg-deb", "--field", file, name], check=True, capture_output=True, text=True).stdout.strip()
