/// A flow of free particles under Gauss's principle: particles and a space of fields, stepped by one of the two
/// schemes.
///
///     const exact::StokesWave wave(0.2, 2 * pi, pi, 1);
///     const LatticePlan plan{.cell_x = 2 * pi / 20, .left_wall = 0, .period = 2 * pi, .bottom = true,
///                            .ground = {.level = -pi}};
///     Flow flow(layer({.begin = 0, .end = 2 * pi, .columns = 120, .rows = 60,
///                      .surface = [&](double x) { return wave.elevation(x); },
///                      .bottom = [](double) { return -pi; }, .markers = 100}),
///               std::make_unique<SplineSpace>(plan),
///               [&](Point r) { const auto v = wave.velocity(r.x, r.y); return Point{v.u, v.v}; });
///     while (flow.time() < 20) flow.advance(0.06);
///
/// Throws std::invalid_argument for bad input, also for steps beyond the stability limit of waves of two cells' length,
/// and Divergence with time, step and place when a particle leaves the lattice, no cell is full, or a value is not
/// finite.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "seiche/mechanics/model_flow.hpp"
#include "seiche/mechanics/one_step.hpp"
#include "seiche/models/gauss_particles/model.hpp"
#include "seiche/samples.hpp"

// The integrators of the model, compiled once and not in every file that steps it.
extern template class seiche::mechanics::OneStep<seiche::gauss_particles::Model>;
extern template class seiche::mechanics::ProjectedStep<seiche::gauss_particles::Model>;
extern template class seiche::mechanics::Start<seiche::gauss_particles::Model>;
extern template class seiche::mechanics::InvariantsWatch<seiche::gauss_particles::Model>;

namespace seiche::gauss_particles {

/// conservative: reflections, second order, energy to round-off. dissipative: Frank's (21) to (23), first order.
enum class Stepping { conservative, dissipative };

class Flow : public mechanics::ModelFlow<Model> {
 public:
  /// @param velocity  at the beginning, of all particles: exact ones, not projected; empty for rest
  Flow(Particles particles, std::unique_ptr<FieldSpace> space, const mechanics::VelocityAt& velocity = {},
       Settings settings = {}, Forcing forcing = {}, Stepping stepping = Stepping::conservative);

  /// One step, 0 < tau <= 2/sqrt(pi g/h) with h the shortest length that the space resolves.
  void advance(double tau) override;

  /// Longest stable step with the lattice of the last step; infinite without gravity or without a lattice.
  [[nodiscard]] double stable_step() const;

  /// Places [m] and velocities [m/s] of all particles, markers too, in the order in which they were given.
  [[nodiscard]] std::span<const double> x() const { return Input(state_.q).first(model_->size()); }
  [[nodiscard]] std::span<const double> y() const { return Input(state_.q).last(model_->size()); }
  [[nodiscard]] std::span<const double> u() const { return Input(state_.u).first(model_->size()); }
  [[nodiscard]] std::span<const double> v() const { return Input(state_.u).last(model_->size()); }
  /// Places of the markers, in the order in which they were given.
  [[nodiscard]] std::vector<Point> markers() const;

  /// Most particles in free flight, over all steps.
  [[nodiscard]] double most_free_particles() const { return free_.value(); }

 private:
  Stepping stepping_;
  std::unique_ptr<mechanics::OneStep<Model>> one_step_;
  std::unique_ptr<mechanics::ProjectedStep<Model>> projected_step_;
  double booked_ = 0;
  Largest free_;
};

}  // namespace seiche::gauss_particles
