#include "seiche/exact/overturning_wave.hpp"

#include <limits>
#include <numbers>

#include "seiche/exact/entries/entries.hpp"
#include "seiche/exact/entries/entry_parts.hpp"

namespace seiche::exact {
namespace {

std::vector<Evaluator::Row> rows_of(const OverturningWave& wave, double t, std::size_t points) {
  const auto profile = points > 0 ? wave.profile(t, points) : wave.profile(t);
  std::vector<Evaluator::Row> rows;
  for (std::size_t j = 0; j < profile.x.size(); ++j) {
    rows.push_back({profile.x[j], profile.y[j], profile.potential[j], profile.u[j], profile.v[j]});
  }
  return rows;
}

double or_none(const std::optional<double>& value) {
  return value.value_or(std::numeric_limits<double>::quiet_NaN());
}

}  // namespace

ExactSolution overturning_wave_entry() {
  return {
      .name = "overturning_wave",
      .title = "A wave steepens, overturns and plunges: fully nonlinear potential flow up to touch-down",
      .citation = OverturningWave::provenance().citation,
      .formula = OverturningWave::provenance().formula,
      .parameters = {{"amplitude", "m", 0.5, 1e-9, 1e6, "half the height of the cosine it starts from"},
                     wavelength_parameter(),
                     depth_parameter(infinite, infinite),
                     gravity_parameter(1),
                     {"markers", "1", 512, 64, 4096, "markers per wavelength, even"},
                     {"last_time", "s", 0, 0, 1e9, "end of the computation; 0: one period of the linear wave"},
                     {"points", "1", 0, 0, 1e6, "points of a profile, at equal arc length; 0: at the markers"}},
      .inputs = {time_t},
      .outputs = {{"x", "m", "along the surface, in the surface's order"},
                  {"y", "m", "elevation there"},
                  {"phi", "m^2/s", "velocity potential"},
                  {"u", "m/s", "horizontal velocity"},
                  {"v", "m/s", "vertical velocity"}},
      .scalars = {{"vertical_tangent_time", "s", "when the front is first vertical; NaN if it is not"},
                  {"touch_down_time", "s", "when the jet meets the water below; NaN if it does not"},
                  {"end_time", "s", "last time computed"},
                  {"kinetic", "m^4/s^2", "kinetic energy per wavelength at the start, density 1"},
                  {"potential", "m^4/s^2", "potential energy per wavelength at the start, density 1"}},
      .factory =
          [](const Values& p) {
            const auto points = static_cast<std::size_t>(p.at("points"));
            auto kept = std::make_shared<const OverturningWave>(OverturningWave::Parameters{
                .amplitude = p.at("amplitude"),
                .wavelength = p.at("wavelength"),
                .depth = p.at("depth"),
                .gravity = p.at("gravity"),
                .markers = static_cast<std::size_t>(p.at("markers")),
                .last_time = p.at("last_time") > 0 ? std::optional(p.at("last_time")) : std::nullopt});
            return Evaluator{
                .eval = [kept, points](std::span<const double> at) { return rows_of(*kept, at[0], points).front(); },
                .scalars =
                    [kept] {
                      const auto start = kept->integrals(0);
                      return Evaluator::Row{or_none(kept->vertical_tangent_time()), or_none(kept->touch_down_time()),
                                            kept->end_time(), start.kinetic_energy, start.potential_energy};
                    },
                .curve = [kept, points](std::span<const double> at) { return rows_of(*kept, at[0], points); },
                .uncertainty = [kept] { return kept->uncertainty(); },
                .self_test = [kept] { return kept->self_test(); }};
          },
  };
}

}  // namespace seiche::exact
