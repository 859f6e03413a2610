"""A finite-volume solver as textbooks print it, to have somebody else's result to score. It is no part of seiche.

Solves the shallow-water equations on a flat bed, h_t + (hu)_x = 0, (hu)_t + (hu^2 + g h^2/2)_x = 0, for a dam break,
with Rusanov's or the HLL flux (E. F. Toro, Shock-capturing methods for free-surface shallow flows, 2001, chapter 10),
first order in space or with minmod slopes (MUSCL) and Heun's method in time. Wet beds only.

    textbook_finite_volume.py --flux rusanov --order 1 --output rusanov.csv
    textbook_finite_volume.py --flux hll --order 2 --output hll.h5
"""
import argparse
import sys

import numpy as np

GRAVITY = 9.81


def physical_flux(h, q):
    return np.array([q, q * q / h + 0.5 * GRAVITY * h * h])


def numerical_flux(left, right, kind):
    """Flux through every interface between the states (h, q) on its two sides."""
    u_left, u_right = left[1] / left[0], right[1] / right[0]
    c_left, c_right = np.sqrt(GRAVITY * left[0]), np.sqrt(GRAVITY * right[0])
    f_left, f_right = physical_flux(*left), physical_flux(*right)
    if kind == "rusanov":
        fastest = np.maximum(abs(u_left) + c_left, abs(u_right) + c_right)
        return 0.5 * (f_left + f_right) - 0.5 * fastest * (right - left)
    slow = np.minimum(0, np.minimum(u_left - c_left, u_right - c_right))
    fast = np.maximum(0, np.maximum(u_left + c_left, u_right + c_right))
    return (fast * f_left - slow * f_right + fast * slow * (right - left)) / (fast - slow)


def rate(state, dx, kind, order):
    """d/dt of the cell means; beyond the ends the state is that of the last cell."""
    padded = np.concatenate([state[:, :1], state[:, :1], state, state[:, -1:], state[:, -1:]], axis=1)
    slope = np.zeros_like(padded)
    if order == 2:
        back, ahead = np.diff(padded, axis=1)[:, :-1], np.diff(padded, axis=1)[:, 1:]
        slope[:, 1:-1] = np.where(back * ahead > 0, np.sign(back) * np.minimum(abs(back), abs(ahead)), 0)
    flux = numerical_flux((padded + 0.5 * slope)[:, 1:-2], (padded - 0.5 * slope)[:, 2:-1], kind)
    return -np.diff(flux, axis=1) / dx


def solve(cells, end, kind, order, start=0.0, stop=50.0, jump=20.0, left=1.0, right=0.1):
    dx = (stop - start) / cells
    x = start + dx * (np.arange(cells) + 0.5)
    state = np.array([np.where(x < jump, left, right), np.zeros(cells)])
    time = 0.0
    while time < end:
        fastest = np.max(abs(state[1] / state[0]) + np.sqrt(GRAVITY * state[0]))
        dt = min(0.45 * dx / fastest, end - time)
        first = state + dt * rate(state, dx, kind, order)
        state = first if order == 1 else 0.5 * (state + first + dt * rate(first, dx, kind, order))
        time += dt
    return x, state[0], state[1] / state[0]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--flux", choices=["rusanov", "hll"], default="rusanov")
    parser.add_argument("--order", type=int, choices=[1, 2], default=1)
    parser.add_argument("--cells", type=int, default=200)
    parser.add_argument("--output", required=True, help="*.csv, or *.h5 with h5py")
    options = parser.parse_args()
    x, h, u = solve(options.cells, 6.0, options.flux, options.order)
    if options.output.endswith(".csv"):
        np.savetxt(options.output, np.column_stack([x, h, u]), delimiter=",", fmt="%.17g", comments="",
                   header="x [m],h [m],u [m/s]")
        return
    try:
        import h5py
    except ImportError:
        sys.exit(f"{sys.executable} has no h5py: write CSV (--output NAME.csv), or choose an interpreter that has it "
                 "(PYTHON=/usr/bin/python3 ./run.sh)")
    with h5py.File(options.output, "w") as file:
        for name, unit, values in (("position", "m", x), ("depth", "m", h), ("velocity", "m/s", u)):
            file[name] = values
            file[name].attrs["unit"] = unit


if __name__ == "__main__":
    main()
