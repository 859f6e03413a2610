// Parts of a step of the Dirichlet mesh: n x n cells in a unit box, jittered by 0.2, stirred by one eddy.
//
//   items_per_second   nodes / second; its inverse is the time per node
//   flips              per node and step
#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "seiche/models/dirichlet_mesh/flow.hpp"

namespace {

using namespace seiche;
using namespace seiche::dirichlet_mesh;
using std::numbers::pi;

Mesh box(int n) {
  return jittered(layer_mesh({.begin = 0, .end = 1, .columns = n, .rows = n}), 0.2, 1);
}

Point eddy(Point r) {
  return {std::sin(pi * r.x) * std::cos(pi * (r.y + 1)), -std::cos(pi * r.x) * std::sin(pi * (r.y + 1))};
}

/// Moves by a tenth of the spacing, there and back: flips, areas and gradients.
void flips_and_geometry(benchmark::State& state) {
  const auto n = static_cast<int>(state.range(0));
  Model model(box(n), {});
  const mechanics::State start = model.state(eddy);
  std::vector<double> there = start.q;
  for (std::size_t i = 0; i < there.size(); ++i) there[i] += 0.1 / n * start.u[i];
  MovingTriangulation mesh = model.triangulation();
  DirichletCells cells;
  cells.connect(mesh.mesh(), static_cast<int>(model.nodes()));
  const long before = mesh.flips();
  bool ahead = true;
  for (auto _ : state) {
    const std::vector<double>& q = ahead ? there : start.q;
    ahead = !ahead;
    mesh.move_to({{q.data(), model.nodes()}, {q.data() + model.nodes(), model.nodes()}});
    cells.connect(mesh.mesh(), static_cast<int>(model.nodes()));
    cells.measure(mesh.mesh(), mesh.nodes());
  }
  const double work = static_cast<double>(state.iterations()) * static_cast<double>(model.nodes());
  state.SetItemsProcessed(static_cast<long>(work));
  state.counters["flips"] = static_cast<double>(mesh.flips() - before) / work;
}

/// Assembly, factor and everything else at a configuration that stays: no new pattern.
void linearisation(benchmark::State& state) {
  Model model(box(static_cast<int>(state.range(0))), {});
  const mechanics::State start = model.state(eddy);
  model.linearise({}, start.q);
  for (auto _ : state) model.linearise({}, start.q);
  state.SetItemsProcessed(state.iterations() * static_cast<long>(model.nodes()));
}

/// Whole steps that flip edges.
void steps(benchmark::State& state) {
  const auto n = static_cast<int>(state.range(0));
  Flow flow(box(n), eddy, {.gravity = 0});
  const long before = flow.flips();
  for (auto _ : state) flow.advance(0.02 / n);
  const double work = static_cast<double>(state.iterations()) * static_cast<double>(flow.model().nodes());
  state.SetItemsProcessed(static_cast<long>(work));
  state.counters["flips"] = static_cast<double>(flow.flips() - before) / work;
}

BENCHMARK(flips_and_geometry)->Arg(100)->Arg(316)->Unit(benchmark::kMillisecond);
BENCHMARK(linearisation)->Arg(100)->Unit(benchmark::kMillisecond);
BENCHMARK(steps)->Arg(100)->Unit(benchmark::kMillisecond)->Iterations(20);

}  // namespace
