#include "seiche/exact/overturning/slope_runup.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>
#include <boost/math/tools/roots.hpp>

#include "seiche/divergence.hpp"
#include "seiche/exact/entry.hpp"
#include "seiche/exact/overturning/slope_climb.hpp"
#include "seiche/exact/solitary_wave.hpp"
#include "seiche/require.hpp"
#include "seiche/require_that.hpp"

namespace seiche::exact {

namespace {

using slope_climb::ChebyshevLine;
using slope_climb::Climb;

constexpr double tail = 1e-8;       // of the wave over the toe at the start, and at the far end
constexpr double held = 5;          // depths of water at rest beyond it
constexpr double settled = 1e-3;    // change of the energy at which nothing is resolved any more
constexpr long fewest = 160;        // markers
constexpr double most_climbs = 60;  // time after the crest's passage of the toe [sqrt(depth/g)]

/// Distance of the crest from the toe at the start [depth].
double distance_of(const SolitaryWave& wave) {
  return -std::log(tail) / wave.decay_rate();
}

Climb start(const SolitaryWave& wave, double cotangent, std::size_t markers, double tolerance) {
  const double distance = distance_of(wave);
  const double far = -2 * distance - held;
  const ChebyshevLine line(markers);
  const Eigen::VectorXd& nodes = line.nodes;
  Eigen::VectorXcd z(nodes.size());
  Eigen::VectorXd phi(nodes.size());
  const double rest = wave.surface_potential(far + distance);
  for (Eigen::Index i = 0; i < nodes.size(); ++i) {
    const double x = far + (1 + nodes[i]) / 2 * (cotangent - far);
    z[i] = {x, 1 + wave.elevation(x + distance)};
    phi[i] = wave.surface_potential(x + distance) - rest;
  }
  auto& shore = z[nodes.size() - 1];
  shore = shore.imag() * std::complex<double>(cotangent, 1);
  return {std::atan2(1, cotangent), z, phi, tolerance};
}

}  // namespace

SlopeRunup::SlopeRunup(double amplitude, double cotangent, double depth, std::size_t markers, double tolerance)
    : amplitude_(amplitude), cotangent_(cotangent), depth_(depth), markers_(markers), tolerance_(tolerance) {
  require_all_positive({{"depth", depth}, {"amplitude", amplitude}});
  require_within("amplitude/depth", amplitude / depth, 0.02, 0.5 * (1 + 1e-12));
  require_within("cotangent", cotangent, 0, 3);
  require_at_least("markers", static_cast<long>(markers), fewest);
  require_within("markers modulo 2", static_cast<double>(markers % 2), 0, 0);
  require_positive("tolerance", tolerance);
  const SolitaryWave wave(amplitude / depth);
  const double passes = distance_of(wave) / wave.speed();
  Climb climb = start(wave, cotangent, markers, tolerance);
  const double energy = climb.energy();
  const double volume = climb.volume();
  const auto keep = [&] { history_.push_back({climb.time() - passes, climb.shore() * depth, climb.shore_speed()}); };
  keep();
  while (history_.back().rise > 0 || climb.time() < passes) {
    climb.step();
    keep();
    if (climb.time() > passes + most_climbs) {
      throw Divergence("at this amplitude and cotangent the shore does not come to rest", climb.time(), climb.steps(),
                       history_.back().level);
    }
  }
  // Highest where the shore rests within the last step.
  const double end = climb.time();
  climb.step_back();
  const double begin = climb.time();
  const auto rise_at = [&](double time) {
    climb.step_back();
    climb.step_to(time);
    return climb.shore_speed();
  };
  boost::uintmax_t iterations = 40;
  const auto close = [](double a, double b) { return b - a < 1e-9; };
  rise_at(boost::math::tools::toms748_solve(rise_at, begin, end, close, iterations).first);
  runup_ = climb.shore() * depth;
  runup_time_ = climb.time() - passes;
  history_.back() = {runup_time_, runup_, 0};
  energy_change_ = std::abs(climb.energy() / energy - 1);
  volume_change_ = std::abs(climb.volume() / volume - 1);
  if (!(energy_change_ < settled)) {
    throw Divergence(
        fmt::format(
            "{:g} of the energy is lost: the surface overturns at this amplitude and cotangent, or has too few markers",
            energy_change_),
        climb.time(), climb.steps(), runup_);
  }
}

double SlopeRunup::level(double time) const {
  const double first = history_.front().time;
  const double last = history_.back().time;
  require_that<std::out_of_range>(time >= first && time <= last, "time = {:g}: the motion is known from {:g} to {:g}",
                                  time, first, last);
  const auto next = std::ranges::upper_bound(history_, time, {}, &Shore::time);
  const Shore& b = next == history_.end() ? history_.back() : *next;
  const Shore& a = next == history_.end() ? history_[history_.size() - 2] : *std::prev(next);
  const double h = b.time - a.time;
  const double u = (time - a.time) / h;
  const double v = 1 - u;
  return v * v * ((1 + 2 * u) * a.level + u * h * a.rise * depth_) +
         u * u * ((1 + 2 * v) * b.level - v * h * b.rise * depth_);
}

double SlopeRunup::uncertainty() const {
  const std::size_t fewer = markers_ / 10 * 8;
  const std::size_t other = fewer < static_cast<std::size_t>(fewest) ? markers_ / 8 * 10 : fewer;
  return std::abs(SlopeRunup(amplitude_, cotangent_, depth_, other, 10 * tolerance_).runup() / runup_ - 1);
}

SelfTest SlopeRunup::identities(double ratio, double tolerance) {
  constexpr double steps = 300;
  // Of the wave's volume, which is more than its amplitude, and of its energy, twice as much as a square.
  const double accuracy = steps * tolerance / ratio;
  const std::string reason =
      "the errors of about 300 steps, each within the tolerance, over the amplitude; along the surface they are "
      "smaller from 160 markers on";
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  return {{"volume is conserved", unknown, accuracy, reason},
          {"energy is conserved", unknown, 2 * accuracy, "twice as much of a square: " + reason}};
}

SelfTest SlopeRunup::self_test() const {
  SelfTest test = identities(amplitude_ / depth_, tolerance_);
  test[0].defect = volume_change_;
  test[1].defect = energy_change_;
  return test;
}

ExactSolution slope_runup_entry() {
  return Entry<SlopeRunup>{
      .name = "slope_runup",
      .title = "Run-up of an exact solitary wave on a plane slope",
      .citation =
          "Grilli, Svendsen & Subramanya, Breaking criterion and characteristics for solitary waves on slopes, J. "
          "Waterway, Port, Coastal, Ocean Eng. 123 (1997) 102; Longuet-Higgins & Cokelet, Proc. R. Soc. Lond. A 350 "
          "(1976) 1",
      .formula =
          "a solitary wave of the Euler equations moved by Cauchy's integral in a plane where bottom and slope are one "
          "line; R = max y of the shore",
      .parameters = {{"amplitude", "m", 0.3, 1e-9, 1e6, "of the incident wave, 0.02 to 0.5 depth"},
                     {"cotangent", "1", 1, 0, 3, "of the slope; 0: a vertical wall"},
                     depth_parameter(1, 1e6),
                     {"markers", "1", 200, 160, 2048, "markers of the computation, even"}},
      .inputs = {{"t", "1", 0,
                  "time from when the crest would pass the toe if there were no slope, times sqrt(g/depth); known "
                  "until the largest run-up"}},
      .outputs = {{"level", "m", "elevation of the shore above still water"}},
      .scalars = {{"runup", "m", "highest elevation of the shore", &SlopeRunup::runup},
                  {"time_of_runup", "1", "when it is reached, times sqrt(g/depth)", &SlopeRunup::runup_time}},
      .make = from<SlopeRunup>("amplitude", "cotangent", "depth", "markers"),
      .row = [](const SlopeRunup& slope, At at) { return Row{slope.level(at[0])}; }};
}

}  // namespace seiche::exact
