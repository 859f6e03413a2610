#include "seiche/models/wcsph/stage.hpp"

#include <algorithm>
#include <cmath>

#include "seiche/simd_clones.hpp"

namespace seiche::wcsph {
namespace {

struct Derived {
  std::array<double, StateBlock::size> pressure, sound;
};

/// (5) for gamma = 7 without powers.
SEICHE_SIMD_CLONES void derive_seventh(const double* density, std::size_t count, double reference, double stiffness,
                                       double scaled_sound, Derived& derived) {
  const double inverse = 1 / reference;
  for (std::size_t k = 0; k < count; ++k) {
    const double s = density[k] * inverse;
    const double cube = s * s * s;
    derived.pressure[k] = stiffness * (cube * cube * s - 1) / (density[k] * density[k]);
    derived.sound[k] = scaled_sound * cube;
  }
}

void derive(const TaitFluid& fluid, const double* density, std::size_t count, double sound_scale, Derived& derived) {
  if (fluid.exponent() == 7) {
    derive_seventh(density, count, fluid.reference_density(), fluid.stiffness(),
                   sound_scale * fluid.reference_sound_speed(), derived);
    return;
  }
  for (std::size_t k = 0; k < count; ++k) {
    derived.pressure[k] = fluid.pressure(density[k]) / (density[k] * density[k]);
    derived.sound[k] = sound_scale * fluid.sound_speed(density[k]);
  }
}

/// h of each density, by the law of derive()'s s.
SEICHE_SIMD_CLONES void smoothing_of(const double* density, std::size_t count, double reference, bool seventh, double h,
                                     bool variable, double* smoothing) {
  const double inverse = 1 / reference;
  if (!variable) {
    std::fill_n(smoothing, count, h);
  } else if (seventh) {
    for (std::size_t k = 0; k < count; ++k) smoothing[k] = h / std::sqrt(density[k] * inverse);
  } else {
    for (std::size_t k = 0; k < count; ++k) smoothing[k] = h * std::sqrt(reference / density[k]);
  }
}

void copy(const Particles& particles, std::size_t first, std::size_t count, StateBlock& block) {
  std::copy_n(&particles.x[first], count, block.x.data());
  std::copy_n(&particles.z[first], count, block.z.data());
  std::copy_n(&particles.u[first], count, block.u.data());
  std::copy_n(&particles.w[first], count, block.w.data());
  std::copy_n(&particles.density[first], count, block.density.data());
}

}  // namespace

Stage::Stage(const TaitFluid& fluid, double smoothing, bool variable, double sound_scale, bool stresses)
    : fluid_(fluid), smoothing_(smoothing), variable_(variable), sound_scale_(sound_scale), stresses_(stresses) {}

void Stage::adopt(const Particles& particles, std::span<const Image> images) {
  count_ = particles.size();
  images_ = images;
  // Far from everything, finite in all that the loops compute of it.
  constexpr double far = 1e30;
  const std::size_t padded = count_ + images.size() + most_lanes;
  records_.resize(padded);
  for (std::size_t i = count_ + images.size(); i < padded; ++i) {
    records_[i] = {.x = far, .z = far, .u = 0, .w = 0, .density = 1, .pressure = 0, .smoothing = 1, .sound = 0};
  }
  mass_.reserve(padded);
  mass_ = particles.mass;
  for (const Image& image : images) mass_.push_back(particles.mass[static_cast<std::size_t>(image.source)]);
  mass_.resize(padded);
  if (stresses_) stress_.assign(padded, Stress{});
  base_.x = particles.x;
  base_.z = particles.z;
  base_.density = particles.density;
  fill(particles);
}

void Stage::write_records(const StateBlock& state, std::size_t first, std::size_t count) {
  Derived derived;
  derive(fluid_, state.density.data(), count, sound_scale_, derived);
  std::array<double, StateBlock::size> smoothing;
  smoothing_of(state.density.data(), count, fluid_.reference_density(), fluid_.exponent() == 7, smoothing_, variable_,
               smoothing.data());
  for (std::size_t k = 0; k < count; ++k) {
    records_[first + k] = {.x = state.x[k],
                           .z = state.z[k],
                           .u = state.u[k],
                           .w = state.w[k],
                           .density = state.density[k],
                           .pressure = derived.pressure[k],
                           .smoothing = smoothing[k],
                           .sound = derived.sound[k]};
  }
}

double Stage::used(const StateBlock& state, std::size_t first, std::size_t count) const {
  std::array<double, StateBlock::size> smoothing;
  smoothing_of(&base_.density[first], count, fluid_.reference_density(), fluid_.exponent() == 7, smoothing_, variable_,
               smoothing.data());
  double used = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t i = first + k;
    const double x = state.x[k] - base_.x[i];
    const double z = state.z[k] - base_.z[i];
    const double growth = records_[i].smoothing - smoothing[k];
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
    write_records(block, first, count);
    found.add({used(block, first, count)});
  });
  refresh_images();
  return largest.used;
}

double Stage::fill(const Particles& particles) {
  return fill(
      [&particles](std::size_t first, std::size_t count, StateBlock& block) { copy(particles, first, count, block); });
}

void Stage::set_density(std::size_t i, double density) {
  Derived derived;
  derive(fluid_, &density, 1, sound_scale_, derived);
  Record& record = records_[i];
  record.density = density;
  record.pressure = derived.pressure[0];
  record.sound = derived.sound[0];
  smoothing_of(&density, 1, fluid_.reference_density(), fluid_.exponent() == 7, smoothing_, variable_,
               &record.smoothing);
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

void Stage::refresh_image_stresses() {
  for (std::size_t k = 0; k < images_.size(); ++k) {
    stress_[count_ + k] = stress_[static_cast<std::size_t>(images_[k].source)];
  }
}

}  // namespace seiche::wcsph
