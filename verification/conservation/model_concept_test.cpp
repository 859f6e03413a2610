// One interface for all models: moving frames, a basis instead of multipliers.
#include <cmath>

#include <Eigen/Dense>

#include "seiche/mechanics/start.hpp"
#include "seiche/samples.hpp"
#include "validation/instruments/mechanics/rigid_chain.hpp"
#include "verification/check.hpp"
#include "verification/conservation/differences.hpp"

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
    turn(v, [&](std::size_t k) { return angle(from, k); });
    chain_.advance(from, v, h, to);
  }
  void enter(Input q, Output u) const {
    turn(u, [&](std::size_t k) { return angle(q, k) - angle_[k]; });
  }
  void settle(Interval, Output q, Output u) const {
    turn(u, [&](std::size_t k) { return angle_[k] - angle(q, k); });
  }
  /// Between Cartesian rates and those of the axes at q.
  void to_axes(Input q, Output u) const {
    turn(u, [&](std::size_t k) { return -angle(q, k); });
  }

 private:
  static double angle(Input q, std::size_t k) { return std::sin(q[3 * k] + 2 * q[3 * k + 2]); }
  template <class By>
  static void turn(Output u, const By& by) {
    for (std::size_t k = 0; k < u.size() / 3; ++k) {
      const double c = std::cos(by(k)), s = std::sin(by(k)), p = u[3 * k], r = u[3 * k + 1];
      u[3 * k] = c * p - s * r;
      u[3 * k + 1] = s * p + c * r;
    }
  }
  [[nodiscard]] std::vector<double> cartesian(Input u) const {
    std::vector<double> v(u.begin(), u.end());
    turn(v, [&](std::size_t k) { return angle_[k]; });
    return v;
  }
  template <class Action>
  void in_cartesian(Output u, const Action& action) const {
    turn(u, [&](std::size_t k) { return angle_[k]; });
    action(u);
    turn(u, [&](std::size_t k) { return -angle_[k]; });
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
    std::vector<double> unit(rates(), 0.0), column(chain_.constraints());
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

static_assert(ConstrainedModel<RigidChain> && HasMultipliers<RigidChain> && HasDiscreteGradients<RigidChain>);
static_assert(ConstrainedModel<TurnedChain> && !HasCurvature<TurnedChain>);
static_assert(ConstrainedModel<BasisChain> && !HasMultipliers<BasisChain> && ProjectsItself<BasisChain>);

RigidChain heavy_chain() {
  return RigidChain({.masses = alternating_masses(4), .pinned = true, .gravity = 1});
}

template <class Model>
double distance_after(Model& model, State state) {
  auto chain = heavy_chain();
  State expected = spiral_start(chain);
  OneStep<RigidChain> reference(chain);
  OneStep<Model> scheme(model);
  Worst largest;
  for (int n = 0; n < 100; ++n) {
    reference.step(expected, 0.01);
    scheme.step(state, 0.01);
    largest.add(largest_difference(state.q, expected.q));
  }
  return largest.value();
}

TEST_CASE("one step for turned axes and for a basis", "[conservation]") {
  Check check("mechanics_one_interface", "One step for all models",
              "The pinned chain in Cartesian rates with multipliers, against the same chain with rates along axes that "
              "turn with the position, and against projection on a basis without multipliers: the same motion.",
              source);
  auto chain = heavy_chain();
  const State start = spiral_start(chain);
  const Roundoff same{100 * 12.0, 4, "100 steps, in each about 12 roundings of a coordinate up to 4"};
  TurnedChain turned(heavy_chain());
  State in_axes = start;
  turned.to_axes(in_axes.q, in_axes.u);
  check.at("tau = 0.01, 100 steps");
  check.that("axes", "Rates along axes that turn with the position give the same motion.",
             "largest difference of a coordinate", {distance_after(turned, in_axes)}, same);
  BasisChain basis(heavy_chain(), alternating_masses(4));
  CHECK_THROWS_WITH(OneStep<BasisChain>(basis, {.drift_feedback = true}), Catch::Contains("constraint_values"));
  check.that("basis", "Projection on a basis gives the same motion as multipliers.",
             "largest difference of a coordinate", {distance_after(basis, start)}, same);
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
