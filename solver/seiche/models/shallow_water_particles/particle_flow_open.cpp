// Fixed sections that water passes: boundary state, and splitting and merging of the end particle.
#include <algorithm>
#include <cmath>

#include "seiche/models/shallow_water_particles/particle_flow.hpp"

namespace seiche::shallow_water_particles {
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
  collisions_.erase(
      std::remove_if(collisions_.begin(), collisions_.end(), [](const Collision& c) { return c.left_particle() < 2; }),
      collisions_.end());
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
