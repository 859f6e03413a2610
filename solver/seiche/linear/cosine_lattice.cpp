#include "seiche/linear/cosine_lattice.hpp"

#include <omp.h>

#include <algorithm>
#include <numbers>

#include "seiche/linear/tridiagonal.hpp"
#include "seiche/linear/worth_threads.hpp"
#include "seiche/require.hpp"
#include "seiche/simd_clones.hpp"

namespace seiche::linear {
namespace {

/// Modes whose systems are solved together: with 256 layers their data and factors fill half of a 1 MB cache.
constexpr std::size_t block = 128;
/// Rows along z that are transposed together: one cache line of each row along x.
constexpr std::size_t tile = 16;

/// At least n, whole vectors, and not a multiple of 512 bytes: the same place of successive rows would compete for the
/// same few lines of a cache.
std::size_t stride(std::size_t n) {
  const std::size_t whole = (n + 15) / 16 * 16;
  return whole % 128 == 0 ? whole + 16 : whole;
}

std::size_t pairs(std::size_t rows) {
  return (rows + 1) / 2;
}

/// Solves the systems of `count` modes, contiguous in every layer.
SEICHE_SIMD_CLONES void solve_block(const float* inverse_pivot, const float* multiplier, float* modes,
                                    std::size_t count, std::size_t layers, std::size_t layer_stride) {
  for (std::size_t j = 1; j < layers; ++j) {
    const float* const below = modes + (j - 1) * layer_stride;
    float* const here = modes + j * layer_stride;
    const float* const l = multiplier + (j - 1) * block;
#pragma omp simd
    for (std::size_t k = 0; k < count; ++k) here[k] -= l[k] * below[k];
  }
  float* const top = modes + (layers - 1) * layer_stride;
  const float* const d_top = inverse_pivot + (layers - 1) * block;
#pragma omp simd
  for (std::size_t k = 0; k < count; ++k) top[k] *= d_top[k];
  for (std::size_t j = layers - 1; j-- > 0;) {
    const float* const above = modes + (j + 1) * layer_stride;
    float* const here = modes + j * layer_stride;
    const float* const l = multiplier + j * block;
    const float* const d = inverse_pivot + j * block;
#pragma omp simd
    for (std::size_t k = 0; k < count; ++k) here[k] = here[k] * d[k] - l[k] * above[k];
  }
}

const CosineLattice::Shape& validated(const CosineLattice::Shape& shape) {
  require_at_least("nx", static_cast<long>(shape.nx), 1);
  require_at_least("nz", static_cast<long>(shape.nz), 1);
  require_at_least("layers", static_cast<long>(shape.layers), 1);
  return shape;
}

}  // namespace

CosineLattice::CosineLattice(Shape shape, const LayerMatrix& matrix)
    : shape_(validated(shape)), along_x_(shape.nx), along_z_(shape.nz), row_stride_(stride(shape.nx)) {
  if (shape.nz == 1) {
    layer_stride_ = row_stride_;
  } else {
    mode_stride_ = stride(shape.nz);
    layer_stride_ = stride(shape.nx * mode_stride_);
    rows_.resize(shape.layers * shape.nz * row_stride_);
  }
  modes_.resize(shape.layers * layer_stride_);
  factor(matrix);
}

void CosineLattice::factor(const LayerMatrix& matrix) {
  const std::size_t layers = shape_.layers;
  const std::size_t blocks = (layer_stride_ + block - 1) / block;
  inverse_pivot_.resize(blocks * layers * block);
  multiplier_.resize(blocks * layers * block);
  std::vector<double> diagonal(layers);
  std::vector<double> off_diagonal(layers);
  for (std::size_t ix = 0; ix < shape_.nx; ++ix) {
    const double theta = std::numbers::pi * static_cast<double>(along_x_.mode(ix)) / static_cast<double>(shape_.nx);
    for (std::size_t iz = 0; iz < shape_.nz; ++iz) {
      const double psi = std::numbers::pi * static_cast<double>(along_z_.mode(iz)) / static_cast<double>(shape_.nz);
      matrix(theta, psi, diagonal, std::span(off_diagonal).first(layers - 1));
      const std::size_t mode = ix * std::max<std::size_t>(mode_stride_, 1) + iz;
      const std::size_t first = mode / block * layers * block + mode % block;
      double pivot = diagonal[0];
      for (std::size_t j = 0;; ++j) {
        if (!(pivot > 0)) throw NotPositiveDefinite(j, pivot);
        inverse_pivot_[first + j * block] = static_cast<float>(1 / pivot);
        if (j + 1 == layers) break;
        const double l = off_diagonal[j] / pivot;
        multiplier_[first + j * block] = static_cast<float>(l);
        pivot = diagonal[j + 1] - l * off_diagonal[j];
      }
    }
  }
}

void CosineLattice::solve(std::span<const double> right_hand_side, std::span<double> x, double magnitude) {
  grow_workspaces();
  transform_rows(right_hand_side.data(), 1 / magnitude);
  if (shape_.nz > 1) transform_along_z();
  solve_layers();
  if (shape_.nz > 1) transform_along_z_back();
  transform_rows_back(magnitude / static_cast<double>(shape_.nx * shape_.nz), x.data());
}

void CosineLattice::grow_workspaces() {
  const auto threads = static_cast<std::size_t>(omp_get_max_threads());
  while (workspaces_.size() < threads) {
    workspaces_.push_back({CosineTransform::Workspace(along_x_), CosineTransform::Workspace(along_z_),
                           std::vector<double>(shape_.nx), std::vector<float>(std::max(shape_.nx, shape_.nz))});
  }
}

void CosineLattice::transform_rows(const double* right_hand_side, double factor) {
  const std::size_t count = shape_.nz * shape_.layers;
  float* const out = shape_.nz == 1 ? modes_.data() : rows_.data();
#pragma omp parallel for schedule(static) if (count * shape_.nx >= worth_threads)
  for (std::size_t pair = 0; pair < pairs(count); ++pair) {
    Workspace& work = workspaces_[static_cast<std::size_t>(omp_get_thread_num())];
    const std::size_t row = 2 * pair;
    const double* const first = right_hand_side + row * shape_.nx;
    float* const result = out + row * row_stride_;
    if (row + 1 < count) {
      along_x_.forward<double>({first, first + shape_.nx}, factor, {result, result + row_stride_}, work.along_x);
    } else {
      along_x_.forward<double>({first, first}, factor, {result, work.mode_copy.data()}, work.along_x);
    }
  }
}

void CosineLattice::transform_rows_back(double factor, double* x) {
  const std::size_t count = shape_.nz * shape_.layers;
  const float* const in = shape_.nz == 1 ? modes_.data() : rows_.data();
#pragma omp parallel for schedule(static) if (count * shape_.nx >= worth_threads)
  for (std::size_t pair = 0; pair < pairs(count); ++pair) {
    Workspace& work = workspaces_[static_cast<std::size_t>(omp_get_thread_num())];
    const std::size_t row = 2 * pair;
    const float* const first = in + row * row_stride_;
    double* const result = x + row * shape_.nx;
    if (row + 1 < count) {
      along_x_.backward<double>({first, first + row_stride_}, factor, {result, result + shape_.nx}, work.along_x);
    } else {
      along_x_.backward<double>({first, first}, factor, {result, work.row_copy.data()}, work.along_x);
    }
  }
}

void CosineLattice::transform_along_z() {
  const std::size_t tiles = (shape_.nx + tile - 1) / tile;
#pragma omp parallel for schedule(static) if (shape_.layers * shape_.nx * shape_.nz >= worth_threads)
  for (std::size_t task = 0; task < tiles * shape_.layers; ++task) {
    Workspace& work = workspaces_[static_cast<std::size_t>(omp_get_thread_num())];
    const std::size_t layer = task / tiles;
    const std::size_t first = task % tiles * tile;
    const std::size_t last = std::min(first + tile, shape_.nx);
    const float* const in = rows_.data() + layer * shape_.nz * row_stride_;
    float* const out = modes_.data() + layer * layer_stride_;
    for (std::size_t iz = 0; iz < shape_.nz; ++iz) {
      for (std::size_t ix = first; ix < last; ++ix) out[ix * mode_stride_ + iz] = in[iz * row_stride_ + ix];
    }
    for (std::size_t ix = first; ix < last; ix += 2) {
      float* const row = out + ix * mode_stride_;
      if (ix + 1 < last) {
        along_z_.forward<float>({row, row + mode_stride_}, 1.0f, {row, row + mode_stride_}, work.along_z);
      } else {
        along_z_.forward<float>({row, row}, 1.0f, {row, work.mode_copy.data()}, work.along_z);
      }
    }
  }
}

void CosineLattice::transform_along_z_back() {
  const std::size_t tiles = (shape_.nx + tile - 1) / tile;
#pragma omp parallel for schedule(static) if (shape_.layers * shape_.nx * shape_.nz >= worth_threads)
  for (std::size_t task = 0; task < tiles * shape_.layers; ++task) {
    Workspace& work = workspaces_[static_cast<std::size_t>(omp_get_thread_num())];
    const std::size_t layer = task / tiles;
    const std::size_t first = task % tiles * tile;
    const std::size_t last = std::min(first + tile, shape_.nx);
    float* const in = modes_.data() + layer * layer_stride_;
    float* const out = rows_.data() + layer * shape_.nz * row_stride_;
    for (std::size_t ix = first; ix < last; ix += 2) {
      float* const row = in + ix * mode_stride_;
      if (ix + 1 < last) {
        along_z_.backward<float>({row, row + mode_stride_}, 1.0f, {row, row + mode_stride_}, work.along_z);
      } else {
        along_z_.backward<float>({row, row}, 1.0f, {row, work.mode_copy.data()}, work.along_z);
      }
    }
    for (std::size_t iz = 0; iz < shape_.nz; ++iz) {
      for (std::size_t ix = first; ix < last; ++ix) out[iz * row_stride_ + ix] = in[ix * mode_stride_ + iz];
    }
  }
}

void CosineLattice::solve_layers() {
  const std::size_t layers = shape_.layers;
  const std::size_t blocks = (layer_stride_ + block - 1) / block;
#pragma omp parallel for schedule(static) if (layers * layer_stride_ >= worth_threads)
  for (std::size_t b = 0; b < blocks; ++b) {
    const std::size_t first = b * block;
    const std::size_t factors = first * layers;
    solve_block(inverse_pivot_.data() + factors, multiplier_.data() + factors, modes_.data() + first,
                std::min(block, layer_stride_ - first), layers, layer_stride_);
  }
}

}  // namespace seiche::linear
