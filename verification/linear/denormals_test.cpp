// Threads that share the loops of a step count denormal numbers as zero as the thread does that called them.
#include <omp.h>

#include <algorithm>
#include <cstddef>
#include <vector>

#include "seiche/flush_denormals.hpp"
#include "seiche/linear/conjugate_gradients.hpp"
#include "seiche/linear/worth_threads.hpp"
#include "seiche/models/dispersive_shallow_water_2d/model.hpp"
#include "seiche/models/lagrangian_mesh_2d/layer.hpp"
#include "seiche/models/lagrangian_mesh_2d/model.hpp"
#include "verification/check.hpp"

namespace seiche::verification::denormals_test {

constexpr double tiny = 1e-310;
constexpr std::size_t rows = 16;
constexpr std::size_t columns = linear::worth_threads / rows + 16;

/// What is left of tiny numbers by the loop, with two threads and without denormal numbers.
template <class Loop>
std::ptrdiff_t left_by(const Loop& loop) {
  const std::vector<double> result = [&] {
    const FlushDenormals guard;
    return loop();
  }();
  return std::ranges::count_if(result, [](double value) { return value != 0; });
}

std::vector<double> copy(const linear::LatticeArray& values) {
  return {values.values().begin(), values.values().end()};
}

TEST_CASE("threads that share loops count denormal numbers as zero", "[linear]") {
  Check check("denormals_of_threads", "Denormal numbers in two threads",
              "A matrix of the constraints times numbers of 1e-310, sums of such vectors, and the rates of cells of "
              "meshes whose nodes move by as much, shared by two threads that were made where denormal numbers count. "
              "The calling thread flushes them to zero: so do both.");
  const int usual = omp_get_max_threads();
  omp_set_num_threads(2);
  int made = 0;
#pragma omp parallel reduction(+ : made)
  ++made;
  REQUIRE(made == 2);

  linear::LatticeArray x(columns, rows), y(columns, rows);
  std::ranges::fill(x.values(), tiny);
  std::ptrdiff_t left = 0;
  linear::StencilMatrix matrix(columns, rows);
  std::fill_n(matrix[matrix.own], matrix.size(), 1.0);
  left += left_by([&] {
    matrix.multiply_and_dot(x, y);
    return copy(y);
  });
  left += left_by([&] {
    std::vector<double> sum(columns * rows, tiny);
    linear::scale_and_add(x.values(), 0.5, sum);
    return sum;
  });
  {
    namespace plan = dispersive_shallow_water_2d;
    plan::Model model(plan::rectangular_lattice({.end = columns, .north = rows, .columns = columns, .rows = rows}),
                      {.solver = linear::SolverMethod::iterative});
    model.linearise({}, model.state().q);
    const std::vector<double> u(model.rates(), tiny);
    left += left_by([&] {
      std::vector<double> end(model.coordinates());
      model.advance(std::vector<double>(model.coordinates(), tiny), u, 0.5, end);
      return end;
    });
  }
  {
    namespace mesh = lagrangian_mesh_2d;
    mesh::Model model(mesh::layer_mesh({.end = columns, .depth = rows, .columns = columns, .rows = rows}),
                      {.solver = linear::SolverMethod::iterative});
    model.linearise({}, model.state().q);
    std::vector<double> u(model.rates());
    for (std::size_t i = 0; i < u.size(); ++i) u[i] = i % 3 == 0 ? tiny : 0;
    left += left_by([&] {
      std::vector<double> rates(model.constraints());
      model.constraint_rates(u, rates);
      return rates;
    });
  }
  omp_set_num_threads(usual);
  check.holds("Denormal numbers are flushed to zero in every thread (four loops).", {static_cast<double>(left)},
              Bound{0, "the same bytes from any number of threads"});
}

}  // namespace seiche::verification::denormals_test
