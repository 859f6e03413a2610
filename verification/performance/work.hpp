/// What a step of a benchmark must do at the least, beside which its speed is read.
///
/// How it is counted, the same everywhere:
///
///     bytes        8 for every number of an array that a pass over the mesh has to read or write, once in a pass,
///                  however often its loop meets it: neighbours are in the cache. Indices are 4 bytes.
///     operations   + - * / sqrt, smallest, largest and comparisons that select count one each, in the formulas as the
///                  loops evaluate them; a sum on several lanes, or one that is done twice, counts once
///
/// Iterations and factors are not guessed: the solvers tell how many they took and made. What is small beside the rest
/// (surfaces of layered meshes, ends of channels, records of a step) is left out, so both are lower bounds.
#pragma once

#include <benchmark/benchmark.h>
#include <omp.h>

#include <cmath>
#include <string>

#include "seiche/linear/sparse_cholesky.hpp"

namespace seiche::performance {

struct Work {
  double bytes = 0, operations = 0;

  friend Work operator+(Work a, Work b) { return {a.bytes + b.bytes, a.operations + b.operations}; }
  friend Work operator*(double times, Work work) { return {times * work.bytes, times * work.operations}; }
};

/// Per entry of passes that read or write so many arrays of doubles.
constexpr Work pass(double arrays, double operations) {
  return {8 * arrays, operations};
}

/// The counters that ci/checks/benchmarks sets beside what the machine can do.
/// @param items  that a step takes on: cells, nodes, particles
inline void show(benchmark::State& state, std::size_t items, Work per_step) {
  state.SetItemsProcessed(state.iterations() * static_cast<long>(items));
  state.counters["bytes_per_step"] = per_step.bytes;
  state.counters["operations_per_step"] = per_step.operations;
}

/// Instead of counters, where what is done depends on the numbers met: a word that says why.
inline void show_not_counted(benchmark::State& state, const char* why) {
  state.SetLabel(std::string("not counted: ") + why);
}
inline void show_not_counted(benchmark::State& state, std::size_t items, const char* why) {
  state.SetItemsProcessed(state.iterations() * static_cast<long>(items));
  show_not_counted(state, why);
}

/// An argument of the benchmark that is a number of cells or particles.
inline std::size_t count_of(const benchmark::State& state, std::size_t argument = 0) {
  return static_cast<std::size_t>(state.range(argument));
}

/// Cells or particles in a row, and threads.
inline void rows_and_threads(benchmark::internal::Benchmark* benchmark) {
  benchmark->Args({1000, 1})->Args({10000, 1})->Args({1000000, 1})->Args({1000000, 2})->UseRealTime();
}

/// So many threads, until the benchmark has ended.
class Threads {
 public:
  explicit Threads(long count) { omp_set_num_threads(static_cast<int>(count)); }
  Threads(const Threads&) = delete;
  Threads& operator=(const Threads&) = delete;
  ~Threads() { omp_set_num_threads(usual_); }

 private:
  int usual_ = omp_get_max_threads();
};

/// An iteration of ConjugateGradients without product and preconditioner, per unknown: both dots of z, the direction,
/// x and r moved, |r|.
inline constexpr Work iteration_vectors = pass(4 + 3 + 6, 4 + 2 + 6);

/// A solution by LatticeGradients per unknown, with the product that the first residual takes.
///
/// Product: half of the stencil is stored, p read, q written. Preconditioner: r read and z written in double precision;
/// modes and factors in single precision, modes written by rows, read and written by tiles, read by rows; a real
/// Fourier transform of n numbers takes (5/2) n log2 n operations, substitution over the layers and scaling 6.
///
/// @param nx, nz   horizontal cells; nz = 1 in a vertical plane
/// @param stencil  unknowns in an equation: 9 or 27
inline Work lattice_solution(double nx, double nz, double stencil, double iterations) {
  const Work product = pass((stencil + 1) / 2 + 2, 2 * stencil + 1);
  const double passes = nz > 1 ? 2 : 0;  // over modes, by tiles
  const Work preconditioner{8 + 4 + passes * 4 + 2 * 4 + 4 + 8, 2 * 2.5 * (std::log2(nx) + std::log2(nz)) + 6};
  return pass(8, 3) + product + iterations * (iteration_vectors + product + preconditioner);
}

/// What a model's solver has done.
struct Solutions {
  double solves = 0, iterations = 0, factorisations = 0;

  Solutions& operator+=(const Solutions& other) {
    return *this = {solves + other.solves, iterations + other.iterations, factorisations + other.factorisations};
  }
  friend Solutions operator-(const Solutions& all, const Solutions& before) {
    return {all.solves - before.solves, all.iterations - before.iterations, all.factorisations - before.factorisations};
  }
  /// In each of so many.
  [[nodiscard]] Solutions over(double steps) const {
    return {solves / steps, iterations / steps, factorisations / steps};
  }
};

template <class Flow>
Solutions solutions_of(const Flow& flow) {
  const auto& solver = flow.model().solver();
  return {static_cast<double>(solver.solutions()), static_cast<double>(solver.iterations()),
          static_cast<double>(solver.factorisations())};
}

/// Of a lattice's nine-point matrix, eliminated within its band.
inline linear::FactorWork band(double columns, double rows) {
  const double column = std::min(columns, rows) + 2;  // with its diagonal
  return {columns * rows * column, columns * rows * column * column};
}

/// A factorisation: its operations by the solver's own analysis, every entry written once.
inline Work factorisation(linear::FactorWork factor) {
  return {8 * factor.entries, factor.operations};
}

/// Forwards and back through the factor: every entry is read twice.
inline Work substitution(linear::FactorWork factor) {
  return {2 * 8 * factor.entries, 2 * 2 * factor.entries};
}

/// A product with a symmetric matrix of which one triangle is stored, entries with their row.
inline Work sparse_product(double entries) {
  return {(8 + 4) * entries, 4 * entries};
}

/// Pressures of a model whose matrix is a RingMatrix: assembly and factorisation, by pairs in rings (where a pair goes,
/// its product of two vectors, the sum), and so many solutions, each refined twice.
/// @param members  of a ring, on the mean
template <class Model>
Work ring_pressures(const Model& model, std::size_t rings, double members, double solutions) {
  const linear::FactorWork factor = model.solver().factor_work();
  const double pairs = members * (members + 1) / 2;
  const auto entries = static_cast<double>(model.matrix().values().size());
  return static_cast<double>(rings) * Work{4 * pairs, 4 * pairs} + factorisation(factor) +
         solutions * (3 * substitution(factor) + 2 * sparse_product(entries));
}

/// Of a ring of a triangulation: a node and, by Euler, six neighbours.
inline constexpr double triangulated = 7;

}  // namespace seiche::performance
