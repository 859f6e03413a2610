// The water's surface of improved dispersion: its operator, second harmonics, and shoaling.
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include <boost/math/tools/roots.hpp>

#include "seiche/models/dispersive_shallow_water_1d/water_surface.hpp"
#include "seiche/samples.hpp"
#include "validation/instruments/wave_source.hpp"
#include "verification/check.hpp"
#include "verification/refinement.hpp"

namespace seiche::verification::dispersive_water_surface_test {

using namespace dispersive_shallow_water_1d;

constexpr double pi = std::numbers::pi, improved = 1.0 / 15;
const std::string derived = "derived in water_surface.hpp";

Channel improved_channel(double period = 0) {
  return {.bottom = {}, .period = period, .gamma = improved};
}

/// kh with omega^2 h/g = nu of the model with alpha = 2/5.
double model_wavenumber(double nu) {
  const double linear = 1 - 0.4 * nu;
  return std::sqrt((std::sqrt(linear * linear + 4 * improved * nu) - linear) * 0.5 / improved);
}

/// Amplitude of a harmonic of samples that cover whole periods.
double harmonic(const std::vector<double>& samples, int periods) {
  const auto count = static_cast<double>(samples.size());
  std::complex<double> sum = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    sum += samples[i] * std::polar(1.0, 2 * pi * periods * static_cast<double>(i) / count);
  }
  return 2 * std::abs(sum) / count;
}

TEST_CASE("the water's surface of a wave between equal nodes has its closed form", "[dispersion]") {
  Check check("water_surface_factor", "The water's surface: factor of waves over a level bottom",
              "Nodes at equal distances over one depth: a wave of the nodes corresponds to a wave of the water's "
              "surface with an amplitude (1 + 3 S gamma/4)/(1 + S gamma/4) times theirs, S = (2 sin(kh/2)/h)^2 over "
              "the depth 1, for every wave that the nodes resolve, in a ring and between walls.");
  Worst ring, walls;
  constexpr int n = 24;
  constexpr double h = 0.3;
  const std::vector<double> widths(n, h);
  for (int waves = 1; waves <= n / 2; ++waves) {
    const double k = 2 * pi * waves / (n * h);
    const double s = improved * std::pow(2 * std::sin(k * h / 2) / h, 2);
    const double factor = (1 + 0.75 * s) / (1 + 0.25 * s);
    std::vector<double> x, y;
    for (int i = 0; i <= n; ++i) {
      x.push_back(h * i);
      y.push_back(std::cos(k * h * i));
    }
    const auto of_walls = water_surface(improved_channel(), x, y, widths);
    x.pop_back();
    y.pop_back();
    const auto of_ring = water_surface(improved_channel(n * h), x, y, widths);
    for (std::size_t i = 0; i < n; ++i) {
      ring.add(of_ring[i] - factor * y[i]);
      walls.add(of_walls[i] - factor * y[i]);
    }
  }
  const auto claim = [&](const std::string& id, const std::string& where, double value) {
    check.holds(
        id + ": Every wave " + where + " is higher by its factor.", {value},
        Roundoff{100, 3, "elimination of 24 rows of four operations; positions of up to 7 rounded against 0.3"});
  };
  claim("ring", "in a ring", ring.value());
  claim("walls", "between walls", walls.value());
}

TEST_CASE("the water's surface is second-order accurate over an uneven bottom", "[dispersion]") {
  Check check("water_surface_order", "The water's surface: order over an uneven bottom",
              "With L w = (H^2 w_x)_x, w = sin x and H = 1 + 0.3 cos x, nodes at uneven positions carry w - gamma L "
              "w/4; the water's surface there is w - 3 gamma L w/4.",
              derived);
  refine(check, {"width of a cell", widths(2 * pi, {50, 100, 200, 400})},
         {{"order",
           "The error of the water surface converges at second order.",
           {2, 0.05, "smooth positions, differences between neighbours"}}},
         [](double width) {
           const auto n = static_cast<int>(cells_of(2 * pi, width));
           std::vector<double> x, y, zeta, volume;
           const auto place = [&](int i) {
             const double a = 2 * pi * i / n;
             return a + 0.3 * std::sin(a + 1);
           };
           for (int i = 0; i < n; ++i) {
             const double at = place(i), depth = 1 + 0.3 * std::cos(at);
             const double operated = 2 * depth * -0.3 * std::sin(at) * std::cos(at) - depth * depth * std::sin(at);
             x.push_back(at);
             y.push_back(std::sin(at) - improved / 4 * operated);
             zeta.push_back(std::sin(at) - 3 * improved / 4 * operated);
             const double next = place(i + 1);
             volume.push_back(next - at + 0.3 * (std::sin(next) - std::sin(at)));
           }
           const auto surface = water_surface(improved_channel(2 * pi), x, y, volume);
           Mean square;
           for (std::size_t i = 0; i < x.size(); ++i) square.add(surface[i] - zeta[i]);
           return square.rms();
         });
}

TEST_CASE("second harmonics of the water's surface agree with Stokes", "[dispersion]") {
  Check check("water_surface_stokes", "The water's surface: bound second harmonics",
              "In a wave of permanent form the second harmonic is (k a^2/4) (3 - s^2)/s^3, s = tanh k, after Stokes. "
              "The second harmonic of the water's surface with gamma = 1/15 and alpha = 2/5 must agree to the order "
              "k^4 of its error; the harmonics of the nodes and of Serre's equations agree to k^2 only. Waves that "
              "start with the nodes' own second harmonic retain it.",
              "Stokes, Trans. Camb. Phil. Soc. 8 (1847) 441");
  refine(check, {"k", {0.1, 0.15, 0.2, 0.3}},
         {{"surface",
           "The second harmonic of the water surface differs from Stokes's by O(k^4).",
           {4, 0.2, "expansion in k"}},
          {"markers", "The second harmonic of the nodes differs from Stokes's by O(k^2).", {2, 0.2, "expansion in k"}}},
         [](double k) {
           const double sigma = std::tanh(k);
           const double stokes = k / 4 * (3 - sigma * sigma) / std::pow(sigma, 3);
           const double markers = bound_second_harmonic(0.4, improved, 2, k);
           const double surface =
               markers * surface_of_wave(improved, 2 * k) / std::pow(surface_of_wave(improved, k), 2);
           return std::array{std::abs(surface / stokes - 1), std::abs(markers / stokes - 1)};
         });

  // A wavelength of 2 pi in a ring.
  constexpr double amplitude = 0.01;
  constexpr std::size_t n = 128;
  const Channel channel{
      .bottom = std::make_shared<LevelBottom>(1.0), .period = 2 * pi, .alpha = 0.4, .gamma = improved};
  const double second = bound_second_harmonic(channel.alpha, channel.gamma, channel.depth_power, 1) * amplitude;
  const double speed = std::sqrt((1 + channel.gamma) / (1 + channel.alpha));
  const auto eta = [&](double x) { return amplitude * (std::cos(x) + second * std::cos(2 * x)); };
  const auto motion = [&](double x) {
    const double slope = -amplitude * (std::sin(x) + 2 * second * std::sin(2 * x)), depth = 1 + eta(x);
    return SurfaceMotion{eta(x), speed * eta(x) / depth, -speed * slope / depth};
  };
  const auto excess = [&](double x) { return amplitude * (std::sin(x) + second / 2 * std::sin(2 * x)); };
  Flow flow(channel, moved_markers(channel, equal_labels(channel, 0, 2 * pi, n), motion, excess, 2 * pi));
  std::vector<double> places;
  for (std::size_t i = 0; i < 4 * n; ++i) places.push_back(2 * pi * static_cast<double>(i) / (4 * n));
  Largest deviation;
  for (int k = 1; k <= 40; ++k) {
    march(flow, k, stable_steps(flow, 0.02));
    deviation.add(std::abs(harmonic(flow.elevation_at(places), 2) / (amplitude * second) - 1));
  }
  check.from(derived).that(
      "kept", "The second harmonic of the wave on the nodes changes by at most 2 % in six periods.",
      "largest change over it", {.value = deviation.value(), .resolution = "128 nodes, steps of 0.02"},
      Bound{0.02,
            "third-order terms in the slope, and straight lines between nodes, are some 0.1 % of it; an additional "
            "free harmonic would beat with twice the error"});
}

TEST_CASE("the water's surface shoals at constant Airy energy flux", "[dispersion]") {
  Check check(
      "water_surface_shoaling", "The water's surface over a slope",
      "Small waves with kh = 1.5 climb a gentle slope from the depth 1 to 0.3. What the surface's amplitude has become "
      "there is compared with the flux of energy: Airy's, a^2 c_g, and the model's own, y^2 (1 + gamma (kh)^2) c_g.",
      derived);
  constexpr double shallow = 0.3;
  const double omega = std::sqrt(1.5 * std::tanh(1.5));
  struct Wave {
    double airy, surface;  // energy flux of the amplitude 1
  };
  const auto wave = [&](double depth) {
    const double nu = omega * omega * depth;
    const auto [low, high] = boost::math::tools::bisect([&](double kh) { return kh * std::tanh(kh) - nu; }, 1e-3, 10.0,
                                                        boost::math::tools::eps_tolerance<double>(40));
    const double airy = 0.5 * (low + high), kh = model_wavenumber(nu), s = kh * kh;
    // c_g over depth: d omega/dk with omega^2 = s (1 + gamma s)/(1 + alpha s)/depth
    const double slope =
        ((1 + 2 * improved * s) * (1 + 0.4 * s) - 0.4 * s * (1 + improved * s)) / std::pow(1 + 0.4 * s, 2);
    return Wave{0.5 * omega / airy * depth * (1 + 2 * airy / std::sinh(2 * airy)),
                slope * kh / omega * (1 + improved * s) / std::pow(surface_of_wave(improved, kh), 2)};
  };
  const Wave deep = wave(1), high = wave(shallow);
  const double airy = std::sqrt(deep.airy / high.airy), own = std::sqrt(deep.surface / high.surface);

  Channel channel{.bottom = std::make_shared<PiecewiseLinearBottom>(std::vector<double>{-260, 0, 40, 140},
                                                                    std::vector<double>{-1, -1, -0.3, -0.3}),
                  .kinetics = Kinetics::green_naghdi,
                  .alpha = 0.4,
                  .gamma = improved};
  constexpr double amplitude = 1e-4;
  const double k = model_wavenumber(omega * omega);
  const auto fade = [](double s) { return 0.5 * (1 + std::tanh(s / 4)); };
  const auto eta = [&](double x) { return amplitude * fade(x + 230) * fade(-20 - x) * std::cos(k * x); };
  const auto motion = [&](double x) {
    const double slope = (eta(x + 1e-3) - eta(x - 1e-3)) / 2e-3;
    return SurfaceMotion{eta(x), omega / k * eta(x), -omega / k * slope};
  };
  std::vector<double> sums{0};
  constexpr double fine = 0.01;
  for (int i = 1; i <= 40000; ++i) {
    const double x = -260 + fine * i;
    sums.push_back(sums.back() + 0.5 * fine * (eta(x - fine) + eta(x)));
  }
  const auto excess = [&](double x) {
    const double at = std::clamp((x + 260) / fine, 0.0, 39999.0);
    const auto i = static_cast<std::size_t>(at);
    return sums[i] + (at - static_cast<double>(i)) * (sums[i + 1] - sums[i]);
  };
  Flow flow(channel, moved_markers(channel, equal_labels(channel, -259, 140, 7980), motion, excess, 140));
  const double period = 2 * pi / omega, begin = 36 * period;
  march(flow, begin, stable_steps(flow, 0.025));
  const std::vector<double> places{-8, -7, -6, -5, 42, 43, 44, 45};
  std::vector<std::vector<double>> records(places.size());
  constexpr int samples = 64;
  for (int i = 1; i <= 2 * samples; ++i) {
    march(flow, begin + period * i / samples, stable_steps(flow, 0.025));
    const auto surface = water_surface_at(flow, places);
    for (std::size_t j = 0; j < places.size(); ++j) records[j].push_back(surface[j]);
  }
  // Means over about half a wavelength, in which what little is reflected cancels.
  double before = 0, after = 0;
  for (std::size_t j = 0; j < 4; ++j) {
    before += harmonic(records[j], 2) / 4;
    after += harmonic(records[j + 4], 2) / 4;
  }
  check.at("7980 nodes, 85 a wavelength");
  check.that(
      "own", "The amplitude agrees with the model's own flux of energy within 0.5 %.", "amplitude above over below",
      {after / before},
      Bound{0.005 * own, "reflections by corners and slope and remains of the train's front, a few per mille", own});
  check.from("Airy's energy flux, e.g. Dean and Dalrymple, Water Wave Mechanics (1991), ch. 4")
      .that("airy", "The amplitude agrees with Airy's flux of energy.", "amplitude above over below", {after / before},
            Bound{std::abs(own - airy) + 0.005 * airy,
                  "as before, and the difference between the two laws of energy flux at kh = 1.5", airy});
}

}  // namespace seiche::verification::dispersive_water_surface_test
