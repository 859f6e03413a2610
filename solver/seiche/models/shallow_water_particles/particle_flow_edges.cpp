// Edges that are not plain, what acts besides thrusts, and how a step is applied.
#include <algorithm>
#include <cmath>

#include "seiche/models/shallow_water_particles/particle_flow.hpp"
#include "seiche/models/shallow_water_particles/reconstruction.hpp"

namespace seiche::shallow_water_particles {

std::optional<double> ParticleFlow::wall_velocity(Side s, double time) const {
  if (end_is<Wall>(s)) return 0.0;
  if (const auto* piston = std::get_if<Piston>(&end(s))) return piston->velocity(time);
  return std::nullopt;
}

bool ParticleFlow::has_tip(Side s) const {
  return end_is<Vacuum>(s) && !forcing_.bed && scheme_.level != Level::godunov;
}

ParticleFlow::Neighbour ParticleFlow::neighbour(std::size_t i, bool to_right) const {
  const double width = now_.width(i);
  const Side s = side(to_right);
  const double own = forcing_.bed ? surface_[i] : depth_[i];
  if (i == s.particle(0)) {
    // The mirror image of a wall lies one width away.
    if (const auto wall = wall_velocity(s, time())) return {own, 2 * *wall - now_.velocity[i], width, true};
    return {own, now_.velocity[i], width, false};
  }
  const std::size_t j = to_right ? i + 1 : i - 1;
  const double distance = 0.5 * (width + now_.width(j));
  if (const Structure* other = structure_at(j)) {
    const State near = to_right ? other->at_left() : other->at_right();
    return {near.depth, near.velocity, distance, true};
  }
  if (j == s.particle(0) && has_tip(s)) {
    const State near = tip_[s.index()].at(forcing_.gravity, 1);
    // A front particle can be very wide: its inner state belongs to the shared edge, half a width away.
    return {near.depth, s.outward() * near.velocity, 0.5 * width, true};
  }
  return {forcing_.bed ? surface_[j] : depth_[j], now_.velocity[j], distance, true};
}

ParticleFlow::Slopes ParticleFlow::slopes(std::size_t i) const {
  const Neighbour before = neighbour(i, false);
  const Neighbour after = neighbour(i, true);
  const double own = forcing_.bed ? surface_[i] : depth_[i];
  const double u = now_.velocity[i];
  if (before.known && after.known) {
    return {slope(before.surface, own, after.surface, before.distance, after.distance, scheme_.theta),
            slope(before.velocity, u, after.velocity, before.distance, after.distance, scheme_.theta)};
  }
  // At an open section and at a shoreline the one-sided slope continues; a Free end is uniform.
  const Side s = side(before.known);
  if (end_is<Free>(s)) return {0, 0};
  const Neighbour& inner = before.known ? before : after;
  const double inward = before.known ? 1.0 : -1.0;
  return {inward * (own - inner.surface) / inner.distance, inward * (u - inner.velocity) / inner.distance};
}

EdgePair ParticleFlow::edges_on_bed(std::size_t i, Slopes s) const {
  const double width = now_.width(i);
  double half = 0.5 * s.surface * width;
  const double left_most = surface_[i] - bed_edge_[i];
  const double right_most = surface_[i] - bed_edge_[i + 1];
  // A negative edge depth: tilt the surface until that edge is just dry.
  if (left_most - half < 0) half = left_most;
  if (right_most + half < 0) half = -right_most;
  const double least = 1e-10 * depth_[i];  // inner edges stay wet for the Riemann problem
  const bool dry_left = i == 0 && end_is<Vacuum>(side(false));
  const bool dry_right = i + 1 == now_.size() && end_is<Vacuum>(side(true));
  const double du = 0.5 * s.velocity * width;
  return {std::max(left_most - half, dry_left ? 0.0 : least), std::max(right_most + half, dry_right ? 0.0 : least),
          now_.velocity[i] - du, now_.velocity[i] + du};
}

double ParticleFlow::acceleration(std::size_t i, double at_time) const {
  double a = 0;
  if (forcing_.body_force) a += forcing_.body_force(now_.centre(i), at_time);
  if (forcing_.manning > 0) {
    const double u = now_.velocity[i];
    const double n = forcing_.manning;
    a -= forcing_.gravity * n * n * u * std::abs(u) / (depth_[i] * std::cbrt(depth_[i]));
  }
  return a;
}

EdgePair ParticleFlow::edges_of(std::size_t i, double half_step) const {
  const double h = depth_[i];
  const double u = now_.velocity[i];
  if (scheme_.level == Level::godunov && !forcing_.bed) return {h, h, u, u};
  if (const Structure* own = structure_at(i)) {
    const State left = own->at_left();
    const State right = own->at_right();
    return {left.depth, right.depth, left.velocity, right.velocity};
  }
  for (const bool right : {false, true}) {
    const Side s = side(right);
    if (i != s.particle(0) || !has_tip(s)) continue;
    // No prediction: the inner state of the profile is already the one that leaves along the simple wave.
    const State inner = tip_[s.index()].at(forcing_.gravity, 1);
    return {inner.depth, inner.depth, s.outward() * inner.velocity, s.outward() * inner.velocity};
  }
  const double width = now_.width(i);
  Slopes s = slopes(i);
  if (scheme_.level == Level::godunov) s = {0, 0};
  EdgePair now{};
  double a = half_step > 0 ? acceleration(i, time()) : 0;
  if (forcing_.bed) {
    now = edges_on_bed(i, s);
    // Thrusts and bed reaction of a linear surface add up to its slope; predict() adds the thrusts.
    const double surface_slope = ((now.h_right + bed_edge_[i + 1]) - (now.h_left + bed_edge_[i])) * inv_width(i);
    a -= forcing_.gravity * surface_slope +
         0.5 * forcing_.gravity * inv_mass_[i] * (now.h_left - now.h_right) * (now.h_left + now.h_right);
  } else {
    const double most = 0.9 * h;  // neither edge falls below a tenth of the mean depth
    const double dh = std::clamp(0.5 * s.surface * width, -most, most);
    const double du = 0.5 * s.velocity * width;
    now = {h - dh, h + dh, u - du, u + du};
  }
  EdgePair half =
      scheme_.level == Level::godunov ? now : predict(forcing_.gravity, now, width, inv_mass_[i], half_step, a);
  // A fixed section sees the water pass: undo the half step along the path of the edge.
  const double depth_slope = (now.h_right - now.h_left) * inv_width(i);
  if (i == 0 && end_is<Open>(side(false))) {
    half.h_left -= half_step * now.u_left * depth_slope;
    half.u_left -= half_step * now.u_left * s.velocity;
  }
  if (i + 1 == now_.size() && end_is<Open>(side(true))) {
    half.h_right -= half_step * now.u_right * depth_slope;
    half.u_right -= half_step * now.u_right * s.velocity;
  }
  return half;
}

void ParticleFlow::solve_end(Side s, double tau) {
  const double g = forcing_.gravity;
  const std::size_t i = s.particle(0);
  const std::size_t k = s.edge(0);
  const State inner = at_end_[s.index()];
  if (const auto wall = wall_velocity(s, time() + 0.5 * tau)) {
    const double out = s.outward() * inner.velocity;
    const double mirror = 2 * s.outward() * *wall - out;
    edge_velocity_[k] = *wall;
    edge_thrust_[k] = edge_state(g, inner.depth, out, inner.depth, mirror).thrust;
  } else if (end_is<Free>(s)) {
    edge_velocity_[k] = now_.velocity[i];
    edge_thrust_[k] = shallow_water::thrust(g, depth_[i]);
  } else if (end_is<Vacuum>(s)) {
    edge_velocity_[k] = has_tip(s) ? s.outward() * front_velocity_[s.index()]
                                   : inner.velocity + s.outward() * 2 * std::sqrt(g * inner.depth);
    edge_thrust_[k] = 0;
  } else {
    solve_open_end(s, std::get<Open>(end(s)), inner, tau);
  }
}

void ParticleFlow::hand_over_jumps(double tau) {
  for (const InteriorJump& jump : jumps_) {
    const std::size_t k = jump.facing == Facing::right ? jump.particle + 1 : jump.particle;
    hand_over(forcing_.gravity, jump, now_.mass[jump.particle], tau, edge_velocity_[k], edge_thrust_[k]);
  }
  for (const Collision& collision : collisions_) {
    for (std::size_t k = collision.left_particle(); k <= collision.right_particle() + 1; ++k) {
      const EdgeState e = collision.average(k, now_.mass, tau, {edge_velocity_[k], edge_thrust_[k]});
      edge_velocity_[k] = e.velocity;
      edge_thrust_[k] = e.thrust;
    }
  }
}

void ParticleFlow::react_bed(double tau) {
  const std::size_t count = now_.size();
  const double half_step = 0.5 * tau;
  // Geometry at mid-step.
  for (std::size_t k = 0; k <= count; ++k) {
    const double x = now_.edge[k] + half_step * edge_velocity_[k];
    bed_edge_[k] = forcing_.bed->elevation(x);
    bed_area_[k] = forcing_.bed->primitive(x);
  }
  for (std::size_t i = 0; i < count; ++i) {
    const double width = now_.width(i) + half_step * (edge_velocity_[i + 1] - edge_velocity_[i]);
    const double mean = (bed_area_[i + 1] - bed_area_[i]) / width;
    const double rise = bed_edge_[i + 1] - bed_edge_[i];
    const double h_left = values_.left_depth[i];
    const double h_right = values_.right_depth[i];
    const double surface_rise = (h_right + bed_edge_[i + 1]) - (h_left + bed_edge_[i]);
    // -int g h z_x dx of a linear surface, free of cancellation: exactly zero on a flat bed, exactly opposite to the
    // difference of the edge thrusts at rest.
    reaction_[i] = forcing_.gravity *
                   (surface_rise * (mean - 0.5 * (bed_edge_[i] + bed_edge_[i + 1])) - 0.5 * rise * (h_left + h_right));
  }
}

std::optional<RowLimits> ParticleFlow::apply(double tau) {
  std::optional<RowLimits> limits;
  const std::size_t count = now_.size();
  double* x = now_.edge.data();
  double* u = now_.velocity.data();
  const double* thrust = edge_thrust_.data();
  if (forcing_.manning > 0) {
    std::copy(now_.velocity.begin(), now_.velocity.end(), old_velocity_.begin());
    for (std::size_t i = 0; i < count; ++i) old_inv_width_[i] = inv_width(i);
  }
  if (forcing_.body_force) {
    double sum = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const double centre = now_.centre(i) + 0.25 * tau * (edge_velocity_[i] + edge_velocity_[i + 1]);
      const double kick = tau * forcing_.body_force(centre, time() + 0.5 * tau);
      u[i] += kick;
      sum += now_.mass[i] * kick;
    }
    ledger_.source_impulse.add(sum);
  }
  if (forcing_.bed) {
    double sum = 0;
    for (std::size_t i = 0; i < count; ++i) {
      // Thrusts and reaction cancel at rest: add them before they meet the velocity.
      u[i] += tau * inv_mass_[i] * (thrust[i] - thrust[i + 1] + reaction_[i]);
      sum += reaction_[i];
    }
    ledger_.bed_impulse.add(tau * sum);
    for (std::size_t k = 0; k <= count; ++k) x[k] += tau * edge_velocity_[k];
  } else if (forcing_.manning > 0 || end_is<Open>(side(false)) || end_is<Open>(side(true))) {
    // Masses or velocities are going to change once more.
    move_row(x, u, inv_mass_.data(), edge_velocity_.data(), thrust, tau, count, true);
  } else {
    limits = move_and_measure(tau);
  }

  ledger_.left_impulse.add(tau * thrust[0]);
  ledger_.right_impulse.add(-tau * thrust[count]);
  for (const bool right : {false, true}) {
    const Side s = side(right);
    if (!end_is<Open>(s)) continue;
    const std::size_t i = s.particle(0);
    const double inflow = -tau * open_mass_flux_[s.index()];
    const double before = now_.mass[i];
    now_.mass[i] += inflow;
    inv_mass_[i] = 1 / now_.mass[i];
    u[i] *= before * inv_mass_[i];  // momentum was complete, now its mass is
    (right ? ledger_.right_mass : ledger_.left_mass).add(inflow);
  }
  if (forcing_.manning > 0) apply_friction(tau);
  return limits;
}

void ParticleFlow::apply_friction(double tau) {
  const double n = forcing_.manning;
  double sum = 0;
  for (std::size_t i = 0; i < now_.size(); ++i) {
    // Rate g n^2 |u|/h^(4/3) at mid-step: width halfway, velocity from the predicted edges.
    const double width = 0.5 * (1 / old_inv_width_[i] + now_.width(i));
    const double h = now_.mass[i] / width;
    const double u = 0.5 * (values_.left_velocity[i] + values_.right_velocity[i]);
    const double rate = forcing_.gravity * n * n * std::abs(u) / (h * std::cbrt(h));
    const double before = now_.velocity[i];
    // Second order where friction is resolved in time, implicit where it would stop the water within the step.
    now_.velocity[i] = tau * rate < 1 ? (before - 0.5 * tau * rate * old_velocity_[i]) / (1 + 0.5 * tau * rate)
                                      : before / (1 + tau * rate);
    sum += now_.mass[i] * (now_.velocity[i] - before);
  }
  ledger_.friction_impulse.add(sum);
}

// Fixed sections that water passes: boundary state, and splitting and merging of the end particle.

namespace {

Array::iterator at(Array& array, std::size_t k) {
  return array.begin() + static_cast<std::ptrdiff_t>(k);
}

}  // namespace

void ParticleFlow::solve_open_end(Side s, const Open& open, State inner, double tau) {
  const double g = forcing_.gravity;
  const double middle = time() + 0.5 * tau;
  const double out = s.outward() * inner.velocity;
  const double c_inner = shallow_water::celerity(g, inner.depth);
  State outer = {inner.depth, out};  // velocities count outwards here
  if (open.discharge && open.depth) {
    const double h = open.depth(middle);
    outer = {h, s.outward() * open.discharge(middle) / h};
  } else if (out < c_inner) {
    const double invariant = out + 2 * c_inner;  // leaves the flow along dx/dt = out + c
    if (open.depth) {
      const double h = open.depth(middle);
      outer = {h, invariant - 2 * shallow_water::celerity(g, h)};
    } else if (open.discharge) {
      // c^2 (invariant - 2c) = g q on the subcritical branch c > invariant/3, where the left side falls.
      const double target = g * s.outward() * open.discharge(middle);
      double c = std::max(c_inner, 0.34 * invariant);
      for (int k = 0; k < 30; ++k) {
        const double change = (c * c * (invariant - 2 * c) - target) / (2 * c * (invariant - 3 * c));
        c = std::max(c - change, 0.334 * invariant);
        if (std::abs(change) <= 1e-15 * c) break;
      }
      outer = {c * c / g, invariant - 2 * c};
    }
  }
  const double flux = outer.depth * outer.velocity;
  open_mass_flux_[s.index()] = flux;
  edge_velocity_[s.edge(0)] = 0;
  edge_thrust_[s.edge(0)] = flux * outer.velocity + shallow_water::thrust(g, outer.depth);
}

void ParticleFlow::regulate(Side s) {
  const double width = now_.width(s.particle(0));
  const double target = open_width_[s.index()];
  if (width >= 2 * target) {
    split(s);
  } else if (width <= 0.5 * target && now_.size() > 4) {
    merge(s);
  } else {
    return;
  }
  resize_work();
  refresh();
  if (s.right) return;
  // What lies to the right of the left end has other numbers now; a collision at the end itself is given up.
  const bool more = width >= 2 * target;
  std::erase_if(collisions_, [](const Collision& c) { return c.left_particle() < 2; });
  for (Collision& collision : collisions_) collision.renumber(more);
}

void ParticleFlow::split(Side s) {
  detect_jumps();
  const std::size_t i = s.particle(0);
  const EdgePair e = edges_of(i, 0);
  const double width = now_.width(i);
  const double centre = now_.centre(i);
  double left_mass = 0.5 * width * (depth_[i] - 0.25 * (e.h_right - e.h_left));
  if (forcing_.bed) {
    const double tilt = (e.h_right + bed_edge_[i + 1]) - (e.h_left + bed_edge_[i]);
    left_mass = 0.5 * width * (surface_[i] - 0.25 * tilt) - (forcing_.bed->primitive(centre) - bed_area_[i]);
  }
  const double mass = now_.mass[i];
  left_mass = std::clamp(left_mass, 0.1 * mass, 0.9 * mass);
  const double right_mass = mass - left_mass;
  const double du = 0.5 * (e.u_right - e.u_left);  // between the centres of the halves
  const double u = now_.velocity[i];
  now_.mass[i] = left_mass;
  now_.mass.insert(at(now_.mass, i + 1), right_mass);
  now_.velocity[i] = u - du * right_mass / mass;
  now_.velocity.insert(at(now_.velocity, i + 1), u + du * left_mass / mass);
  now_.edge.insert(at(now_.edge, i + 1), centre);
}

void ParticleFlow::merge(Side s) {
  const std::size_t i = std::min(s.particle(0), s.particle(1));
  const double mass = now_.mass[i] + now_.mass[i + 1];
  const double momentum = now_.mass[i] * now_.velocity[i] + now_.mass[i + 1] * now_.velocity[i + 1];
  now_.mass[i] = mass;
  now_.velocity[i] = momentum / mass;
  now_.mass.erase(at(now_.mass, i + 1));
  now_.velocity.erase(at(now_.velocity, i + 1));
  now_.edge.erase(at(now_.edge, i + 1));
}

}  // namespace seiche::shallow_water_particles
