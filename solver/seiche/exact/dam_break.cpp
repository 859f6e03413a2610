#include "seiche/exact/dam_break.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/require.hpp"

namespace seiche::exact {

namespace sw = shallow_water;

namespace {

double checked_depth(double depth) {
  require_positive("depth", depth);
  return depth;
}

double checked_downstream(double upstream, double downstream) {
  require_positive("upstream", upstream);
  require_positive("downstream", downstream);
  if (!(downstream < upstream)) {
    throw std::invalid_argument(
        fmt::format("downstream = {:.17g} is out of range: must be below upstream = {:g}", downstream, upstream));
  }
  return downstream;
}

}  // namespace

Ritter::Ritter(double gravity, double depth, double dam) : problem_(gravity, {checked_depth(depth), 0}, {0, 0}, dam) {}

double Ritter::front(double t) const {
  return problem_.jump() + problem_.left_wave().fastest * t;
}
double Ritter::tail(double t) const {
  return problem_.jump() + problem_.left_wave().slowest * t;
}
double Ritter::depth_at_dam() const {
  return 4 * problem_.left().depth / 9;
}
double Ritter::velocity_at_dam() const {
  return 2 * sw::celerity(problem_.gravity(), problem_.left().depth) / 3;
}
double Ritter::discharge_at_dam() const {
  const double depth = problem_.left().depth;
  return 8.0 / 27.0 * depth * sw::celerity(problem_.gravity(), depth);
}

Provenance Ritter::provenance() {
  return {"Ritter, Die Fortpflanzung der Wasserwellen (1892); Stoker, Water Waves (1957)",
          "c = (2 c1 - (x - dam)/t)/3, u = (x - dam)/t + c; front dam + 2 c1 t"};
}

Stoker::Stoker(double gravity, double upstream, double downstream, double dam)
    : problem_(gravity, {upstream, 0}, {checked_downstream(upstream, downstream), 0}, dam) {}

double Stoker::discharge_at_dam() const {
  const double h1 = problem_.left().depth;
  if (problem_.right().depth <= critical_ratio() * h1) return 8.0 / 27.0 * h1 * sw::celerity(problem_.gravity(), h1);
  return plateau().depth * plateau().velocity;
}

double Stoker::critical_ratio() {
  const double root = std::sqrt(10.0);
  const double angle = (std::acos(1 / (10 * root)) + 4 * std::numbers::pi) / 3;
  return 4.0 / 9.0 * (1.0 / 3.0 + 2 * root / 3 * std::cos(angle));
}

Provenance Stoker::provenance() {
  return {
      "Stoker, Water Waves (1957), section 10.8; Bogomolov, Zakharov and Zerkal, Modelling of shallow-water waves by "
      "the particle method",
      "2 (c1 - c*) = (h* - h0) sqrt(g (h* + h0)/(2 h* h0)); bore speed sqrt(g h*(h* + h0)/(2 h0))"};
}

}  // namespace seiche::exact
