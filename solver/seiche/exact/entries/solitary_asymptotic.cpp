#include "seiche/exact/solitary_asymptotic.hpp"

#include <memory>

#include "seiche/exact/entries/entries.hpp"
#include "seiche/exact/entries/entry_parts.hpp"

namespace seiche::exact {
namespace {

/// One of the theories, chosen when the program runs.
class Theory {
 public:
  Theory(int choice, double amplitude, double depth, double gravity) {
    switch (choice) {
      case 0:
        wave_ = std::make_shared<BoussinesqSolitary>(amplitude, depth, gravity);
        break;
      case 1:
        wave_ = std::make_shared<SerreSolitary>(amplitude, depth, gravity);
        break;
      case 2:
        wave_ = std::make_shared<LaitoneSolitary>(amplitude, depth, gravity);
        break;
      default:
        wave_ = std::make_shared<GrimshawSolitary>(amplitude, depth, gravity);
    }
  }

  [[nodiscard]] const AsymptoticSolitary& wave() const { return *wave_; }

  static Provenance provenance() {
    std::string citation;
    std::string formula;
    for (const Provenance& one : {BoussinesqSolitary::provenance(), SerreSolitary::provenance(),
                                  LaitoneSolitary::provenance(), GrimshawSolitary::provenance()}) {
      citation += (citation.empty() ? "" : "; ") + one.citation;
      formula += (formula.empty() ? "" : "; ") + one.formula;
    }
    return {citation, formula};
  }
  [[nodiscard]] double uncertainty() const { return wave_->uncertainty(); }
  [[nodiscard]] SelfTest self_test() const { return wave_->self_test(); }

 private:
  std::shared_ptr<const AsymptoticSolitary> wave_;
};

}  // namespace

ExactSolution solitary_asymptotic_entry() {
  return {
      .name = "solitary_asymptotic",
      .title = "Solitary waves as series in the amplitude: Boussinesq, Rayleigh, Laitone, Grimshaw",
      .citation = Theory::provenance().citation,
      .formula = Theory::provenance().formula,
      .parameters = {{"theory", "1", 3, 0, 3, "whose series", {"boussinesq", "rayleigh", "laitone", "grimshaw"}},
                     {"amplitude", "m", 0.3, 1e-9, 1e6, "crest above still water, up to 0.8332 depth"},
                     depth_parameter(1, 1e6),
                     gravity_parameter(1)},
      .inputs = {position_x, time_t},
      .outputs = {{"eta", "m", "surface elevation"}, {"u", "m/s", "horizontal velocity, mean over the depth"}},
      .scalars = {{"speed", "m/s", "phase speed"}, {"mass", "m^2", "int eta dx"}},
      .factory =
          [](const Values& p) {
            return evaluator_of(
                Theory(static_cast<int>(p.at("theory")), p.at("amplitude"), p.at("depth"), p.at("gravity")),
                [](const Theory& theory, std::span<const double> at) {
                  const double x = at[0] - theory.wave().speed() * at[1];
                  return Evaluator::Row{theory.wave().elevation(x), theory.wave().depth_averaged_velocity(x)};
                },
                [](const Theory& theory) {
                  return Evaluator::Row{theory.wave().speed(), theory.wave().area()};
                });
          },
  };
}

}  // namespace seiche::exact
