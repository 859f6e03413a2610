// What the Dirichlet mesh refuses, singular lattices among it, and how it breaks down.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <Eigen/Dense>

#include "seiche/models/dirichlet_mesh/flow.hpp"
#include "seiche/samples.hpp"
#include "verification/jittered_mesh.hpp"
#include "verification/robustness/breakdown.hpp"
#include "verification/robustness/refusals.hpp"

namespace seiche::verification::dirichlet_mesh_test {

using namespace dirichlet_mesh;
using namespace free_lagrangian;

/// A square without walls of four nodes and one inside.
Mesh square() {
  Mesh mesh{.x = {0, 1, 1, 0, 0.4}, .y = {0, 0, 1, 1, 0.45}, .outline = {0, 1, 2, 3}};
  mesh.held.resize(5);
  return mesh;
}

/// Derivatives of all cells by the coordinates that may move, weighted with the inverse masses: [coordinate][cell].
Eigen::MatrixXd responses(const Mesh& mesh) {
  Model model(mesh, {.stabilisation = 1});
  model.linearise({}, model.state().q);
  const auto n = static_cast<Eigen::Index>(model.nodes());
  Eigen::MatrixXd all(2 * n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    std::vector<double> impulse(model.nodes(), 0.0);
    std::vector<double> u(model.rates(), 0.0);
    impulse[static_cast<std::size_t>(i)] = 1;
    model.react(impulse, u);
    for (Eigen::Index k = 0; k < 2 * n; ++k) all(k, i) = u[static_cast<std::size_t>(k)];
  }
  return all;
}

struct Rank {
  long rank = 0;
  Eigen::MatrixXd null_vectors;  ///< in columns
};

Rank rank_of(const Mesh& mesh) {
  const Eigen::BDCSVD<Eigen::MatrixXd> svd(responses(mesh), Eigen::ComputeThinV);
  const Eigen::VectorXd& values = svd.singularValues();
  const long rank = (values.array() > 1e-10 * values[0]).count();
  return {rank, svd.matrixV().rightCols(static_cast<long>(mesh.nodes()) - rank)};
}

TEST_CASE("regular arrangements of Dirichlet cells are singular, staggered and jittered ones are not", "[robustness]") {
  Check check("dirichlet_mesh_rank", "Pressures without forces",
              "Singular values of the forces that pressures of the cells make, $W^{1/2} G^T$ up to masses. A "
              "rectangular arrangement of 25 x 9 nodes in a tank has two pressure modes without force: chequerboards "
              "along one axis at least. Staggered rows and jittered meshes have none. Without stabilisation the model "
              "rejects the arrangement and names the remedy.");
  Layer layer{.end = 3, .columns = 24, .rows = 8, .staggered = false};
  const Mesh rectangular = layer_mesh(layer);
  layer.staggered = true;
  const auto claim = [&](const std::string& text, const Rank& rank, double expected) {
    check.holds(text, {static_cast<double>(rank.rank)},
                Bound{0, "counted; singular values below 1e-10 of the largest are zero to rounding", expected});
  };
  const Rank lattice = rank_of(rectangular);
  const Mesh staggered = layer_mesh(layer);
  claim("The rank deficiency of the constraint matrix of a rectangular grid is two.", lattice, 223);
  claim("The constraint matrix of staggered rows has full rank.", rank_of(staggered),
        static_cast<double>(staggered.nodes()));
  claim("The constraint matrix of a jittered block has full rank.",
        rank_of(jittered(free_patch(8, 5, {0, 0}, {8, 5}, false), 0.2, 1)), 54);
  auto& figure = check.figure("null-vectors", "A pressure without forces",
                              "In the rectangular arrangement: the nodes where it is positive, and where negative.");
  std::vector<double> x_of[2], y_of[2];
  const Eigen::VectorXd shown = lattice.null_vectors.col(0);
  for (std::size_t k = 0; k < rectangular.nodes(); ++k) {
    const double value = shown[static_cast<Eigen::Index>(k)];
    if (std::abs(value) < 0.01 * shown.cwiseAbs().maxCoeff()) continue;
    x_of[value > 0].push_back(rectangular.x[k]);
    y_of[value > 0].push_back(rectangular.y[k]);
  }
  auto& panel = figure.panel({.x = "x", .y = "y", .equal_aspect = true});
  panel.points("positive", x_of[1], y_of[1]);
  panel.points("negative", x_of[0], y_of[0]);

  Refusals refusals(check);
  refusals.refused({"singular configuration", "stabilisation = 0", "set stabilisation > 0"},
                   [&] { Flow flow(rectangular, {}, {.stabilisation = 0}); });
  const Layer large{.end = 1, .columns = 60, .rows = 60, .staggered = false};
  refusals.refused({"singular configuration"}, [&] { Flow flow(layer_mesh(large), {}, {.stabilisation = 0}); });
  Flow cured(rectangular, {}, {.stabilisation = 0.1});
  cured.advance(0.05);
  check.holds("Water on the rectangular grid stays at rest with stabilisation.", {worst(cured.state().u)},
              Bound{0, "every force is exactly zero"});
}

TEST_CASE("bad meshes and settings of Dirichlet cells are rejected by name", "[robustness]") {
  Check check("dirichlet_mesh_bad_input", "Bad input of the Dirichlet mesh",
              "Invalid outlines, nodes outside their region, walls beside the outline, settings out of range.");
  Refusals refusals(check);
  const auto refused = refusals.of(square(), [](const Mesh& m) { Flow flow(m); });
  refused({"node 4", "nan", "finite"}, [](Mesh& m) { m.x[4] = not_a_number; });
  refused({"node 2", "inf", "finite"}, [](Mesh& m) { m.y[2] = infinity; });
  refused({"2 nodes", "at least 3"}, [](Mesh& m) { m.outline = {0, 1}; });
  refused({"node 9", "0 to 4"}, [](Mesh& m) { m.outline[2] = 9; });
  refused({"node 1", "twice"}, [](Mesh& m) { m.outline[2] = 1; });
  const auto add = [](Mesh& m, double x, double y) {
    m.x.push_back(x);
    m.y.push_back(y);
    m.held.emplace_back();
  };
  refused({"node 5", "coincides with node 4"}, [=](Mesh& m) { add(m, 0.4, 0.45); });
  refused({"coincides", "apart", "at least"}, [=](Mesh& m) {
    for (auto* places : {&m.x, &m.y}) {
      for (double& place : *places) place -= 0.5;
    }
    add(m, m.x[4] + 1e-14, m.y[4]);
  });
  refused({"counter-clockwise", "-1"}, [](Mesh& m) { std::reverse(m.outline.begin(), m.outline.end()); });
  refused({"meets itself", "0-1", "2-3"}, [](Mesh& m) {
    m.x = {0, 1, 0, 1, 0.5};
    m.y = {0, 1, 1, 0, 0.1};
  });
  refused({"meets itself"}, [](Mesh& m) { m.y = {0, 0, 0, 0, 0.1}; });
  refused({"node 4", "outside"}, [](Mesh& m) { m.x[4] = 1.5; });
  refused({"node 4", "edge 0-1"}, [](Mesh& m) { m.y[4] = 0; });
  refused({"cell of node 0", "area of -", "positive"}, [](Mesh& m) {
    m = {.x = {0, 1, 2}, .y = {0, 0, 0.1}, .outline = {0, 1, 2}};
    m.held.resize(3);
  });
  refused({"5 x", "4 y"}, [](Mesh& m) { m.y.pop_back(); });
  const auto hold = [](Mesh& m, double level, std::size_t node, int wall) {
    m.walls = {{{0, level}, {1, 0}}};
    m.held[node].one = wall;
  };
  refused({"node 1", "off its wall 0"}, [=](Mesh& m) { hold(m, 0.1, 1, 0); });
  refused({"node 4", "inside"}, [=](Mesh& m) { hold(m, 0.45, 4, 0); });
  refused({"wall 3", "1 walls"}, [=](Mesh& m) { hold(m, 0, 0, 3); });
  refused({"direction of wall 0", "= 0", "positive"}, [](Mesh& m) { m.walls = {{{0, 0}, {0, 0}}}; });
  refusals.outside_ranges(
      "Settings", "gravity non-negative and finite; density positive and finite; stabilisation non-negative and finite",
      Settings{}, [](const Settings& s) { Flow(square(), {}, s); });
  refusals.refused({"drift_feedback", "= 1.5", "[0, 1]"}, [] { Flow flow(square(), {}, {}, 1.5); });
  refusals.refused({"u[", "nan", "finite"}, [] { Flow flow(square(), [](Point) { return Point{not_a_number, 0}; }); });
  refusals.refused({"part", "= 0.5"}, [] { jittered(square(), 0.5, 1); });
  refusals.refused({"end - begin", "= -1"}, [] { layer_mesh({.begin = 1, .end = 0}); });
  refusals.refused({"no water", "-1.5"}, [] { layer_mesh({.elevation = [](double) { return -1.5; }}); });
}

TEST_CASE("tangling Dirichlet cells stop with time, step and position", "[robustness]") {
  Check check("dirichlet_mesh_breakdown", "A jet tangles the outline of the Dirichlet mesh",
              "A free patch whose two ends are thrown at each other: nodes of the outline meet. No flip helps; the run "
              "stops and names the triangle, with the state of before.");
  const auto together = [](Point r) {
    return Point{-std::sin(4 * r.x) * std::cosh(4 * r.y), std::cos(4 * r.x) * std::sinh(4 * r.y)};
  };
  Flow flow(jittered(free_patch(16, 8, {-1, -0.5}, {1, 0.5}), 0.2, 1), together, {.gravity = 0, .stabilisation = 0.1});
  holds_of_breakdown(check, "jet", run_until_breakdown(flow, 20, 0.02), "is inverted", -20, 20);
}

}  // namespace seiche::verification::dirichlet_mesh_test
