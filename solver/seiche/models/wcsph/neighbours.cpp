#include "seiche/models/wcsph/neighbours.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

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

/// Order of particles in the plane: tiles of strips of bins.
///
/// A strip is a few particle spacings high, a bin one spacing wide. Within a strip particles go by x, in every second
/// strip backwards, so that consecutive ones stay near each other across its ends; strips are cut into tiles, so that
/// neighbours above and below stay in cache however long the tank. What lies outside the box counts to its edge:
/// neighbouring places stay neighbours.
class TileGrid {
 public:
  TileGrid(const Box& box, double spacing)
      : left_(box.left), bottom_(box.bottom), per_bin_(1 / spacing), per_strip_(1 / (strip_height * spacing)) {
    const double columns = std::min((box.right - box.left) * per_bin_, most_bins_across);
    const double rows = std::min((box.top - box.bottom) * per_strip_, most_bins_across);
    tiles_ = 1 + static_cast<std::int32_t>(columns) / bins_per_tile;
    strips_ = 1 + static_cast<std::int32_t>(rows);
  }

  [[nodiscard]] std::int32_t bins() const { return tiles_ * strips_ * bins_per_tile; }
  /// Counted along the order.
  [[nodiscard]] std::int32_t bin(double x, double z) const {
    const auto clamped = [](double place, std::int32_t count) {
      return static_cast<std::int32_t>(std::clamp(place, 0.0, static_cast<double>(count - 1)));
    };
    const std::int32_t column = clamped((x - left_) * per_bin_, tiles_ * bins_per_tile);
    const std::int32_t strip = clamped((z - bottom_) * per_strip_, strips_);
    const std::int32_t tile = column / bins_per_tile;
    const std::int32_t within = column - tile * bins_per_tile;
    return (tile * strips_ + strip) * bins_per_tile + (strip % 2 == 0 ? within : bins_per_tile - 1 - within);
  }
  [[nodiscard]] bool backwards(std::int32_t bin) const { return bin / bins_per_tile % strips_ % 2 != 0; }

 private:
  static constexpr std::int32_t bins_per_tile = 64;
  /// In spacings: eight particles fill about a square.
  static constexpr double strip_height = 3;
  /// Beyond it the rest counts to the edge; keeps indices within 32 bits.
  static constexpr double most_bins_across = 20000;

  double left_, bottom_, per_bin_, per_strip_;
  std::int32_t tiles_, strips_;
};

}  // namespace

/// Boxes around runs of consecutive records, and around runs of those, and so on: what is near a box is found in any
/// order of the records, the sooner the nearer consecutive ones are to each other.
class Neighbours::Boxes {
 public:
  explicit Boxes(std::span<const Record> records) : count_(records.size()), levels_(1) {
    for (std::size_t first = 0; first < count_; first += run) {
      Box box = nothing;
      for (const Record& record : records.subspan(first, std::min(run, count_ - first))) {
        extend(box, {record.x, record.x, record.z, record.z});
      }
      levels_.front().push_back(box);
    }
    while (levels_.back().size() > run) {
      std::vector<Box> above((levels_.back().size() + run - 1) / run, nothing);
      for (std::size_t k = 0; k < levels_.back().size(); ++k) extend(above[k / run], levels_.back()[k]);
      levels_.push_back(std::move(above));
    }
  }

  static constexpr Box nothing{unbounded.right, unbounded.left, unbounded.top, unbounded.bottom};
  static void extend(Box& box, const Box& other) {
    box.left = std::min(box.left, other.left);
    box.right = std::max(box.right, other.right);
    box.bottom = std::min(box.bottom, other.bottom);
    box.top = std::max(box.top, other.top);
  }

  /// Appends the runs of records of `among` that have some in the box, going up.
  void collect(const Box& box, IndexRange among, std::vector<IndexRange>& ranges) const {
    collect(box, among, ranges, levels_.size() - 1, 0, levels_.back().size());
  }

 private:
  static constexpr std::size_t run = 8;

  void collect(const Box& box, IndexRange among, std::vector<IndexRange>& ranges, std::size_t level, std::size_t first,
               std::size_t last) const {
    for (std::size_t k = first; k < last; ++k) {
      const Box& other = levels_[level][k];
      if (other.left > box.right || other.right < box.left || other.bottom > box.top || other.top < box.bottom)
        continue;
      const std::size_t end = std::min((k + 1) * run, level > 0 ? levels_[level - 1].size() : count_);
      if (level > 0) {
        collect(box, among, ranges, level - 1, k * run, end);
        continue;
      }
      const IndexRange range{std::max(static_cast<std::int32_t>(k * run), among.begin),
                             std::min(static_cast<std::int32_t>(end), among.end)};
      if (range.begin >= range.end) continue;
      if (!ranges.empty() && ranges.back().end == range.begin) {
        ranges.back().end = range.end;
      } else {
        ranges.push_back(range);
      }
    }
  }

  std::size_t count_;
  std::vector<std::vector<Box>> levels_;
};

Neighbours::Neighbours(double spacing, const Box& box, Period period, std::size_t lanes)
    : spacing_(spacing), expected_(box), period_(period), lanes_(lanes) {}

void Neighbours::sort(Particles& particles) {
  wrap(particles.x, period_.x);
  wrap(particles.z, period_.z);
  const auto [left, right] = std::minmax_element(particles.x.begin(), particles.x.end());
  const auto [bottom, top] = std::minmax_element(particles.z.begin(), particles.z.end());
  const TileGrid grid({std::max(*left, expected_.left), std::min(*right, expected_.right),
                       std::max(*bottom, expected_.bottom), std::min(*top, expected_.top)},
                      spacing_);
  std::vector<std::int32_t> bins(particles.size());  // those of walls after those of fluid
  for (std::size_t i = 0; i < bins.size(); ++i) {
    bins[i] = grid.bin(particles.x[i], particles.z[i]) + (particles.kind[i] == Kind::fluid ? 0 : grid.bins());
  }
  const auto key = [&](std::int32_t particle) {
    const auto i = static_cast<std::size_t>(particle);
    return std::tuple(bins[i], grid.backwards(bins[i]) ? -particles.x[i] : particles.x[i], particle);
  };
  order_.resize(particles.size());
  std::iota(order_.begin(), order_.end(), 0);
  std::sort(order_.begin(), order_.end(), [&](std::int32_t a, std::int32_t b) { return key(a) < key(b); });
  std::vector<double> scratch;
  for (std::vector<double>* const values :
       {&particles.x, &particles.z, &particles.u, &particles.w, &particles.density, &particles.mass}) {
    reorder(*values, scratch);
  }
  std::vector<Kind> kinds;
  reorder(particles.kind, kinds);
  reorder(particles.body, bins);
  reorder(particles.identity, bins);
}

void Neighbours::arrange(const Particles& particles, double widest, double reserve) {
  reach_ = 2 * widest + reserve;
  count_ = particles.size();
  fluid_count_ = particles.count(Kind::fluid);
  make_images(particles);
  clusters_.clear();
  clusters_.reserve(count_ / lanes_ + 2);
  make_clusters(0, fluid_count_);
  fluid_clusters_ = clusters_.size();
  make_clusters(fluid_count_, count_);
}

void Neighbours::make_images(const Particles& particles) {
  images_.clear();
  fluid_images_ = 0;
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
  for (std::size_t i = 0; i < count_; ++i) {
    double shift_x[2];
    double shift_z[2];
    const int along = shifts(particles.x[i], period_.x, shift_x);
    const int up = shifts(particles.z[i], period_.z, shift_z);
    for (int k = 1; k < along * up; ++k) {
      images_.push_back({static_cast<std::int32_t>(i), shift_x[k % along], shift_z[k / along]});
      if (i < fluid_count_) ++fluid_images_;
    }
  }
}

void Neighbours::make_clusters(std::size_t first, std::size_t last) {
  for (std::size_t i = first; i < last; i += lanes_) {
    clusters_.push_back(
        {.first = static_cast<std::int32_t>(i), .count = static_cast<std::int32_t>(std::min(lanes_, last - i))});
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

void Neighbours::list_share(const Listing& listing, std::size_t thread, std::size_t threads) {
  const std::size_t first = clusters_.size() * thread / threads;
  const std::size_t last = clusters_.size() * (thread + 1) / threads;
  const auto first_image = static_cast<std::int32_t>(count_);
  const auto nobody = static_cast<std::int32_t>(count_ + images_.size());
  std::vector<std::int32_t>& list = lists_[thread];
  std::vector<IndexRange> ranges;
  Tally& tally = tallies_[thread];
  tally = {};
  std::size_t used = 0;
  for (std::size_t c = first; c < last; ++c) {
    Cluster& cluster = clusters_[c];
    const auto a = static_cast<std::size_t>(cluster.first);
    Box box = Boxes::nothing;
    for (const Record& record : listing.records.subspan(a, static_cast<std::size_t>(cluster.count))) {
      Boxes::extend(box, {record.x - reach_, record.x + reach_, record.z - reach_, record.z + reach_});
    }
    const bool fluid = c < fluid_clusters_;
    ranges.clear();
    if (fluid) {
      listing.boxes.collect(box, {0, nobody}, ranges);
    } else {
      listing.boxes.collect(box, {0, static_cast<std::int32_t>(fluid_count_)}, ranges);
      listing.boxes.collect(box, {first_image, first_image + static_cast<std::int32_t>(fluid_images_)}, ranges);
    }
    // The search writes before it decides, and lists are filled up to whole groups.
    std::size_t room = used + group + candidates_ahead;
    for (const IndexRange& range : ranges) room += static_cast<std::size_t>(range.end - range.begin);
    if (list.size() < room) make_room(list, room, first, c, last);
    const Found found = listing.search(listing.records.data(), listing.reserve, cluster, ranges.data(), ranges.size(),
                                       list.data() + used);
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

void Neighbours::list(std::span<const Record> records, CandidateSearch search, double reserve) {
  const auto threads = clusters_.size() > worth_threads ? static_cast<std::size_t>(omp_get_max_threads()) : 1;
  lists_.resize(std::max(lists_.size(), threads));
  tallies_.resize(lists_.size());
  work_before_.resize(clusters_.size() + 1);
  const Boxes boxes(records.first(count_ + images_.size()));
  const Listing listing{records, boxes, search, reserve};
#pragma omp parallel for schedule(static) num_threads(static_cast <int>(threads))
  for (std::size_t thread = 0; thread < threads; ++thread) list_share(listing, thread, threads);
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

}  // namespace seiche::wcsph
