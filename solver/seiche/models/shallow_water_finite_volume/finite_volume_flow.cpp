#include "seiche/models/shallow_water_finite_volume/finite_volume_flow.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/divergence.hpp"
#include "seiche/linear/worth_threads.hpp"
#include "seiche/models/shallow_water_finite_volume/faces.hpp"
#include "seiche/require.hpp"
#include "seiche/require_that.hpp"

namespace seiche::shallow_water_finite_volume {
namespace {

constexpr std::size_t least_of_a_strip = 512;  // cells: what a strip needs for a step stays near the core

}  // namespace

/// Cells [begin, end) of the channel, and what a stage computes of n cells: these, or in the first of two stages all
/// that the second needs. Face k lies left of cell k, face n is the right end.
struct Strip {
  using Row = std::array<double, 2 * least_of_a_strip + 4 * ghosts>;
  std::size_t begin, end, n;
  struct Faces {
    Row mass, on_left, on_right;  // as the cell left and right of a face feels it
  } faces;
  Row source;  // centred, of the bed [m^3/s^2]
  struct Edges {
    Row hl, hr, ul, ur, zl, zr;  // of cells, from cell -1 on
  } edges;
  struct Middle {
    Row h, q, u, c;  // cells after the first of two stages
  } middle;
};

namespace {

template <class TwoPointFlux>
SEICHE_INLINE void two_point(const TwoPointFlux& flux, const CellsView& w, Strip& strip) {
  auto& [mass, on_left, on_right] = strip.faces;
  const auto faces = static_cast<std::ptrdiff_t>(strip.n + 1);
#pragma GCC ivdep
  for (std::ptrdiff_t k = 0; k < faces; ++k) {
    const std::ptrdiff_t l = k - 1;
    const Flux f = flux(Water{w.h[l], w.q[l], w.u[l], w.c[l]}, Water{w.h[k], w.q[k], w.u[k], w.c[k]});
    mass[k] = f.mass;
    on_left[k] = f.thrust;
  }
}

SEICHE_SIMD_CLONES
void classical_fluxes(const FiniteVolumeFlow::Settings& settings, double ratio, const CellsView& cells, Strip& strip) {
  const double g = settings.gravity;
  switch (settings.scheme) {
    case Scheme::lax_friedrichs:
      return two_point(LaxFriedrichs{g, 0.5 * settings.viscosity / ratio}, cells, strip);
    case Scheme::mac_cormack:
      return two_point(MacCormack{g, ratio}, cells, strip);
    default:
      return two_point(Roe{g}, cells, strip);
  }
}

/// Values at the edges of cells -1, ..., n. Null bed: flat.
SEICHE_SIMD_CLONES
void reconstruct(double theta, const CellsView& cells, const double* bed, Strip& strip) {
  const double* h = cells.h - 1;
  const double* u = cells.u - 1;
  auto& [hl, hr, ul, ur, zl, zr] = strip.edges;
  const auto entries = static_cast<std::ptrdiff_t>(strip.n + 2);
#pragma GCC ivdep
  for (std::ptrdiff_t j = 0; j < entries; ++j) {
    const double dh = half_slope(h[j - 1], h[j], h[j + 1], theta);
    const double du = half_slope(u[j - 1], u[j], u[j + 1], theta);
    // The limiter keeps h - |dh| >= 0 for theta <= 2 but for its last bit.
    hl[j] = std::max(h[j] - dh, 0.0);
    hr[j] = std::max(h[j] + dh, 0.0);
    // Weighted so that the two edges carry the cell's momentum: (hl ul + hr ur)/2 = h u. 1e-300: a dry cell divides 0
    // by it.
    const double inverse = 1 / std::max(h[j], 1e-300);
    ul[j] = u[j] - du * hr[j] * inverse;
    ur[j] = u[j] + du * hl[j] * inverse;
  }
  if (bed == nullptr) return;
  const double* z = bed - 1;
#pragma GCC ivdep
  for (std::ptrdiff_t j = 0; j < entries; ++j) {
    const double surface = h[j] + z[j];
    const double de = half_slope(h[j - 1] + z[j - 1], surface, h[j + 1] + z[j + 1], theta);
    zl[j] = (surface - de) - hl[j];
    zr[j] = (surface + de) - hr[j];
  }
}

/// On an uneven bed with depths above the higher of the two beds, the thrust of the step added to either side (Audusse
/// et al. 2004, formulas 2.9-2.14), and the centred source of the second-order scheme (formula 4.6).
SEICHE_SIMD_CLONES
void hll_fluxes(double g, bool uneven, Strip& strip) {
  const auto& [hl, hr, ul, ur, zl, zr] = strip.edges;
  auto& [mass, on_left, on_right] = strip.faces;
  const std::size_t faces = strip.n + 1;
  if (!uneven) {
#pragma GCC ivdep
    for (std::size_t k = 0; k < faces; ++k) {
      const Flux flux = hll(g, hr[k], ur[k], hl[k + 1], ul[k + 1]);
      mass[k] = flux.mass;
      on_left[k] = flux.thrust;
    }
    return;
  }
  auto& source = strip.source;
#pragma GCC ivdep
  for (std::size_t k = 0; k < faces; ++k) {
    const double step = std::max(zr[k], zl[k + 1]);
    const double left = std::max(0.0, hr[k] + zr[k] - step);
    const double right = std::max(0.0, hl[k + 1] + zl[k + 1] - step);
    const Flux flux = hll(g, left, ur[k], right, ul[k + 1]);
    mass[k] = flux.mass;
    on_left[k] = flux.thrust + 0.5 * g * (hr[k] - left) * (hr[k] + left);
    on_right[k] = flux.thrust + 0.5 * g * (hl[k + 1] - right) * (hl[k + 1] + right);
  }
#pragma GCC ivdep
  for (std::size_t i = 0; i + 1 < faces; ++i) {
    source[i] = -0.5 * g * (hl[i + 1] + hr[i + 1]) * (zr[i + 1] - zl[i + 1]);
  }
}

/// What becomes of a depth below zero: -roundoff is cut, a cell that empties is the difference of larger numbers.
struct Drying {
  double gravity, dry_depth, roundoff;
};

/// U' = U - (tau/dx) (F_{i+1} - F_i) + (tau/dx) S_i, in Heun's second stage the mean of that and of the old state;
/// velocity and celerity. Returns how many depths are negative or numbers not finite.
template <bool uneven, bool mean>
SEICHE_INLINE long update(const Drying& drying, double ratio, const Strip& strip, const CellsView& from,
                          const CellsView& old, const CellsView& to) {
  const auto& [mass, on_left, on_right] = strip.faces;
  const auto [h, q, u, c] = to;
  const auto [g, dry, roundoff] = drying;
  const auto n = static_cast<std::ptrdiff_t>(strip.n);
  long bad = 0;
#pragma GCC ivdep
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    double depth = from.h[i] - ratio * (mass[i + 1] - mass[i]);
    const double thrusts = uneven ? on_left[i + 1] - on_right[i] - strip.source[i] : on_left[i + 1] - on_left[i];
    double discharge = from.q[i] - ratio * thrusts;
    if (mean) depth = 0.5 * (old.h[i] + depth);
    if (mean) discharge = 0.5 * (old.q[i] + discharge);
    // x - x is 0 for finite numbers only; comparisons with NaN are false.
    const double probe = (depth - depth) + (discharge - discharge);
    bad += static_cast<long>(depth < -roundoff) + static_cast<long>(!(probe == 0));
    depth = depth < 0 && !(depth < -roundoff) ? 0.0 : depth;
    h[i] = depth;
    q[i] = discharge;
    // q/infinity = 0 in a dry cell: a select that vectorises, unlike a division under a condition.
    u[i] = discharge / (depth > dry ? depth : std::numeric_limits<double>::infinity());
    c[i] = std::sqrt(g * depth);
  }
  return bad;
}

SEICHE_SIMD_CLONES
long update(bool uneven, bool mean, const Drying& drying, double ratio, const Strip& strip, const CellsView& from,
            const CellsView& old, const CellsView& to) {
  if (uneven && mean) return update<true, true>(drying, ratio, strip, from, old, to);
  if (uneven) return update<true, false>(drying, ratio, strip, from, old, to);
  if (mean) return update<false, true>(drying, ratio, strip, from, old, to);
  return update<false, false>(drying, ratio, strip, from, old, to);
}

/// max(|u| + c) [m/s].
SEICHE_SIMD_CLONES
double fastest(const CellsView& cells, std::size_t n) {
  // Independent maxima, one per lane: a single one would have to be found one cell after the other.
  constexpr std::size_t lanes = 8;
  std::array<double, lanes> most{};
  std::size_t i = 0;
  for (; i + lanes <= n; i += lanes) {
    for (std::size_t k = 0; k < lanes; ++k) {
      const double speed = std::abs(cells.u[i + k]) + cells.c[i + k];
      most[k] = speed > most[k] ? speed : most[k];
    }
  }
  for (; i < n; ++i) most[0] = std::max(most[0], std::abs(cells.u[i]) + cells.c[i]);
  return *std::max_element(most.begin(), most.end());
}

}  // namespace

std::string_view name(Scheme scheme) {
  constexpr std::array<std::string_view, 4> names{"lax_friedrichs", "mac_cormack", "roe", "muscl_hll"};
  return names[static_cast<std::size_t>(scheme)];
}

FiniteVolumeFlow::FiniteVolumeFlow(const Settings& settings, double start, double end, std::span<const double> depth,
                                   std::span<const double> discharge, const std::optional<Bed>& bed)
    : settings_(settings), start_(start), dx_((end - start) / static_cast<double>(depth.size())), n_(depth.size()) {
  require_at_least("number of cells", static_cast<long>(n_), 4);
  require_finite("start", start);
  require_positive("end - start", end - start);
  require_ranges(settings);
  for (const End& side : {settings.left, settings.right}) {
    require_not_negative("depth of the inflow", side.state.depth);
    require_finite("velocity of the inflow", side.state.velocity);
    if (side.kind != End::Kind::inflow) continue;
    const double celerity = shallow_water::celerity(settings.gravity, side.state.depth);
    fastest_inflow_ = std::max(fastest_inflow_, std::abs(side.state.velocity) + celerity);
  }
  require_that(discharge.size() == n_, "discharge has {} cells: must have {} like depth", discharge.size(), n_);
  require_that(!bed || settings.scheme == Scheme::muscl_hll, "bed: scheme {} takes a flat bed only, use muscl_hll",
               name(settings.scheme));
  for (Cells* cells : {&now_, &next_}) {
    for (auto* row : {&cells->depth, &cells->discharge, &cells->velocity, &cells->celerity}) {
      row->resize(n_ + 2 * ghosts);
    }
  }
  const CellsView now = now_.from(0);
  for (std::size_t i = 0; i < n_; ++i) {
    require_not_negative("depth", depth[i]);
    require_finite("discharge", discharge[i]);
    require_that(depth[i] != 0 || discharge[i] == 0, "discharge = {:.17g} is out of range: must be 0 where depth is 0",
                 discharge[i]);
    now.h[i] = depth[i];
    now.q[i] = discharge[i];
    now.u[i] = depth[i] > settings.dry_depth ? discharge[i] / depth[i] : 0;
    now.c[i] = shallow_water::celerity(settings.gravity, depth[i]);
    depth_scale_ = std::max(depth_scale_, depth[i]);
  }
  if (bed) {  // means over the cells; beyond the ends as the ghosts have it
    bed->validate(start, start + dx_ * static_cast<double>(n_));
    bed_.resize(n_ + 2 * ghosts);
    for (std::size_t i = 0; i < n_; ++i) {
      const double a = start + dx_ * static_cast<double>(i);
      bed_[i + ghosts] = (bed->primitive(a + dx_) - bed->primitive(a)) / dx_;
    }
    for (std::size_t k = 0; k < ghosts; ++k) {
      bed_[ghosts - 1 - k] = bed_[ghosts + (settings.left.kind == End::Kind::wall ? k : 0)];
      bed_[n_ + ghosts + k] = bed_[n_ + ghosts - 1 - (settings.right.kind == End::Kind::wall ? k : 0)];
    }
  }
  reports_.resize(std::max<std::size_t>(1, n_ / least_of_a_strip));
  fastest_ = std::max(fastest(now, n_), fastest_inflow_);
  initial_mass_ = mass();
  initial_momentum_ = momentum();
}

double FiniteVolumeFlow::courant_limit() const {
  return settings_.scheme == Scheme::lax_friedrichs ? std::sqrt(settings_.viscosity) : 1.0;
}

void FiniteVolumeFlow::advance(double tau) {
  require_positive("tau", tau);
  const double courant = courant_number(tau);
  // A hair above the limit is the rounding of a step that was chosen to meet it.
  if (!(courant <= courant_limit() * (1 + 1e-12))) {
    const std::string text =
        fmt::format("Courant number of tau = {:g} is {:.4g}, must not exceed {:g}", tau, courant, courant_limit());
    if (steps_ == 0) throw std::invalid_argument(text);
    throw Divergence(text, time_, steps_, start_);
  }
  fill_ghosts(now_.from(0), n_, true, true);
  const std::size_t strips = reports_.size();
  linear::share_out(strips, n_ > linear::worth_threads,
                    [&](std::size_t k) { advance_strip(n_ * k / strips, n_ * (k + 1) / strips, tau, reports_[k]); });
  for (const Report& report : reports_) {
    if (!report.broken) continue;
    throw Divergence(fmt::format("cell {} of scheme {}: depth {} (tau = {:g})", *report.broken, name(settings_.scheme),
                                 report.finite ? "became negative" : "or discharge is not finite", tau),
                     time_, steps_, start_ + (static_cast<double>(*report.broken) + 0.5) * dx_);
  }
  book(tau);
  std::swap(now_, next_);
  largest_courant_ = std::max(largest_courant_, courant);
  time_ += tau;
  ++steps_;
}

/// Beyond an end of the channel.
void FiniteVolumeFlow::fill_ghosts(const CellsView& cells, std::size_t n, bool left, bool right) const {
  const auto fill = [&](const End& end, std::ptrdiff_t ghost, std::ptrdiff_t mirror, std::ptrdiff_t last) {
    const bool held = end.kind == End::Kind::inflow;
    const std::ptrdiff_t from = end.kind == End::Kind::wall ? mirror : last;
    const double sign = end.kind == End::Kind::wall ? -1 : 1;
    const auto [h, u] = end.state;
    cells.h[ghost] = held ? h : cells.h[from];
    cells.q[ghost] = held ? h * u : sign * cells.q[from];
    cells.u[ghost] = held ? u : sign * cells.u[from];
    cells.c[ghost] = held ? shallow_water::celerity(settings_.gravity, h) : cells.c[from];
  };
  const auto count = static_cast<std::ptrdiff_t>(n);
  for (std::ptrdiff_t k = 0; k < static_cast<std::ptrdiff_t>(ghosts); ++k) {
    if (left) fill(settings_.left, -1 - k, k, 0);
    if (right) fill(settings_.right, count + k, count - 1 - k, count - 1);
  }
}

/// From the present state of the cells and of their neighbours to the next of [begin, end).
void FiniteVolumeFlow::advance_strip(std::size_t begin, std::size_t end, double tau, Report& report) {
  Strip strip;  // NOLINT(cppcoreguidelines-pro-type-member-init): no number is read before it is written
  strip.begin = begin;
  strip.end = end;
  report = {};
  if (settings_.scheme != Scheme::muscl_hll) {
    stage(strip, 0, begin, end, now_.from(begin), next_.from(begin), tau, report);
  } else {
    const bool at_left = begin == 0;
    const bool at_right = end == n_;
    const std::size_t first = at_left ? begin : begin - ghosts;
    auto& [h, q, u, c] = strip.middle;
    const CellsView middle{&h[ghosts], &q[ghosts], &u[ghosts], &c[ghosts]};
    stage(strip, 0, first, at_right ? end : end + ghosts, now_.from(first), middle, tau, report);
    fill_ghosts(middle, strip.n, at_left, at_right);
    stage(strip, 1, begin, end, middle.from(static_cast<std::ptrdiff_t>(begin - first)), next_.from(begin), tau,
          report);
  }
  const CellsView next = next_.from(begin);
  for (std::size_t i = 0; settings_.manning > 0 && i < strip.n; ++i) {
    // q' = q/(1 + tau g n^2 |u|/h^(4/3)): implicit in the discharge, so that shallow water comes to rest and not back.
    const double h = next.h[i];
    if (h <= settings_.dry_depth) continue;
    const double factor = tau * settings_.gravity * settings_.manning * settings_.manning;
    const double before = next.q[i];
    next.q[i] = before / (1 + factor * std::abs(next.u[i]) / (h * std::cbrt(h)));
    next.u[i] = next.q[i] / h;
    report.friction += next.q[i] - before;
  }
  report.fastest = fastest(next, strip.n);
}

/// One of Euler's steps of the cells [first, last), the views counting from `first`; the second is the mean of it and
/// of the present state.
void FiniteVolumeFlow::stage(Strip& strip, std::size_t number, std::size_t first, std::size_t last,
                             const CellsView& from, const CellsView& to, double tau, Report& report) {
  const double ratio = tau / dx_;
  const bool uneven = !bed_.empty();
  strip.n = last - first;
  if (settings_.scheme == Scheme::muscl_hll) {
    reconstruct(settings_.theta, from, uneven ? &bed_[first + ghosts] : nullptr, strip);
    hll_fluxes(settings_.gravity, uneven, strip);
  } else {
    classical_fluxes(settings_, ratio, from, strip);
  }
  auto& [mass, on_left, own_right] = strip.faces;
  // A wall passes no mass: zero by symmetry in every scheme, and here to the last bit.
  if (first == 0 && settings_.left.kind == End::Kind::wall) mass[0] = 0;
  if (last == n_ && settings_.right.kind == End::Kind::wall) mass[strip.n] = 0;

  const auto& on_right = uneven ? own_right : on_left;
  const std::size_t begin = strip.begin - first;
  const std::size_t end = strip.end - first;
  Report::Stage& passed = report.stages[number];
  passed = {mass[begin], mass[end], on_right[begin], on_left[end], 0};
  if (uneven) {
    // The bed acts through the sources and through the steps of the hydrostatic reconstruction at inner faces.
    for (std::size_t i = begin; i < end; ++i) passed.reaction += strip.source[i];
    for (std::size_t k = strip.begin == 0 ? 1 : begin; k < end; ++k) passed.reaction += on_right[k] - on_left[k];
  }
  const Drying drying{settings_.gravity, settings_.dry_depth, 1e-13 * depth_scale_};
  if (update(uneven, number > 0, drying, ratio, strip, from, now_.from(first), to) == 0) return;
  for (std::size_t i = begin; i < end && !report.broken; ++i) {
    report.finite = std::isfinite(to.h[i]) && std::isfinite(to.q[i]);
    if (!report.finite || to.h[i] < 0) report.broken = first + i;
  }
}

void FiniteVolumeFlow::book(double tau) {
  const std::size_t stages = settings_.scheme == Scheme::muscl_hll ? 2 : 1;
  const double part = tau / static_cast<double>(stages);
  auto& [mass_left, mass_right, impulse_left, impulse_right, impulse_bed, impulse_friction] = booked_;
  for (std::size_t k = 0; k < stages; ++k) {
    const Report::Stage& left = reports_.front().stages[k];
    const Report::Stage& right = reports_.back().stages[k];
    mass_left.add(part * left.mass_first);
    mass_right.add(-part * right.mass_last);
    impulse_left.add(part * left.thrust_first);
    impulse_right.add(-part * right.thrust_last);
    for (const Report& report : reports_) impulse_bed.add(part * report.stages[k].reaction);
  }
  fastest_ = fastest_inflow_;
  for (const Report& report : reports_) {
    impulse_friction.add(report.friction * dx_);
    fastest_ = std::max(fastest_, report.fastest);
  }
}

std::vector<double> FiniteVolumeFlow::edges() const {
  std::vector<double> faces(n_ + 1);
  for (std::size_t k = 0; k <= n_; ++k) faces[k] = start_ + dx_ * static_cast<double>(k);
  return faces;
}

Ledger FiniteVolumeFlow::ledger() const {
  return {booked_[0].value(), booked_[1].value(), booked_[2].value(),
          booked_[3].value(), booked_[4].value(), booked_[5].value()};
}

double FiniteVolumeFlow::mass_defect() const {
  return mass() - initial_mass_ - booked_[0].value() - booked_[1].value();
}

double FiniteVolumeFlow::momentum_defect() const {
  double defect = momentum() - initial_momentum_;
  for (std::size_t k = 2; k < booked_.size(); ++k) defect -= booked_[k].value();
  return defect;
}

std::vector<Invariant> FiniteVolumeFlow::invariants() const {
  double impulse = 0;
  for (std::size_t k = 2; k < booked_.size(); ++k) impulse += booked_[k].value();
  return {{"mass", mass(), booked_[0].value() + booked_[1].value()}, {"momentum_x", momentum(), impulse}};
}

}  // namespace seiche::shallow_water_finite_volume
