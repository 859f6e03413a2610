// What a free body of particles in a plane keeps while neighbours change, and what is booked: one check for all models.
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "seiche/compensated_sum.hpp"
#include "seiche/models/dirichlet_mesh/flow.hpp"
#include "seiche/models/overlapping_particles/flow.hpp"
#include "seiche/models/variable_mass/flow.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"
#include "verification/conservation/mechanical_problem.hpp"
#include "verification/jittered_mesh.hpp"
#include "verification/noise.hpp"

namespace seiche::verification::free_body_test {

/// 153 nodes.
free_lagrangian::Mesh patch() {
  return jittered(free_lagrangian::free_patch(16, 8, {-1, -0.5}, {1, 0.5}), 0.2, 1);
}

/// 239 particles.
overlapping_particles::Particles disc() {
  return shaken(overlapping_particles::staggered_disc(1, 0.125), 0.0125, 1);
}

/// Some of a kind, or the check would show nothing of it.
void some(Check& check, const std::string& what, bool is, const std::string& how_much) {
  check.holds(what, {is ? 1.0 : 0.0}, Qualitative{how_much, "otherwise the balances would be trivial"});
}

void takes_energy(Check& check, const std::string& what, const auto& flow) {
  some(check, what + ": energy is taken", flow.stabilisation_loss() > 1e-6 * flow.energy(), "a millionth");
}

/// The flow at the end.
template <class Flow>
Flow kept(Check& check, const std::string& what, Flow flow, double tau, const std::vector<std::string>& invariants) {
  march(flow, 50 * tau, tau, [&] { flow.observe(); });
  const Roundoff rounded{static_cast<double>(flow.steps()), 1,
                         "one rounding per step of a sum of order 1; sums are compensated"};
  for (const std::string& name : invariants) {
    check.holds(what + ": " + name, {flow.ledger().largest_defect(name)}, rounded);
  }
  return flow;
}

const std::vector<std::string> all{"mass", "momentum", "angular_momentum", "energy"};

/// Cells less the polygon that their nodes enclose.
double area_defect(const dirichlet_mesh::Flow& flow) {
  std::vector<double> drift(flow.model().constraints());
  flow.model().constraint_values(flow.state().q, drift);
  CompensatedSum area;
  for (std::size_t k = 0; k < drift.size(); ++k) area.add(drift[k] + flow.model().masses()[k]);
  const auto nodes = flow.model().triangulation().nodes();
  const auto outline = flow.model().outline();
  for (std::size_t e = 0; e < outline.size(); ++e) {
    const Point a = nodes[outline[e]], b = nodes[outline[(e + 1) % outline.size()]];
    area.add(-0.5 * (a.x * b.y - a.y * b.x));
  }
  return area.value();
}

TEST_CASE("free bodies of particles conserve mass, momenta and energy while neighbours change", "[conservation]") {
  Check check("free_bodies", "Free bodies of particles: invariants",
              "A disc of 239 overlapping particles, and a rectangle of 153 Dirichlet cells and of particles of "
              "variable mass, drawn to the centroids of their cells at the rate 1; no gravity, sheared, turned and "
              "bent by their first velocity, 50 steps over some twenty flips. Energy is conserved without "
              "stabilisation; with it, and with the feedback of the drift, the energy they remove is recorded to "
              "round-off. Variable masses do not conserve angular momentum: exchanged water leaves one node and "
              "arrives at another. Areas of cells are not conserved; their sum remains the polygon's area.");
  using overlapping_particles::Shape;
  for (const auto& [name, settings] :
       {std::pair{std::string("Overlapping particles, smoothed"), overlapping_particles::Settings{}},
        {"Overlapping balls", {.shape = Shape::ball, .support = 1.6}},
        {"Overlapping particles, stabilised", {.stabilisation = 0.1}}}) {
    const auto flow = kept(check, name, overlapping_particles::Flow(disc(), stirring, settings), 0.02, all);
    if (settings.stabilisation > 0) takes_energy(check, name, flow);
  }
  for (const auto& [name, stabilisation, feedback] : {std::tuple{std::string(""), 0.0, 0.0},
                                                      {", stabilised", 0.1, 0.0},
                                                      {", stabilised, drift fed back", 0.1, 0.2}}) {
    const free_lagrangian::Settings settings{.gravity = 0, .stabilisation = stabilisation};
    const std::string cells = "Dirichlet cells" + name, masses = "Variable masses" + name;
    const auto of_cells = kept(check, cells, dirichlet_mesh::Flow(patch(), stirring, settings, feedback), 0.012, all);
    check.holds(cells + ": areas together", {area_defect(of_cells)},
                Roundoff{2 * 306.0, 1, "two sums over 306 coordinates, of order 1 at most"});
    variable_mass::Flow start(patch(), {.velocity = stirring}, {variable_mass::ControlKind::centroid, 1, 0}, settings,
                              feedback);
    const std::vector<double> first(start.masses().begin(), start.masses().end());
    const auto of_masses = kept(check, masses, std::move(start), 0.012, {"mass", "momentum", "energy"});
    Worst change;
    for (std::size_t k = 0; k < first.size(); ++k) change.add(of_masses.masses()[k] / first[k] - 1);
    some(check, masses + ": masses change", change.value() > 0.1, "one by more than a tenth");
    if (stabilisation == 0) {
      some(check, cells + ": edges are flipped", of_cells.flips() >= 20, "at least 20 flips");
      some(check, masses + ": edges are flipped", of_masses.flips() >= 10, "at least 10 flips");
    } else {
      takes_energy(check, cells, of_cells);
      takes_energy(check, masses, of_masses);
    }
  }
}

}  // namespace seiche::verification::free_body_test
