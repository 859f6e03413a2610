/// The law of a plan lattice for waves of one direction, as a function of |k|: what an entry of such a law evaluates.
#pragma once

#include <cmath>
#include <numbers>

#include "seiche/exact/entries/law_in_time.hpp"

namespace seiche::exact {

template <ReferenceSolution Law>
class DirectedLaw {
 public:
  /// @param values  of "direction" [degrees]
  DirectedLaw(const Law& law, const Values& values)
      : law_(law),
        cosine_(std::cos(values.at("direction") * std::numbers::pi / 180)),
        sine_(std::sin(values.at("direction") * std::numbers::pi / 180)) {}

  [[nodiscard]] double frequency(double k) const { return law_.frequency(k * cosine_, k * sine_); }

  static Provenance provenance() { return Law::provenance(); }
  [[nodiscard]] double uncertainty() const { return law_.uncertainty(); }
  [[nodiscard]] SelfTest self_test() const { return law_.self_test(); }

 private:
  Law law_;
  double cosine_;
  double sine_;
};

inline Parameter direction_parameter() {
  return {"direction", "degrees", 0, -180, 180, "of the wavenumber, from the x axis"};
}

}  // namespace seiche::exact
