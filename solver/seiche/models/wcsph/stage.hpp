/// Records of all particles and images at one instant, as the pair loops read them; internal to Flow.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "seiche/models/wcsph/equation_of_state.hpp"
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

/// What the lists were made of.
struct Base {
  std::vector<double> x, z, density;
};

/// Records of one kind, and what goes with them; padded for loops that load whole blocks.
template <class SomeRecord>
struct Held {
  using Real = typename RealOf<SomeRecord>::Type;
  std::vector<SomeRecord> records;
  std::vector<Real> mass;
  std::vector<StressOf<Real>> stress;  ///< empty where stresses were not asked for
};

/// What numbers of mixed records are in terms of; ones and zeros beside full records.
struct Units {
  double place = 1;             ///< [m]
  double left = 0, bottom = 0;  ///< where places are 0 [m]
  double per_length = 1;        ///< 1/h_0 [1/m]
  double density = 1;           ///< rho_0 [kg/m^3]
};

/// Widest domain of mixed records, over h_0: places are resolved to 3e-5 of it there.
inline constexpr double widest_mixed_domain = 1 << 15;

class Stage {
 public:
  /// The state of particles first, ..., first + count - 1.
  using Source = std::function<void(std::size_t first, std::size_t count, StateBlock& block)>;

  /// @param smoothing  h_0; @param stresses  of eddies are asked for
  Stage(const TaitFluid& fluid, double smoothing, double sound_scale, bool stresses, Storage storage);

  /// After a sorting: records of the particles and their images, new masses; what displacements are measured from.
  void adopt(const Particles& particles, std::span<const Image> images);
  /// Returns how much of the reserve of the lists is used up: twice the largest displacement and growth of h since
  /// adopt().
  double fill(const Particles& particles);
  double fill(const Source& source);
  /// Density of one particle, and what follows from it.
  void set_density(std::size_t i, double density);
  /// Copies what changed since fill() to the images.
  void refresh_images();
  void refresh_volumes();
  void refresh_image_stresses();

  /// Of particles and images. Empty for the kind that is not this storage's.
  template <class SomeRecord>
  [[nodiscard]] Held<SomeRecord>& held() {
    if constexpr (sizeof(SomeRecord) == sizeof(Record)) {
      return full_;
    } else {
      return mixed_;
    }
  }
  /// In double precision.
  [[nodiscard]] std::span<const Record> records() const { return full_.records; }
  [[nodiscard]] const std::vector<double>& mass() const { return full_.mass; }
  [[nodiscard]] const Units& units() const { return units_; }
  /// Of adopt().
  [[nodiscard]] const Base& base() const { return base_; }
  [[nodiscard]] double sound_scale() const { return sound_scale_; }

 private:
  /// What follows from the densities of a block.
  struct Derived;
  [[nodiscard]] Derived derived(const double* density, std::size_t count) const;
  void smoothing_of(const double* density, std::size_t count, double* smoothing) const;
  void adopt_mixed(const Particles& particles);
  void write_records(const StateBlock& state, const Derived& derived, std::size_t first, std::size_t count);
  [[nodiscard]] double used(const StateBlock& state, const Derived& derived, std::size_t first,
                            std::size_t count) const;

  TaitFluid fluid_;
  double smoothing_;
  double sound_scale_;
  bool stresses_;
  Storage storage_;
  Units units_;
  std::size_t count_ = 0;
  std::span<const Image> images_;
  Held<Record> full_;
  Held<MixedRecord> mixed_;
  Base base_;
};

}  // namespace seiche::wcsph
