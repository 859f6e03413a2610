#include "seiche/linear/cosine_lattice.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <omp.h>

#include "seiche/linear/tridiagonal.hpp"
#include "seiche/linear/worth_threads.hpp"
#include "seiche/require.hpp"
#include "seiche/simd_clones.hpp"

namespace seiche::linear {
namespace {

/// Modes whose systems are solved together: with 256 layers their data and factors fill half of a 1 MB cache.
constexpr std::size_t block = 128;

/// At least n, whole vectors, and not a multiple of 512 bytes: the same place of successive rows would compete for the
/// same few lines of a cache.
std::size_t stride(std::size_t n) {
  const std::size_t whole = (n + 15) / 16 * 16;
  return whole % 128 == 0 ? whole + 16 : whole;
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

/// to = factor scale from; scale null: 1.
SEICHE_SIMD_CLONES void narrow(const double* from, const double* scale, double factor, float* to, std::size_t n) {
  if (scale == nullptr) {
    for (std::size_t i = 0; i < n; ++i) to[i] = static_cast<float>(factor * from[i]);
  } else {
    for (std::size_t i = 0; i < n; ++i) to[i] = static_cast<float>(factor * (scale[i] * from[i]));
  }
}
SEICHE_SIMD_CLONES void widen(const float* from, const double* scale, double factor, double* to, std::size_t n) {
  if (scale == nullptr) {
    for (std::size_t i = 0; i < n; ++i) to[i] = factor * static_cast<double>(from[i]);
  } else {
    for (std::size_t i = 0; i < n; ++i) to[i] = scale[i] * (factor * static_cast<double>(from[i]));
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
    : shape_(validated(shape)),
      along_x_(shape.nx),
      along_z_(shape.nz),
      row_stride_(stride(shape.nx)),
      mode_stride_(shape.nz > 1 ? stride(shape.nz) : 1),
      tile_(shape.nz > 1 ? 16 : block) {
  rows_.resize(shape.layers * shape.nz * row_stride_);
  factor(matrix);
}

void CosineLattice::factor(const LayerMatrix& matrix) {
  const std::size_t layers = shape_.layers;
  const std::size_t blocks = (shape_.nx * mode_stride_ + block - 1) / block;
  inverse_pivot_.resize(blocks * layers * block);
  multiplier_.resize(blocks * layers * block);
  std::vector<double> diagonal(layers);
  std::vector<double> off_diagonal(layers);
  for (std::size_t ix = 0; ix < shape_.nx; ++ix) {
    const double theta = std::numbers::pi * static_cast<double>(along_x_.mode(ix)) / static_cast<double>(shape_.nx);
    for (std::size_t iz = 0; iz < shape_.nz; ++iz) {
      const double psi = std::numbers::pi * static_cast<double>(along_z_.mode(iz)) / static_cast<double>(shape_.nz);
      matrix(theta, psi, diagonal, std::span(off_diagonal).first(layers - 1));
      const std::size_t mode = ix * mode_stride_ + iz;
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

void CosineLattice::solve(std::span<const double> right_hand_side, std::span<double> x, double magnitude,
                          std::span<const double> scale) {
  grow_workspaces();
  const double* const s = scale.empty() ? nullptr : scale.data();
  transform_rows(right_hand_side.data(), 1 / magnitude, s);
  const bool many = shape_.layers * shape_.nx * shape_.nz >= worth_threads;
  share_out((shape_.nx + tile_ - 1) / tile_, many, [&](std::size_t t) {
    solve_tile(t * tile_, std::min((t + 1) * tile_, shape_.nx),
               workspaces_[static_cast<std::size_t>(omp_get_thread_num())]);
  });
  transform_rows_back(magnitude / static_cast<double>(shape_.nx * shape_.nz), x.data(), s);
}

void CosineLattice::grow_workspaces() {
  const auto threads = static_cast<std::size_t>(omp_get_max_threads());
  const std::size_t nx = shape_.nx;
  while (workspaces_.size() < threads) {
    workspaces_.push_back({CosineTransform::Workspace(along_x_), CosineTransform::Workspace(along_z_),
                           std::vector<float>(nx), std::vector<float>(nx), std::vector<float>(std::max(nx, shape_.nz)),
                           std::vector<float>(shape_.nz > 1 ? shape_.layers * tile_ * mode_stride_ : 0)});
  }
}

/// act(row, whether it is alone, workspace) for every second row along x, with the next one.
template <class Act>
void CosineLattice::each_pair(const Act& act) {
  const std::size_t count = shape_.nz * shape_.layers;
  share_out((count + 1) / 2, count * shape_.nx >= worth_threads, [&](std::size_t pair) {
    act(2 * pair, 2 * pair + 1 == count, workspaces_[static_cast<std::size_t>(omp_get_thread_num())]);
  });
}

void CosineLattice::transform_rows(const double* right_hand_side, double factor, const double* scale) {
  const std::size_t nx = shape_.nx;
  each_pair([&](std::size_t row, bool alone, Workspace& work) {
    const auto load = [&](std::size_t r, std::vector<float>& to) {
      narrow(right_hand_side + r * nx, scale == nullptr ? nullptr : scale + r * nx, factor, to.data(), nx);
    };
    load(row, work.row);
    if (!alone) load(row + 1, work.next);
    float* const result = rows_.data() + row * row_stride_;
    along_x_.forward({work.row.data(), alone ? work.row.data() : work.next.data()},
                     {result, alone ? work.mode_copy.data() : result + row_stride_}, work.along_x);
  });
}

void CosineLattice::transform_rows_back(double factor, double* x, const double* scale) {
  const std::size_t nx = shape_.nx;
  each_pair([&](std::size_t row, bool alone, Workspace& work) {
    const auto store = [&](std::size_t r, const std::vector<float>& from) {
      widen(from.data(), scale == nullptr ? nullptr : scale + r * nx, factor, x + r * nx, nx);
    };
    const float* const first = rows_.data() + row * row_stride_;
    along_x_.backward({first, alone ? first : first + row_stride_}, {work.row.data(), work.next.data()}, work.along_x);
    store(row, work.row);
    if (!alone) store(row + 1, work.next);
  });
}

/// Along z, over the layers and back, for the positions [first, last) along x.
void CosineLattice::solve_tile(std::size_t first, std::size_t last, Workspace& work) {
  const std::size_t layers = shape_.layers;
  const bool plane = shape_.nz == 1;
  const std::size_t layer_stride = plane ? row_stride_ : tile_ * mode_stride_;
  float* const tile = plane ? rows_.data() + first : work.modes.data();
  // act(number of the mode in the tile, its place in the rows), position by position along x.
  const auto each_mode = [&](std::size_t layer, const auto& act) {
    for (std::size_t iz = 0; iz < shape_.nz; ++iz) {
      float* const row = rows_.data() + (layer * shape_.nz + iz) * row_stride_;
      for (std::size_t ix = first; ix < last; ++ix) act((ix - first) * mode_stride_ + iz, row[ix]);
    }
  };
  // Pairs of rows along z, in place.
  const auto transform = [&](float* rows, const auto& along_z) {
    using From = std::array<const float*, 2>;
    using To = std::array<float*, 2>;
    for (std::size_t ix = first; ix < last; ix += 2) {
      float* const row = rows + (ix - first) * mode_stride_;
      if (ix + 1 < last) {
        along_z(From{row, row + mode_stride_}, To{row, row + mode_stride_});
      } else {
        along_z(From{row, row}, To{row, work.mode_copy.data()});
      }
    }
  };
  for (std::size_t layer = 0; layer < layers && !plane; ++layer) {
    float* const modes = tile + layer * layer_stride;
    each_mode(layer, [modes](std::size_t mode, float value) { modes[mode] = value; });
    transform(modes, [&](auto... rows) { along_z_.forward(rows..., work.along_z); });
  }
  // A tile begins with a block of factors: it has a multiple of 128 modes.
  const std::size_t count = (last - first) * mode_stride_;
  for (std::size_t mode = 0; mode < count; mode += block) {
    const std::size_t factors = (first * mode_stride_ + mode) * layers;
    solve_block(inverse_pivot_.data() + factors, multiplier_.data() + factors, tile + mode,
                std::min(block, count - mode), layers, layer_stride);
  }
  for (std::size_t layer = 0; layer < layers && !plane; ++layer) {
    float* const modes = tile + layer * layer_stride;
    transform(modes, [&](auto... rows) { along_z_.backward(rows..., work.along_z); });
    each_mode(layer, [modes](std::size_t mode, float& value) { value = modes[mode]; });
  }
}

CosineLattice::LayerMatrix hexahedral_lattice(double hx, double hy, std::vector<double> heights, double density,
                                              bool free_bottom) {
  require_positive("hx", hx);
  require_positive("hy", hy);
  require_positive("density", density);
  require_at_least("layers", static_cast<long>(heights.size()), 1);
  for (const double height : heights) require_positive("layer height", height);
  std::vector<double> mobility;  // 1/m_l of the levels
  for (std::size_t l = 0; l <= heights.size(); ++l) {
    const double below = l > 0 ? heights[l - 1] : 0;
    const double above = l < heights.size() ? heights[l] : 0;
    mobility.push_back(2 / (density * hx * hy * (below + above)));
  }
  const auto square = [](double a) { return a * a; };
  return [=, heights = std::move(heights)](double theta, double psi, std::span<double> diagonal,
                                           std::span<double> off_diagonal) {
    const double s1 = std::sin(theta / 2);
    const double c1 = std::cos(theta / 2);
    const double s2 = std::sin(psi / 2);
    const double c2 = std::cos(psi / 2);
    const double horizontal = square(hy * s1 * c2) + square(hx * s2 * c1);
    const double vertical = square(hx * hy * c1 * c2);
    for (std::size_t l = 0; l < heights.size(); ++l) {
      const double across = horizontal * square(heights[l]);
      const double bottom = l > 0 || free_bottom ? vertical : 0;
      diagonal[l] = mobility[l] * (across + bottom) + mobility[l + 1] * (across + vertical);
      if (l + 1 == heights.size()) break;
      off_diagonal[l] = mobility[l + 1] * (horizontal * heights[l] * heights[l + 1] - vertical);
    }
  };
}

}  // namespace seiche::linear
