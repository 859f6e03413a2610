"""The column of Martin and Moyce (1952), a = 5.715 cm and 2 a high, by weakly compressible particles of PySPH.

    python3 collapsing_column.py --particles 20 --directory run

Boundary and artificial viscosity (0.02) are those of the dam break of Adami, Hu and Adams (2012), the speed of sound is
ten times that of a fall through the column.
"""
import numpy as np

from pysph.base.kernels import QuinticSpline
from pysph.base.utils import get_particle_array
from pysph.solver.application import Application
from pysph.sph.scheme import AdamiHuAdamsScheme
from pysph.tools.geometry import get_2d_block, get_2d_tank

WIDTH, HEIGHT, TANK, WALL = 0.05715, 0.1143, 0.5715, 0.13
GRAVITY, DENSITY = 9.81, 1000.0
SOUND = 10 * np.sqrt(2 * GRAVITY * HEIGHT)


class CollapsingColumn(Application):
    def add_user_options(self, group):
        group.add_argument("--particles", type=int, default=20, help="across the width of the column")

    def consume_user_options(self):
        self.dx = WIDTH / self.options.particles

    def create_scheme(self):
        return AdamiHuAdamsScheme(["fluid"], ["wall"], dim=2, c0=SOUND, nu=0.0, rho0=DENSITY, h0=1.0, p0=0.0,
                                  gy=-GRAVITY, gamma=1.0, tdamp=0.0, alpha=0.02)

    def configure_scheme(self):
        self.scheme.configure(h0=self.dx)
        self.scheme.configure_solver(kernel=QuinticSpline(dim=2), dt=0.25 * self.dx / (1.1 * SOUND), tf=0.33,
                                     output_at_times=np.arange(0.005, 0.33, 0.005), pfreq=1000000)

    def create_particles(self):
        dx = self.dx
        x, y = get_2d_block(dx=dx, length=WIDTH - dx, height=HEIGHT - dx, center=[WIDTH / 2, HEIGHT / 2])
        pressure = DENSITY * GRAVITY * (HEIGHT - y)
        fluid = get_particle_array(name="fluid", x=x, y=y, h=dx, m=DENSITY * dx * dx,
                                   rho=DENSITY + pressure / SOUND**2)
        x, y = get_2d_tank(dx=dx, length=TANK + dx, height=WALL, base_center=[TANK / 2, -dx / 2], num_layers=3)
        wall = get_particle_array(name="wall", x=x, y=y, h=dx, m=DENSITY * dx * dx, rho=DENSITY)
        self.scheme.setup_properties([fluid, wall])
        return [fluid, wall]


if __name__ == "__main__":
    CollapsingColumn().run()
