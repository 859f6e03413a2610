#include "seiche/models/gauss_particles/cell_kernels.hpp"

#include <array>

#include "seiche/models/gauss_particles/occupied_cells.hpp"
#include "seiche/simd_clones.hpp"

namespace seiche::gauss_particles {

namespace {

constexpr std::size_t lanes = OccupiedCells::lanes;

// Plain arrays: the compiler keeps them in registers.
// NOLINTBEGIN(modernize-avoid-c-arrays)

/// Powers 0 ... N - 1 of a block's numbers, times a weight, lane by lane.
template <std::size_t N>
SEICHE_INLINE void powers(const double* z, const double* weight, double (&power)[N][lanes]) {
#pragma omp simd
  for (std::size_t l = 0; l < lanes; ++l) power[0][l] = weight == nullptr ? 1.0 : weight[l];
  for (std::size_t k = 1; k < N; ++k) {
#pragma omp simd
    for (std::size_t l = 0; l < lanes; ++l) power[k][l] = power[k - 1][l] * z[l];
  }
}

template <std::size_t A, std::size_t B>
SEICHE_INLINE void add_moments(const double (&x)[A][lanes], const double (&y)[B][lanes], double (&sum)[A * B][lanes]) {
  for (std::size_t a = 0; a < A; ++a) {
    for (std::size_t b = 0; b < B; ++b) {
#pragma omp simd
      for (std::size_t l = 0; l < lanes; ++l) sum[a * B + b][l] += x[a][l] * y[b][l];
    }
  }
}

template <std::size_t N>
SEICHE_INLINE void gather_lanes(const double (&sum)[N][lanes], double (&total)[N]) {
  for (std::size_t k = 0; k < N; ++k) {
    const double* s = sum[k];
    total[k] = ((s[0] + s[1]) + (s[2] + s[3])) + ((s[4] + s[5]) + (s[6] + s[7]));
  }
}

/// table [rows][B] = left [rows][A] times moments [A][B].
template <std::size_t A, std::size_t B>
SEICHE_INLINE void contract(const double* left, std::size_t rows, const double (&moments)[A * B], double* table) {
  for (std::size_t r = 0; r < rows; ++r) {
    double row[B] = {};
    for (std::size_t a = 0; a < A; ++a) {
      const double factor = left[r * A + a];
#pragma omp simd
      for (std::size_t b = 0; b < B; ++b) row[b] += factor * moments[a * B + b];
    }
    for (std::size_t b = 0; b < B; ++b) table[r * B + b] = row[b];
  }
}

template <std::size_t B>
SEICHE_INLINE double dot(const double* a, const double* b) {
  double sum = 0;
  for (std::size_t k = 0; k < B; ++k) sum += a[k] * b[k];
  return sum;
}

template <int P>
struct Sizes {
  static constexpr std::size_t order = P + 1;
  static constexpr std::size_t powers = 2 * P + 1;
  static constexpr std::size_t pairs = order * (order + 1) / 2;
  static constexpr std::size_t functions = order * order;

  /// Number of the pair i <= k in the order in which SplineAxis writes them.
  static constexpr std::size_t pair(std::size_t i, std::size_t k) {
    const std::size_t low = i < k ? i : k;
    const std::size_t high = i < k ? k : i;
    return low * order - low * (low + 1) / 2 + high;
  }
};

/// Moments of the mass, of the mass times 1 + b'^2 and of the mass times b'.
template <int P, bool uneven>
struct Moments {
  static constexpr std::size_t size = Sizes<P>::powers * Sizes<P>::powers;
  double mass[size];
  double stretched[uneven ? size : 1];
  double sheared[uneven ? size : 1];
};

template <int P, bool uneven>
SEICHE_INLINE void take_moments(const CellParticles& at, Moments<P, uneven>& moments) {
  constexpr std::size_t n = Sizes<P>::powers;
  double sum[uneven ? 3 : 1][n * n][lanes] = {};
  for (std::size_t k = 0; k < at.count; k += lanes) {
    double x[n][lanes];
    double y[n][lanes];
    powers(at.across + k, nullptr, x);
    powers(at.up + k, at.mass + k, y);
    add_moments(x, y, sum[0]);
    if constexpr (uneven) {
      double weight[lanes];
      const double* slope = at.slope + k;
#pragma omp simd
      for (std::size_t l = 0; l < lanes; ++l) weight[l] = at.mass[k + l] * slope[l];
      powers(at.up + k, weight, y);
      add_moments(x, y, sum[2]);
#pragma omp simd
      for (std::size_t l = 0; l < lanes; ++l) weight[l] = at.mass[k + l] + weight[l] * slope[l];
      powers(at.up + k, weight, y);
      add_moments(x, y, sum[1]);
    }
  }
  gather_lanes(sum[0], moments.mass);
  if constexpr (uneven) {
    gather_lanes(sum[1], moments.stretched);
    gather_lanes(sum[2], moments.sheared);
  }
}

template <int P, bool uneven>
SEICHE_INLINE void mass_matrix(const CellParticles& at, const CellSplines& splines, double* matrix) {
  using S = Sizes<P>;
  constexpr std::size_t n = S::powers;
  Moments<P, uneven> moments;
  take_moments<P, uneven>(at, moments);
  // Sums of B_i B_k and of B_i' B_k' along x against powers of eta, then against pairs along eta.
  double values[S::pairs * n];
  double slopes[S::pairs * n];
  if constexpr (uneven) {
    contract<n, n>(splines.x->product.data(), S::pairs, moments.stretched, values);
  } else {
    contract<n, n>(splines.x->product.data(), S::pairs, moments.mass, values);
  }
  contract<n, n>(splines.x->derivative_product.data(), S::pairs, moments.mass, slopes);
  const double per_x = 1 / (splines.cell_x * splines.cell_x);
  const double per_y = 1 / (splines.cell_y * splines.cell_y);
  double pairs[S::pairs][S::pairs];
  for (std::size_t x = 0; x < S::pairs; ++x) {
    for (std::size_t y = 0; y < S::pairs; ++y) {
      pairs[x][y] = per_y * dot<n>(values + x * n, splines.y->derivative_product.data() + y * n) +
                    per_x * dot<n>(slopes + x * n, splines.y->product.data() + y * n);
    }
  }
  for (std::size_t i = 0; i < S::order; ++i) {
    for (std::size_t j = 0; j < S::order; ++j) {
      double* row = matrix + (i * S::order + j) * S::functions;
      for (std::size_t k = 0; k < S::order; ++k) {
        for (std::size_t l = 0; l < S::order; ++l) row[k * S::order + l] = pairs[S::pair(i, k)][S::pair(j, l)];
      }
    }
  }
  if constexpr (uneven) {
    // -b' (Phi_a,x Phi_b,eta + Phi_a,eta Phi_b,x)
    double mixed[S::functions * n];
    contract<n, n>(splines.x->mixed_product.data(), S::functions, moments.sheared, mixed);
    const double per_xy = 1 / (splines.cell_x * splines.cell_y);
    const double* up = splines.y->mixed_product.data();
    for (std::size_t i = 0; i < S::order; ++i) {
      for (std::size_t j = 0; j < S::order; ++j) {
        for (std::size_t k = 0; k < S::order; ++k) {
          for (std::size_t l = 0; l < S::order; ++l) {
            matrix[(i * S::order + j) * S::functions + k * S::order + l] -=
                per_xy * (dot<n>(mixed + (i * S::order + k) * n, up + (l * S::order + j) * n) +
                          dot<n>(mixed + (k * S::order + i) * n, up + (j * S::order + l) * n));
          }
        }
      }
    }
  }
}

template <int P, bool uneven>
SEICHE_INLINE void load(const CellParticles& at, const CellSplines& splines, const double* wx, const double* wy,
                        double* loads) {
  using S = Sizes<P>;
  constexpr std::size_t n = S::order;
  // Moments of m (wx + b' wy), which meets Phi_eta, and of m wy, which meets -Phi_x.
  double along[n * P][lanes] = {};
  double down[P * n][lanes] = {};
  for (std::size_t k = 0; k < at.count; k += lanes) {
    double x[n][lanes];
    double low_x[P][lanes];
    double y[n][lanes];
    double low_y[P][lanes];
    double weight[lanes];
#pragma omp simd
    for (std::size_t l = 0; l < lanes; ++l) {
      weight[l] = at.mass[k + l] * (uneven ? wx[k + l] + at.slope[k + l] * wy[k + l] : wx[k + l]);
    }
    powers(at.across + k, nullptr, x);
    powers(at.up + k, weight, low_y);
    add_moments(x, low_y, along);
#pragma omp simd
    for (std::size_t l = 0; l < lanes; ++l) weight[l] = at.mass[k + l] * wy[k + l];
    powers(at.across + k, nullptr, low_x);
    powers(at.up + k, weight, y);
    add_moments(low_x, y, down);
  }
  double u[n * P];
  double v[P * n];
  gather_lanes(along, u);
  gather_lanes(down, v);
  double powers_load[n * n];
  for (std::size_t a = 0; a < n; ++a) {
    for (std::size_t b = 0; b < n; ++b) {
      powers_load[a * n + b] = (b == 0 ? 0 : static_cast<double>(b) / splines.cell_y * u[a * P + b - 1]) -
                               (a == 0 ? 0 : static_cast<double>(a) / splines.cell_x * v[(a - 1) * n + b]);
    }
  }
  double half[n * n];
  contract<n, n>(splines.x->function.data(), n, powers_load, half);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) loads[i * n + j] = dot<n>(half + i * n, splines.y->function.data() + j * n);
  }
}

template <int P, bool uneven>
SEICHE_INLINE void velocity(const CellParticles& at, const CellSplines& splines, const double* coefficients, double* ux,
                            double* uy) {
  constexpr std::size_t n = Sizes<P>::order;
  // Phi as a polynomial, then its derivatives.
  double half[n][n] = {};  // [power of x][function along y]
  double phi[n][n] = {};
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t a = 0; a < n; ++a) {
      const double factor = splines.x->function[i * n + a];
      for (std::size_t j = 0; j < n; ++j) half[a][j] += factor * coefficients[i * n + j];
    }
  }
  for (std::size_t a = 0; a < n; ++a) {
    for (std::size_t j = 0; j < n; ++j) {
      for (std::size_t b = 0; b < n; ++b) phi[a][b] += half[a][j] * splines.y->function[j * n + b];
    }
  }
  double up[n][P];
  double down[P][n];
  for (std::size_t a = 0; a < n; ++a) {
    for (std::size_t b = 1; b < n; ++b) up[a][b - 1] = static_cast<double>(b) * phi[a][b] / splines.cell_y;
  }
  for (std::size_t a = 1; a < n; ++a) {
    for (std::size_t b = 0; b < n; ++b) down[a - 1][b] = -static_cast<double>(a) * phi[a][b] / splines.cell_x;
  }
#pragma omp simd
  for (std::size_t k = 0; k < at.count; ++k) {
    const double x = at.across[k];
    const double y = at.up[k];
    double u = 0;
    for (std::size_t a = n; a-- > 0;) {
      double row = up[a][P - 1];
      for (std::size_t b = P - 1; b-- > 0;) row = row * y + up[a][b];
      u = u * x + row;
    }
    double v = 0;
    for (std::size_t a = P; a-- > 0;) {
      double row = down[a][n - 1];
      for (std::size_t b = n - 1; b-- > 0;) row = row * y + down[a][b];
      v = v * x + row;
    }
    ux[k] = u;
    uy[k] = uneven ? v + at.slope[k] * u : v;
  }
}

// One function per degree and ground, in all versions of the processor's vectors.
#define SEICHE_CELL_KERNELS(P, UNEVEN, NAME)                                                                        \
  SEICHE_SIMD_CLONES void mass_matrix_##NAME(const CellParticles& at, const CellSplines& splines, double* matrix) { \
    mass_matrix<P, UNEVEN>(at, splines, matrix);                                                                    \
  }                                                                                                                 \
  SEICHE_SIMD_CLONES void load_##NAME(const CellParticles& at, const CellSplines& splines, const double* wx,        \
                                      const double* wy, double* loads) {                                            \
    load<P, UNEVEN>(at, splines, wx, wy, loads);                                                                    \
  }                                                                                                                 \
  SEICHE_SIMD_CLONES void velocity_##NAME(const CellParticles& at, const CellSplines& splines,                      \
                                          const double* coefficients, double* ux, double* uy) {                     \
    velocity<P, UNEVEN>(at, splines, coefficients, ux, uy);                                                         \
  }

SEICHE_CELL_KERNELS(2, false, level_2)
SEICHE_CELL_KERNELS(3, false, level_3)
SEICHE_CELL_KERNELS(4, false, level_4)
SEICHE_CELL_KERNELS(2, true, uneven_2)
SEICHE_CELL_KERNELS(3, true, uneven_3)
SEICHE_CELL_KERNELS(4, true, uneven_4)

#undef SEICHE_CELL_KERNELS

// NOLINTEND(modernize-avoid-c-arrays)

}  // namespace

const CellKernels& cell_kernels(int degree, bool uneven) {
  static const std::array<CellKernels, 6> all{{{mass_matrix_level_2, load_level_2, velocity_level_2},
                                               {mass_matrix_level_3, load_level_3, velocity_level_3},
                                               {mass_matrix_level_4, load_level_4, velocity_level_4},
                                               {mass_matrix_uneven_2, load_uneven_2, velocity_uneven_2},
                                               {mass_matrix_uneven_3, load_uneven_3, velocity_uneven_3},
                                               {mass_matrix_uneven_4, load_uneven_4, velocity_uneven_4}}};
  return all[static_cast<std::size_t>(degree - lowest_degree) + (uneven ? 3 : 0)];
}

}  // namespace seiche::gauss_particles
