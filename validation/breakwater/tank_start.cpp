#include "validation/breakwater/tank_start.hpp"

#include <cmath>
#include <numbers>

#include "seiche/exact/dispersion.hpp"
#include "seiche/exact/wavemaker.hpp"

namespace seiche::validation {

using std::numbers::pi;
using Complex = std::complex<double>;

TankStart::TankStart(const IncidentWaves& waves) {
  const exact::AiryDispersion airy(1, 1);
  const auto height = [](double omega) {
    return exact::Wavemaker(exact::Paddle::piston, {1, 1}, exact::AngularFrequency{omega}).height_per_stroke();
  };
  wavenumber_ = airy.wavenumber(waves.omega);
  // A sum over frequencies repeats itself after 2 pi/spacing: four runs, in which shorter waves do not come so far.
  const double spacing = 2 * pi / (4 * waves.end);
  constexpr double fastest = 4;
  const auto steps = static_cast<long>(std::ceil(waves.end / (pi / fastest) * 4));
  const double dt = waves.end / static_cast<double>(steps);
  const double window = 2 * pi / waves.omega * static_cast<double>(waves.settled_periods);
  const double settled = waves.half_stroke * height(waves.omega);
  for (double omega = spacing; omega < fastest; omega += spacing) {
    Complex motion = 0;
    Complex same = 0;
    Complex opposite = 0;
    double weights = 0;
    for (long n = 1; n <= steps; ++n) {
      const double t = static_cast<double>(n) * dt;
      motion += waves.piston(t) * std::polar(dt, -omega * t);
      if (t <= waves.end - window) continue;
      const double weight = 1 - std::cos(2 * pi * (t - waves.end) / window);
      weights += weight;
      same += weight * std::polar(1.0, (waves.omega - omega) * t);
      opposite += weight * std::polar(1.0, (waves.omega + omega) * t);
    }
    // The elevation, the sum of Re share exp(i (omega t - k x)), is ahead of the piston's place by a quarter period.
    const Complex share = Complex(0, 1) * motion * (spacing / pi) * height(omega) / settled;
    parts_.push_back({airy.wavenumber(omega), share * opposite / weights, std::conj(share) * same / weights});
  }
}

Complex TankStart::settled_share(double distance) const {
  Complex sum = 0;
  for (const Part& part : parts_) {
    const Complex travel = std::polar(1.0, part.wavenumber * distance);
    sum += part.forward * std::conj(travel) + part.backward * travel;
  }
  return sum * std::polar(1.0, -wavenumber_ * distance);
}

}  // namespace seiche::validation
