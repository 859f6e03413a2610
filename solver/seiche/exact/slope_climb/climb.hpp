/// The motion of water that climbs a slope: dz/dt = u + iv, dphi/dt = |grad phi|^2/2 - (y - 1), depth and gravity 1.
///
/// Nodes move with the water, by the pair of Dormand & Prince with steps of a tolerance; after each the highest
/// coefficients are filtered and the shore is put back on the slope. Over the first depths the water is held at rest.
#pragma once

#include <vector>

#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>

#include "seiche/exact/slope_climb/wedge_flow.hpp"

namespace seiche::exact::slope_climb {

class Climb {
 public:
  /// @param z  nodes from the far end to the shore;  @param phi  potential there, 0 at the far end
  Climb(double slope, const Eigen::VectorXcd& z, const Eigen::VectorXd& phi, double tolerance);

  /// One accepted step. Throws Divergence.
  void step();
  /// To before the last step(), and whatever came after it.
  void step_back();
  /// To a time within the next step, not before now.
  void step_to(double time);

  [[nodiscard]] double time() const { return time_; }
  [[nodiscard]] long steps() const { return steps_; }
  [[nodiscard]] double shore() const { return state_[2 * n_ - 1] - 1; }  ///< level above still water
  [[nodiscard]] double shore_speed();                                    ///< of that level
  /// T + V, V = int int y above still water less what is missing below; slope and bottom taken as they are.
  [[nodiscard]] double energy();
  /// Of the water, above that at rest.
  [[nodiscard]] double volume() const;

 private:
  using State = std::vector<double>;  ///< x, y and phi of all nodes
  void rate(const State& state, State& rate);
  void filter();
  void require_finite() const;
  [[nodiscard]] Eigen::VectorXcd nodes(const State& state) const;

  std::size_t n_;  ///< nodes
  double slope_;
  WedgeFlow flow_;
  State state_, before_;
  Eigen::VectorXd moved_;  ///< 1, and 0 where water is held at rest
  double time_ = 0;
  double time_before_ = 0;
  double duration_ = 0.01;
  long steps_ = 0;
  boost::numeric::odeint::controlled_runge_kutta<boost::numeric::odeint::runge_kutta_dopri5<State>> stepper_;
};

}  // namespace seiche::exact::slope_climb
