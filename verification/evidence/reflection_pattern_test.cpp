// The measures of Mach reflection on surfaces whose crests are known exactly.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <fmt/format.h>
#include <boost/math/tools/minima.hpp>

#include "seiche/samples.hpp"
#include "validation/instruments/plan/reflection_pattern.hpp"
#include "validation/instruments/plan/wall_history.hpp"
#include "verification/check.hpp"
#include "verification/evidence/reflection_problems.hpp"

namespace seiche::verification::reflection_pattern_test {

using namespace validation;

constexpr double a = 0.3, spacing = 0.5;
const double S = std::sqrt(3 * a);

/// Error of the parabola through three nodes of a crest 1 - s^2 + 2 s^4/3, s = S x/2 in units of its width: with nodes
/// at most eta apart its top is wrong by 3 eta^4/8 of the height and by 0.128 eta^3 in s. Displaced nodes are farther
/// apart across the crest, by twice the displacement along and across it.
struct ParabolaError {
  double height;  ///< relative
  double place;   ///< in depths
};
ParabolaError parabola_limit(double disorder, double lean) {
  const double eta = 0.5 * S * spacing * (1 + 2 * disorder * (1 + lean));
  return {0.375 * std::pow(eta, 4), 0.128 * std::pow(eta, 3) * 2 / S};
}

struct Configuration {
  std::string id;
  double kappa, disorder;
};

/// With a stem: when its end is 25 depths from the wall, but not before the wall has its limit to 1e-4.
double time_of(const ExactReflection& waves) {
  return waves.has_stem() ? std::max(25 / waves.stem_growth(), 10 / waves.settling_rate()) : 300;
}

double height_of(const ExactReflection& waves) {
  return 55 + (waves.has_stem() ? waves.stem_growth() * time_of(waves) : 0);
}

double highest_on_wall(const ExactReflection& waves, double t) {
  const double crest = waves.wall().at(0, t);
  return -boost::math::tools::brent_find_minima([&](double x) { return -waves.elevation(x, 0, t); }, crest - 1,
                                                crest + 1, 50)
              .second;
}

void claim_pattern(Check& check, const Configuration& configuration) {
  const ExactReflection waves(a, configuration.kappa);
  const double t = time_of(waves);
  const SampledReflection sampled(waves, t, height_of(waves), spacing, configuration.disorder);
  const ReflectionPattern pattern = measured_reflection(sampled.lattice(), a);
  const std::string what = fmt::format("kappa = {:g}, {} grid: ", configuration.kappa,
                                       configuration.disorder > 0 ? "disordered" : "uniform");
  const auto bounded = [&](const std::string& id, const std::string& text, double value, double expected, double limit,
                           const std::string& reason) {
    check.holds(id + "-" + configuration.id + ": " + what + text, {value}, Bound{limit, reason, expected});
  };
  const ParabolaError error = parabola_limit(configuration.disorder, waves.incident().lean);
  // The crest on the wall is higher and, for a stem, narrower: S becomes S (1 + kappa).
  const double wall_height = highest_on_wall(waves, t);
  bounded("wall-amplitude", "the amplitude at the wall is found.", pattern.wall_amplitude.value, wall_height,
          wall_height * parabola_limit(configuration.disorder, 0).height *
              std::pow(1 + std::min(configuration.kappa, 1.0), 4),
          "error of the parabola, 3 eta^4/8 with the width of the stem");
  bounded("incident-amplitude", "the amplitude of the incident wave is found.", pattern.incident_amplitude.value, a,
          a * error.height, "error of the parabola, 3 eta^4/8");
  // Errors E of either sign at the rows of a band of length L change the slope by up to 3 E/L.
  const double band = (ReflectionBands{}.incident_to - ReflectionBands{}.incident_from) * height_of(waves);
  const double slope_error = 3 * error.place / band;
  bounded("incident-angle", "the angle of the incident wave is found.", pattern.incident_angle.value,
          waves.incident().angle(), slope_error, "error E of the parabola's position in a band of length L: 3 E/L");
  const double stem =
      (waves.wall().at(0, t) - waves.incident().offset - waves.incident().speed * t) / waves.incident().lean;
  const double from_band = 0.89 * height_of(waves) - stem;
  bounded("stem-length", "where the incident line reaches the crest on the wall.", pattern.stem_length.value, stem,
          (2 * error.place + slope_error * from_band) / waves.incident().lean,
          "errors of the positions on the wall and in the band and of the slope, extrapolated");
  // The tail of the front crest, 4 exp(-8 S) = 0.002 of it at 8 depths, is in the uncertainty by the spread of the
  // rows.
  REQUIRE(pattern.reflected);
  const double widest = 0.02;
  check.holds(what + "the reflected amplitude is Miles's within the uncertainty stated.", pattern.reflected_ratio(),
              evidence::Uncertainty{.expected = waves.reflected().amplitude / a,
                                    .useful = widest,
                                    .reason = "spread of the rows, which see the front crest's tail"});
  check.holds(what + "the reflected angle is Miles's within the uncertainty stated.", pattern.reflected->angle,
              evidence::Uncertainty{.expected = waves.reflected().angle(),
                                    .useful = widest,
                                    .reason = "standard error of the line and its curvature near the front crest"});
}

/// Rows of the surface above one another, and the crests found on them.
void draw(Check& check) {
  const ExactReflection waves(a, 0.5);
  const double t = time_of(waves), height = height_of(waves);
  const SampledReflection sampled(waves, t, height, spacing);
  const SurfaceLattice surface = sampled.lattice();
  const ReflectionPattern pattern = measured_reflection(surface, a);
  auto& figure = check.figure(
      "pattern", "Crests found on an exact surface of Mach reflection",
      fmt::format("Kadomtsev-Petviashvili equation, $a_i = {:g}$, $\\kappa = 0.5$, $t = {:.0f}$: elevations of the "
                  "rows of a grid, ten times exaggerated; the crests that are measured and the lines through them. The "
                  "incident line meets the crest on the wall at the end of the stem.",
                  a, t));
  auto& panel = figure.panel({.x = "x [depths]", .y = "distance from the wall y + 10 eta [depths]", .y_max = 150});
  const double origin = waves.wall().at(0, t);
  for (std::size_t j = 0; j <= surface.rows; j += 8) {
    std::vector<double> x, raised;
    for (std::size_t i = 0; i <= surface.columns; ++i) {
      const std::size_t n = surface.node(i, j);
      x.push_back(surface.x[n] - origin);
      raised.push_back(surface.y[n] + 10 * surface.z[n]);
    }
    panel.line(j == 0 ? "surface" : "", x, raised, Role::water);
  }
  const auto points = [&](const std::string& label, const std::vector<Crest>& crests, Role role) {
    std::vector<double> x, raised;
    for (const Crest& crest : crests) {
      x.push_back(crest.x - origin);
      raised.push_back(crest.y + 10 * crest.height);
    }
    panel.points(label, x, raised, role);
  };
  const auto line = [&](const std::string& label, const StraightLine& fit, double from, double to, double raise) {
    panel.line(label, std::vector<double>{fit.at(from) - origin, fit.at(to) - origin},
               std::vector<double>{from + raise, to + raise}, Role::guide);
  };
  const double end = pattern.stem_length.value;
  line("lines", pattern.incident_line, end, height, 10 * a);
  line("", pattern.reflected->line, end, 0.75 * height, 10 * pattern.reflected->amplitude.value);
  points("incident crest, a_i and psi_i", pattern.incident, Role::computed);
  points("reflected crest, a_r and psi_r", pattern.reflected->crests, Role::peer);
  points("crest on the wall, a_w", {pattern.wall}, Role::exact);
  const std::vector<double> stem_end{end + 10 * a};
  panel.points("end of the stem, y_T", std::vector<double>{pattern.wall.x - origin}, stem_end, Role::data);
}

TEST_CASE("amplitudes, angles and stem of a reflection are recovered from its surface", "[evidence]") {
  Check check(
      "reflection_measures", "Measuring Mach reflection",
      "Measurements of the reflection of a solitary wave (amplitudes at the wall and of the incident and reflected "
      "wave, their angles, the stem's length and angle), on exact surfaces of the Kadomtsev-Petviashvili equation with "
      "$a_i = 0.3$ sampled every h/2, on uniform grids and on grids whose nodes are displaced by up to 15 % of the "
      "spacing. The limits are the error of the parabola through three nodes.");
  for (const double disorder : {0.0, 0.15}) {
    for (const double kappa : {0.4, 0.6, 0.8, 1.3}) {
      claim_pattern(check,
                    {fmt::format("{:02.0f}-{}", 10 * kappa, disorder > 0 ? "disordered" : "uniform"), kappa, disorder});
    }
  }

  const ExactReflection waves(a, 0.6);
  std::vector<double> wall_x, stem;
  for (const double later : {0.0, 60.0}) {
    const double t = time_of(waves) + later;
    const ReflectionPattern pattern =
        measured_reflection(SampledReflection(waves, t, height_of(waves) + 10, spacing).lattice(), a);
    wall_x.push_back(pattern.wall.x);
    stem.push_back(pattern.stem_length.value);
  }
  const double path = wall_x.back() - wall_x.front();
  const ParabolaError error = parabola_limit(0, waves.incident().lean);
  check.holds("The stem's angle, from two surfaces 60 h/c0 apart.", {std::tan(stem_angle(wall_x, stem).value)},
              Bound{2 * (2 + 3 * 55 / (0.14 * 80)) * error.place / waves.incident().lean / path,
                    "errors of two lengths of the stem over the path", waves.stem_growth() / waves.wall().speed});
  std::reverse(stem.begin(), stem.end());
  check.holds("The angle of a shrinking stem is negative.",
              {stem_angle(wall_x, stem).value + std::atan((stem.front() - stem.back()) / path)},
              Roundoff{10, 1, "a line through two points and its angle"});

  const double exact_height = highest_on_wall(waves, time_of(waves));
  std::vector<double> spacings, three_nodes, five_nodes;
  for (double h = 0.3; h > 0.07; h /= std::numbers::sqrt2) {
    // The crest wanders over the spacing between the nodes as the lattice moves.
    Worst worst_of_three, worst_of_five;
    for (int shift = 0; shift < 8; ++shift) {
      const SampledReflection row(waves, time_of(waves), 4.5 * h, h, 0, h * shift / 8);
      const Crest crest = wall_crest(row.lattice(), 0.01 * a);
      worst_of_three.add(crest.height - exact_height);
      worst_of_five.add(five_node_height(row.lattice(), crest, 0) - exact_height);
    }
    spacings.push_back(h);
    three_nodes.push_back(worst_of_three.value());
    five_nodes.push_back(worst_of_five.value());
  }
  const auto claim_order = [&](const std::string& id, const std::string& nodes, const std::vector<double>& errors,
                               double order) {
    check.holds(id + ": The wall amplitude from " + nodes + " nodes converges with this order.",
                observed_order(spacings, errors),
                Order{order, 0.4, "interpolation of an even maximum by polynomials of degree 2 and 4"});
  };
  claim_order("three-nodes", "three", three_nodes, 4);
  claim_order("five-nodes", "five", five_nodes, 6);
  draw(check);

  std::vector<double> x(25), y(25), z(25);
  const SurfaceLattice flat{4, 4, x, y, z};
  CHECK_THROWS_AS(measured_reflection(flat, a), std::runtime_error);
  CHECK_THROWS_AS(measured_reflection({4, 5, x, y, z}, a), std::invalid_argument);
  CHECK_THROWS_AS(measured_reflection({3, 3, x, y, z}, a), std::invalid_argument);
  CHECK_THROWS_AS(measured_reflection(SampledReflection(waves, 10, 20, 1).lattice(), 0), std::invalid_argument);
  z[7] = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(measured_reflection({4, 4, x, y, z}, a), std::invalid_argument);
}

}  // namespace seiche::verification::reflection_pattern_test
