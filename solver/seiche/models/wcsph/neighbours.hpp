/// Who may be within whose support: the order of particles, their images in a periodic box, clusters and their lists of
/// candidates; internal to Flow.
///
/// Records are numbered: fluid, walls (both in the order of the grid), images of fluid, images of walls, and one far
/// away that fills up lists (beyond Cluster::end) to whole groups. Lists hold
/// what is nearer than h_a + h_b + reserve, so they last until displacements and growing smoothing lengths use up the
/// reserve. Wall clusters list fluid only: pairs of wall particles are not evaluated. Lists go by increasing numbers,
/// and who is too far away adds nothing: sums depend on the order of the particles alone, not on where lists were made.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "seiche/linear/worth_threads.hpp"
#include "seiche/models/wcsph/pair_loops.hpp"
#include "seiche/models/wcsph/particles.hpp"
#include "seiche/models/wcsph/settings.hpp"

namespace seiche::wcsph {

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

  /// New order of the particles: fluid first, both kinds by places in the plane. Wraps positions into the box.
  void sort(Particles& particles);
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
  /// Images and clusters of particles that are in their order.
  /// @param widest  longest smoothing length
  void arrange(const Particles& particles, double widest, double reserve);
  /// Lists for the records of particles and images.
  void list(std::span<const Record> records, CandidateSearch search, double reserve);

  [[nodiscard]] std::size_t particles() const { return count_; }
  [[nodiscard]] std::size_t fluid() const { return fluid_count_; }
  [[nodiscard]] bool is_fluid(std::size_t record) const {
    return record < fluid_count_ || (record >= count_ && record < count_ + fluid_images_);
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

  /// Calls loop(first, last) for shares of the clusters [begin, end), on all threads.
  template <class Loop>
  void share(std::size_t begin, std::size_t end, const Loop& loop) const {
    constexpr std::size_t together = 64;
#pragma omp parallel for schedule(dynamic) if (end - begin > worth_threads)
    for (std::size_t first = begin; first < end; first += together) loop(first, std::min(first + together, end));
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

  class Boxes;

  void make_images(const Particles& particles);
  void make_clusters(std::size_t first, std::size_t last);
  /// The lists of the clusters [first, last).
  Tally list_share(std::span<const Record> records, const Boxes& boxes, CandidateSearch search, double reserve,
                   std::size_t first, std::size_t last, std::vector<std::int32_t>& list);
  /// Makes room for so many candidates in a list that has come so far through the clusters [first, last).
  static void make_room(std::vector<std::int32_t>& list, std::size_t room, std::size_t first, std::size_t at,
                        std::size_t last);

  double spacing_;
  Box expected_;
  Period period_;
  std::size_t lanes_;
  double reach_ = 0;  ///< longest distance of a candidate
  std::size_t count_ = 0;
  std::size_t fluid_count_ = 0;
  std::vector<std::int32_t> order_;
  std::vector<Image> images_;
  std::size_t fluid_images_ = 0;
  std::vector<Cluster> clusters_;
  std::size_t fluid_clusters_ = 0;
  std::vector<std::vector<std::int32_t>> lists_;  ///< one per thread
  long long pairs_ = 0;
  Tally most_;
};

}  // namespace seiche::wcsph
