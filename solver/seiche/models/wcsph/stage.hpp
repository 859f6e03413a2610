/// Records of all particles and images at one instant, as the pair loops read them; internal to Flow.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "seiche/models/wcsph/equation_of_state.hpp"
#include "seiche/models/wcsph/neighbours.hpp"
#include "seiche/models/wcsph/pair_loops.hpp"
#include "seiche/models/wcsph/particles.hpp"

namespace seiche::wcsph {

/// What a step advances.
struct State {
  std::vector<double> x, z, u, w, density;
  void resize(std::size_t n);
};

/// Arrays of a State or of Particles.
struct StateView {
  const double *x, *z, *u, *w, *density;
  explicit StateView(const State& state);
  explicit StateView(const Particles& particles);
};

class Stage {
 public:
  /// @param smoothing  h_0; @param variable  h = h_0 (rho_0/rho)^(1/2) instead of h_0
  Stage(const TaitFluid& fluid, double smoothing, bool variable, double sound_scale);

  /// After a sorting: new masses and images; the next fill() is what displacements are measured from.
  void adopt(const Particles& particles, std::span<const Image> images);
  /// Returns how much of the reserve of the lists is used up: twice the largest displacement and growth of h since the
  /// first fill() after adopt().
  double fill(const StateView& state);
  /// Density of one particle, and what follows from it.
  void set_density(std::size_t i, double density);
  /// Copies what changed since fill() to the images.
  void refresh_images();
  void refresh_volumes();
  void refresh_image_stresses();

  /// Particles and images; padded for loops that load whole blocks.
  [[nodiscard]] std::span<const Record> records() const { return records_; }
  [[nodiscard]] const std::vector<double>& mass() const { return mass_; }
  [[nodiscard]] std::vector<Stress>& stress() { return stress_; }
  [[nodiscard]] double sound_scale() const { return sound_scale_; }

 private:
  double fill_range(const StateView& state, std::size_t first, std::size_t last);

  TaitFluid fluid_;
  double smoothing_;
  bool variable_;
  double sound_scale_;
  std::size_t count_ = 0;
  std::span<const Image> images_;
  bool fresh_ = false;
  std::vector<Record> records_;
  std::vector<double> mass_;
  std::vector<Stress> stress_;
  std::vector<double> base_x_, base_z_, base_smoothing_;
};

}  // namespace seiche::wcsph
