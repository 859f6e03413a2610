#include "seiche/exact/mach_reflection.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <Eigen/Eigenvalues>

#include "seiche/exact/entry.hpp"
#include "seiche/require.hpp"
#include "seiche/samples.hpp"

namespace seiche::exact {

MachReflection::MachReflection(double amplitude, double angle, Theory theory) : amplitude_(amplitude), angle_(angle) {
  require_positive("amplitude/depth", amplitude);
  require_within("amplitude/depth", amplitude, 0, 0.8332);
  require_positive("angle", angle);
  require_within("angle", angle, 0, std::nextafter(0.5 * std::numbers::pi, 0));
  const double critical = std::sqrt(3 * amplitude);
  kappa_ = theory == Theory::miles ? angle / critical : std::tan(angle) / (critical * std::cos(angle));
}

double MachReflection::reflected_ratio(double kappa) {
  require_positive("kappa", kappa);
  return kappa < 1 ? kappa * kappa : 1;
}

double MachReflection::wall_ratio(double kappa) {
  require_positive("kappa", kappa);
  if (kappa < 1) return (1 + kappa) * (1 + kappa);
  return 4 / (1 + std::sqrt((kappa - 1) * (kappa + 1)) / kappa);
}

SelfTest MachReflection::self_test() const {
  const double wall = wall_ratio();
  if (has_stem()) {
    // Resonant triad: the wavenumbers, proportional to the root of the amplitudes, add up.
    return {{"sqrt(a_w) = sqrt(a_i) + sqrt(a_r)", std::abs(std::sqrt(wall) - 1 - std::sqrt(reflected_ratio())), 2e-15,
             "6 roundings of numbers up to 2"}};
  }
  // 4/x - 1 = sqrt(1 - kappa^-2), squared
  return {{"16 - 8 x + (x/kappa)^2 = 0 for x = a_w/a_i", std::abs(16 - 8 * wall + wall * wall / (kappa_ * kappa_)) / 32,
           3e-16,
           "half an ulp for each rounding of (x/kappa)^2, at most 16, and of x, by which it changes by at most 8: 60 "
           "half ulps in all, over 32"}};
}

namespace {

/// Lowest eigenvalues of -psi'' - nu (nu + 1) sech^2(x) psi, by the sinc series on [-half, half].
Eigen::VectorXd levels(double order, double spacing, double half) {
  const auto beside = static_cast<Eigen::Index>(std::ceil(half / spacing));
  const Eigen::Index n = 2 * beside + 1;
  Eigen::MatrixXd matrix(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < n; ++j) {
      const auto apart = static_cast<double>(i - j);
      matrix(i, j) = ((i - j) % 2 == 0 ? 2 : -2) / std::pow(apart * spacing, 2);
    }
    const double sech = 1 / std::cosh(static_cast<double>(i - beside) * spacing);
    matrix(i, i) = std::pow(std::numbers::pi / spacing, 2) / 3 - order * (order + 1) * sech * sech;
  }
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix, Eigen::EigenvaluesOnly).eigenvalues();
}

/// A solution of ratios, and the amplitude that they are of.
template <class Solution>
struct Scaled : Solution {
  double amplitude_of_incident;
};

}  // namespace

SolitonFission::SolitonFission(double depth, Passage passage) : depth_(depth) {
  require_within("depth", depth, 0.05, 1);
  const double root = std::sqrt(depth);
  transmission_ = passage == Passage::abrupt ? 2 / (1 + root) : 1 / std::sqrt(root);
  reflection_ = passage == Passage::abrupt ? (1 - root) / (1 + root) : 0;
  order_ = std::sqrt(0.25 + 2 * transmission_ / (depth * depth)) - 0.5;
}

double SolitonFission::amplitude(int n) const {
  require_at_least("n", n, 1);
  const double level = std::max(order_ - n + 1, 0.0);
  return std::pow(depth_ * level, 2);
}

SelfTest SolitonFission::self_test() const {
  const double root = std::sqrt(depth_);
  const double flux = reflection_ * reflection_ + transmission_ * transmission_ * root;
  // The bound states that decay within the interval.
  const double slowest = std::max(0.5, order_ / 4);
  const double spacing = std::min(0.15, 0.8 / order_);  // sech^2 has poles at i pi/2: exp(-pi^2/(2 spacing))
  // They oscillate out to where the potential is their level, about nu sech x = slowest, and decay from there.
  const double turning = std::acosh(std::max(1.0, (order_ + 0.5) / slowest));
  const Eigen::VectorXd found = levels(order_, spacing, turning + 1 + 15 / slowest);
  Worst worst;
  for (int n = 1; n <= solitons(); ++n) {
    const double decay = std::sqrt(amplitude(n)) / depth_;
    if (decay >= slowest) worst.add(std::sqrt(-found[n - 1]) / decay - 1);
  }
  return {{"the energy of long waves passes or is reflected, R^2 + T^2 sqrt(h) = 1", std::abs(flux - 1), 1e-14,
           "a few rounded operations of numbers of order 1"},
          {"the amplitudes are the levels of -nu (nu + 1) sech^2 x, by the sinc series", std::abs(worst.value()), 1e-11,
           "rounding of a matrix whose entries, (pi/spacing)^2, are up to 1e3 times the levels; what the interval cuts "
           "off is exp(-30)"}};
}

static_assert(ReferenceSolution<SolitonFission>);

ExactSolution mach_reflection_entry() {
  constexpr double degree = std::numbers::pi / 180;
  return Entry<Scaled<MachReflection>>{
      .name = "mach_reflection",
      .title = "A solitary wave meets a wall at an angle: Mach stem or regular reflection",
      .citation = "Miles, J. Fluid Mech. 79 (1977) 171; Li, Yeh and Kodama, J. Fluid Mech. 672 (2011) 326",
      .formula =
          "kappa = psi/sqrt(3a) or tan(psi)/(sqrt(3a) cos psi); a_w/a_i = (1 + kappa)^2 for kappa < 1, 4/(1 + sqrt(1 - "
          "kappa^-2)) for kappa >= 1",
      .parameters = {{"amplitude", "m", 0.05, 1e-9, 1e6, "amplitude of the incident wave"},
                     {"angle", "deg", 20, 1e-6, 89.999999, "between the incident wave's direction and the wall"},
                     depth_parameter(1, 1e6),
                     {"theory", "1", 0, 0, 1, "small angles, or corrected for their size", {"miles", "kodama_yeh"}}},
      .inputs = {},
      .outputs = {{"a_w", "m", "amplitude at the wall; error of the theory about amplitude/depth, relative"},
                  {"a_r", "m", "amplitude of the reflected wave"},
                  {"psi_r", "deg", "angle of the reflected wave"},
                  {"kappa", "1", "interaction parameter, Mach reflection below 1"},
                  {"stem_angle", "deg", "direction in which the stem grows, from the wall; 0 without a stem"}},
      .scalars = {},
      .make = made_by(
          [](double amplitude, double angle, double depth, MachReflection::Theory theory) {
            return Scaled<MachReflection>{{amplitude / depth, angle * degree, theory}, amplitude};
          },
          "amplitude", "angle", "depth", "theory"),
      .row = [](const Scaled<MachReflection>& reflection, At) {
        const double amplitude = reflection.amplitude_of_incident;
        return Row{amplitude * reflection.wall_ratio(), amplitude * reflection.reflected_ratio(),
                   reflection.reflected_angle() / degree, reflection.kappa(), reflection.stem_angle() / degree};
      }};
}

ExactSolution soliton_fission_entry() {
  return Entry<Scaled<SolitonFission>>{
      .name = "soliton_fission",
      .title = "A solitary wave passes onto a shelf and falls apart into several",
      .citation =
          "Madsen & Mei, J. Fluid Mech. 39 (1969) 781; Johnson, Proc. Camb. Phil. Soc. 73 (1973) 183; Lamb (1932), 176",
      .formula = "a_n/a_0 = h^2 (nu - n + 1)^2, nu (nu + 1) = 2 T/h^2, T = 2/(1 + sqrt h) or h^(-1/4)",
      .parameters = {{"amplitude", "1", 0.1, 1e-9, 1e6, "of the wave before the shelf, over the depth there"},
                     {"shelf_depth", "1", 0.5, 0.05, 1, "of the water on the shelf, over that depth"},
                     {"passage", "1", 0, 0, 1, "how it gets there", {"abrupt", "gradual"}}},
      .inputs = {{"n", "1", 1, "of the wave on the shelf, 1 for the highest"}},
      .outputs = {{"a_n", "1", "its amplitude, over that depth; error of the theory about a_n/shelf_depth, relative"}},
      .scalars = {{"solitons", "1", "how many there are", &SolitonFission::solitons},
                  {"a_r", "1", "amplitude of the reflected wave, over that depth",
                   [](const Scaled<SolitonFission>& fission) {
                     return fission.amplitude_of_incident * fission.reflection();
                   }},
                  {"transmission", "1", "amplitude at the beginning of the shelf, relative",
                   &SolitonFission::transmission}},
      .make = made_by(
          [](double amplitude, double depth, SolitonFission::Passage passage) {
            return Scaled<SolitonFission>{SolitonFission(depth, passage), amplitude};
          },
          "amplitude", "shelf_depth", "passage"),
      .row = [](const Scaled<SolitonFission>& fission, At at) {
        return Row{fission.amplitude_of_incident * fission.amplitude(static_cast<int>(std::lround(at[0])))};
      }};
}

}  // namespace seiche::exact
