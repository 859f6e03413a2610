"""The Debian packages in a system that has nothing else: installed one by one, used, removed.

Needs root, mmdebstrap and Debian's archive, the one that this system installs from; says so and skips where one of them
is missing.
"""
import os
import pathlib
import platform
import shutil
import subprocess
import tempfile
import unittest

from made_packages import packages
from somebody_else import NOBODY, use

SOURCES = ("/etc/apt/sources.list.d/debian.sources", "/etc/apt/sources.list.d/ubuntu.sources", "/etc/apt/sources.list")
# What a running system has: /proc, where the command finds itself, and the shared memory of Python's processes.
ENTER = 'mount -t proc proc "$0/proc" && mount -t tmpfs -o mode=1777 tmpfs "$0/dev/shm" && exec chroot "$@"'


class CleanRoot:
    """A minimal system of the release that runs here, in a folder."""

    def __init__(self, folder):
        if os.geteuid() != 0:
            raise unittest.SkipTest("only root can install packages into a root of its own")
        if not shutil.which("mmdebstrap"):
            raise unittest.SkipTest("mmdebstrap is not here: ci/setup mmdebstrap installs it")
        sources = next((file for file in SOURCES if pathlib.Path(file).is_file()), None)
        if sources is None:
            raise unittest.SkipTest(f"no archive is known: none of {', '.join(SOURCES)} exists")
        self.root = folder
        self.home = folder / "home/somebody"
        release = platform.freedesktop_os_release()["VERSION_CODENAME"]
        made = subprocess.run(["mmdebstrap", "--variant=apt", release, folder, sources], capture_output=True, text=True)
        # Nothing of ours has had a part in it yet: what failed is the machine or the network.
        if made.returncode == 0:
            made = self.as_root("apt-get", "update")
        if made.returncode != 0:
            raise unittest.SkipTest(f"no clean root can be made here: {made.stderr.strip().splitlines()[-1:]}")
        self.home.mkdir()
        os.chown(self.home, NOBODY, NOBODY)

    def as_root(self, *words):
        return self.enter([], words, {"DEBIAN_FRONTEND": "noninteractive"})

    def run(self, *words, **environment):
        """As a user without a name, in a folder of their own."""
        inside = ["sh", "-c", 'cd /home/somebody && umask 077 && exec "$@"', "sh", *words]
        return self.enter([f"--userspec={NOBODY}:{NOBODY}"], inside, {"HOME": "/home/somebody", **environment})

    def enter(self, options, words, environment):
        proxies = {name: value for name, value in os.environ.items() if name.lower().endswith("_proxy")}
        return subprocess.run(["unshare", "--mount", "--pid", "--fork", "sh", "-c", ENTER, self.root, *options,
                               self.root, *map(str, words)], capture_output=True, text=True, timeout=1800,
                              env={"PATH": "/usr/sbin:/usr/bin:/sbin:/bin", "LANG": "C.UTF-8", **proxies, **environment})


class Install(unittest.TestCase):
    def setUp(self):
        scratch = pathlib.Path(tempfile.mkdtemp(prefix="seiche-test-"))
        self.addCleanup(shutil.rmtree, scratch, ignore_errors=True)
        scratch.chmod(0o755)
        self.packages = packages(scratch / "packages")
        self.system = CleanRoot(scratch / "root")

    def succeeds(self, result):
        self.assertEqual(result.returncode, 0, f"{result.args}\n{result.stdout[-4000:]}{result.stderr[-4000:]}")
        return result.stdout

    def install(self, *names):
        """Packages of ours, and of Debian's, with what they depend on and nothing else."""
        for name in names:
            if name in self.packages:
                shutil.copy(self.packages[name], self.system.root / f"{name}.deb")
        words = [f"/{name}.deb" if name in self.packages else name for name in names]
        self.succeeds(self.system.as_root("apt-get", "install", "--yes", "--no-install-recommends", *words))

    def build_example(self):
        example = "/usr/share/doc/seiche/examples/wave_on_a_beach"
        self.succeeds(self.system.run("cmake", "-S", example, "-B", "build"))
        self.succeeds(self.system.run("cmake", "--build", "build"))
        self.succeeds(self.system.run("build/wave_on_a_beach"))

    def test_each_package_brings_what_it_needs(self):
        self.install("python3-seiche")
        self.succeeds(self.system.run("python3", "-c", "import seiche; seiche.stokes(amplitude=0.1).scalars"))
        self.install("seiche")
        use(self, self.system, "/usr", "/usr/bin/python3")
        self.install("libseiche-dev", "cmake", "g++", "make")
        self.build_example()
        rest = sorted(set(self.packages) - {"seiche", "libseiche-dev", "python3-seiche"})
        if rest:
            self.install(*rest)
            self.succeeds(self.system.run("seiche-parallel", "--help"))
        self.succeeds(self.system.as_root("apt-get", "purge", "--yes", *self.packages))
        left = [path for path in (self.system.root / "usr").rglob("*seiche*")]
        self.assertEqual(left, [])


if __name__ == "__main__":
    unittest.main()
