#include "seiche/models/wcsph/stage.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "seiche/simd_clones.hpp"

namespace seiche::wcsph {
namespace {

/// Places of mixed records, from the middle of the domain: any two of them differ by less than 2^31.
constexpr double farthest_place = (1 << 30) - 1;

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

/// h of each density, by the law of derive_seventh()'s s or of other exponents.
SEICHE_SIMD_CLONES void smoothing_lengths(const double* density, std::size_t count, double reference, bool seventh,
                                          double h, double* smoothing) {
  const double inverse = 1 / reference;
  if (seventh) {
    for (std::size_t k = 0; k < count; ++k) smoothing[k] = h / std::sqrt(density[k] * inverse);
  } else {
    for (std::size_t k = 0; k < count; ++k) smoothing[k] = h * std::sqrt(reference / density[k]);
  }
}

/// Places in whole numbers; what lies beyond them, or nowhere, is kept at the edge: lists do not last so far, and steps
/// report it.
SEICHE_SIMD_CLONES void whole_places(const double* places, std::size_t count, double origin, double per_unit,
                                     std::int32_t* whole) {
  for (std::size_t k = 0; k < count; ++k) {
    const double place = (places[k] - origin) * per_unit;
    const double above = place > -farthest_place ? place : -farthest_place;
    const double within = above < farthest_place ? above : farthest_place;
    whole[k] = static_cast<std::int32_t>(within < 0 ? within - 0.5 : within + 0.5);
  }
}

/// Wraps where a particle stands at the edge of what can be told.
std::int32_t shifted(std::int32_t place, double shift) {
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(place) + static_cast<std::uint32_t>(std::lround(shift)));
}

void copy(const Particles& particles, std::size_t first, std::size_t count, StateBlock& block) {
  std::copy_n(&particles.x[first], count, block.x.data());
  std::copy_n(&particles.z[first], count, block.z.data());
  std::copy_n(&particles.u[first], count, block.u.data());
  std::copy_n(&particles.w[first], count, block.w.data());
  std::copy_n(&particles.density[first], count, block.density.data());
}

}  // namespace

struct Stage::Derived {
  std::array<double, StateBlock::size> pressure, sound, smoothing;
};

Stage::Stage(const TaitFluid& fluid, double smoothing, double sound_scale, bool stresses, Storage storage)
    : fluid_(fluid), smoothing_(smoothing), sound_scale_(sound_scale), stresses_(stresses), storage_(storage) {}

void Stage::adopt(const Particles& particles, std::span<const Image> images) {
  count_ = particles.size();
  images_ = images;
  const std::size_t padded = count_ + images.size() + most_lanes;
  if (storage_ == Storage::mixed) adopt_mixed(particles);
  const auto adopt = [&](auto& held, const auto& nobody, double mass_unit) {
    held.records.resize(padded);
    std::fill(held.records.begin() + static_cast<std::ptrdiff_t>(count_ + images.size()), held.records.end(), nobody);
    using Real = typename std::decay_t<decltype(held)>::Real;
    held.mass.resize(padded);
    for (std::size_t i = 0; i < count_; ++i) held.mass[i] = static_cast<Real>(particles.mass[i] / mass_unit);
    for (std::size_t k = 0; k < images.size(); ++k) {
      held.mass[count_ + k] = held.mass[static_cast<std::size_t>(images[k].source)];
    }
    std::fill(held.mass.begin() + static_cast<std::ptrdiff_t>(count_ + images.size()), held.mass.end(), Real{0});
    if (stresses_) held.stress.assign(padded, {});
  };
  // Far from everything, finite in all that the loops compute of it.
  if (storage_ == Storage::mixed) {
    constexpr std::int32_t far = std::numeric_limits<std::int32_t>::min();
    adopt(mixed_,
          MixedRecord{.x = far, .z = far, .u = 0, .w = 0, .density = 1, .pressure = 0, .smoothing = 1, .sound = 0},
          units_.density * smoothing_ * smoothing_);
  } else {
    constexpr double far = 1e30;
    adopt(full_, Record{.x = far, .z = far, .u = 0, .w = 0, .density = 1, .pressure = 0, .smoothing = 1, .sound = 0},
          1);
  }
  base_.x = particles.x;
  base_.z = particles.z;
  base_.density = particles.density;
  fill(particles);
}

void Stage::adopt_mixed(const Particles& particles) {
  const auto [left, right] = std::minmax_element(particles.x.begin(), particles.x.end());
  const auto [bottom, top] = std::minmax_element(particles.z.begin(), particles.z.end());
  // Images lie within a support around, and particles move by less than that before the next sorting.
  const double margin = 4 * support * smoothing_;
  const double extent = std::max(*right - *left, *top - *bottom) + 2 * margin;
  units_ = {.place = 0.5 * extent / farthest_place,
            .left = 0.5 * (*left + *right),
            .bottom = 0.5 * (*bottom + *top),
            .per_length = 1 / smoothing_,
            .density = fluid_.reference_density()};
}

void Stage::smoothing_of(const double* density, std::size_t count, double* smoothing) const {
  smoothing_lengths(density, count, fluid_.reference_density(), fluid_.exponent() == 7, smoothing_, smoothing);
}

Stage::Derived Stage::derived(const double* density, std::size_t count) const {
  Derived derived;
  if (fluid_.exponent() == 7) {
    derive_seventh(density, count, fluid_.reference_density(), fluid_.stiffness(),
                   sound_scale_ * fluid_.reference_sound_speed(), derived.pressure.data(), derived.sound.data());
  } else {
    for (std::size_t k = 0; k < count; ++k) {
      derived.pressure[k] = fluid_.pressure(density[k]) / (density[k] * density[k]);
      derived.sound[k] = sound_scale_ * fluid_.sound_speed(density[k]);
    }
  }
  smoothing_of(density, count, derived.smoothing.data());
  return derived;
}

void Stage::write_records(const StateBlock& state, const Derived& derived, std::size_t first, std::size_t count) {
  if (storage_ == Storage::full) {
    for (std::size_t k = 0; k < count; ++k) {
      full_.records[first + k] = {.x = state.x[k],
                                  .z = state.z[k],
                                  .u = state.u[k],
                                  .w = state.w[k],
                                  .density = state.density[k],
                                  .pressure = derived.pressure[k],
                                  .smoothing = derived.smoothing[k],
                                  .sound = derived.sound[k]};
    }
    return;
  }
  std::array<std::int32_t, StateBlock::size> x, z;
  whole_places(state.x.data(), count, units_.left, 1 / units_.place, x.data());
  whole_places(state.z.data(), count, units_.bottom, 1 / units_.place, z.data());
  const double per_density = 1 / units_.density;
  for (std::size_t k = 0; k < count; ++k) {
    mixed_.records[first + k] = {.x = x[k],
                                 .z = z[k],
                                 .u = static_cast<float>(state.u[k]),
                                 .w = static_cast<float>(state.w[k]),
                                 .density = static_cast<float>(state.density[k] * per_density),
                                 .pressure = static_cast<float>(derived.pressure[k] * units_.density),
                                 .smoothing = static_cast<float>(derived.smoothing[k] * units_.per_length),
                                 .sound = static_cast<float>(derived.sound[k])};
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
  return fill(
      [&particles](std::size_t first, std::size_t count, StateBlock& block) { copy(particles, first, count, block); });
}

void Stage::set_density(std::size_t i, double density) {
  const Derived derived_of = derived(&density, 1);
  Record& record = full_.records[i];
  record.density = density;
  record.pressure = derived_of.pressure[0];
  record.sound = derived_of.sound[0];
  record.smoothing = derived_of.smoothing[0];
}

void Stage::refresh_images() {
  const double per_unit = 1 / units_.place;
  for (std::size_t k = 0; k < images_.size(); ++k) {
    const auto source = static_cast<std::size_t>(images_[k].source);
    if (storage_ == Storage::mixed) {
      // The shift is rounded alike in both directions: pairs across the border stay antisymmetric.
      MixedRecord& record = mixed_.records[count_ + k];
      record = mixed_.records[source];
      record.x = shifted(record.x, images_[k].shift_x * per_unit);
      record.z = shifted(record.z, images_[k].shift_z * per_unit);
    } else {
      Record& record = full_.records[count_ + k];
      record = full_.records[source];
      record.x += images_[k].shift_x;
      record.z += images_[k].shift_z;
    }
  }
}

void Stage::refresh_volumes() {
  const std::size_t count = count_ + images_.size();
  const auto refresh = [count](auto& held) {
#pragma omp parallel for schedule(static) if (count > 2048)
    for (std::size_t i = 0; i < count; ++i) held.stress[i].volume = held.mass[i] / held.records[i].density;
  };
  if (storage_ == Storage::mixed) {
    refresh(mixed_);
  } else {
    refresh(full_);
  }
}

void Stage::refresh_image_stresses() {
  const auto refresh = [this](auto& stress) {
    for (std::size_t k = 0; k < images_.size(); ++k) {
      stress[count_ + k] = stress[static_cast<std::size_t>(images_[k].source)];
    }
  };
  if (storage_ == Storage::mixed) {
    refresh(mixed_.stress);
  } else {
    refresh(full_.stress);
  }
}

}  // namespace seiche::wcsph
