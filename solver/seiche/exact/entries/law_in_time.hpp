/// A discrete dispersion law in space, then in time: what the entries of such laws share.
#pragma once

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "seiche/exact/entries/entry_parts.hpp"
#include "seiche/exact/frank_dispersion.hpp"

namespace seiche::exact {

template <ReferenceSolution Law>
class LawInTime {
 public:
  /// @param values  of "wavelength", "time_step" and "scheme"
  LawInTime(const Law& law, const Values& values)
      : law_(law),
        time_step_(values.at("time_step")),
        scheme_(values.at("scheme") == 0 ? TimeScheme::one_step : TimeScheme::conservative),
        wavenumber_(2 * std::numbers::pi / values.at("wavelength")) {}

  /// omega and omega/k; of the wavelength where k is NaN.
  [[nodiscard]] Evaluator::Row row(double given) const {
    const double k = std::isnan(given) ? wavenumber_ : given;
    const double omega = law_.frequency(k);
    const double discrete = time_step_ > 0 ? discrete_frequency(omega, time_step_, scheme_) : omega;
    return {discrete, discrete / k};
  }

  static Provenance provenance() { return Law::provenance(); }
  [[nodiscard]] double uncertainty() const { return law_.uncertainty(); }
  [[nodiscard]] SelfTest self_test() const { return law_.self_test(); }

 private:
  Law law_;
  double time_step_;
  TimeScheme scheme_;
  double wavenumber_;
};

/// An entry for a law; `own` are the parameters after wavelength, depth and gravity.
template <ReferenceSolution Law>
ExactSolution law_in_time_entry(const std::string& name, const std::string& title, const std::vector<Parameter>& own,
                                std::function<Law(const Values&)> make) {
  std::vector<Parameter> parameters{wavelength_parameter(), depth_parameter(1, 1e6), gravity_parameter(1)};
  parameters.insert(parameters.end(), own.begin(), own.end());
  parameters.push_back({"time_step", "s", 0, 0, 1e6, "time step of the scheme; 0: continuous in time"});
  parameters.push_back({"scheme", "1", 0, 0, 1, "scheme in time", {"one_step", "conservative"}});
  return {
      .name = name,
      .title = title,
      .citation = Law::provenance().citation,
      .formula = Law::provenance().formula,
      .parameters = std::move(parameters),
      .inputs = {wavenumber_k},
      .outputs = {{"omega", "1/s", "angular frequency"}, {"phase_speed", "m/s", "omega/k"}},
      .scalars = {{"omega", "1/s", "angular frequency of the wavelength"}, {"phase_speed", "m/s", "its phase speed"}},
      .factory =
          [make = std::move(make)](const Values& values) {
            return evaluator_of(
                LawInTime<Law>(make(values), values),
                [](const LawInTime<Law>& law, std::span<const double> at) { return law.row(at[0]); },
                [](const LawInTime<Law>& law) { return law.row(std::numeric_limits<double>::quiet_NaN()); });
          },
  };
}

}  // namespace seiche::exact
