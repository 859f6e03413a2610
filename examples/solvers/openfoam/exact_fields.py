"""Starts a case of OpenFOAM from an exact wave: writes 0/alpha.water, with --velocity 0/U, of a block of equal cells.

    exact_fields.py solitary --set amplitude=0.3 --velocity     # in the folder of the case, after blockMesh

Shares of water are those below the exact surface, by eight columns in each cell; velocities those at the centres. The
numbers are `seiche exact`'s (SEICHE names the program).
"""
import argparse
import os
import re
import subprocess

import numpy as np

SUBCOLUMNS = 8


def exact(solution, settings, outputs, **coordinates):
    """Columns of `seiche exact` at points: dictionary by name without unit."""
    axes = ",".join(f"{name}={values[0]:.17g}:{values[-1]:.17g}:{values.size}" for name, values in coordinates.items())
    words = [os.environ.get("SEICHE", "seiche"), "exact", solution, *settings, "--grid", f"{axes},t=0"]
    lines = subprocess.run(words, check=True, capture_output=True, text=True).stdout.splitlines()
    lines = [line for line in lines if not line.startswith("#")]
    names = [re.sub(r"\s*\[.*", "", name) for name in lines[0].split(",")]
    table = np.array([[float(word) for word in line.split(",")] for line in lines[1:]])
    return [table[:, names.index(output)] for output in outputs]


def block():
    """Corners and cells of the block in system/blockMeshDict."""
    text = open("system/blockMeshDict").read()
    corners = np.array([[float(word) for word in corner.split()[:2]] for corner in
                        re.findall(r"\(([-\d.]+ [-\d.]+ [-\d.]+)\)", text.partition("vertices")[2])[:3]])
    cells = dict(re.findall(r"(along|up) (\d+)", open("system/cells").read()))
    return corners[0], corners[2], int(cells["along"]), int(cells["up"])


def write(path, kind, values):
    text = open(path).read()
    rows = "\n".join(values)
    new = f"internalField nonuniform List<{kind}> {len(values)}\n(\n{rows}\n);"
    open(path, "w").write(re.sub(r"internalField[^;]*;", new, text))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("solution")
    parser.add_argument("--set", action="append", default=[])
    parser.add_argument("--velocity", action="store_true")
    options = parser.parse_args()
    settings = [word for one in options.set for word in ("--set", one)]
    low, high, along, up = block()
    dx, dy = (high - low) / (along, up)
    columns = low[0] + dx / SUBCOLUMNS * (np.arange(along * SUBCOLUMNS) + 0.5)
    eta, = exact(options.solution, settings, ["eta"], x=columns)
    floors = low[1] + dy * np.arange(up)
    share = np.clip((eta[None, :] - floors[:, None]) / dy, 0, 1).reshape(up, along, SUBCOLUMNS).mean(axis=2)
    write("0/alpha.water", "scalar", [f"{value:.10g}" for value in share.ravel()])
    if options.velocity:
        x = low[0] + dx * (np.arange(along) + 0.5)
        crest = eta.max()
        y = floors + dy / 2
        wet = y[y < crest]
        u, v = (values.reshape(wet.size, along) for values in exact(options.solution, settings, ["u", "v"], x=x, y=wet))
        velocity = np.zeros((up, along, 2))
        velocity[:wet.size, :, 0], velocity[:wet.size, :, 1] = np.nan_to_num(u), np.nan_to_num(v)
        write("0/U", "vector", [f"({a:.10g} {b:.10g} 0)" for a, b in velocity.reshape(-1, 2)])


if __name__ == "__main__":
    main()
