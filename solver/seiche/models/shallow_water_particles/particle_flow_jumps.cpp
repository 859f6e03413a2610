// Which particles hold a jump at the present time.
#include <algorithm>
#include <cmath>

#include "seiche/models/shallow_water_particles/particle_flow.hpp"

namespace seiche::shallow_water_particles {
namespace {

/// A jump must exceed this many times the variation beside it.
constexpr double isolation = 2;
constexpr std::size_t searched_together = 64;  // particles: most blocks hold nothing that could be a jump

}  // namespace

const Structure* ParticleFlow::structure_at(std::size_t i) const {
  if (structures_.empty()) return nullptr;
  const auto found = std::ranges::lower_bound(structures_, i, {}, &Structure::particle);
  return found != structures_.end() && found->particle == i ? &*found : nullptr;
}

void ParticleFlow::detect_jumps() {
  jumps_.clear();
  structures_.clear();
  if (scheme_.level != Level::hand_over || forcing_.bed) return;

  const std::size_t count = now_.size();
  // A collision is over when three particles with the state between lie between its jumps; it is given up near an end.
  std::erase_if(collisions_, [&](const Collision& c) {
    const bool apart = c.met() && c.right_particle() >= c.left_particle() + 3;
    return apart || c.left_particle() < 2 || c.right_particle() + 3 > count;
  });
  const auto followed = [&](std::size_t i) {
    return std::ranges::any_of(
        collisions_, [&](const Collision& c) { return i + 1 >= c.left_particle() && i <= c.right_particle() + 1; });
  };

  const auto difference = [&](std::size_t a, std::size_t b) { return std::abs(depth_[a] - depth_[b]); };
  const std::size_t blocks = (count - 3 + searched_together) / searched_together;
  share(blocks, threads(), [&](std::size_t block, std::size_t /*thread*/) {
    const std::size_t first = 1 + block * searched_together;
    const std::size_t last = std::min(first + searched_together, count - 1);
    if (!may_hold_jump(&depth_[first], &now_.velocity[first], forcing_.gravity, jump_threshold, last - first)) return;
    for (std::size_t i = first; i < last; ++i) {
      if (!collisions_.empty() && followed(i)) continue;
      auto jump = jump_between(forcing_.gravity, state(i - 1), state(i), state(i + 1), jump_threshold);
      if (!jump) continue;
      const double beside = (i >= 2 ? difference(i - 1, i - 2) : 0) + (i + 2 < count ? difference(i + 2, i + 1) : 0);
      if (jump->size() < isolation * beside) continue;
      jump->particle = i;
#pragma omp critical(shallow_water_particles_jump)
      jumps_.push_back(*jump);  // in any order: discard_adjacent() has one of its own
    }
  });
  detect_at_wall(side(false));
  detect_at_wall(side(true));
  discard_adjacent();
  start_collisions();
  list_structures();
}

void ParticleFlow::detect_at_wall(Side s) {
  std::optional<State>& ahead = ahead_at_wall_[s.index()];
  const auto wall = wall_velocity(s, time());
  if (!wall) return;
  // Everything below is written with velocities towards the wall, the wall on the right.
  const auto towards = [&](std::size_t k) {
    return State{depth_[s.particle(k)], s.outward() * now_.velocity[s.particle(k)]};
  };
  const double wall_out = s.outward() * *wall;
  const Facing to_wall = s.right ? Facing::right : Facing::left;
  const auto restore = [&](InteriorJump jump, State reflected) {
    for (State* state : {&jump.behind, &jump.ahead, &reflected}) state->velocity *= s.outward();
    jump.facing = (jump.facing == Facing::right) == s.right ? Facing::right : Facing::left;
    jump.particle = s.particle(0);
    jump.reflected = reflected;
    jumps_.push_back(jump);
  };
  const auto arriving = std::find_if(jumps_.begin(), jumps_.end(), [&](const InteriorJump& j) {
    return j.particle == s.particle(1) && j.facing == to_wall;
  });
  if (arriving != jumps_.end()) {
    ahead = towards(0);
    return;
  }
  if (ahead) {
    // The jump has entered the end particle: its mean is mixed, the state ahead is remembered.
    auto jump = jump_between(forcing_.gravity, towards(1), towards(0), *ahead, jump_threshold);
    if (jump && jump->facing == Facing::right) {
      const State mirror = {jump->behind.depth, 2 * wall_out - jump->behind.velocity};
      jump->leaves_through_wall = true;
      restore(*jump, shallow_water::star_state(forcing_.gravity, jump->behind, mirror));
      return;
    }
    ahead.reset();
  }
  const State inner = towards(1);
  const State mirror = {inner.depth, 2 * wall_out - inner.velocity};
  // Of the two equal jumps of this symmetric problem the one that has left the wall is wanted.
  if (!(inner.velocity > mirror.velocity)) return;
  const State star = shallow_water::star_state(forcing_.gravity, inner, mirror);
  if (star.depth - inner.depth <= jump_threshold * inner.depth) return;
  const State mean = towards(0);
  InteriorJump jump;
  jump.facing = Facing::left;
  jump.ahead = inner;
  jump.behind = {star.depth, wall_out};
  jump.behind_by_volume = (1 / inner.depth - 1 / mean.depth) / (1 / inner.depth - 1 / star.depth);
  jump.behind_by_momentum = (mean.velocity - inner.velocity) / (wall_out - inner.velocity);
  jump.mass_flux = shallow_water::jump_mass_flux(forcing_.gravity, inner.depth, star.depth);
  if (jump.inside()) restore(jump, {});
}

/// The largest first: which ones stay does not depend on the end of the row that one begins at.
void ParticleFlow::discard_adjacent() {
  std::vector<InteriorJump> largest_first = jumps_;
  std::sort(largest_first.begin(), largest_first.end(), [](const InteriorJump& a, const InteriorJump& b) {
    if (a.size() != b.size()) return a.size() > b.size();
    if (a.facing != b.facing) return a.facing < b.facing;
    return a.facing == Facing::right ? a.particle > b.particle : a.particle < b.particle;  // the one ahead
  });
  jumps_.clear();
  for (const InteriorJump& jump : largest_first) {
    const auto larger = std::find_if(jumps_.begin(), jumps_.end(), [&](const InteriorJump& kept) {
      return kept.facing == jump.facing && (kept.particle + 1 == jump.particle || jump.particle + 1 == kept.particle);
    });
    if (larger == jumps_.end()) {
      jumps_.push_back(jump);
      continue;
    }
    const bool not_yet_there = (jump.particle > larger->particle) == (jump.facing == Facing::right);
    for (const double behind : {jump.behind_by_volume, jump.behind_by_momentum}) {
      events_.discarded_inside.add(not_yet_there ? behind : 1 - behind);
    }
    ++events_.adjacent_discarded;
  }
  std::ranges::sort(jumps_, {}, &InteriorJump::particle);
}

void ParticleFlow::start_collisions() {
  // Detection from means needs two undisturbed particles between the jumps, and each jump moves up to one particle a
  // step: from five particles apart on they are followed.
  constexpr std::size_t nearest = 3;
  constexpr std::size_t farthest = 5;
  for (std::size_t k = 0; k + 1 < jumps_.size();) {
    const InteriorJump& a = jumps_[k];
    const InteriorJump& b = jumps_[k + 1];
    const std::size_t apart = b.particle - a.particle;
    const bool meet = a.facing == Facing::right && b.facing == Facing::left && apart >= nearest && apart <= farthest &&
                      a.particle >= 3 && b.particle + 4 <= now_.size();
    if (!meet) {
      ++k;
      continue;
    }
    collisions_.emplace_back(forcing_.gravity, a, b, now_.mass);
    ++events_.collisions;
    jumps_.erase(jumps_.begin() + static_cast<std::ptrdiff_t>(k), jumps_.begin() + static_cast<std::ptrdiff_t>(k) + 2);
  }
}

void ParticleFlow::list_structures() {
  for (const InteriorJump& jump : jumps_) structures_.push_back(structure_of(jump));
  for (const Collision& c : collisions_) {
    for (std::size_t i = c.left_particle(); i <= c.right_particle(); ++i) {
      structures_.push_back(c.structure(i, now_.mass));
    }
  }
  std::ranges::sort(structures_, {}, &Structure::particle);
}

}  // namespace seiche::shallow_water_particles
