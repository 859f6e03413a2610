/// Who may be within whose support: the order of particles, their images in a periodic box, clusters and their lists of
/// candidates; internal to Flow.
///
/// Records are numbered: fluid, walls (both in the order of the grid), images of fluid, images of walls, and one far
/// away that fills up lists (beyond Cluster::end) to whole groups. Lists hold
/// what is nearer than h_a + h_b + reserve, so they last until displacements and growing smoothing lengths use up the
/// reserve. Wall clusters list fluid only: pairs of wall particles are not evaluated.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include <omp.h>

#include "seiche/linear/worth_threads.hpp"
#include "seiche/models/wcsph/pair_loops.hpp"
#include "seiche/models/wcsph/particles.hpp"
#include "seiche/models/wcsph/settings.hpp"

namespace seiche::wcsph {

/// Order of particles in the plane: tiles of strips of bins; internal to Flow.
///
/// A strip is a few particle spacings high, a bin one spacing wide. Within a strip particles go by x, in every second
/// strip backwards, so that consecutive ones stay near each other across its ends; strips are cut into tiles, so that
/// neighbours above and below stay in cache however long the tank. What lies outside the box counts to its edge:
/// neighbouring places stay neighbours.
class TileGrid {
 public:
  TileGrid() = default;
  TileGrid(const Box& box, double spacing);

  [[nodiscard]] std::int32_t size() const { return tiles_ * strips_ * bins_per_tile; }
  [[nodiscard]] std::int32_t bin(double x, double z) const;
  /// Whether particles of this bin go by decreasing x.
  [[nodiscard]] bool backwards(std::int32_t bin) const { return (bin / bins_per_tile) % strips_ % 2 != 0; }

  /// Calls visit(first, last) with the bins that the box touches, as few runs of consecutive ones.
  template <class Visit>
  void visit_runs(const Box& box, Visit visit) const {
    const std::int32_t left = column(box.left);
    const std::int32_t right = column(box.right);
    const std::int32_t bottom = strip(box.bottom);
    const std::int32_t top = strip(box.top);
    for (std::int32_t tile = left / bins_per_tile; tile <= right / bins_per_tile; ++tile) {
      const std::int32_t begin = tile * bins_per_tile;
      const std::int32_t low = left > begin ? left - begin : 0;
      const std::int32_t high = right - begin < bins_per_tile ? right - begin : bins_per_tile - 1;
      for (std::int32_t k = bottom; k <= top; ++k) {
        const std::int32_t base = (tile * strips_ + k) * bins_per_tile;
        if (k % 2 == 0) {
          visit(base + low, base + high);
        } else {
          visit(base + bins_per_tile - 1 - high, base + bins_per_tile - 1 - low);
        }
      }
    }
  }

 private:
  static constexpr std::int32_t bins_per_tile = 64;
  /// In spacings: eight particles fill about a square.
  static constexpr double strip_height = 3;

  [[nodiscard]] std::int32_t column(double x) const;
  [[nodiscard]] std::int32_t strip(double z) const;

  double left_ = 0;
  double bottom_ = 0;
  double per_bin_ = 0;
  double per_strip_ = 0;
  std::int32_t tiles_ = 0;
  std::int32_t strips_ = 0;
};

/// Where each bin begins among particles of one kind in the order of a grid.
class BinnedOrder {
 public:
  /// Writes the members in their new order. Stable: particles in the same place keep theirs.
  void sort(const TileGrid& grid, std::span<const double> x, std::span<const double> z,
            std::span<const std::int32_t> members, std::span<std::int32_t> order);
  /// Place in the order of the first particle of a bin.
  [[nodiscard]] std::int32_t begin(std::int32_t bin) const { return begin_[static_cast<std::size_t>(bin)]; }
  [[nodiscard]] std::size_t size() const { return size_; }
  /// Gives back the memory of the bins, of which an empty tank has many, until the next sorting.
  void release() { std::vector<std::int32_t>().swap(begin_); }

 private:
  std::size_t size_ = 0;
  std::vector<std::int32_t> begin_;
};

/// A record that repeats another one a period away.
struct Image {
  std::int32_t source;
  double shift_x, shift_z;
};

class Neighbours {
 public:
  /// @param spacing  mean distance of particles [m]
  /// @param box      where particles are to be expected; sorted less well outside
  /// @param lanes    particles of a cluster
  Neighbours(double spacing, const Box& box, Period period, std::size_t lanes);

  /// New order of the particles: fluid first. Wraps positions into the box. `widest` is the longest smoothing length.
  void sort(Particles& particles, double widest, double reserve);
  /// New numbers of the particles before the last sort(): what was at order()[i] is now at i. Until list(), which gives
  /// back its memory.
  [[nodiscard]] std::span<const std::int32_t> order() const { return order_; }
  /// Values of the particles before the last sort(), in their new order. Arrays of one size can share a scratch.
  template <class T>
  void reorder(std::vector<T>& values, std::vector<T>& scratch) const {
    scratch.resize(order_.size());
    for (std::size_t i = 0; i < scratch.size(); ++i) scratch[i] = values[static_cast<std::size_t>(order_[i])];
    values.swap(scratch);
  }
  /// Appends the candidates of a cluster among ranges of records to the list; see CandidateSearch.
  using Search = std::function<Found(const Cluster& cluster, std::span<const IndexRange> ranges, std::int32_t* list)>;
  /// Lists for the particles, at the places of the last sort().
  void list(const Particles& particles, const Search& search);

  [[nodiscard]] std::size_t particles() const { return count_; }
  [[nodiscard]] std::size_t fluid() const { return fluid_count_; }
  [[nodiscard]] bool is_fluid(std::size_t record) const {
    return record < fluid_count_ || (record >= count_ && record < count_ + fluid_images_.size());
  }
  [[nodiscard]] std::span<const Image> images() const { return images_; }
  /// What a loop found of particles, for their images.
  template <class T>
  void copy_to_images(std::vector<T>& values) const {
    for (std::size_t k = 0; k < images_.size(); ++k) {
      values[count_ + k] = values[static_cast<std::size_t>(images_[k].source)];
    }
  }
  [[nodiscard]] std::span<const Cluster> clusters() const { return clusters_; }
  [[nodiscard]] std::size_t fluid_clusters() const { return fluid_clusters_; }
  /// Ordered pairs within the support, fluid with fluid or walls.
  [[nodiscard]] long long pairs() const { return pairs_; }
  /// Largest mean number of neighbours of a cluster's particles.
  [[nodiscard]] double most_neighbours() const { return most_.neighbours; }
  /// First particle of that cluster.
  [[nodiscard]] std::size_t most_crowded() const { return most_.particle; }

  /// Calls loop(first, last) for shares of the clusters [begin, end) of about equal work, on all threads.
  template <class Loop>
  void share(std::size_t begin, std::size_t end, const Loop& loop) const {
#pragma omp parallel if (end - begin > worth_threads)
    {
      const auto threads = static_cast<std::size_t>(omp_get_num_threads());
      const auto thread = static_cast<std::size_t>(omp_get_thread_num());
      const std::size_t first = boundary(begin, end, thread, threads);
      const std::size_t last = boundary(begin, end, thread + 1, threads);
      if (first < last) loop(first, last);
    }
  }

  /// The loop over all clusters of the fluid.
  void over_fluid(PairLoop loop, const PairWork& work) const {
    share(0, fluid_clusters_, [&](std::size_t first, std::size_t last) { loop(work, first, last); });
  }

 private:
  /// Clusters below which one thread does it all: a pass over 4096 particles takes a millisecond, less than a time
  /// slice on a machine whose cores are busy.
  static constexpr std::size_t worth_threads = linear::threads_from(4096) / static_cast<std::size_t>(abreast);

  struct Tally {
    long long pairs = 0;
    double neighbours = 0;     ///< largest mean of a cluster
    std::size_t particle = 0;  ///< its first particle
  };

  void make_images(const Particles& particles);
  void make_clusters(std::size_t first, std::size_t last);
  [[nodiscard]] Box box_of(const Particles& particles) const;
  void list_share(const Particles& particles, const Search& search, std::size_t thread, std::size_t threads);
  /// Makes room for so many candidates in a list that has come so far through the clusters [first, last).
  static void make_room(std::vector<std::int32_t>& list, std::size_t room, std::size_t first, std::size_t at,
                        std::size_t last);
  void collect_ranges(const Box& box, bool walls_too, std::vector<IndexRange>& ranges) const;
  /// First cluster of a share.
  [[nodiscard]] std::size_t boundary(std::size_t begin, std::size_t end, std::size_t share, std::size_t shares) const;

  double spacing_;
  Box expected_;
  Period period_;
  std::size_t lanes_;
  double reach_ = 0;  ///< longest distance of a candidate
  TileGrid grid_;
  BinnedOrder fluid_, walls_, fluid_images_, wall_images_;
  std::size_t count_ = 0;
  std::size_t fluid_count_ = 0;
  std::vector<std::int32_t> order_;
  std::vector<Image> images_;
  std::vector<Cluster> clusters_;
  std::size_t fluid_clusters_ = 0;
  std::vector<std::vector<std::int32_t>> lists_;  ///< one per thread
  std::vector<std::vector<IndexRange>> ranges_;   ///< one per thread
  std::vector<Tally> tallies_;                    ///< one per thread
  std::vector<std::size_t> work_before_;          ///< candidates and overhead of all earlier clusters
  long long pairs_ = 0;
  Tally most_;
};

}  // namespace seiche::wcsph
