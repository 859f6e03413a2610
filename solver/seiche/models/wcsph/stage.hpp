/// Records of all particles and images at one instant, as the pair loops read them; internal to Flow.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "seiche/models/wcsph/neighbours.hpp"
#include "seiche/models/wcsph/pair_loops.hpp"
#include "seiche/models/wcsph/particles.hpp"
#include "seiche/models/wcsph/settings.hpp"

namespace seiche::wcsph {

/// What a step advances, of a few particles at a time.
struct StateBlock {
  static constexpr std::size_t size = 64;
  std::array<double, size> x, z, u, w, density;
};

/// The same five quantities of both: (x, x), ..., (density, density).
template <class All, class Others>
auto matched(All& all, Others& others) {
  return std::array{std::pair{&all.x, &others.x}, std::pair{&all.z, &others.z}, std::pair{&all.u, &others.u},
                    std::pair{&all.w, &others.w}, std::pair{&all.density, &others.density}};
}

/// Calls work(first, count, found) for blocks of the particles first, ..., last - 1, on all threads if they are many;
/// found.add(what another thread found) must not mind the order.
template <class Found, class Work>
Found over_blocks(std::size_t first, std::size_t last, const Work& work) {
  Found all;
  const std::size_t blocks = (last - first + StateBlock::size - 1) / StateBlock::size;
#pragma omp parallel if (blocks > 32)
  {
    Found own;
#pragma omp for schedule(static) nowait
    for (std::size_t b = 0; b < blocks; ++b) {
      const std::size_t begin = first + b * StateBlock::size;
      work(begin, std::min(StateBlock::size, last - begin), own);
    }
#pragma omp critical(wcsph_over_blocks)
    all.add(own);
  }
  return all;
}

class Stage {
 public:
  /// The state of particles first, ..., first + count - 1.
  using Source = std::function<void(std::size_t first, std::size_t count, StateBlock& block)>;

  /// @param smoothing  h_0; @param stresses  of eddies are asked for; @param walls_keep  h_0, see WallPressure
  Stage(const TaitFluid& fluid, double smoothing, bool stresses, bool walls_keep)
      : fluid_(fluid), smoothing_(smoothing), stresses_(stresses), walls_keep_(walls_keep) {}

  /// Records of the particles and their images, whose lists are going to be made.
  /// @param used  of their reserve, see fill()
  void adopt(const Particles& particles, std::span<const Image> images, double used);
  /// Returns how much of the reserve of the lists is used up: twice what has been the largest displacement and growth
  /// of h from one filling to the next, summed since adopt(). What is longest in one place is hardly ever so in
  /// another: the sum is little more than the largest of sums, for which places of all particles would have to be kept.
  double fill(const Particles& particles);
  double fill(const Source& source, std::size_t begin = 0);
  [[nodiscard]] double used() const { return used_; }
  void refresh_volumes();

  /// Of particles and images, padded for loops that load whole blocks.
  [[nodiscard]] std::span<const Record> records() const { return records_; }
  [[nodiscard]] std::vector<Stress>& stress() { return stress_; }  ///< empty where stresses were not asked for
  /// With what all loops read.
  [[nodiscard]] PairWork work(const Neighbours& neighbours, PairWork work = {}) const {
    work.records = records_.data();
    work.clusters = neighbours.clusters().data();
    return work;
  }

 private:
  TaitFluid fluid_;
  double smoothing_;
  bool stresses_;
  bool walls_keep_;
  std::size_t count_ = 0;
  std::size_t varying_ = 0;  ///< so many particles have the h of their density, the others h_0
  std::span<const Image> images_;
  std::vector<Record> records_;
  std::vector<Stress> stress_;
  double used_ = 0;
};

}  // namespace seiche::wcsph
