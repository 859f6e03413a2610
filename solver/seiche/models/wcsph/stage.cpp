#include "seiche/models/wcsph/stage.hpp"

#include <algorithm>
#include <cmath>

#include "seiche/simd_clones.hpp"

namespace seiche::wcsph {
namespace {

/// (5) for gamma = 7 without powers.
SEICHE_SIMD_CLONES void derive_seventh(const double* density, std::size_t count, double reference, double stiffness,
                                       double scaled_sound, double* pressure, double* sound) {
  const double inverse = 1 / reference;
  for (std::size_t k = 0; k < count; ++k) {
    const double s = density[k] * inverse;
    const double cube = s * s * s;
    pressure[k] = stiffness * (cube * cube * s - 1) / (density[k] * density[k]);
    sound[k] = scaled_sound * cube;
  }
}

/// h of each density.
SEICHE_SIMD_CLONES void smoothing_lengths(const double* density, std::size_t count, double reference, double h,
                                          double* smoothing) {
  const double inverse = 1 / reference;
  for (std::size_t k = 0; k < count; ++k) smoothing[k] = h / std::sqrt(density[k] * inverse);
}

}  // namespace

struct Stage::Derived {
  std::array<double, StateBlock::size> pressure, sound, smoothing;
};

Stage::Stage(const TaitFluid& fluid, double smoothing, double sound_scale, bool stresses)
    : fluid_(fluid), smoothing_(smoothing), sound_scale_(sound_scale), stresses_(stresses) {}

void Stage::adopt(const Particles& particles, std::span<const Image> images) {
  count_ = particles.size();
  images_ = images;
  const std::size_t padded = count_ + images.size() + most_lanes;
  // Far from everything, finite in all that the loops compute of it.
  constexpr double far = 1e30;
  constexpr Record nobody{.x = far, .z = far, .u = 0, .w = 0, .density = 1, .pressure = 0, .smoothing = 1, .sound = 0};
  records_.resize(padded);
  std::fill(records_.begin() + static_cast<std::ptrdiff_t>(count_ + images.size()), records_.end(), nobody);
  mass_.assign(padded, 0);
  std::copy(particles.mass.begin(), particles.mass.end(), mass_.begin());
  for (std::size_t k = 0; k < images.size(); ++k) mass_[count_ + k] = mass_[static_cast<std::size_t>(images[k].source)];
  if (stresses_) stress_.assign(padded, {});
  base_.x = particles.x;
  base_.z = particles.z;
  base_.density = particles.density;
  fill(particles);
}

void Stage::smoothing_of(const double* density, std::size_t count, double* smoothing) const {
  smoothing_lengths(density, count, fluid_.reference_density(), smoothing_, smoothing);
}

Stage::Derived Stage::derived(const double* density, std::size_t count) const {
  Derived derived;
  derive_seventh(density, count, fluid_.reference_density(), fluid_.stiffness(),
                 sound_scale_ * fluid_.reference_sound_speed(), derived.pressure.data(), derived.sound.data());
  smoothing_of(density, count, derived.smoothing.data());
  return derived;
}

void Stage::write_records(const StateBlock& state, const Derived& derived, std::size_t first, std::size_t count) {
  for (std::size_t k = 0; k < count; ++k) {
    records_[first + k] = {.x = state.x[k],
                           .z = state.z[k],
                           .u = state.u[k],
                           .w = state.w[k],
                           .density = state.density[k],
                           .pressure = derived.pressure[k],
                           .smoothing = derived.smoothing[k],
                           .sound = derived.sound[k]};
  }
}

double Stage::used(const StateBlock& state, const Derived& derived, std::size_t first, std::size_t count) const {
  std::array<double, StateBlock::size> smoothing;
  smoothing_of(&base_.density[first], count, smoothing.data());
  double used = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t i = first + k;
    const double x = state.x[k] - base_.x[i];
    const double z = state.z[k] - base_.z[i];
    const double growth = derived.smoothing[k] - smoothing[k];
    used = std::max(used, std::sqrt(x * x + z * z) + (growth > 0 ? growth : 0));
  }
  return 2 * used;
}

double Stage::fill(const Source& source) {
  struct Largest {
    double used = 0;
    void add(Largest other) { used = std::max(used, other.used); }
  };
  const auto largest = over_blocks<Largest>(0, count_, [&](std::size_t first, std::size_t count, Largest& found) {
    StateBlock block;
    source(first, count, block);
    const Derived derived_of = derived(block.density.data(), count);
    write_records(block, derived_of, first, count);
    found.add({used(block, derived_of, first, count)});
  });
  refresh_images();
  return largest.used;
}

double Stage::fill(const Particles& particles) {
  return fill([&](std::size_t first, std::size_t count, StateBlock& block) {
    for (const auto& [of, to] : matched(particles, block)) std::copy_n(&(*of)[first], count, to->data());
  });
}

void Stage::set_density(std::size_t i, double density) {
  const Derived derived_of = derived(&density, 1);
  Record& record = records_[i];
  record.density = density;
  record.pressure = derived_of.pressure[0];
  record.sound = derived_of.sound[0];
  record.smoothing = derived_of.smoothing[0];
}

void Stage::refresh_images() {
  for (std::size_t k = 0; k < images_.size(); ++k) {
    Record& record = records_[count_ + k];
    record = records_[static_cast<std::size_t>(images_[k].source)];
    record.x += images_[k].shift_x;
    record.z += images_[k].shift_z;
  }
}

void Stage::refresh_volumes() {
  const std::size_t count = count_ + images_.size();
#pragma omp parallel for schedule(static) if (count > 2048)
  for (std::size_t i = 0; i < count; ++i) stress_[i].volume = mass_[i] / records_[i].density;
}

}  // namespace seiche::wcsph
