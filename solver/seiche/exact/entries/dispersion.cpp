#include "seiche/exact/dispersion.hpp"

#include <numbers>
#include <variant>

#include "seiche/exact/entries/entries.hpp"
#include "seiche/exact/entries/entry_parts.hpp"

namespace seiche::exact {
namespace {

/// Any of the continuous laws behind one face.
class Law {
 public:
  Law(std::variant<AiryDispersion, RationalDispersion> law, double wavenumber) : law_(law), wavenumber_(wavenumber) {}

  [[nodiscard]] Evaluator::Row row(double k) const {
    return std::visit(
        [k](const auto& law) {
          return Evaluator::Row{law.frequency(k), law.phase_speed(k), law.group_speed(k)};
        },
        law_);
  }
  [[nodiscard]] double wavenumber() const { return wavenumber_; }

  static Provenance provenance() {
    return {AiryDispersion::provenance().citation + "; " + RationalDispersion::provenance().citation,
            AiryDispersion::provenance().formula + "; " + RationalDispersion::provenance().formula};
  }
  [[nodiscard]] double uncertainty() const {
    return std::visit([](const auto& law) { return law.uncertainty(); }, law_);
  }
  [[nodiscard]] SelfTest self_test() const {
    return std::visit([](const auto& law) { return law.self_test(); }, law_);
  }

 private:
  std::variant<AiryDispersion, RationalDispersion> law_;
  double wavenumber_;
};

Law law_from(const Values& p) {
  const double k = 2 * std::numbers::pi / p.at("wavelength");
  const double g = p.at("gravity");
  const double depth = p.at("depth");
  switch (static_cast<int>(p.at("law"))) {
    case 0:
      return {AiryDispersion(g, depth), k};
    case 1:
      return {RationalDispersion::green_naghdi(g, depth, p.at("alpha")), k};
    case 2:
      return {RationalDispersion::nwogu(g, depth, p.at("nwogu_a")), k};
    default:
      return {RationalDispersion::madsen_sorensen(g, depth, p.at("madsen_b")), k};
  }
}

}  // namespace

ExactSolution dispersion_entry() {
  return {
      .name = "dispersion",
      .title = "Linear dispersion laws of water waves and of Boussinesq-type models",
      .citation = Law::provenance().citation,
      .formula = Law::provenance().formula,
      .parameters = {{"law", "1", 0, 0, 3, "whose law", {"airy", "green_naghdi", "nwogu", "madsen_sorensen"}},
                     wavelength_parameter(),
                     depth_parameter(1, infinite),
                     gravity_parameter(1),
                     {"alpha", "1", 1.0 / 3, 1e-6, 10, "Green-Naghdi: factor of the vertical kinetic energy"},
                     {"nwogu_a", "1", -0.39, -0.5, -1.0 / 3, "Nwogu: z (z/2 + 1) of the reference level"},
                     {"madsen_b", "1", 1.0 / 15, 0, 10, "Madsen-Sorensen: coefficient B"}},
      .inputs = {wavenumber_k},
      .outputs = {{"omega", "1/s", "angular frequency"},
                  {"phase_speed", "m/s", "omega/k"},
                  {"group_speed", "m/s", "d omega/d k"}},
      .scalars = {{"omega", "1/s", "angular frequency of the wavelength"},
                  {"phase_speed", "m/s", "its phase speed"},
                  {"group_speed", "m/s", "its group speed"}},
      .factory =
          [](const Values& p) {
            return evaluator_of(
                law_from(p),
                [](const Law& law, std::span<const double> at) {
                  return law.row(std::isnan(at[0]) ? law.wavenumber() : at[0]);
                },
                [](const Law& law) { return law.row(law.wavenumber()); });
          },
  };
}

}  // namespace seiche::exact
