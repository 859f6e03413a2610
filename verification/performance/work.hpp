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
inline void show(benchmark::State& state, Work per_step) {
  state.counters["bytes_per_step"] = per_step.bytes;
  state.counters["operations_per_step"] = per_step.operations;
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

/// Instead of counters, where what is done depends on the numbers met: a word that says why.
inline void show_not_counted(benchmark::State& state, const char* why) {
  state.SetLabel(std::string("not counted: ") + why);
}

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

/// Assembly and factorisation of a RingMatrix, by pairs in rings: where a pair goes, its product of two vectors, the
/// sum.
/// @param members  of a ring, on the mean
inline Work ring_factorisation(linear::FactorWork factor, double rings, double members) {
  const double pairs = members * (members + 1) / 2;
  return rings * Work{4 * pairs, 4 * pairs} + factorisation(factor);
}

/// A solution by RingSolver, refined twice.
/// @param entries  of the matrix's triangle
inline Work ring_solution(linear::FactorWork factor, double entries) {
  return 3 * substitution(factor) + 2 * sparse_product(entries);
}

}  // namespace seiche::performance
