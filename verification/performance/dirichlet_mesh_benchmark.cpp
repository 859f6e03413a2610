// Parts of a step of the Dirichlet mesh: n x n cells in a unit box, jittered by 0.2, stirred by one eddy.
//
//   items_per_second   nodes / second; its inverse is the time per node
//   flips              per node and step
//   iterations         of conjugate gradients per step, where there are more unknowns than are factorised
#include <benchmark/benchmark.h>

#include <boost/polygon/voronoi.hpp>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "seiche/models/dirichlet_mesh/flow.hpp"
#include "verification/jittered_mesh.hpp"
#include "verification/performance/work.hpp"

namespace {

using namespace seiche;
using namespace seiche::dirichlet_mesh;
using namespace seiche::free_lagrangian;
using std::numbers::pi;

Mesh box(int n) {
  return jittered(layer_mesh({.end = 1, .columns = n, .rows = n}), 0.2, 1);
}

Point eddy(Point r) {
  return {std::sin(pi * r.x) * std::cos(pi * (r.y + 1)), -std::cos(pi * r.x) * std::sin(pi * (r.y + 1))};
}

void show_flips(benchmark::State& state, long flips) {
  state.counters["flips"] = static_cast<double>(flips) / static_cast<double>(state.items_processed());
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
  performance::show_not_counted(state, model.nodes(), "branching");
  show_flips(state, mesh.flips() - before);
}

/// What the flips save: all cells anew, by the sweep of a library. Whole numbers are what it computes with.
void rebuild(benchmark::State& state) {
  const Mesh mesh = box(static_cast<int>(state.range(0)));
  std::vector<boost::polygon::point_data<std::int32_t>> points;
  const auto whole = [](double value) { return static_cast<std::int32_t>(std::ldexp(value, 28)); };
  for (std::size_t i = 0; i < mesh.nodes(); ++i) points.emplace_back(whole(mesh.x[i]), whole(mesh.y[i]));
  for (auto _ : state) {
    boost::polygon::voronoi_diagram<double> diagram;
    boost::polygon::construct_voronoi(points.begin(), points.end(), &diagram);
    benchmark::DoNotOptimize(diagram.num_vertices());
  }
  performance::show_not_counted(state, mesh.nodes(), "branching");
}

/// Assembly, factor and everything else at a configuration that stays: no new pattern.
void linearisation(benchmark::State& state) {
  Model model(box(static_cast<int>(state.range(0))), {});
  const mechanics::State start = model.state(eddy);
  model.linearise({}, start.q);
  for (auto _ : state) model.linearise({}, start.q);
  performance::show(state, model.nodes(),
                    performance::ring_pressures(model, model.nodes(), performance::triangulated, 0));
}

/// Whole steps that flip edges: cells along a side, threads. Counted are the pressures; flips
/// and geometry branch.
void steps(benchmark::State& state) {
  const performance::Threads threads(state.range(1));
  const auto n = static_cast<int>(state.range(0));
  Flow flow(box(n), eddy, {.gravity = 0, .stabilisation = 0.01});
  flow.advance(0.02 / n);  // the analysis
  const long before = flow.flips();
  for (auto _ : state) flow.advance(0.02 / n);
  const std::size_t nodes = flow.model().nodes();
  performance::show(state, nodes, performance::ring_pressures(flow.model(), nodes, performance::triangulated, 1));
  show_flips(state, flow.flips() - before);
}

BENCHMARK(flips_and_geometry)->Arg(100)->Arg(316)->Arg(1000)->Unit(benchmark::kMillisecond);
BENCHMARK(rebuild)->Arg(100)->Arg(316)->Arg(1000)->Unit(benchmark::kMillisecond);
BENCHMARK(linearisation)->Arg(100)->Arg(316)->Unit(benchmark::kMillisecond);
BENCHMARK(steps)->ArgsProduct({{100, 316, 1000}, {1, 2}})->Unit(benchmark::kMillisecond)->Iterations(4)->UseRealTime();

}  // namespace
