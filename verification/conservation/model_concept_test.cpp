// One interface for all models: moving frames, a basis instead of multipliers, constraints that come and go.
#include <cmath>

#include <Eigen/Dense>

#include "seiche/mechanics/start.hpp"
#include "seiche/samples.hpp"
#include "validation/instruments/mechanics/rigid_chain.hpp"
#include "verification/check.hpp"

namespace seiche::verification::model_concept_test {

using namespace mechanics;
using namespace rigid_chain;

const std::string source = "Frank, Discrete models of incompressible fluid (1994), chapters 1, 3, 5, 6";

/// The chain with the horizontal rates of each mass along axes turned by an angle that depends on where the mass is,
/// as bottom tangents do.
class TurnedChain {
 public:
  explicit TurnedChain(RigidChain chain) : chain_(std::move(chain)), angle_(chain_.coordinates() / 3) {}
  [[nodiscard]] std::size_t coordinates() const { return chain_.coordinates(); }
  [[nodiscard]] std::size_t rates() const { return chain_.rates(); }
  [[nodiscard]] std::size_t constraints() const { return chain_.constraints(); }
  void linearise(Interval when, Input q) {
    chain_.linearise(when, q);
    for (std::size_t k = 0; k < angle_.size(); ++k) angle_[k] = angle(q, k);
  }
  void kick(double h, Output u) const {
    in_cartesian(u, [&](Output v) { chain_.kick(h, v); });
  }
  void react(Input mu, Output u) const {
    in_cartesian(u, [&](Output v) { chain_.react(mu, v); });
  }
  void constraint_rates(Input u, Output w) const { chain_.constraint_rates(cartesian(u), w); }
  void solve(Input right_hand_side, Output mu) { chain_.solve(right_hand_side, mu); }
  void advance(Input from, Input u, double h, Output to) const { chain_.advance(from, cartesian(u), h, to); }
  void predict(Input from, Input u, double h, Output to) const {
    std::vector<double> v(u.begin(), u.end());
    for (std::size_t k = 0; k < angle_.size(); ++k) turn(v, k, angle(from, k));
    chain_.advance(from, v, h, to);
  }
  void enter(Input q, Output u) const {
    for (std::size_t k = 0; k < angle_.size(); ++k) turn(u, k, angle(q, k) - angle_[k]);
  }
  void settle(Interval, Output q, Output u) const {
    for (std::size_t k = 0; k < angle_.size(); ++k) turn(u, k, angle_[k] - angle(q, k));
  }
  /// Between Cartesian rates and those of the axes at q.
  void to_axes(Input q, Output u) const {
    for (std::size_t k = 0; k < angle_.size(); ++k) turn(u, k, -angle(q, k));
  }

 private:
  static double angle(Input q, std::size_t k) { return std::sin(q[3 * k] + 2 * q[3 * k + 2]); }
  static void turn(Output u, std::size_t k, double by) {
    const double c = std::cos(by);
    const double s = std::sin(by);
    const double p = u[3 * k];
    const double r = u[3 * k + 1];
    u[3 * k] = c * p - s * r;
    u[3 * k + 1] = s * p + c * r;
  }
  [[nodiscard]] std::vector<double> cartesian(Input u) const {
    std::vector<double> v(u.begin(), u.end());
    for (std::size_t k = 0; k < angle_.size(); ++k) turn(v, k, angle_[k]);
    return v;
  }
  template <class Action>
  void in_cartesian(Output u, const Action& action) const {
    for (std::size_t k = 0; k < angle_.size(); ++k) turn(u, k, angle_[k]);
    action(u);
    for (std::size_t k = 0; k < angle_.size(); ++k) turn(u, k, -angle_[k]);
  }

  RigidChain chain_;
  std::vector<double> angle_;
};

/// The chain without multipliers: u~ = Phi c, (Phi^T M Phi) c = Phi^T M u*, the columns of Phi a basis of J u = 0.
class BasisChain {
 public:
  BasisChain(RigidChain chain, const std::vector<double>& masses)
      : chain_(std::move(chain)), mass_(static_cast<Eigen::Index>(3 * masses.size())) {
    for (Eigen::Index i = 0; i < mass_.size(); ++i) mass_[i] = masses[static_cast<std::size_t>(i / 3)];
  }
  [[nodiscard]] std::size_t coordinates() const { return chain_.coordinates(); }
  [[nodiscard]] std::size_t rates() const { return chain_.rates(); }
  void linearise(Interval when, Input q) {
    chain_.linearise(when, q);
    Eigen::MatrixXd j(static_cast<Eigen::Index>(chain_.constraints()), mass_.size());
    std::vector<double> unit(rates(), 0.0);
    std::vector<double> column(chain_.constraints());
    for (std::size_t i = 0; i < rates(); ++i) {
      unit[i] = 1;
      chain_.constraint_rates(unit, column);
      unit[i] = 0;
      j.col(static_cast<Eigen::Index>(i)) = Eigen::Map<const Eigen::VectorXd>(column.data(), j.rows());
    }
    basis_ = j.fullPivLu().kernel();
    gram_.compute(basis_.transpose() * mass_.asDiagonal() * basis_);
  }
  void kick(double h, Output u) const { chain_.kick(h, u); }
  void advance(Input from, Input u, double h, Output to) const { chain_.advance(from, u, h, to); }
  void project(Output u, Input, Output) {
    Eigen::Map<Eigen::VectorXd> rates(u.data(), static_cast<Eigen::Index>(u.size()));
    const Eigen::VectorXd right_hand_side = basis_.transpose() * mass_.cwiseProduct(rates);
    rates = basis_ * gram_.solve(right_hand_side);
  }

 private:
  RigidChain chain_;
  Eigen::VectorXd mass_;
  Eigen::MatrixXd basis_;
  Eigen::LLT<Eigen::MatrixXd> gram_;
};

/// Free masses of which other pairs are kept apart in each step, as neighbours change in free-Lagrangian models.
class ChangingLinks {
 public:
  explicit ChangingLinks(std::size_t masses) : masses_(masses) {}
  [[nodiscard]] std::size_t coordinates() const { return 3 * masses_; }
  [[nodiscard]] std::size_t rates() const { return 3 * masses_; }
  [[nodiscard]] std::size_t constraints() const { return pairs_.size(); }
  void linearise(Interval, Input q) {
    const std::size_t span = 1 + turn_ % 3;
    const std::size_t first = turn_ % 2;
    ++turn_;
    pairs_.clear();
    for (std::size_t a = first; a + span < masses_; a += 2 * span) pairs_.push_back({a, a + span, {}});
    for (Pair& pair : pairs_) {
      for (std::size_t c = 0; c < 3; ++c) pair.link[c] = q[3 * pair.b + c] - q[3 * pair.a + c];
    }
  }
  void kick(double, Output) const {}
  void advance(Input from, Input u, double h, Output to) const {
    for (std::size_t i = 0; i < u.size(); ++i) to[i] = from[i] + h * u[i];
  }
  void constraint_rates(Input u, Output w) const {
    for (std::size_t s = 0; s < pairs_.size(); ++s) {
      w[s] = 0;
      for (std::size_t c = 0; c < 3; ++c) w[s] += pairs_[s].link[c] * (u[3 * pairs_[s].b + c] - u[3 * pairs_[s].a + c]);
    }
  }
  void react(Input mu, Output u) const {
    for (std::size_t s = 0; s < pairs_.size(); ++s) {
      for (std::size_t c = 0; c < 3; ++c) {
        u[3 * pairs_[s].b + c] += mu[s] * pairs_[s].link[c];
        u[3 * pairs_[s].a + c] -= mu[s] * pairs_[s].link[c];
      }
    }
  }
  /// Pairs of one step share no mass: A is diagonal.
  void solve(Input right_hand_side, Output mu) const {
    for (std::size_t s = 0; s < pairs_.size(); ++s) {
      const auto& d = pairs_[s].link;
      mu[s] = right_hand_side[s] / (2 * (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]));
    }
  }
  [[nodiscard]] double kinetic_energy(Input, Input u) const {
    double sum = 0;
    for (const double rate : u) sum += rate * rate / 2;
    return sum;
  }
  [[nodiscard]] double potential_energy(Input) const { return 0; }
  [[nodiscard]] std::array<double, 3> momentum(Input, Input u) const {
    std::array<double, 3> sum{};
    for (std::size_t i = 0; i < u.size(); ++i) sum[i % 3] += u[i];
    return sum;
  }
  [[nodiscard]] std::array<double, 3> angular_momentum(Input q, Input u) const {
    std::array<double, 3> sum{};
    for (std::size_t k = 0; k < q.size(); k += 3) {
      for (std::size_t c = 0; c < 3; ++c) {
        sum[c] += q[k + (c + 1) % 3] * u[k + (c + 2) % 3] - q[k + (c + 2) % 3] * u[k + (c + 1) % 3];
      }
    }
    return sum;
  }

 private:
  struct Pair {
    std::size_t a, b;
    std::array<double, 3> link;
  };
  std::size_t masses_;
  std::vector<Pair> pairs_;
  std::size_t turn_ = 0;
};

static_assert(ConstrainedModel<RigidChain> && HasMultipliers<RigidChain> && HasDiscreteGradients<RigidChain>);
static_assert(ConstrainedModel<TurnedChain> && !HasCurvature<TurnedChain>);
static_assert(ConstrainedModel<BasisChain> && !HasMultipliers<BasisChain> && ProjectsItself<BasisChain>);
static_assert(ConstrainedModel<ChangingLinks> && !HasConstraintValues<ChangingLinks>);

RigidChain heavy_chain() {
  return RigidChain({.masses = alternating_masses(4), .pinned = true, .gravity = 1});
}

template <class Model>
double distance_after(Model& model, State state, int steps, double tau) {
  auto chain = heavy_chain();
  State expected = spiral_start(chain);
  OneStep<RigidChain> reference(chain);
  OneStep<Model> scheme(model);
  Worst largest;
  for (int n = 0; n < steps; ++n) {
    reference.step(expected, tau);
    scheme.step(state, tau);
    for (std::size_t i = 0; i < state.q.size(); ++i) largest.add(state.q[i] - expected.q[i]);
  }
  return largest.value();
}

TEST_CASE("one step for turned axes, for a basis, and for constraints that change", "[conservation]") {
  Check check("mechanics_one_interface", "One step for all models",
              "The pinned chain in Cartesian rates with multipliers, against the same chain with rates along axes that "
              "turn with the position, and against projection on a basis without multipliers: the same motion. Free "
              "masses, other pairs of which are kept apart in each step: energy and momenta are exact although the "
              "constraints are never the same.",
              source);
  auto chain = heavy_chain();
  const State start = spiral_start(chain);
  const Roundoff same{
      .operations = 100 * 12.0, .scale = 4, .reason = "100 steps, in each about 12 roundings of a coordinate up to 4"};
  TurnedChain turned(heavy_chain());
  State in_axes = start;
  turned.to_axes(in_axes.q, in_axes.u);
  check.that("axes", "Rates along axes that turn with the position give the same motion.",
             "largest difference of a coordinate",
             {.value = distance_after(turned, in_axes, 100, 0.01), .resolution = "tau = 0.01, 100 steps"}, same);
  BasisChain basis(heavy_chain(), alternating_masses(4));
  check.that("basis", "Projection on a basis gives the same motion as multipliers.",
             "largest difference of a coordinate",
             {.value = distance_after(basis, start, 100, 0.01), .resolution = "tau = 0.01, 100 steps"}, same);
  auto free = RigidChain({.masses = std::vector<double>(9, 1.0)});
  State state = spiral_start(free);
  ChangingLinks changing(9);
  OneStep<ChangingLinks> scheme(changing);
  InvariantsWatch watch(changing, state);
  Worst far;
  for (int n = 0; n < 10000; ++n) {
    scheme.step(state, 0.01);
    watch.record(state);
    for (const double x : state.q) far.add(x);
  }
  const double speed = std::sqrt(2 * changing.kinetic_energy(state.q, state.u));
  const std::string resolution = "tau = 0.01, 10000 steps";
  check.that("changing-energy", "Energy is exact with constraints that change from step to step.",
             "largest energy defect", {.value = watch.ledger().largest_defect("energy"), .resolution = resolution},
             Roundoff{10000, speed * speed / 2, "one rounded energy per step"});
  check.that("changing-momentum", "Momentum is exact with constraints that change from step to step.",
             "largest momentum defect", {.value = watch.ledger().largest_defect("momentum"), .resolution = resolution},
             Roundoff{10000, 3 * speed, "one rounded update of sum m|u| per step"});
  check.that(
      "changing-angular-momentum", "Angular momentum is exact with constraints that change from step to step.",
      "largest angular momentum defect",
      {.value = watch.ledger().largest_defect("angular_momentum"), .resolution = resolution},
      Roundoff{10000, 3 * speed * far.value(), "one rounded update of sum m|r||u| per step, at the largest distance"});
}

TEST_CASE("curvature by differences of J equals the Hessians of quadratic constraints", "[conservation]") {
  auto chain = heavy_chain();
  State state = spiral_start(chain);
  IndexReduced<RigidChain> exact(chain);
  const Input expected = exact.curvature(0, state.q, state.u, state.u);
  struct Plain : private RigidChain {
    using RigidChain::advance, RigidChain::constraint_rates, RigidChain::constraints, RigidChain::coordinates,
        RigidChain::kick, RigidChain::linearise, RigidChain::rates, RigidChain::react, RigidChain::RigidChain,
        RigidChain::solve;
  };
  static_assert(ConstrainedModel<Plain> && !HasCurvature<Plain>);
  Plain plain({.masses = alternating_masses(4), .pinned = true, .gravity = 1});
  IndexReduced<Plain> differences(plain);
  auto start = spiral_start(chain);
  const Input found = differences.curvature(0, start.q, start.u, start.u);
  for (std::size_t s = 0; s < found.size(); ++s) {
    // J is linear in q: only rounding, amplified by the division by a displacement of 6e-6.
    CHECK(std::abs(found[s] - expected[s]) < 4 * 2.3e-16 * 8 / 6e-6);
  }
}

}  // namespace seiche::verification::model_concept_test
