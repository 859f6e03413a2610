#include "seiche/exact/frank_dispersion.hpp"

#include <numbers>

#include "seiche/exact/entries/entries.hpp"
#include "seiche/exact/entries/entry_parts.hpp"

namespace seiche::exact {
namespace {

/// The law in space, then in time.
class Law {
 public:
  Law(const FrankDispersion& law, double time_step, TimeScheme scheme, double wavenumber)
      : law_(law), time_step_(time_step), scheme_(scheme), wavenumber_(wavenumber) {}

  [[nodiscard]] Evaluator::Row row(double given) const {
    const double k = std::isnan(given) ? wavenumber_ : given;
    const double omega = law_.frequency(k);
    const double discrete = time_step_ > 0 ? discrete_frequency(omega, time_step_, scheme_) : omega;
    return {discrete, discrete / k};
  }

  static Provenance provenance() { return FrankDispersion::provenance(); }
  [[nodiscard]] double uncertainty() const { return law_.uncertainty(); }
  [[nodiscard]] SelfTest self_test() const { return law_.self_test(); }

 private:
  FrankDispersion law_;
  double time_step_;
  TimeScheme scheme_;
  double wavenumber_;
};

}  // namespace

ExactSolution frank_dispersion_entry() {
  return {
      .name = "frank_dispersion",
      .title = "Dispersion of Frank's discrete dispersive shallow water, formula (13), and with a time step",
      .citation = Law::provenance().citation,
      .formula = Law::provenance().formula,
      .parameters = {wavelength_parameter(),
                     depth_parameter(1, 1e6),
                     gravity_parameter(1),
                     {"spacing", "m", 0.1, 1e-9, 1e6, "distance of the markers"},
                     {"alpha", "1", 1.0 / 3, 0, 10, "factor of the vertical kinetic energy"},
                     {"beta", "1", 1.0 / 3, -10, 10, "factor of the potential energy of a cell's slope"},
                     {"gamma", "1", 0, -10, 10, "factor of an added potential energy of slopes"},
                     {"time_step", "s", 0, 0, 1e6, "time step of the scheme; 0: continuous in time"},
                     {"scheme", "1", 0, 0, 1, "scheme in time", {"one_step", "conservative"}}},
      .inputs = {wavenumber_k},
      .outputs = {{"omega", "1/s", "angular frequency"}, {"phase_speed", "m/s", "omega/k"}},
      .scalars = {{"omega", "1/s", "angular frequency of the wavelength"}, {"phase_speed", "m/s", "its phase speed"}},
      .factory =
          [](const Values& p) {
            const FrankDispersion law(p.at("gravity"), p.at("depth"), p.at("spacing"),
                                      {.alpha = p.at("alpha"), .beta = p.at("beta"), .gamma = p.at("gamma")});
            return evaluator_of(
                Law(law, p.at("time_step"), p.at("scheme") == 0 ? TimeScheme::one_step : TimeScheme::conservative,
                    2 * std::numbers::pi / p.at("wavelength")),
                [](const Law& both, std::span<const double> at) { return both.row(at[0]); },
                [](const Law& both) { return both.row(std::numeric_limits<double>::quiet_NaN()); });
          },
  };
}

}  // namespace seiche::exact
