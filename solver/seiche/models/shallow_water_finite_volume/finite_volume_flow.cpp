#include "seiche/models/shallow_water_finite_volume/finite_volume_flow.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/divergence.hpp"
#include "seiche/require.hpp"
#include "seiche/simd_clones.hpp"

namespace seiche::shallow_water_finite_volume {
namespace {

template <class Term>
double sum(std::size_t n, Term term) {
  CompensatedSum total;
  for (std::size_t i = 0; i < n; ++i) total.add(term(i));
  return total.value();
}

std::size_t checked_cells(std::span<const double> depth, std::span<const double> discharge) {
  require_at_least("number of cells", static_cast<long>(depth.size()), 4);
  if (discharge.size() != depth.size()) {
    throw std::invalid_argument(
        fmt::format("discharge has {} cells: must have {} like depth", discharge.size(), depth.size()));
  }
  return depth.size();
}

/// Means of the bed over the cells; beyond the ends as the ghosts have it: mirrored at a wall, continued level
/// otherwise.
std::vector<double> bed_means(const std::optional<Bed>& bed, double start, double dx, std::size_t n, const End& left,
                              const End& right) {
  if (!bed) return {};
  bed->validate(start, start + dx * static_cast<double>(n));
  std::vector<double> means(n + 2 * ghosts);
  for (std::size_t i = 0; i < n; ++i) {
    const double a = start + dx * static_cast<double>(i);
    means[i + ghosts] = (bed->primitive(a + dx) - bed->primitive(a)) / dx;
  }
  for (std::size_t k = 0; k < ghosts; ++k) {
    means[ghosts - 1 - k] = means[ghosts + (left.kind == End::Kind::wall ? k : 0)];
    means[n + ghosts + k] = means[n + ghosts - 1 - (right.kind == End::Kind::wall ? k : 0)];
  }
  return means;
}

void check_end(const char* side, const End& end) {
  if (end.kind != End::Kind::inflow) return;
  require_not_negative(fmt::format("depth of the {} inflow", side), end.state.depth);
  require_finite(fmt::format("velocity of the {} inflow", side), end.state.velocity);
}

double checked_spacing(double start, double end, std::size_t n) {
  require_finite("start", start);
  require_finite("end", end);
  if (!(end > start)) {
    throw std::invalid_argument(fmt::format("end = {:.17g} is out of range: must exceed start = {:g}", end, start));
  }
  return (end - start) / static_cast<double>(n);
}

}  // namespace

FiniteVolumeFlow::FiniteVolumeFlow(const Settings& settings, double start, double end, std::span<const double> depth,
                                   std::span<const double> discharge, const std::optional<Bed>& bed)
    : settings_(settings),
      start_(start),
      dx_(checked_spacing(start, end, checked_cells(depth, discharge))),
      n_(depth.size()),
      bed_(bed_means(bed, start, dx_, n_, settings.left, settings.right)),
      now_(n_),
      old_depth_(n_),
      old_discharge_(n_),
      fluxes_(n_, bed.has_value()),
      mac_cormack_(settings.scheme == Scheme::mac_cormack ? n_ : 0),
      muscl_hll_(settings.scheme == Scheme::muscl_hll ? n_ : 0, bed_) {
  require_positive("gravity", settings.gravity);
  require_within("viscosity", settings.viscosity, 1e-3, 1);
  require_within("theta", settings.theta, 1, 2);
  require_not_negative("manning", settings.manning);
  require_positive("dry_depth", settings.dry_depth);
  check_end("left", settings.left);
  check_end("right", settings.right);
  if (bed && settings.scheme != Scheme::muscl_hll) {
    throw std::invalid_argument(
        fmt::format("bed: scheme {} takes a flat bed only, use muscl_hll", name(settings.scheme)));
  }
  for (std::size_t i = 0; i < n_; ++i) {
    require_not_negative("depth", depth[i]);
    require_finite("discharge", discharge[i]);
    if (depth[i] == 0 && discharge[i] != 0) {
      throw std::invalid_argument(
          fmt::format("discharge = {:.17g} is out of range: must be 0 where depth is 0", discharge[i]));
    }
    now_.depth[i + ghosts] = depth[i];
    now_.discharge[i + ghosts] = discharge[i];
    depth_scale_ = std::max(depth_scale_, depth[i]);
  }
  update_primitives(settings_.gravity, settings_.dry_depth, ghosts, n_ + ghosts, now_);
  initial_mass_ = mass();
  initial_momentum_ = momentum();
}

double FiniteVolumeFlow::courant_limit() const {
  return settings_.scheme == Scheme::lax_friedrichs ? std::sqrt(settings_.viscosity) : 1.0;
}

SEICHE_SIMD_CLONES
double FiniteVolumeFlow::courant_number(double tau) const {
  const double* u = now_.velocity.data() + ghosts;
  const double* c = now_.celerity.data() + ghosts;
  // Independent maxima, one per lane: a single one would have to be found one cell after the other.
  constexpr std::size_t lanes = 8;
  std::array<double, lanes> fastest{};
  std::size_t i = 0;
  for (; i + lanes <= n_; i += lanes) {
    for (std::size_t k = 0; k < lanes; ++k) {
      const double speed = std::abs(u[i + k]) + c[i + k];
      fastest[k] = speed > fastest[k] ? speed : fastest[k];
    }
  }
  for (; i < n_; ++i) fastest[0] = std::max(fastest[0], std::abs(u[i]) + c[i]);
  return *std::max_element(fastest.begin(), fastest.end()) * tau / dx_;
}

void FiniteVolumeFlow::step(double tau) {
  require_positive("tau", tau);
  const double courant = courant_number(tau);
  // A hair above the limit is the rounding of a step that was chosen to meet it.
  if (!(courant <= courant_limit() * (1 + 1e-12))) {
    const std::string text =
        fmt::format("Courant number of tau = {:g} is {:.4g}, must not exceed {:g}", tau, courant, courant_limit());
    if (steps_ == 0) throw std::invalid_argument(text);
    throw Divergence(text, time_, steps_, start_);
  }
  largest_courant_ = std::max(largest_courant_, courant);

  const double ratio = tau / dx_;
  if (settings_.scheme == Scheme::muscl_hll) {
    // Heun: the mean of the old state and of two Euler steps.
    std::copy_n(now_.depth.data() + ghosts, n_, old_depth_.data());
    std::copy_n(now_.discharge.data() + ghosts, n_, old_discharge_.data());
    compute_fluxes(ratio);
    apply_fluxes(ratio, 0.5);
    settle(tau);
    compute_fluxes(ratio);
    apply_fluxes(ratio, 0.5);
    double* __restrict h = now_.depth.data() + ghosts;
    double* __restrict q = now_.discharge.data() + ghosts;
    for (std::size_t i = 0; i < n_; ++i) {
      h[i] = 0.5 * (old_depth_[i] + h[i]);
      q[i] = 0.5 * (old_discharge_[i] + q[i]);
    }
  } else {
    compute_fluxes(ratio);
    apply_fluxes(ratio, 1);
  }
  settle(tau);
  if (settings_.manning > 0) apply_friction(tau);
  time_ += tau;
  ++steps_;
}

long FiniteVolumeFlow::advance_to(double time, double courant) {
  require_finite("time", time);
  require_within("courant", courant, 1e-6, courant_limit());
  if (time < time_) {
    throw std::invalid_argument(fmt::format("time = {:.17g} is out of range: must not precede {:g}", time, time_));
  }
  const long before = steps_;
  const double interval = time - time_;
  while (time_ < time) {
    const double per_second = courant_number(1);
    const double largest = per_second > 0 ? courant / per_second : time - time_;
    // Steps that shrink to a millionth of a millionth of the interval will never arrive.
    if (!(largest > 1e-12 * interval))
      throw Divergence("admissible time step shrinks to nothing", time_, steps_, start_);
    if (largest >= time - time_) {
      step(time - time_);
      time_ = time;
    } else {
      step(largest);
    }
  }
  return steps_ - before;
}

void FiniteVolumeFlow::fill_ghosts() {
  const auto fill = [&](const End& end, std::size_t ghost, std::size_t mirror, std::size_t last) {
    const std::size_t from = end.kind == End::Kind::wall ? mirror : last;
    const double sign = end.kind == End::Kind::wall ? -1 : 1;
    if (end.kind == End::Kind::inflow) {
      now_.depth[ghost] = end.state.depth;
      now_.discharge[ghost] = end.state.depth * end.state.velocity;
      now_.velocity[ghost] = end.state.velocity;
      now_.celerity[ghost] = shallow_water::celerity(settings_.gravity, end.state.depth);
      return;
    }
    now_.depth[ghost] = now_.depth[from];
    now_.discharge[ghost] = sign * now_.discharge[from];
    now_.velocity[ghost] = sign * now_.velocity[from];
    now_.celerity[ghost] = now_.celerity[from];
  };
  for (std::size_t k = 0; k < ghosts; ++k) {
    fill(settings_.left, ghosts - 1 - k, ghosts + k, ghosts);
    fill(settings_.right, n_ + ghosts + k, n_ + ghosts - 1 - k, n_ + ghosts - 1);
  }
}

void FiniteVolumeFlow::compute_fluxes(double ratio) {
  fill_ghosts();
  switch (settings_.scheme) {
    case Scheme::lax_friedrichs:
      lax_friedrichs_fluxes(settings_.gravity, settings_.viscosity, ratio, now_, fluxes_);
      break;
    case Scheme::mac_cormack:
      mac_cormack_(settings_.gravity, ratio, now_, fluxes_);
      break;
    case Scheme::roe:
      roe_fluxes(settings_.gravity, now_, fluxes_);
      break;
    case Scheme::muscl_hll:
      muscl_hll_(settings_.gravity, settings_.theta, now_, fluxes_);
      break;
  }
  // A wall passes no mass: zero by symmetry in every scheme, and here to the last bit.
  if (settings_.left.kind == End::Kind::wall) fluxes_.mass.front() = 0;
  if (settings_.right.kind == End::Kind::wall) fluxes_.mass.back() = 0;
}

SEICHE_SIMD_CLONES
void FiniteVolumeFlow::apply_fluxes(double ratio, double weight) {
  double* __restrict h = now_.depth.data() + ghosts;
  double* __restrict q = now_.discharge.data() + ghosts;
  const double* mass = fluxes_.mass.data();
  const double* on_left = fluxes_.momentum.data();
  const double tau = weight * ratio * dx_;
  if (bed_.empty()) {
    for (std::size_t i = 0; i < n_; ++i) {
      h[i] -= ratio * (mass[i + 1] - mass[i]);
      q[i] -= ratio * (on_left[i + 1] - on_left[i]);
    }
    impulse_left_.add(tau * on_left[0]);
  } else {
    const double* on_right = fluxes_.momentum_right.data();
    const double* source = fluxes_.source.data();
    for (std::size_t i = 0; i < n_; ++i) {
      h[i] -= ratio * (mass[i + 1] - mass[i]);
      q[i] -= ratio * (on_left[i + 1] - on_right[i] - source[i]);
    }
    impulse_left_.add(tau * on_right[0]);
    // The bed acts through the sources and through the steps of the hydrostatic reconstruction at inner faces.
    double reaction = 0;
    for (std::size_t i = 0; i < n_; ++i) reaction += source[i];
    for (std::size_t k = 1; k < n_; ++k) reaction += on_right[k] - on_left[k];
    impulse_bed_.add(tau * reaction);
  }
  impulse_right_.add(-tau * on_left[n_]);
  mass_left_.add(tau * mass[0]);
  mass_right_.add(-tau * mass[n_]);
}

/// Removes negative depths of round-off size, refuses others, and refreshes velocity and celerity.
void FiniteVolumeFlow::settle(double tau) {
  double* __restrict h = now_.depth.data() + ghosts;
  const double* q = now_.discharge.data() + ghosts;
  // A cell that empties is the difference of numbers of the size of the largest depth.
  const double roundoff = -1e-13 * depth_scale_;
  long bad = 0;
  for (std::size_t i = 0; i < n_; ++i) {
    // x - x is 0 for finite numbers only; comparisons with NaN are false.
    const double probe = (h[i] - h[i]) + (q[i] - q[i]);
    bad += static_cast<long>(h[i] < roundoff) + static_cast<long>(!(probe == 0));
    h[i] = h[i] < 0 ? 0.0 : h[i];
  }
  if (bad > 0) {
    for (std::size_t i = 0; i < n_; ++i) {
      // Negative depths were cut above: what is reported is the first cell whose update explains one.
      const double updated = fluxes_.mass[i + 1] - fluxes_.mass[i];
      if (std::isfinite(h[i]) && std::isfinite(q[i]) && !(h[i] == 0 && updated > 0)) continue;
      throw Divergence(
          fmt::format("cell {} of scheme {}: depth {} (tau = {:g})", i, name(settings_.scheme),
                      std::isfinite(h[i]) && std::isfinite(q[i]) ? "became negative" : "or discharge is not finite",
                      tau),
          time_, steps_, centre(i));
    }
    throw Divergence(fmt::format("depth of scheme {} became negative", name(settings_.scheme)), time_, steps_, start_);
  }
  update_primitives(settings_.gravity, settings_.dry_depth, ghosts, n_ + ghosts, now_);
}

/// q' = q/(1 + tau g n^2 |u|/h^(4/3)): implicit in the discharge, so that shallow water comes to rest and not back.
void FiniteVolumeFlow::apply_friction(double tau) {
  const double factor = tau * settings_.gravity * settings_.manning * settings_.manning;
  double lost = 0;
  for (std::size_t i = ghosts; i < n_ + ghosts; ++i) {
    const double h = now_.depth[i];
    if (h <= settings_.dry_depth) continue;
    const double before = now_.discharge[i];
    now_.discharge[i] = before / (1 + factor * std::abs(now_.velocity[i]) / (h * std::cbrt(h)));
    now_.velocity[i] = now_.discharge[i] / h;
    lost += now_.discharge[i] - before;
  }
  impulse_friction_.add(lost * dx_);
}

std::vector<double> FiniteVolumeFlow::edges() const {
  std::vector<double> faces(n_ + 1);
  for (std::size_t k = 0; k <= n_; ++k) faces[k] = start_ + dx_ * static_cast<double>(k);
  return faces;
}

std::span<const double> FiniteVolumeFlow::bed() const {
  return bed_.empty() ? std::span<const double>() : std::span<const double>(bed_.data() + ghosts, n_);
}

double FiniteVolumeFlow::mass() const {
  return dx_ * sum(n_, [&](std::size_t i) { return now_.depth[i + ghosts]; });
}

double FiniteVolumeFlow::momentum() const {
  return dx_ * sum(n_, [&](std::size_t i) { return now_.discharge[i + ghosts]; });
}

double FiniteVolumeFlow::energy() const {
  return dx_ * sum(n_, [&](std::size_t i) {
           const double h = now_.depth[i + ghosts];
           const double u = now_.velocity[i + ghosts];
           const double z = bed_.empty() ? 0.0 : bed_[i + ghosts];
           return 0.5 * h * u * u + settings_.gravity * h * (0.5 * h + z);
         });
}

Ledger FiniteVolumeFlow::ledger() const {
  return {mass_left_.value(),     mass_right_.value(),  impulse_left_.value(),
          impulse_right_.value(), impulse_bed_.value(), impulse_friction_.value()};
}

double FiniteVolumeFlow::mass_defect() const {
  return mass() - initial_mass_ - mass_left_.value() - mass_right_.value();
}

double FiniteVolumeFlow::momentum_defect() const {
  return momentum() - initial_momentum_ - impulse_left_.value() - impulse_right_.value() - impulse_bed_.value() -
         impulse_friction_.value();
}

}  // namespace seiche::shallow_water_finite_volume
