#include "validation/studies/shallow_water/flow.hpp"
#include "validation/case/reference_case.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/models/shallow_water_finite_volume/finite_volume_flow.hpp"
#include "seiche/models/shallow_water_particles/particle_flow.hpp"
#include "seiche/models/shallow_water_particles/particles.hpp"
#include "seiche/require.hpp"
#include "seiche/samples.hpp"
#include "validation/instruments/particles/as_written.hpp"
#include "validation/instruments/processor_time.hpp"

namespace seiche::validation {
namespace {

namespace particles = shallow_water_particles;
namespace cells = shallow_water_finite_volume;

// ---- particles

/// The uniform stretches of the initial state that hold water, with the number of particles each gets: as many per
/// metre as over the whole channel, so that the same number means the same width for every scheme.
particles::Particles initial_particles(const FlowProblem& problem, const Discretisation& d) {
  std::vector<double> ends{problem.start};
  for (const double jump : problem.jumps) {
    if (jump > problem.start && jump < problem.end) ends.push_back(jump);
  }
  ends.push_back(problem.end);
  std::vector<particles::Stretch> stretches;
  double wet = 0;
  for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
    const State state = problem.exact(0.5 * (ends[k] + ends[k + 1]), 0);
    if (state.depth <= 0) continue;
    stretches.push_back({ends[k], ends[k + 1], state});
    wet += ends[k + 1] - ends[k];
  }
  if (stretches.empty()) throw std::invalid_argument("depth = 0 everywhere: at least one side must be positive");
  const long count = std::lround(static_cast<double>(d.particles) * wet / problem.length());
  return particles::uniform_stretches(stretches, static_cast<std::size_t>(std::max(1L, count)), d.equal_masses);
}

particles::Scheme particle_scheme(const Discretisation& d) {
  using enum particles::Level;
  return {.level = d.scheme == "G1"   ? godunov
                   : d.scheme == "M2" ? muscl
                                      : hand_over,
          .theta = d.theta,
          .courant = d.courant};
}

particles::End particle_end(FlowProblem::End kind, State at_start) {
  if (kind == FlowProblem::End::dry) return particles::Vacuum{};
  if (kind == FlowProblem::End::wall || at_start.velocity == 0) return particles::Wall{};
  return particles::Piston{[u = at_start.velocity](double) { return u; }};
}

particles::Ends particle_ends(const FlowProblem& problem) {
  return {.left = particle_end(problem.left, problem.exact(problem.start, 0)),
          .right = particle_end(problem.right, problem.exact(problem.end, 0))};
}

/// Of a method that has no curve of its own between edges. @param mean  state of cell i
template <class MeanOf>
Profile stepwise(const std::vector<double>& edges, MeanOf mean) {
  Profile profile;
  profile.edges = edges;
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) profile.means.push_back(mean(i));
  profile.reconstruction = [edges = profile.edges, means = profile.means](double x) {
    const auto above = std::upper_bound(edges.begin(), edges.end(), x) - edges.begin();
    return means[static_cast<std::size_t>(std::clamp<long>(above - 1, 0, static_cast<long>(means.size()) - 1))];
  };
  return profile;
}

// ---- cells

cells::Scheme cell_scheme(const std::string& name) {
  if (name == "lax_friedrichs") return cells::Scheme::lax_friedrichs;
  if (name == "maccormack") return cells::Scheme::mac_cormack;
  if (name == "roe") return cells::Scheme::roe;
  return cells::Scheme::muscl_hll;
}

cells::End cell_end(FlowProblem::End kind, State at_start) {
  if (kind == FlowProblem::End::wall) return cells::End::wall();
  if (kind == FlowProblem::End::dry) return cells::End::free();
  return cells::End::inflow(at_start);
}

/// The problem's initial state as an exact solution, with breakpoints at its jumps.
struct InitialState {
  const FlowProblem* problem;
  [[nodiscard]] State at(double x, double /*t*/) const { return problem->exact(x, 0); }
  [[nodiscard]] std::vector<double> breakpoints(double /*t*/) const {
    std::vector<double> breaks = problem->breakpoints(0);
    breaks.insert(breaks.end(), problem->jumps.begin(), problem->jumps.end());
    std::sort(breaks.begin(), breaks.end());
    return breaks;
  }
};

cells::FiniteVolumeFlow cell_flow(const FlowProblem& problem, const Discretisation& d) {
  const std::vector<double> edges =
      evenly(problem.start, problem.start + problem.length(), static_cast<int>(d.particles) + 1);
  std::vector<double> depth, discharge;
  for (const validation::CellMean& mean : validation::cell_averages(InitialState{&problem}, edges, 0)) {
    depth.push_back(mean.depth);
    discharge.push_back(mean.discharge);
  }
  cells::FiniteVolumeFlow::Settings settings;
  settings.scheme = cell_scheme(d.scheme);
  settings.gravity = problem.gravity;
  settings.theta = d.theta;
  settings.left = cell_end(problem.left, problem.exact(problem.start, 0));
  settings.right = cell_end(problem.right, problem.exact(problem.end, 0));
  return {settings, problem.start, problem.end, depth, discharge};
}

// ---- all

Profile profile_of(const particles::ParticleFlow& flow) {
  return flow.measured_profile();
}
Profile profile_of(const AsWritten& flow) {
  return stepwise(flow.edges(), [&](std::size_t i) { return State{flow.depth(i), flow.velocity(i)}; });
}
Profile profile_of(const cells::FiniteVolumeFlow& flow) {
  return stepwise(flow.edges(), [&](std::size_t i) { return State{flow.depth()[i], flow.velocity()[i]}; });
}

double largest_step_of(const particles::ParticleFlow& flow, double /*courant*/) {
  return flow.largest_step().tau;  // it knows its Courant number
}
double largest_step_of(const AsWritten& flow, double courant) {
  return courant * flow.shortest_crossing();
}
double largest_step_of(const cells::FiniteVolumeFlow& flow, double courant) {
  return courant / flow.courant_number(1);
}

template <class Model>
class FlowBy final : public Flow {
 public:
  FlowBy(Discretisation d, double gravity, Model model) : Flow(std::move(d), gravity), flow_(std::move(model)) {}

  [[nodiscard]] double time() const override { return flow_.time(); }
  [[nodiscard]] Profile profile() const override { return profile_of(flow_); }
  [[nodiscard]] double mass_defect() const override { return flow_.mass_defect(); }
  [[nodiscard]] double momentum_defect() const override { return flow_.momentum_defect(); }
  [[nodiscard]] double max_courant() const override { return flow_.largest_courant(); }

 private:
  void step(double tau) override { flow_.advance(tau); }
  [[nodiscard]] double largest_step(double courant) const override { return largest_step_of(flow_, courant); }

  Model flow_;
};

template <class Model>
std::unique_ptr<Flow> flow_by(Model model, const FlowProblem& problem, const Discretisation& d) {
  return std::make_unique<FlowBy<Model>>(d, problem.gravity, std::move(model));
}

}  // namespace

std::string Discretisation::text() const {
  const std::string step =
      time_step > 0 ? fmt::format("tau = {:g} s", time_step) : fmt::format("Courant number {:g}", courant);
  return fmt::format("{}, N = {}{}, {}", scheme, particles, equal_masses ? " of equal masses" : "", step);
}

void Flow::advance_to(double time, const std::function<void(double)>& after_step) {
  const double fixed = discretisation_.time_step;
  // A remainder below this share of a step is rounding of the times, not a step.
  constexpr double negligible = 1e-9;
  while (true) {
    const double remaining = time - this->time();
    const double wanted = fixed > 0 ? fixed : largest_step(discretisation_.courant);
    if (remaining <= negligible * wanted) break;
    const double begin = processor_seconds();
    step(remaining < wanted * (1 + negligible) ? remaining : wanted);
    seconds_ += processor_seconds() - begin;
    ++steps_;
    if (after_step) after_step(this->time());
  }
}

double Flow::momentum_scale() const {
  const Profile now = profile();
  double sum = 0;
  for (std::size_t i = 0; i < now.means.size(); ++i) {
    const State s = now.means[i];
    sum += s.depth * (now.edges[i + 1] - now.edges[i]) *
           (std::abs(s.velocity) + shallow_water::celerity(gravity_, std::max(0.0, s.depth)));
  }
  return sum;
}

std::unique_ptr<Flow> make_flow(const FlowProblem& problem, const Discretisation& d) {
  require_at_least("particles", d.particles, 4);
  require_not_negative("time_step", d.time_step);
  if (d.scheme == as_written) {
    return flow_by(AsWritten(initial_particles(problem, d), particle_ends(problem), problem.gravity), problem, d);
  }
  if (std::ranges::count(particle_schemes, d.scheme) > 0) {
    return flow_by(particles::ParticleFlow(initial_particles(problem, d), particle_ends(problem),
                                           {.gravity = problem.gravity, .bed = {}, .manning = 0, .body_force = {}},
                                           particle_scheme(d)),
                   problem, d);
  }
  if (std::ranges::count(peer_schemes, d.scheme) > 0) return flow_by(cell_flow(problem, d), problem, d);
  throw std::invalid_argument(fmt::format("scheme = {} is unknown", d.scheme));
}

}  // namespace seiche::validation
