#include "seiche/models/wcsph/neighbours.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <omp.h>

namespace seiche::wcsph {
namespace {

/// Work on a cluster besides its candidates, in candidates.
constexpr std::size_t overhead = 6;
/// Lists are whole numbers of these.
constexpr std::size_t group = abreast;

void wrap(std::vector<double>& values, double period) {
  if (std::isinf(period)) return;
  for (double& value : values) {
    value -= period * std::floor(value / period);
    // Rounding may give the period itself.
    if (value >= period) value = 0;
  }
}

/// Beyond it the rest counts to the edge; keeps indices within 32 bits.
constexpr double most_bins_across = 20000;

std::int32_t clamped(double place, std::int32_t count) {
  return static_cast<std::int32_t>(std::clamp(place, 0.0, static_cast<double>(count - 1)));
}

}  // namespace

Neighbours::Neighbours(double spacing, const Box& box, Period period, std::size_t lanes)
    : spacing_(spacing), expected_(box), period_(period), lanes_(lanes) {}

Box Neighbours::box_of(const Particles& particles) const {
  const auto [left, right] = std::minmax_element(particles.x.begin(), particles.x.end());
  const auto [bottom, top] = std::minmax_element(particles.z.begin(), particles.z.end());
  // Only periodic boxes have images, which reach outside.
  const double margin_x = std::isinf(period_.x) ? 0 : reach_;
  const double margin_z = std::isinf(period_.z) ? 0 : reach_;
  return {std::max(*left, expected_.left) - margin_x, std::min(*right, expected_.right) + margin_x,
          std::max(*bottom, expected_.bottom) - margin_z, std::min(*top, expected_.top) + margin_z};
}

void Neighbours::sort(Particles& particles, double widest, double reserve) {
  reach_ = 2 * widest + reserve;
  wrap(particles.x, period_.x);
  wrap(particles.z, period_.z);
  grid_ = TileGrid(box_of(particles), spacing_);

  const std::size_t n = particles.size();
  count_ = n;
  order_.resize(n);
  // Sorting is done once in many steps: nothing of it is kept in between.
  std::vector<std::int32_t> members;
  members.reserve(n);
  for (const bool fluid : {true, false}) {
    members.clear();
    for (std::size_t i = 0; i < n; ++i) {
      if ((particles.kind[i] == Kind::fluid) == fluid) members.push_back(static_cast<std::int32_t>(i));
    }
    if (fluid) fluid_count_ = members.size();
    (fluid ? fluid_ : walls_)
        .sort(grid_, particles.x, particles.z, members, std::span(order_).subspan(fluid ? 0 : fluid_count_));
  }
  std::vector<double> scratch;
  for (std::vector<double>* const values :
       {&particles.x, &particles.z, &particles.u, &particles.w, &particles.density, &particles.mass}) {
    reorder(*values, scratch);
  }
  std::vector<Kind> kinds;
  reorder(particles.kind, kinds);
  reorder(particles.body, members);
  reorder(particles.identity, members);

  make_images(particles);
  clusters_.clear();
  clusters_.reserve(n / lanes_ + 2);
  make_clusters(0, fluid_count_);
  fluid_clusters_ = clusters_.size();
  make_clusters(fluid_count_, n);
}

void Neighbours::make_images(const Particles& particles) {
  images_.clear();
  if (std::isinf(period_.x) && std::isinf(period_.z)) return;
  const auto shifts = [this](double place, double period, double(&found)[2]) {
    int count = 0;
    found[count++] = 0;
    if (std::isinf(period)) return count;
    if (place < reach_) {
      found[count++] = period;
    } else if (place > period - reach_) {
      found[count++] = -period;
    }
    return count;
  };
  const std::size_t n = particles.size();
  for (const bool fluid : {true, false}) {
    std::vector<Image> unsorted;
    std::vector<double> image_x;
    std::vector<double> image_z;
    for (std::size_t i = fluid ? 0 : fluid_count_; i < (fluid ? fluid_count_ : n); ++i) {
      double shift_x[2];
      double shift_z[2];
      const int along = shifts(particles.x[i], period_.x, shift_x);
      const int up = shifts(particles.z[i], period_.z, shift_z);
      for (int k = 1; k < along * up; ++k) {
        unsorted.push_back({static_cast<std::int32_t>(i), shift_x[k % along], shift_z[k / along]});
        image_x.push_back(particles.x[i] + unsorted.back().shift_x);
        image_z.push_back(particles.z[i] + unsorted.back().shift_z);
      }
    }
    std::vector<std::int32_t> members(unsorted.size());
    std::vector<std::int32_t> order(unsorted.size());
    std::iota(members.begin(), members.end(), 0);
    (fluid ? fluid_images_ : wall_images_).sort(grid_, image_x, image_z, members, order);
    for (const std::int32_t k : order) images_.push_back(unsorted[static_cast<std::size_t>(k)]);
  }
}

void Neighbours::make_clusters(std::size_t first, std::size_t last) {
  for (std::size_t i = first; i < last; i += lanes_) {
    clusters_.push_back(
        {.first = static_cast<std::int32_t>(i), .count = static_cast<std::int32_t>(std::min(lanes_, last - i))});
  }
}

void Neighbours::collect_ranges(const Box& box, bool walls_too, std::vector<IndexRange>& ranges) const {
  ranges.clear();
  auto offset = std::int32_t{0};
  for (const BinnedOrder* binned : {&fluid_, &walls_, &fluid_images_, &wall_images_}) {
    const bool walls = binned == &walls_ || binned == &wall_images_;
    if (binned->size() > 0 && (walls_too || !walls)) {
      grid_.visit_runs(box, [&](std::int32_t first, std::int32_t last) {
        const IndexRange range{offset + binned->begin(first), offset + binned->begin(last + 1)};
        if (range.begin < range.end) ranges.push_back(range);
      });
    }
    offset += static_cast<std::int32_t>(binned->size());
  }
}

void Neighbours::make_room(std::vector<std::int32_t>& list, std::size_t room, std::size_t first, std::size_t at,
                           std::size_t last) {
  // By what the clusters so far have taken; a few per cent beyond. Doubled instead, half of the lists would be empty.
  const double expected =
      1.03 * static_cast<double>(room) * static_cast<double>(last - first) / static_cast<double>(at - first + 1);
  const std::size_t least = room + room / 32;
  list.reserve(std::clamp(static_cast<std::size_t>(expected), least, 8 * room));
  list.resize(list.capacity());
}

void Neighbours::list_share(const Particles& particles, const Search& search, std::size_t thread, std::size_t threads) {
  const std::size_t first = clusters_.size() * thread / threads;
  const std::size_t last = clusters_.size() * (thread + 1) / threads;
  std::vector<std::int32_t>& list = lists_[thread];
  std::vector<IndexRange>& ranges = ranges_[thread];
  Tally& tally = tallies_[thread];
  const auto nobody = static_cast<std::int32_t>(count_ + images_.size());
  tally = {};
  std::size_t used = 0;
  for (std::size_t c = first; c < last; ++c) {
    Cluster& cluster = clusters_[c];
    const auto a = static_cast<std::size_t>(cluster.first);
    Box box{particles.x[a], particles.x[a], particles.z[a], particles.z[a]};
    for (std::size_t i = a + 1; i < a + static_cast<std::size_t>(cluster.count); ++i) {
      box.left = std::min(box.left, particles.x[i]);
      box.right = std::max(box.right, particles.x[i]);
      box.bottom = std::min(box.bottom, particles.z[i]);
      box.top = std::max(box.top, particles.z[i]);
    }
    const bool fluid = c < fluid_clusters_;
    collect_ranges({box.left - reach_, box.right + reach_, box.bottom - reach_, box.top + reach_}, fluid, ranges);
    // The search writes before it decides, and lists are filled up to whole groups.
    std::size_t room = used + group + candidates_ahead;
    for (const IndexRange& range : ranges) room += static_cast<std::size_t>(range.end - range.begin);
    if (list.size() < room) make_room(list, room, first, c, last);
    const Found found = search(cluster, ranges, list.data() + used);
    used += static_cast<std::size_t>(found.candidates);
    while (used % group != 0) list[used++] = nobody;
    work_before_[c + 1] = static_cast<std::size_t>(found.candidates);
    const std::int32_t pairs = found.pairs - (fluid ? cluster.count : 0);
    tally.pairs += pairs;
    const double mean = static_cast<double>(pairs) / cluster.count;
    if (mean > tally.neighbours) {
      tally.neighbours = mean;
      tally.particle = a;
    }
  }
  // The lists stand still only now.
  const std::int32_t* begin = list.data();
  for (std::size_t c = first; c < last; ++c) {
    const std::size_t count = work_before_[c + 1];
    clusters_[c].begin = begin;
    clusters_[c].end = begin + count;
    begin += (count + group - 1) / group * group;
  }
}

void Neighbours::list(const Particles& particles, const Search& search) {
  const auto threads = clusters_.size() > worth_threads ? static_cast<std::size_t>(omp_get_max_threads()) : 1;
  lists_.resize(std::max(lists_.size(), threads));
  ranges_.resize(lists_.size());
  tallies_.resize(lists_.size());
  work_before_.resize(clusters_.size() + 1);
#pragma omp parallel for schedule(static) num_threads(static_cast <int>(threads))
  for (std::size_t thread = 0; thread < threads; ++thread) list_share(particles, search, thread, threads);
  for (BinnedOrder* const binned : {&fluid_, &walls_, &fluid_images_, &wall_images_}) binned->release();
  std::vector<std::int32_t>().swap(order_);
  pairs_ = 0;
  most_ = {};
  for (std::size_t thread = 0; thread < threads; ++thread) {
    pairs_ += tallies_[thread].pairs;
    if (tallies_[thread].neighbours > most_.neighbours) most_ = tallies_[thread];
  }
  work_before_[0] = 0;
  for (std::size_t c = 0; c < clusters_.size(); ++c) work_before_[c + 1] += work_before_[c] + overhead;
}

std::size_t Neighbours::boundary(std::size_t begin, std::size_t end, std::size_t share, std::size_t shares) const {
  if (share == shares) return end;
  const std::size_t work = work_before_[end] - work_before_[begin];
  const auto first = work_before_.begin();
  const auto found =
      std::lower_bound(first + static_cast<std::ptrdiff_t>(begin), first + static_cast<std::ptrdiff_t>(end),
                       work_before_[begin] + work * share / shares);
  return static_cast<std::size_t>(found - first);
}

TileGrid::TileGrid(const Box& box, double spacing)
    : left_(box.left), bottom_(box.bottom), per_bin_(1 / spacing), per_strip_(1 / (strip_height * spacing)) {
  const double columns = std::min((box.right - box.left) * per_bin_, most_bins_across);
  const double rows = std::min((box.top - box.bottom) * per_strip_, most_bins_across);
  tiles_ = 1 + static_cast<std::int32_t>(columns) / bins_per_tile;
  strips_ = 1 + static_cast<std::int32_t>(rows);
}

std::int32_t TileGrid::column(double x) const {
  return clamped((x - left_) * per_bin_, tiles_ * bins_per_tile);
}

std::int32_t TileGrid::strip(double z) const {
  return clamped((z - bottom_) * per_strip_, strips_);
}

std::int32_t TileGrid::bin(double x, double z) const {
  const std::int32_t c = column(x);
  const std::int32_t k = strip(z);
  const std::int32_t tile = c / bins_per_tile;
  const std::int32_t within = c - tile * bins_per_tile;
  return (tile * strips_ + k) * bins_per_tile + (k % 2 == 0 ? within : bins_per_tile - 1 - within);
}

void BinnedOrder::sort(const TileGrid& grid, std::span<const double> x, std::span<const double> z,
                       std::span<const std::int32_t> members, std::span<std::int32_t> order) {
  size_ = members.size();
  begin_.clear();
  if (size_ == 0) return;
  begin_.assign(static_cast<std::size_t>(grid.size()) + 1, 0);
  std::vector<std::int32_t> bins(size_);
  for (std::size_t k = 0; k < size_; ++k) {
    const auto i = static_cast<std::size_t>(members[k]);
    bins[k] = grid.bin(x[i], z[i]);
    ++begin_[static_cast<std::size_t>(bins[k])];
  }
  // Ends of bins; placing from the back turns them into beginnings.
  std::int32_t total = 0;
  for (std::int32_t& bin : begin_) bin = total += bin;
  for (std::size_t k = size_; k-- > 0;) {
    order[static_cast<std::size_t>(--begin_[static_cast<std::size_t>(bins[k])])] = members[k];
  }
  for (std::int32_t bin = 0; bin < grid.size(); ++bin) {
    const auto first = begin_[static_cast<std::size_t>(bin)];
    const auto last = begin_[static_cast<std::size_t>(bin) + 1];
    const double sign = grid.backwards(bin) ? -1 : 1;
    for (std::int32_t k = first + 1; k < last; ++k) {
      const std::int32_t moving = order[static_cast<std::size_t>(k)];
      const double place = sign * x[static_cast<std::size_t>(moving)];
      std::int32_t to = k;
      for (; to > first; --to) {
        const std::int32_t before = order[static_cast<std::size_t>(to - 1)];
        if (!(place < sign * x[static_cast<std::size_t>(before)])) break;
        order[static_cast<std::size_t>(to)] = before;
      }
      order[static_cast<std::size_t>(to)] = moving;
    }
  }
}

}  // namespace seiche::wcsph
