"""The same from Python: PYTHONPATH=build/release/python python3 particles.py"""

import numpy

import seiche

depth, gravity = 0.4, 9.81
wave = seiche.solitary(amplitude=0.3 * depth, depth=depth, gravity=gravity)
print(f"# {wave} travels at {wave.scalars['speed']:.15g} m/s, known to {wave.uncertainty:.0e}")

x = numpy.arange(-5 * depth, 5 * depth, depth / 8)
surface = wave(x=x)["eta"]
rows = numpy.arange(8) + 0.5
y = -depth + (depth + surface) * rows[:, None] / rows.size  # (rows, columns)
inside = wave(x=x, y=y)
particles = numpy.stack([numpy.broadcast_to(x, y.shape), y, inside["u"], inside["v"]], axis=-1).reshape(-1, 4)
print("x [m],y [m],u [m/s],v [m/s]")
for row in particles:
    print(",".join(f"{value:.17g}" for value in row))
