#include "seiche/models/shallow_water_particles/particle_flow.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "seiche/divergence.hpp"
#include "seiche/require.hpp"
#include "seiche/require_that.hpp"

namespace seiche::shallow_water_particles {

namespace {

constexpr double jump_fraction = 0.8;  // a jump may cross this part of a particle in one step

}  // namespace

ParticleFlow::ParticleFlow(Particles initial, Ends ends, Forcing forcing, Scheme scheme)
    : now_(std::move(initial)), ends_(std::move(ends)), forcing_(std::move(forcing)), scheme_(scheme) {
  validate();
  resize_work();
  jumps_.reserve(now_.size());
  structures_.reserve(now_.size());
  ledger_.initial_mass = mass();
  ledger_.initial_momentum = momentum();
  for (const bool right : {false, true}) {
    const Side s = side(right);
    open_width_[s.index()] = now_.width(s.particle(0));
    const double depth = now_.depth(s.particle(0));
    front_velocity_[s.index()] =
        s.outward() * now_.velocity[s.particle(0)] + 2 * shallow_water::celerity(forcing_.gravity, depth);
  }
  refresh();
  detect_jumps();
}

void ParticleFlow::validate() const {
  now_.validate();
  require_ranges(forcing_);
  require_ranges(scheme_);
  if (forcing_.bed) forcing_.bed->validate(now_.edge.front(), now_.edge.back());
  for (const bool right : {false, true}) {
    const Side s = side(right);
    if (const auto* piston = std::get_if<Piston>(&end(s))) {
      require_that(piston->velocity != nullptr, "piston: a velocity as a function of time must be given");
      require_finite("piston velocity", piston->velocity(0));
    }
    refuse_vacuum(s, 0);
  }
}

void ParticleFlow::refuse_vacuum(Side s, double at_time) const {
  const std::optional<double> wall = wall_velocity(s, at_time);
  if (!wall) return;
  const std::size_t i = s.particle(0);
  // A middle that is dry in the Riemann problem with the mirror image.
  const double escape = 2 * shallow_water::celerity(forcing_.gravity, now_.depth(i));
  const double parting = s.outward() * (*wall - now_.velocity[i]);
  if (parting < escape) return;
  // Later the mean of the end particle lags behind the water at the wall: only what leaves all of the water behind,
  // with more than u + 2 c anywhere, is a vacuum for certain.
  for (std::size_t k = 0; steps_ > 0 && k < now_.size(); ++k) {
    const double follows =
        s.outward() * now_.velocity[k] + 2 * shallow_water::celerity(forcing_.gravity, now_.depth(k));
    if (s.outward() * *wall < follows) return;
  }
  throw std::invalid_argument(
      fmt::format("{} velocity = {:g} leaves a vacuum at x = {:g}, t = {:g}: it parts with {:g} from particle {}, "
                  "whose velocity is "
                  "{:g}; allowed: less than 2 c = {:g}. Dry ground is an end of kind Vacuum",
                  end_is<Piston>(s) ? "piston" : "wall", *wall, now_.edge[s.edge(0)], at_time, parting, i,
                  now_.velocity[i], escape));
}

void ParticleFlow::resize_work() {
  const std::size_t count = now_.size();
  for (Array* a : {&inv_mass_, &depth_}) a->resize(count);
  edge_velocity_.resize(count + 1);
  edge_thrust_.resize(count + 1);
  if (keeps_edge_values()) values_.resize(count);
  for (std::size_t i = 0; i < count; ++i) inv_mass_[i] = 1 / now_.mass[i];
  if (forcing_.manning > 0) {
    old_velocity_.resize(count);
    old_inv_width_.resize(count);
  }
  if (forcing_.bed) {
    for (Array* a : {&surface_, &bed_mean_, &reaction_}) a->resize(count);
    for (Array* a : {&bed_edge_, &bed_area_}) a->resize(count + 1);
  }
}

void ParticleFlow::refresh(std::optional<RowLimits> known) {
  const std::size_t count = now_.size();
  const double* x = now_.edge.data();
  const double* u = now_.velocity.data();
  const RowLimits limits = known ? *known : measure(0, count);
  if (!limits.sound) {
    for (std::size_t i = 0; i < count; ++i) {
      if (!(now_.width(i) > 0)) {
        throw Divergence(fmt::format("width of particle {} is {:g}: its edges crossed", i, now_.width(i)), time(),
                         steps_, x[i]);
      }
      if (!std::isfinite(u[i])) {
        throw Divergence(fmt::format("velocity of particle {} is {}", i, u[i]), time(), steps_, x[i]);
      }
    }
  }
  celerity_rate_ = limits.celerity_rate;
  closing_rate_ = limits.closing_rate;

  if (forcing_.bed) {
    for (std::size_t k = 0; k <= count; ++k) {
      bed_edge_[k] = forcing_.bed->elevation(x[k]);
      bed_area_[k] = forcing_.bed->primitive(x[k]);
    }
    for (std::size_t i = 0; i < count; ++i) {
      bed_mean_[i] = (bed_area_[i + 1] - bed_area_[i]) * inv_width(i);
      surface_[i] = depth_[i] + bed_mean_[i];
    }
  }
  for (const bool right : {false, true}) {
    const Side s = side(right);
    if (!has_tip(s)) continue;
    const std::size_t end_particle = s.particle(0);
    const State mean = {depth_[end_particle], s.outward() * u[end_particle]};
    double& front = front_velocity_[s.index()];
    if (mean.velocity > front) front = mean.velocity + 2 * celerity(end_particle);
    tip_[s.index()] = tip_profile(forcing_.gravity, mean, front, depth_[s.particle(1)]);
  }
}

StepLimit ParticleFlow::step_limit(double courant, bool named) const {
  const std::size_t count = now_.size();
  StepLimit limit;
  const auto lower = [&](double tau, std::size_t particle, const char* reason) {
    if (tau < limit.tau) limit = {tau, particle, reason};
  };
  if (celerity_rate_ > 0) lower(courant / celerity_rate_, count, "celerity");
  // Stay clear of crossing by the same margin as jumps.
  if (closing_rate_ > 0) lower(jump_fraction / closing_rate_, count, "edges would cross");
  for (const bool right : {false, true}) {
    const Side s = side(right);
    const bool moves_freely = end_is<Free>(s) || end_is<Vacuum>(s);
    const std::size_t i = s.particle(0);
    const double inner = 0.5 * (now_.velocity[i] + now_.velocity[s.particle(1)]);  // of the other edge, about
    for (int visit = 0; visit < 2 && !moves_freely; ++visit) {
      // A piston's velocity counts now and at the middle of the step.
      const double end_velocity = wall_velocity(s, visit == 0 ? time() : time() + 0.5 * limit.tau).value_or(0);
      const double closing = s.outward() * (inner - end_velocity) * inv_width(i);
      if (closing > 0)
        lower(jump_fraction / closing, i, end_is<Piston>(s) ? "the piston would cross it" : "its end would cross it");
    }
  }
  for (const InteriorJump& jump : jumps_) {
    lower(jump_fraction * now_.mass[jump.particle] / jump.mass_flux, jump.particle, "jump in the particle");
  }
  for (const Collision& collision : collisions_) {
    for (std::size_t i = collision.left_particle(); i <= collision.right_particle(); ++i) {
      lower(jump_fraction * now_.mass[i] / collision.fastest_mass_flux(), i, "jump in the particle");
    }
  }
  if (!named || limit.particle != count) return limit;
  // Only rates are kept from step to step: look for the particle that has it, which was rounded in another order.
  constexpr double nearly = 1 - 1e-12;
  std::size_t& who = limit.particle = 0;
  if (limit.tau == courant / celerity_rate_) {
    while (who + 1 < count && celerity(who) * inv_width(who) < nearly * celerity_rate_) ++who;
  } else {
    const auto closing = [&](std::size_t i) { return (now_.velocity[i] - now_.velocity[i + 1]) * inv_width(i); };
    while (who + 2 < count && closing(who) < nearly * closing_rate_) ++who;
  }
  return limit;
}

void ParticleFlow::check_step(double tau) const {
  require_positive("tau", tau);
  StepLimit limit = step_limit(hard_courant, false);
  for (const bool right : {false, true}) refuse_vacuum(side(right), time() + 0.5 * tau);
  // One rounding error of slack: callers form steps as T/n.
  if (tau > limit.tau * (1 + 1e-12)) {
    if (limit.particle == now_.size()) limit = step_limit(hard_courant, true);
    throw std::invalid_argument(fmt::format("tau = {:g} must not exceed {:g} at t = {:g}: limited by particle {} ({})",
                                            tau, limit.tau, time(), limit.particle, limit.reason));
  }
}

void ParticleFlow::advance(double tau) {
  check_step(tau);
  largest_courant_ = std::max(largest_courant_, tau * celerity_rate_);

  solve_edges(tau);
  hand_over_jumps(tau);
  if (forcing_.bed) react_bed(tau);
  const std::optional<RowLimits> limits = apply(tau);

  for (Collision& collision : collisions_) collision.advance(tau, now_.mass);
  refresh(limits);  // throws with the time and step at which this step began
  time_.add(tau);
  ++steps_;
  for (const bool right : {false, true}) {
    if (end_is<Open>(side(right))) regulate(side(right));
  }
  detect_jumps();
}

double ParticleFlow::mean_energy() const {
  CompensatedSum sum;
  for (std::size_t i = 0; i < now_.size(); ++i) {
    const double bed = forcing_.bed ? bed_mean_[i] : 0.0;
    const double u = now_.velocity[i];
    sum.add(now_.mass[i] * (0.5 * u * u + forcing_.gravity * (0.5 * depth_[i] + bed)));
  }
  return sum.value();
}

double ParticleFlow::energy() const {
  CompensatedSum sum;
  sum.add(mean_energy());
  for (const Structure& s : structures_) {
    const auto specific = [&](State state) {
      return 0.5 * state.velocity * state.velocity + 0.5 * forcing_.gravity * state.depth;
    };
    double layered = 0;
    for (int k = 0; k < s.count; ++k) {
      const Layer& layer = s.layers[static_cast<std::size_t>(k)];
      layered += layer.mass_fraction * specific(layer.state);
    }
    sum.add(now_.mass[s.particle] * (layered - specific(state(s.particle))));
  }
  return sum.value();
}

double ParticleFlow::discharge(double x) const {
  const State at = reconstruction().at(x);
  return at.depth * at.velocity;
}

MeasuredProfile ParticleFlow::measured_profile() const {
  MeasuredProfile profile;
  profile.edges.assign(now_.edge.begin(), now_.edge.end());
  for (std::size_t i = 0; i < now_.size(); ++i) profile.means.push_back(state(i));
  const Reconstruction whole = reconstruction();
  for (const Piece& piece : whole.pieces()) profile.breaks.push_back(piece.left);
  profile.reconstruction = [whole](double x) { return whole.at(x); };
  return profile;
}

Reconstruction ParticleFlow::reconstruction() const {
  std::vector<Piece> pieces;
  pieces.reserve(now_.size() + 2 * structures_.size());
  for (std::size_t i = 0; i < now_.size(); ++i) {
    const double left = now_.edge[i];
    const double right = now_.edge[i + 1];
    const bool last = i + 1 == now_.size();
    const bool tip = (i == 0 && has_tip(side(false))) || (last && has_tip(side(true)));
    if (const Structure* s = structure_at(i)) {
      double start = left;
      for (int k = 0; k < s->count; ++k) {
        const Layer& layer = s->layers[static_cast<std::size_t>(k)];
        const double stop = k + 1 == s->count ? right : start + layer.mass_fraction * now_.mass[i] / layer.state.depth;
        if (!(stop > start)) continue;
        pieces.push_back({start, stop, layer.state.depth, layer.state.depth, layer.state.velocity, layer.state.velocity,
                          std::nullopt, true});
        start = stop;
      }
    } else if (tip) {
      pieces.push_back({left, right, 0, 0, 0, 0, tip_[last ? 1 : 0], last});
    } else {
      const EdgePair e = edges_of(i, 0);
      const double bed_left = forcing_.bed ? bed_edge_[i] : 0;
      const double bed_right = forcing_.bed ? bed_edge_[i + 1] : 0;
      pieces.push_back(
          {left, right, e.h_left + bed_left, e.h_right + bed_right, e.u_left, e.u_right, std::nullopt, true});
    }
  }
  return {forcing_.gravity, std::move(pieces), forcing_.bed};
}

}  // namespace seiche::shallow_water_particles
