#include "seiche/exact/hexahedral_dispersion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "seiche/exact/dispersion.hpp"
#include "seiche/exact/layer_response.hpp"
#include "seiche/exact/plan_dispersion.hpp"
#include "seiche/exact/plan_symbol.hpp"
#include "seiche/require.hpp"
#include "seiche/samples.hpp"

namespace seiche::exact {

static_assert(ReferenceSolution<HexahedralDispersion>);

HexahedralDispersion::HexahedralDispersion(double gravity, double depth, double spacing_x, double spacing_y,
                                           std::size_t layers, SurfaceInertia inertia)
    : gravity_(gravity), depth_(depth), spacing_x_(spacing_x), spacing_y_(spacing_y), layers_(layers) {
  require_positive("gravity", gravity);
  require_positive("depth", depth);
  require_positive("spacing_x", spacing_x);
  require_positive("spacing_y", spacing_y);
  require_at_least("layers", static_cast<long>(layers), 1);
  inertia_ = 0.5 - (inertia == SurfaceInertia::tuned ? 1 / (6 * static_cast<double>(layers)) : 0.0);
}

double HexahedralDispersion::frequency(double kx, double ky) const {
  const PlanSymbol symbol = plan_symbol(kx, ky, spacing_x_, spacing_y_);
  return std::sqrt(2 * gravity_ / layer_height() * symbol.potential *
                   layer_response(0.5 * layer_height() * symbol.gradient, symbol.mean, layers_, inertia_));
}

double HexahedralDispersion::by_layers(double kx, double ky) const {
  const PlanSymbol symbol = plan_symbol(kx, ky, spacing_x_, spacing_y_);
  return std::sqrt(2 * gravity_ / layer_height() * symbol.potential *
                   layer_response_by_rows(0.5 * layer_height() * symbol.gradient, symbol.mean, layers_, inertia_));
}

double HexahedralDispersion::phase_speed(double kx, double ky) const {
  return frequency(kx, ky) / std::hypot(kx, ky);
}

double HexahedralDispersion::frequency_error(double wavenumber, double direction) const {
  require_positive("wavenumber", wavenumber);
  require_finite("direction", direction);
  return frequency(wavenumber * std::cos(direction), wavenumber * std::sin(direction)) /
             AiryDispersion(gravity_, depth_).frequency(wavenumber) -
         1;
}

double HexahedralDispersion::frequency_bound() const {
  return std::sqrt(gravity_ / (inertia_ * layer_height()));
}

Provenance HexahedralDispersion::provenance() {
  return {
      "Frank, Discrete models of incompressible fluid (1994), section 4.1; closed form derived from the linearised "
      "layers",
      "omega^2 = (2g/h3) G T (1 - T^2) t_n/(1 - T t_n + 2 b T (1 - T^2) t_n), T = K h3/2, "
      "K^2 = sum ((2/h_i) tan(k_i h_i/2))^2, G = product (2 + cos k_i h_i)/3, t_n = tanh(2 n artanh T), h3 = H/n, "
      "b = 1/2 or 1/2 - 1/(6n)"};
}

double HexahedralDispersion::uncertainty() const {
  return 20 * std::numeric_limits<double>::epsilon();
}

SelfTest HexahedralDispersion::self_test() const {
  const double shortest_x = std::numbers::pi / spacing_x_;
  const double shortest_y = std::numbers::pi / spacing_y_;
  const auto inertia = inertia_ < 0.5 ? SurfaceInertia::tuned : SurfaceInertia::nodal;
  const LagrangianMeshDispersion section(gravity_, depth_, spacing_x_, layers_, inertia);
  const HexahedralDispersion one_layer(gravity_, depth_, spacing_x_, spacing_y_, 1, inertia);
  const PlanDispersion markers(gravity_, depth_, spacing_x_, spacing_y_, one_layer.inertia_);
  Worst layers_defect;
  Worst section_defect;
  Worst markers_defect;
  constexpr int waves = 16;
  for (int i = 1; i <= waves; ++i) {
    const double kx = shortest_x * i / waves;
    section_defect.add(frequency(kx, 0) / section.frequency(kx) - 1);
    for (int j = 0; j <= waves; ++j) {
      const double ky = shortest_y * j / waves;
      layers_defect.add(by_layers(kx, ky) / frequency(kx, ky) - 1);
      markers_defect.add(one_layer.frequency(kx, ky) / markers.frequency(kx, ky) - 1);
    }
  }
  const double longest = 1e-9 / std::max({depth_, spacing_x_, spacing_y_});
  return {
      {"frequency from the layers one by one", layers_defect.value(),
       std::numeric_limits<double>::epsilon() * (20 + 1.5 * static_cast<double>(layers_)),
       "half an ulp for each of 20 roundings in either formula; 6 more per layer, under the root"},
      {"along an axis: the two-dimensional mesh", section_defect.value(), 1e-14,
       "45 ulp for 20 roundings in either law"},
      {"one layer: the plan law with alpha = b", markers_defect.value(), 1e-14,
       "45 ulp for 20 roundings in either law"},
      {"shortest wave: omega^2 = g/(9 b h3)", std::abs(3 * frequency(shortest_x, shortest_y) / frequency_bound() - 1),
       4e-15 + std::pow(std::numeric_limits<double>::epsilon() * std::max(spacing_x_, spacing_y_) / layer_height(), 2),
       "18 ulp for as many roundings; the law is stationary there in 1/T, which is 0 to a rounding of pi h1/h3"},
      {"long waves: omega = k sqrt(g H)",
       std::abs(phase_speed(0.6 * longest, 0.8 * longest) / std::sqrt(gravity_ * depth_) - 1), 4e-15,
       "18 ulp for as many roundings; the next term of the law is 1e-18"}};
}

}  // namespace seiche::exact
