"""The cases of the suite from Python: templates, files, and scores by the command `seiche`."""
import functools
import html
import json
import os
import pathlib
import shutil
import subprocess
import tempfile

import numpy as np


def _command():
    beside = pathlib.Path(__file__).resolve().parents[2] / "seiche"  # in the build tree
    found = os.environ.get("SEICHE") or shutil.which("seiche") or (str(beside) if beside.is_file() else None)
    if found is None:
        raise FileNotFoundError("the command 'seiche' is not on the PATH: build it by 'ci/build release seiche_command', or "
                                "name it by the variable SEICHE")
    return found


def _run(*words, allowed=(0,)):
    done = subprocess.run([_command(), *map(str, words)], capture_output=True, text=True, check=False)
    if done.returncode not in allowed:
        raise ValueError(done.stderr.strip() or f"seiche {words[0]}: ended with status {done.returncode}")
    return done.stdout


@functools.cache
def _listed():
    return {one["name"]: one for one in json.loads(_run("list", "--json"))["cases"]}


def _settings(parameters):
    return [word for name, value in parameters.items() for word in ("--set", f"{name}={value}")]


def _numbers(values):
    """Dates and spans of time in seconds, dates from the first on."""
    values = np.asarray(values)
    if values.dtype.kind == "M":
        values = values - values.flat[0]
    return values / np.timedelta64(1, "s") if values.dtype.kind == "m" else np.asarray(values, float)


class Claims(list):
    """Claims of a result, a dict each: id, verdict, text, measured, expected, limit, unit."""

    def to_pandas(self):
        import pandas

        return pandas.DataFrame(list(self))


class Result:
    """The score of a result, or the outcome of a case that was run."""

    def __init__(self, record, notes=(), since=()):
        self.record = record
        self.notes = list(notes)
        self.worse = [line for line in since if "WORSE" in line]  # than the baseline
        self.claims = Claims({**{key: claim.get(key) for key in ("id", "verdict", "text", "measured", "expected", "unit")},
                              "limit": claim["criterion"].get("limit")} for claim in record["claims"])
        self.measurements = record["measurements"]

    @property
    def passed(self):
        """Whether every claim is as expected."""
        return all(claim["as_declared"] for claim in self.record["claims"])

    def __repr__(self):
        met = sum(claim["verdict"] == "pass" for claim in self.claims)
        return f"<seiche.Result {self.record['case']}: {met} of {len(self.claims)} claims met>"

    def _repr_html_(self):
        def cells(values):
            return "".join(f"<td>{html.escape(f'{v:.6g}' if isinstance(v, float) else str(v))}</td>" for v in values)

        keys = ("verdict", "text", "measured", "expected", "limit", "unit")
        head = "".join(f"<th>{key}</th>" for key in keys)
        rows = "".join(f"<tr>{cells(claim[key] for key in keys)}</tr>" for claim in self.claims)
        return f"<p>{html.escape(repr(self))}</p><table><tr>{head}</tr>{rows}</table>"

    def plot(self, axes=None):
        """Plots the fraction of its limit that every claim uses. Returns matplotlib's axes."""
        import matplotlib.pyplot as plt

        axes = axes or plt.subplots(figsize=(7, 0.4 * len(self.claims) + 1))[1]
        told = [c for c in self.claims if None not in (c["limit"], c["measured"], c["expected"]) and c["limit"] > 0]
        axes.barh([c["id"] for c in told], [abs(c["measured"] - c["expected"]) / c["limit"] for c in told],
                  color=["tab:green" if c["verdict"] == "pass" else "tab:red" for c in told])
        axes.axvline(1, color="black")
        axes.set_xlabel("error over its limit")
        return axes


class Case:
    """A case of the suite with its parameters: `seiche.case("monai_valley")`, `seiche.case("riemann", right_depth=0)`."""

    def __init__(self, name, **parameters):
        if name not in _listed():
            _run("list", "--claims", name)  # says which was meant
        self.name, self.parameters = name, parameters
        self.about = _listed()[name]
        self.tables = self.about["tables"]  # by name: columns with their units, and files

    def __repr__(self):
        return f"<seiche.Case {self.name}: {self.about['title']}>"

    def template(self, table=None):
        """The template, a dict of columns by table: coordinates of the reference, and NaN to be filled in."""
        chosen = {}
        for name in [table] if table else self.tables:
            printed = _run("score", self.name, "--template", "--table", name, *_settings(self.parameters))
            lines = [line for line in printed.splitlines() if not line.startswith("#")]
            columns = [word.split(" [")[0] for word in lines[0].split(",")]
            rows = [[float(entry or "nan") for entry in line.split(",")] for line in lines[1:]]
            values = np.array(rows or [[np.nan] * len(columns)]).T
            chosen[name] = dict(zip(columns, values))
        return chosen[table] if table else chosen

    @property
    def files(self):
        """Bathymetry, incident wave and others of an experiment by name; measurements as FOLDER/table.csv."""
        files = [pathlib.Path(file) for table in self.tables.values() for file in table["files"]]
        return {f"{file.parent.name}/{file.name}" if file.name == "table.csv" else file.name: file for file in files}

    def score(self, data, solver="mine", dx=None, seconds=None, uncertainty=None, out=None, **options):
        """Scores tables of columns, {"gauges": {"gauge": ..., "t": ..., "eta": ...}}; one table may be given as it is, as
        a pandas DataFrame, as an xarray Dataset, or as a file's path.

        uncertainty  standard, by quantity: {"eta": 0.001} or {"eta": "1%"}
        options      further options of `seiche score`: baseline="folder", bless=True, gauges="WG1=6"
        """
        with tempfile.TemporaryDirectory(prefix="seiche-") as folder:
            files = [data] if isinstance(data, (str, os.PathLike)) else self._written(data, pathlib.Path(folder))
            words = [word for file in files for word in ("--data", file)]
            if len(files) < len(self.tables) and len(files) == 1 and isinstance(data, dict) and set(data) <= set(self.tables):
                words += ["--table", next(iter(data))]
            words += [word for name, u in (uncertainty or {}).items() for word in ("--uncertainty", f"{name}={u}")]
            given = {"dx": dx, "seconds": seconds, **options}
            words += [f"--{name}" if value is True else f"--{name}={value}" for name, value in given.items()
                      if value is not None and value is not False]
            told = json.loads(_run("score", self.name, *words, *_settings(self.parameters), "--solver", solver, "--json",
                                   "--out", out or pathlib.Path(folder) / "results", allowed=(0, 1)))
        return Result(told["record"], told["notes"], told.get("baseline", ()))

    def _written(self, data, folder):
        named = hasattr(data, "keys") and not hasattr(data, "to_dataframe") and set(data) <= set(self.tables)
        for name in data if isinstance(data, dict) and not named else ():
            if isinstance(data[name], dict) and name not in self.tables:
                raise ValueError(f"table {name}: must be one of {', '.join(self.tables)}")
        for name, table in (data.items() if named else [("table", data)]):
            units = {}
            if hasattr(table, "to_dataframe"):
                units = {name: f" [{values.attrs['units']}]" for name, values in table.variables.items() if "units" in values.attrs}
                table = table.to_dataframe().reset_index()
            columns = [np.atleast_1d(_numbers(table[column])) for column in table.keys()]
            lengths = {column.size for column in columns}
            if len(lengths) != 1:
                raise ValueError(f"table {name}: columns of {', '.join(map(str, sorted(lengths)))} values, must be as many")
            np.savetxt(folder / f"{name}.csv", np.column_stack(columns), "%.17g", ",", comments="",
                       header=",".join(f"{column}{units.get(column, '')}" for column in table.keys()))
        return sorted(folder.glob("*.csv"))


def cases():
    """Names of the cases that accept external results."""
    return [name for name, one in _listed().items() if one["scores"]]


def case(name, **parameters):
    return Case(name, **parameters)


def read_record(path):
    """The result that a command wrote as JSON."""
    return Result(json.loads(pathlib.Path(path).read_text()))


def run(*names, out, tier="quick", **parameters):
    """Runs cases of the suite into a folder and returns their results."""
    _run("run", *names, "--tier", tier, "--out", out, *_settings(parameters), allowed=(0, 1))
    suffix = "" if tier == "quick" else f"@{tier}"
    return [read_record(pathlib.Path(out) / f"{name}{suffix}.json") for name in names]
