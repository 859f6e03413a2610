// Particles under an exact solitary wave, with its velocities: how a particle method starts. Prints CSV.
#include <cmath>
#include <cstdio>

#include <seiche/exact/solitary_wave.hpp>

int main() {
  const double depth = 0.4;     // m
  const double gravity = 9.81;  // m/s^2
  const seiche::exact::SolitaryWave wave(0.3 * depth, depth, gravity);

  std::printf("# solitary wave of %.3f m in %.3f m of water travels at %.15g m/s\n", wave.amplitude(), depth,
              wave.speed());
  std::printf("x [m],y [m],u [m/s],v [m/s]\n");
  const double spacing = depth / 8;
  for (int column = -40; column <= 40; ++column) {
    const double x = column * spacing;
    // As many rows as fit, stretched to reach from the bottom to the surface.
    const double surface = wave.elevation(x);
    const int rows = static_cast<int>(std::lround((depth + surface) / spacing));
    for (int row = 0; row < rows; ++row) {
      const double y = -depth + (depth + surface) * (row + 0.5) / rows;
      const auto [u, v] = wave.velocity(x, y);
      std::printf("%.17g,%.17g,%.17g,%.17g\n", x, y, u, v);
    }
  }
}
