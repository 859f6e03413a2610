#include "seiche/exact/affine_ellipsoid.hpp"

#include "seiche/exact/entries/entries.hpp"
#include "seiche/exact/entries/entry_parts.hpp"

namespace seiche::exact {

ExactSolution affine_ellipsoid_entry() {
  const auto entry = [](const std::string& name, double value, const std::string& meaning) {
    return Parameter{name, "1/s", value, -1e6, 1e6, meaning + " at t = 0"};
  };
  return {
      .name = "affine_ellipsoid",
      .title = "A liquid ball without gravity becomes a turning ellipsoid",
      .citation = AffineEllipsoid::provenance().citation,
      .formula = AffineEllipsoid::provenance().formula,
      .parameters = {entry("xx", 0.8, "du/dx"),
                     entry("xy", -0.3, "du/dy"),
                     entry("xz", 0.1, "du/dz"),
                     entry("yx", 0.4, "dv/dx"),
                     entry("yy", -0.2, "dv/dy; dw/dz = -du/dx - dv/dy"),
                     entry("yz", -0.2, "dv/dz"),
                     entry("zx", 0.2, "dw/dx"),
                     entry("zy", 0.1, "dw/dy"),
                     {"radius", "m", 1, 1e-9, 1e6, "of the ball at t = 0"}},
      .inputs = {time_t},
      .outputs = {{"a", "m", "largest semi-axis"},
                  {"b", "m", "middle semi-axis"},
                  {"c", "m", "smallest semi-axis"},
                  {"p", "m^2/s^2", "pressure over density at the centre"}},
      .scalars = {{"p0", "m^2/s^2", "pressure over density at the centre of the ball"}},
      .factory =
          [](const Values& p) {
            Eigen::Matrix3d gradient;
            gradient << p.at("xx"), p.at("xy"), p.at("xz"), p.at("yx"), p.at("yy"), p.at("yz"), p.at("zx"), p.at("zy"),
                -p.at("xx") - p.at("yy");
            return evaluator_of(
                AffineEllipsoid(gradient, p.at("radius")),
                [](const AffineEllipsoid& drop, std::span<const double> at) {
                  const AffineEllipsoid::Instant instant = drop.at(at[0]);
                  const Eigen::Vector3d axes = drop.semi_axes(instant);
                  return Evaluator::Row{axes.x(), axes.y(), axes.z(), instant.central_pressure};
                },
                [](const AffineEllipsoid& drop) { return Evaluator::Row{drop.at(0).central_pressure}; });
          },
  };
}

}  // namespace seiche::exact
