#include "seiche/models/wcsph/stage.hpp"

#include <algorithm>
#include <cmath>

#include "seiche/simd_clones.hpp"

namespace seiche::wcsph {
namespace {

/// Particles whose records are computed together, array by array.
constexpr std::size_t block = 64;

struct Derived {
  double pressure[block], smoothing[block], sound[block];
};

/// (5) for gamma = 7 without powers.
SEICHE_SIMD_CLONES void derive_seventh(const double* density, std::size_t count, double reference, double stiffness,
                                       double scaled_sound, double h, bool variable, Derived& derived) {
  const double inverse = 1 / reference;
  for (std::size_t k = 0; k < count; ++k) {
    const double s = density[k] * inverse;
    const double cube = s * s * s;
    derived.pressure[k] = stiffness * (cube * cube * s - 1) / (density[k] * density[k]);
    derived.sound[k] = scaled_sound * cube;
    derived.smoothing[k] = variable ? h / std::sqrt(s) : h;
  }
}

void derive(const TaitFluid& fluid, const double* density, std::size_t count, double sound_scale, double h,
            bool variable, Derived& derived) {
  if (fluid.exponent() == 7) {
    derive_seventh(density, count, fluid.reference_density(), fluid.stiffness(),
                   sound_scale * fluid.reference_sound_speed(), h, variable, derived);
    return;
  }
  for (std::size_t k = 0; k < count; ++k) {
    derived.pressure[k] = fluid.pressure(density[k]) / (density[k] * density[k]);
    derived.sound[k] = sound_scale * fluid.sound_speed(density[k]);
    derived.smoothing[k] = variable ? h * std::sqrt(fluid.reference_density() / density[k]) : h;
  }
}

}  // namespace

void State::resize(std::size_t n) {
  for (std::vector<double>* values : {&x, &z, &u, &w, &density}) values->resize(n);
}

StateView::StateView(const State& state)
    : x(state.x.data()), z(state.z.data()), u(state.u.data()), w(state.w.data()), density(state.density.data()) {}

StateView::StateView(const Particles& particles)
    : x(particles.x.data()),
      z(particles.z.data()),
      u(particles.u.data()),
      w(particles.w.data()),
      density(particles.density.data()) {}

Stage::Stage(const TaitFluid& fluid, double smoothing, bool variable, double sound_scale)
    : fluid_(fluid), smoothing_(smoothing), variable_(variable), sound_scale_(sound_scale) {}

void Stage::adopt(const Particles& particles, std::span<const Image> images) {
  count_ = particles.size();
  images_ = images;
  fresh_ = true;
  // Far from everything, finite in all that the loops compute of it.
  constexpr double far = 1e30;
  const std::size_t padded = count_ + images.size() + most_lanes;
  records_.resize(padded);
  for (std::size_t i = count_ + images.size(); i < padded; ++i) {
    records_[i] = {.x = far, .z = far, .u = 0, .w = 0, .density = 1, .pressure = 0, .smoothing = 1, .sound = 0};
  }
  mass_ = particles.mass;
  for (const Image& image : images) mass_.push_back(particles.mass[static_cast<std::size_t>(image.source)]);
  mass_.resize(padded);
  stress_.assign(padded, Stress{});
  base_x_.resize(count_);
  base_z_.resize(count_);
  base_smoothing_.resize(count_);
}

double Stage::fill_range(const StateView& state, std::size_t first, std::size_t last) {
  double used = 0;
  Derived derived;
  for (std::size_t begin = first; begin < last; begin += block) {
    const std::size_t count = std::min(block, last - begin);
    derive(fluid_, state.density + begin, count, sound_scale_, smoothing_, variable_, derived);
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t i = begin + k;
      records_[i] = {.x = state.x[i],
                     .z = state.z[i],
                     .u = state.u[i],
                     .w = state.w[i],
                     .density = state.density[i],
                     .pressure = derived.pressure[k],
                     .smoothing = derived.smoothing[k],
                     .sound = derived.sound[k]};
    }
    if (fresh_) {
      for (std::size_t k = 0; k < count; ++k) {
        base_x_[begin + k] = state.x[begin + k];
        base_z_[begin + k] = state.z[begin + k];
        base_smoothing_[begin + k] = derived.smoothing[k];
      }
      continue;
    }
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t i = begin + k;
      const double x = state.x[i] - base_x_[i];
      const double z = state.z[i] - base_z_[i];
      const double growth = derived.smoothing[k] - base_smoothing_[i];
      used = std::max(used, std::sqrt(x * x + z * z) + (growth > 0 ? growth : 0));
    }
  }
  return 2 * used;
}

double Stage::fill(const StateView& state) {
  double used = 0;
  const std::size_t blocks = (count_ + block - 1) / block;
#pragma omp parallel for schedule(static) reduction(max : used) if (blocks > 32)
  for (std::size_t b = 0; b < blocks; ++b) {
    used = std::max(used, fill_range(state, b * block, std::min(count_, (b + 1) * block)));
  }
  fresh_ = false;
  refresh_images();
  return used;
}

void Stage::set_density(std::size_t i, double density) {
  Derived derived;
  derive(fluid_, &density, 1, sound_scale_, smoothing_, variable_, derived);
  Record& record = records_[i];
  record.density = density;
  record.pressure = derived.pressure[0];
  record.smoothing = derived.smoothing[0];
  record.sound = derived.sound[0];
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
