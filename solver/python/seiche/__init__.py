"""Exact solutions of free-surface flows with numpy arrays, and the cases of the suite for your own results.

    import numpy, seiche
    wave = seiche.solitary(amplitude=0.3, depth=1.0, gravity=9.81)
    values = wave(x=numpy.linspace(-10, 10, 401), y=-0.5, t=0.0)      # {"eta": array, "u": array, "v": array}

    case = seiche.case("monai_valley")
    result = case.score({"gauges": {"gauge": ..., "t": ..., "eta": ...}}, solver="mine", dx=0.014)
    result.passed, result.claims.to_pandas()

Lengths are in metres and times in seconds unless a parameter such as gravity=1 makes them nondimensional.
"""
import inspect
import os

import numpy

from . import _seiche
from ._seiche import Solution, __version__, solutions
from .scoring import Case, Claims, Result, case, cases, read_record, run

__all__ = ["Case", "Claims", "Result", "Solution", "case", "cases", "exact", "read_record", "read_table", "run", "solutions",
           *solutions]


def exact(name: str, **parameters: float | str) -> Solution:
    """The exact solution of that name with its parameters: seiche.exact("solitary", amplitude=0.3).

    `seiche.solutions` lists the names; help(seiche.solitary) shows the parameters, coordinates and outputs of one.
    Parameters left out have their defaults. ValueError names what is wrong.
    """
    return _seiche.exact(name, **parameters)


def read_table(path: str | os.PathLike) -> dict[str, numpy.ndarray]:
    """Columns of a text file of numbers, or of an HDF5 file, by name, as `seiche score` reads it; NaN for no value.

    ValueError names file, line and column in one line.
    """
    return _seiche.read_table(path)


def _solution(name):
    def solution(**parameters):
        return exact(name, **parameters)

    described = _seiche.describe(name)
    solution.__name__ = solution.__qualname__ = name
    solution.__doc__ = described["doc"]
    solution.__signature__ = inspect.Signature(
        [inspect.Parameter(parameter, inspect.Parameter.KEYWORD_ONLY, default=default, annotation=type(default))
         for parameter, default in described["defaults"].items()], return_annotation=Solution)
    return solution


globals().update({name: _solution(name) for name in solutions})


def _stubs():
    """What type checkers and editors are told: the functions above, with their parameters."""
    lines = ["from typing import Any", "from ._seiche import Solution as Solution",
             "from .scoring import Case as Case, Claims as Claims, Result as Result, case as case, cases as cases",
             "from .scoring import read_record as read_record, run as run", "__version__: str", "solutions: list[str]",
             "def exact(name: str, **parameters: float | str) -> Solution: ...",
             "def read_table(path: Any) -> dict[str, Any]: ..."]
    for name in solutions:
        words = [f"{p.name}: {p.annotation.__name__} = {p.default!r}".replace("= inf", '= float("inf")')
                 for p in inspect.signature(globals()[name]).parameters.values()]
        lines.append(f"def {name}({', '.join(['*', *words]) if words else ''}) -> Solution: ...")
    return "\n".join(lines) + "\n"
