#include "seiche/models/shallow_water_finite_volume/finite_volume_flow.hpp"

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "seiche/divergence.hpp"
#include "seiche/linear/worth_threads.hpp"
#include "seiche/models/shallow_water_finite_volume/cell_passes.hpp"
#include "seiche/require.hpp"

namespace seiche::shallow_water_finite_volume {
namespace {

constexpr std::size_t least_of_a_block = 512;  // cells
constexpr std::ptrdiff_t reach = 2 * ghosts;   // of a step of two stages, in cells to either side
constexpr auto seam_cells = static_cast<std::size_t>(2 * reach);

std::size_t blocks_for(std::size_t n) {
  return std::max<std::size_t>(1, n / least_of_a_block);
}

void copy(const CellsView& from, std::ptrdiff_t n, const CellsView& to) {
  std::copy_n(from.depth, n, to.depth);
  std::copy_n(from.discharge, n, to.discharge);
  std::copy_n(from.velocity, n, to.velocity);
  std::copy_n(from.celerity, n, to.celerity);
}

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
      blocks_(blocks_for(n_)),
      seams_(seam_cells * blocks_.size()) {
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
  update_primitives(settings_.gravity, settings_.dry_depth, n_, now_.view());
  for (const End& inflow : {settings.left, settings.right}) {
    if (inflow.kind != End::Kind::inflow) continue;
    const double celerity = shallow_water::celerity(settings.gravity, inflow.state.depth);
    fastest_inflow_ = std::max(fastest_inflow_, std::abs(inflow.state.velocity) + celerity);
  }
  fastest_ = std::max(fastest(n_, now_.view()), fastest_inflow_);
  std::size_t most = 0;
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    blocks_[b].begin = n_ * b / blocks_.size();
    blocks_[b].end = n_ * (b + 1) / blocks_.size();
    most = std::max(most, blocks_[b].end - blocks_[b].begin);
  }
  const int threads = n_ > linear::worth_threads ? omp_get_max_threads() : 1;
  for (int k = 0; k < threads; ++k) workspaces_.emplace_back(most + 2 * ghosts, settings.scheme, bed.has_value());
  initial_mass_ = mass();
  initial_momentum_ = momentum();
}

double FiniteVolumeFlow::courant_limit() const {
  return settings_.scheme == Scheme::lax_friedrichs ? std::sqrt(settings_.viscosity) : 1.0;
}

double FiniteVolumeFlow::courant_number(double tau) const {
  return fastest_ * tau / dx_;
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

  fill_ghosts(now_.view(), n_, true, true);
  save_seams();
  if (workspaces_.size() > 1) {
    const auto threads = static_cast<int>(workspaces_.size());
#pragma omp parallel for schedule(static) num_threads(threads)
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
      advance(b, tau, workspaces_[static_cast<std::size_t>(omp_get_thread_num())]);
    }
  } else {
    for (std::size_t b = 0; b < blocks_.size(); ++b) advance(b, tau, workspaces_.front());
  }
  refuse_breakdown(tau);
  book(tau);
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

/// Beyond an end of the channel.
void FiniteVolumeFlow::fill_ghosts(const CellsView& cells, std::size_t n, bool left, bool right) const {
  const auto fill = [&](const End& end, std::ptrdiff_t ghost, std::ptrdiff_t mirror, std::ptrdiff_t last) {
    const std::ptrdiff_t from = end.kind == End::Kind::wall ? mirror : last;
    const double sign = end.kind == End::Kind::wall ? -1 : 1;
    if (end.kind == End::Kind::inflow) {
      cells.depth[ghost] = end.state.depth;
      cells.discharge[ghost] = end.state.depth * end.state.velocity;
      cells.velocity[ghost] = end.state.velocity;
      cells.celerity[ghost] = shallow_water::celerity(settings_.gravity, end.state.depth);
      return;
    }
    cells.depth[ghost] = cells.depth[from];
    cells.discharge[ghost] = sign * cells.discharge[from];
    cells.velocity[ghost] = sign * cells.velocity[from];
    cells.celerity[ghost] = cells.celerity[from];
  };
  const auto count = static_cast<std::ptrdiff_t>(n);
  for (std::ptrdiff_t k = 0; k < static_cast<std::ptrdiff_t>(ghosts); ++k) {
    if (left) fill(settings_.left, -1 - k, k, 0);
    if (right) fill(settings_.right, count + k, count - 1 - k, count - 1);
  }
}

/// Counted from the first cell of a block, from -reach to reach - 1.
CellsView FiniteVolumeFlow::seam(std::size_t block) {
  return seams_.view().from(static_cast<std::ptrdiff_t>(seam_cells * block) + reach);
}

void FiniteVolumeFlow::save_seams() {
  for (std::size_t b = 1; b < blocks_.size(); ++b) {
    copy(now_.view().from(static_cast<std::ptrdiff_t>(blocks_[b].begin) - reach), 2 * reach, seam(b).from(-reach));
  }
}

/// The cells [from, to) and two more at either side, as they were at the step's start. Counted from cell `from`.
CellsView FiniteVolumeFlow::load(std::size_t block, std::size_t from, std::size_t to, Cells& into) {
  const auto [begin, end] = std::pair(blocks_[block].begin, blocks_[block].end);
  const auto n = static_cast<std::ptrdiff_t>(end - begin);
  const auto before = static_cast<std::ptrdiff_t>(begin - from + ghosts);
  const auto after = static_cast<std::ptrdiff_t>(to - end + ghosts);
  const CellsView whole = now_.view();
  const CellsView cells = into.view();
  const CellsView own = cells.from(static_cast<std::ptrdiff_t>(begin - from));
  copy(whole.from(static_cast<std::ptrdiff_t>(begin)), n, own);
  copy((block > 0 ? seam(block) : whole).from(-before), before, own.from(-before));
  copy(block + 1 < blocks_.size() ? seam(block + 1) : whole.from(static_cast<std::ptrdiff_t>(n_)), after, own.from(n));
  return cells;
}

/// One step of a block. The first of two stages goes through the cells as well that the second one reaches.
void FiniteVolumeFlow::advance(std::size_t number, double tau, Workspace& work) {
  Block& block = blocks_[number];
  const std::size_t n = block.end - block.begin;
  const bool at_left = block.begin == 0;
  const bool at_right = block.end == n_;
  const std::size_t margin = (stages() - 1) * ghosts;
  const std::size_t from = at_left ? 0 : block.begin - margin;
  const std::size_t to = at_right ? n_ : block.end + margin;
  const CellsView all = blocks_.size() > 1 ? load(number, from, to, work.cells) : now_.view();
  const CellsView own = all.from(static_cast<std::ptrdiff_t>(block.begin - from));
  const double ratio = tau / dx_;
  if (stages() > 1) {
    std::copy_n(own.depth, n, work.old_depth.data());
    std::copy_n(own.discharge, n, work.old_discharge.data());
  }
  for (std::size_t stage = 0; stage < stages(); ++stage) {
    const bool last = stage + 1 == stages();
    const CellsView cells = last ? own : all;
    const std::size_t first = last ? block.begin : from;
    const std::size_t count = last ? n : to - from;
    if (stage > 0) fill_ghosts(cells, count, at_left, at_right);
    compute_fluxes(ratio, cells, first, count, work);
    apply_fluxes(ratio, count, work.fluxes, cells);
    // Heun: the mean of the old state and of two Euler steps.
    if (stage > 0) average(work.old_depth.data(), work.old_discharge.data(), n, cells);
    block.stages[stage] = booked(block, first, work.fluxes);
    // A cell that empties is the difference of numbers of the size of the largest depth.
    if (cut_negative(1e-13 * depth_scale_, count, cells) > 0) {
      find_breakdown(block, first, cells, work.fluxes, block.stages[stage]);
    }
    update_primitives(settings_.gravity, settings_.dry_depth, count, cells);
  }
  if (settings_.manning > 0) {
    const double factor = tau * settings_.gravity * settings_.manning * settings_.manning;
    block.friction = apply_friction(factor, settings_.dry_depth, n, own);
  }
  block.fastest = fastest(n, own);
  if (blocks_.size() > 1) {
    copy(own, static_cast<std::ptrdiff_t>(n), now_.view().from(static_cast<std::ptrdiff_t>(block.begin)));
  }
}

/// Of n cells, the channel's from `first` on.
void FiniteVolumeFlow::compute_fluxes(double ratio, const CellsView& cells, std::size_t first, std::size_t n,
                                      Workspace& work) const {
  switch (settings_.scheme) {
    case Scheme::lax_friedrichs:
      lax_friedrichs_fluxes(settings_.gravity, settings_.viscosity, ratio, cells, n, work.fluxes);
      break;
    case Scheme::mac_cormack:
      work.mac_cormack(settings_.gravity, ratio, cells, n, work.fluxes);
      break;
    case Scheme::roe:
      roe_fluxes(settings_.gravity, cells, n, work.fluxes);
      break;
    case Scheme::muscl_hll:
      work.muscl_hll(settings_.gravity, settings_.theta, cells, bed_.empty() ? nullptr : bed_.data() + ghosts + first,
                     n, work.fluxes);
      break;
  }
  // A wall passes no mass: zero by symmetry in every scheme, and here to the last bit.
  if (first == 0 && settings_.left.kind == End::Kind::wall) work.fluxes.mass[0] = 0;
  if (first + n == n_ && settings_.right.kind == End::Kind::wall) work.fluxes.mass[n] = 0;
}

/// What a stage books of fluxes that count from cell `first` on.
FiniteVolumeFlow::Stage FiniteVolumeFlow::booked(const Block& block, std::size_t first, const Fluxes& fluxes) const {
  const std::size_t begin = block.begin - first;
  const std::size_t end = block.end - first;
  const std::vector<double>& on_left = fluxes.momentum;
  const std::vector<double>& on_right = bed_.empty() ? on_left : fluxes.momentum_right;
  Stage stage{.mass_first = fluxes.mass[begin],
              .mass_last = fluxes.mass[end],
              .thrust_first = on_right[begin],
              .thrust_last = on_left[end]};
  if (!bed_.empty()) {
    // The bed acts through the sources and through the steps of the hydrostatic reconstruction at inner faces.
    for (std::size_t i = begin; i < end; ++i) stage.reaction += fluxes.source[i];
    for (std::size_t k = block.begin == 0 ? 1 : begin; k < end; ++k) stage.reaction += on_right[k] - on_left[k];
  }
  return stage;
}

void FiniteVolumeFlow::find_breakdown(const Block& block, std::size_t first, const CellsView& cells,
                                      const Fluxes& fluxes, Stage& stage) const {
  stage.broken = true;
  for (std::size_t i = block.begin - first; i < block.end - first; ++i) {
    // Negative depths were cut before: what is found is the first cell whose update explains one.
    const bool finite = std::isfinite(cells.depth[i]) && std::isfinite(cells.discharge[i]);
    if (finite && !(cells.depth[i] == 0 && fluxes.mass[i + 1] - fluxes.mass[i] > 0)) continue;
    stage.where = first + i;
    stage.finite = finite;
    return;
  }
}

void FiniteVolumeFlow::refuse_breakdown(double tau) const {
  for (std::size_t k = 0; k < stages(); ++k) {
    bool broken = false;
    for (const Block& block : blocks_) {
      const Stage& stage = block.stages[k];
      broken = broken || stage.broken;
      if (!stage.where) continue;
      throw Divergence(fmt::format("cell {} of scheme {}: depth {} (tau = {:g})", *stage.where, name(settings_.scheme),
                                   stage.finite ? "became negative" : "or discharge is not finite", tau),
                       time_, steps_, centre(*stage.where));
    }
    if (broken) {
      throw Divergence(fmt::format("depth of scheme {} became negative", name(settings_.scheme)), time_, steps_,
                       start_);
    }
  }
}

void FiniteVolumeFlow::book(double tau) {
  const double part = tau / static_cast<double>(stages());
  for (std::size_t k = 0; k < stages(); ++k) {
    const Stage& left = blocks_.front().stages[k];
    const Stage& right = blocks_.back().stages[k];
    mass_left_.add(part * left.mass_first);
    mass_right_.add(-part * right.mass_last);
    impulse_left_.add(part * left.thrust_first);
    impulse_right_.add(-part * right.thrust_last);
    if (!bed_.empty()) {
      for (const Block& block : blocks_) impulse_bed_.add(part * block.stages[k].reaction);
    }
  }
  fastest_ = fastest_inflow_;
  for (const Block& block : blocks_) {
    if (settings_.manning > 0) impulse_friction_.add(block.friction * dx_);
    fastest_ = std::max(fastest_, block.fastest);
  }
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
