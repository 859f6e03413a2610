"""Running the command, and submitting a result to `seiche score`: what their tests share."""

import functools
import json
import os
import pathlib
import re
import subprocess
import tempfile
import unittest

import h5py
import numpy as np

SEICHE = os.environ["SEICHE"]
SOURCE = pathlib.Path(os.environ["SEICHE_SOURCE"])


def seiche(*words, **options):
    return subprocess.run([SEICHE, *map(str, words)], capture_output=True, text=True, timeout=120, **options)


@functools.cache
def printed(*words):
    """What a command prints that prints the same each time."""
    return seiche(*words).stdout


def messages_of(file):
    """Messages by which a source file of the project rejects its input, as patterns."""
    for thrown in re.findall(r"(?:throw std::invalid_argument|\bfail)\(.*?\);", (SOURCE / file).read_text(), re.DOTALL):
        for text in re.findall(r'(?:"(?:[^"\\]|\\.)*"\s*)+', thrown):
            words = "".join(re.findall(r'"((?:[^"\\]|\\.)*)"', text))
            if len(re.findall(r"[a-z]{2,}", words)) > 1:  # more than a separator
                yield ".*".join(re.escape(part) for part in re.split(r"\{[^}]*\}", words))


def rows_of(csv):
    """Names with units, and the columns that are filled."""
    lines = [line for line in csv.splitlines() if line and not line.startswith("#")]
    return lines[0].split(","), [line.split(",") for line in lines[1:]]


def columns_of(csv):
    """{name without its unit: numbers} of a CSV text."""
    names, rows = rows_of(csv)
    values = np.array([[float(word) for word in row] for row in rows])
    return {name.split("[")[0].strip(): values[:, k] for k, name in enumerate(names)}


def exact(name, *words):
    """Columns of an exact solution."""
    return columns_of(printed("exact", name, *map(str, words)))


class Scratch(unittest.TestCase):
    """Tests with a folder each, and in it one for evidence."""

    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory(prefix="seiche-test-")))
        self.out = self.folder / "evidence"

    def record(self, stem):
        return json.loads((self.out / f"{stem}.json").read_text())


class Scoring(Scratch):
    def score(self, case, *words, solver="mine"):
        return seiche("score", case, *words, "--solver", solver, "--out", self.out)

    def write(self, content, name="mine.csv"):
        path = self.folder / name
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return path

    def hdf5(self, name="mine.h5", units=None, **columns):
        path = self.folder / name
        with h5py.File(path, "w") as file:
            for column, values in columns.items():
                file[column] = values
                if units and column in units:
                    file[column].attrs["unit"] = units[column]
        return path

    def refused(self, result, *words):
        """Exit status 2, one line that holds the words, nothing written."""
        self.assertEqual(result.returncode, 2, result.stdout + result.stderr)
        self.assertEqual(result.stdout, "")
        self.assertEqual(len(result.stderr.strip().splitlines()), 1, result.stderr)
        for word in words:
            self.assertIn(word, result.stderr)
        self.assertFalse(self.out.exists() and list(self.out.iterdir()))

    def every_message_tried(self, file, said):
        for pattern in messages_of(file):
            with self.subTest(file=str(file), message=pattern):
                self.assertTrue(any(re.search(pattern, one) for one in said), "no row is rejected by it")

    def accepted(self, result, status=0):
        self.assertEqual(result.returncode, status, result.stdout + result.stderr)

    def verdicts(self, stem):
        return {claim["id"]: claim["verdict"] for claim in self.record(stem)["claims"]}

    def reference(self, case, table, *words):
        """What the commands that a template prints give, in the template's columns."""
        template = printed("score", case, "--template", "--table", table, *words)
        commands = [line.split("the reference: seiche ")[1].split() for line in template.splitlines()
                    if "the reference: seiche " in line]
        self.assertTrue(commands, template)
        parts = [columns_of(printed(*command)) for command in commands]
        return {name: np.concatenate([part[name] for part in parts])
                for name in (wanted.split(" ")[0] for wanted in rows_of(template)[0])}

    def table(self, columns, name="mine.csv"):
        """A CSV file of named columns, to the last digit."""
        rows = zip(*(list(map(float, values)) for values in columns.values()))
        return self.write(",".join(columns) + "\n" + "".join(",".join(map(repr, row)) + "\n" for row in rows), name)

    def gauges(self, late=0.0, factor=1.0):
        """The template of the gauges in the parabolic bowl, filled in with the exact depth, late by some seconds."""
        names, rows = rows_of(printed("score", "thacker", "--template", "--table", "gauges"))
        self.assertEqual(names, ["x [m]", "t [s]", "h [m]"])
        x, t = (np.array([float(row[k]) for row in rows]) for k in (0, 1))
        radius, depth, displacement, gravity = 1.0, 0.5, 0.5, 9.81
        shift = -displacement * np.cos(np.sqrt(2 * gravity * depth) / radius * (t - late))
        middle = 1.25 * (radius + displacement)
        h = depth * np.maximum(0, 1 - ((x - middle - shift) / radius) ** 2)
        return x, t, factor * h
