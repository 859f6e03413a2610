#include "seiche/models/wcsph/stage.hpp"

#include <algorithm>
#include <cmath>

#include "seiche/simd_clones.hpp"

namespace seiche::wcsph {
namespace {

/// P/rho^2 of (5) for gamma = 7 without powers, and h.
SEICHE_SIMD_CLONES void derive(const double* density, std::size_t count, double reference, double stiffness, double h,
                               double* pressure, double* smoothing) {
  const double inverse = 1 / reference;
  for (std::size_t k = 0; k < count; ++k) {
    const double s = density[k] * inverse;
    const double cube = s * s * s;
    pressure[k] = stiffness * (cube * cube * s - 1) / (density[k] * density[k]);
    smoothing[k] = h / std::sqrt(s);
  }
}

}  // namespace

void Stage::adopt(const Particles& particles, std::span<const Image> images, double used) {
  count_ = particles.size();
  images_ = images;
  const auto& kinds = particles.kind;
  varying_ = walls_keep_ ? static_cast<std::size_t>(std::ranges::count(kinds, Kind::fluid)) : count_;
  // Far from everything, finite in all that the loops compute of it.
  constexpr double far = 1e30;
  constexpr Record nobody{.x = far, .z = far, .u = 0, .w = 0, .density = 1, .pressure = 0, .smoothing = 1, .mass = 0};
  records_.assign(count_ + images.size() + most_lanes, nobody);
  for (std::size_t i = 0; i < count_; ++i) records_[i].mass = particles.mass[i];
  if (stresses_) stress_.assign(records_.size(), {});
  fill(particles);
  used_ = used;
}

double Stage::fill(const Source& source, std::size_t begin) {
  struct Largest {
    double moved = 0;
    void add(Largest other) { moved = std::max(moved, other.moved); }
  };
  const auto largest = over_blocks<Largest>(begin, count_, [&](std::size_t first, std::size_t count, Largest& found) {
    StateBlock block;
    source(first, count, block);
    std::array<double, StateBlock::size> pressure, smoothing;
    derive(block.density.data(), count, fluid_.reference_density(), fluid_.stiffness(), smoothing_, pressure.data(),
           smoothing.data());
    for (std::size_t k = std::max(first, varying_); k < first + count; ++k) smoothing[k - first] = smoothing_;
    for (std::size_t k = 0; k < count; ++k) {
      Record& record = records_[first + k];
      const double x = block.x[k] - record.x;
      const double z = block.z[k] - record.z;
      const double growth = std::max(smoothing[k] - record.smoothing, 0.0);
      found.moved = std::max(found.moved, std::sqrt(x * x + z * z) + growth);
      record = {.x = block.x[k],
                .z = block.z[k],
                .u = block.u[k],
                .w = block.w[k],
                .density = block.density[k],
                .pressure = pressure[k],
                .smoothing = smoothing[k],
                .mass = record.mass};
    }
  });
  used_ += 2 * largest.moved;
  for (std::size_t k = 0; k < images_.size(); ++k) {
    Record& record = records_[count_ + k];
    record = records_[static_cast<std::size_t>(images_[k].source)];
    record.x += images_[k].shift_x;
    record.z += images_[k].shift_z;
  }
  return used_;
}

double Stage::fill(const Particles& particles) {
  return fill([&](std::size_t first, std::size_t count, StateBlock& block) {
    for (const auto& [of, to] : matched(particles, block)) std::copy_n(&(*of)[first], count, to->data());
  });
}

void Stage::refresh_volumes() {
  const std::size_t count = count_ + images_.size();
#pragma omp parallel for schedule(static) if (count > 2048)
  for (std::size_t i = 0; i < count; ++i) stress_[i].volume = records_[i].mass / records_[i].density;
}

}  // namespace seiche::wcsph
