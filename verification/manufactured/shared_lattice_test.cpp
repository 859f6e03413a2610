// What the lattice models do for one that is shared out among processes, here without any: blocks of a lattice with a
// ring of their neighbours' cells are shifted by a moving window as the whole is, and their energies add up to its.
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include <fmt/format.h>

#include "seiche/models/dispersive_shallow_water_2d/model.hpp"
#include "seiche/models/lagrangian_mesh_3d/flow.hpp"
#include "seiche/models/lagrangian_mesh_3d/model.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"
#include "verification/polynomial_bottom.hpp"

namespace seiche::verification::shared_lattice_test {

using plan_lattice::Shape;

namespace plan = dispersive_shallow_water_2d;
namespace mesh = lagrangian_mesh_3d;

constexpr Shape whole{8, 6};

/// Cells from a first to before a last column and row: those that a block owns, and with a ring around them.
struct Block {
  std::size_t west, east, south, north;

  [[nodiscard]] std::size_t first_column() const { return west > 0 ? west - 1 : 0; }
  [[nodiscard]] std::size_t first_row() const { return south > 0 ? south - 1 : 0; }
  [[nodiscard]] Shape shape() const {
    return {std::min(east + 1, whole.columns) - first_column(), std::min(north + 1, whole.rows) - first_row()};
  }
  [[nodiscard]] plan_lattice::Sides sides(const plan_lattice::Sides& of_whole) const {
    plan_lattice::Sides sides = of_whole;
    if (west > 0) sides.west = plan_lattice::FreeSide{};
    if (east < whole.columns) sides.east = plan_lattice::FreeSide{};
    if (south > 0) sides.south = plan_lattice::FreeSide{};
    if (north < whole.rows) sides.north = plan_lattice::FreeSide{};
    return sides;
  }
  /// Of so many numbers in the block with its ring. @param more  1 for numbers at nodes, 0 for numbers of cells
  [[nodiscard]] std::size_t levels(std::size_t more, std::size_t count) const {
    return count / ((shape().columns + more) * (shape().rows + more));
  }
  /// Calls visit(index in the block with its ring, index in the whole, owned) for nodes, or for cells, of all levels.
  template <class Visit>
  void each(std::size_t more, std::size_t levels, const Visit& visit) const {
    const std::size_t columns = shape().columns + more, rows = shape().rows + more;
    for (std::size_t k = 0; k < columns * rows * levels; ++k) {
      const std::size_t i = first_column() + k % columns;
      const std::size_t j = first_row() + k / columns % rows;
      const std::size_t level = k / (columns * rows);
      const bool own = i >= west && i < east + (east == whole.columns ? more : 0) && j >= south &&
                       j < north + (north == whole.rows ? more : 0);
      visit(k, (level * (whole.rows + more) + j) * (whole.columns + more) + i, own);
    }
  }
};
const std::vector<Block> blocks{{0, 3, 0, 4}, {3, 8, 0, 4}, {0, 3, 4, 6}, {3, 8, 4, 6}};

/// @param more  1 for numbers at nodes, 0 for numbers of cells
std::vector<double> cut(const std::vector<double>& values, const Block& block, std::size_t more) {
  std::vector<double> part;
  const std::size_t levels = values.size() / ((whole.columns + more) * (whole.rows + more));
  block.each(more, levels, [&](std::size_t, std::size_t there, bool) { part.push_back(values[there]); });
  return part;
}

double wave(double x, double y) {
  return 0.05 * std::sin(0.8 * x + 0.3) * std::cos(0.9 * y + 0.2);
}

/// Columns of growing width up to the last two, between walls.
plan::Lattice water() {
  plan::Lattice lattice = plan::rectangular_lattice(
      {.end = 8, .north = 6, .columns = whole.columns, .rows = whole.rows, .elevation = wave});
  for (double& x : lattice.x) x *= 1 + 0.02 * std::min(x, 6.0);
  return lattice;
}

mesh::Mesh hexahedra() {
  return mesh::layer_mesh(
      {.end = 8, .north = 6, .columns = whole.columns, .rows = whole.rows, .layers = 2, .elevation = wave});
}

Shape& shape_of(plan::Lattice& lattice) {
  return lattice.shape;
}
Shape& shape_of(mesh::Mesh& layers) {
  return layers.plan;
}

template <class Lattice>
Lattice part_of(Lattice lattice, const Block& block) {
  for (auto* values : {&lattice.x, &lattice.y, &lattice.z}) *values = cut(*values, block, 1);
  lattice.sides = block.sides(lattice.sides);
  shape_of(lattice) = block.shape();
  return lattice;
}

const std::vector<double>& first_x(const plan::Model& model) {
  return model.lattice().x;
}
const std::vector<double>& first_x(const mesh::Model& model) {
  return model.mesh().x;
}
std::span<const double> masses(const plan::Model& model) {
  return model.node_masses();
}
std::span<const double> masses(const mesh::Model& model) {
  return model.nodes().mass();
}

/// A model of the whole or of a block and its state.
template <class Model>
struct Moved {
  std::unique_ptr<Model> model;
  mechanics::State state;
};

template <class Model, class Lattice>
Moved<Model> made(const Lattice& lattice) {
  Moved<Model> moved{std::make_unique<Model>(lattice), {}};
  moved.state = moved.model->state();
  moved.state.u.assign(moved.state.u.size(), 0.0);
  return moved;
}

/// What all blocks hold of some numbers, from the owners, and back to where others hold copies.
class Exchange {
 public:
  explicit Exchange(std::size_t more) : more_(more) {}
  void take(const Block& block, std::span<const double> values) {
    visit(block, values.size(), [&](std::size_t here, std::size_t there, bool own) {
      if (own) owned_[there] = values[here];
    });
  }
  void give(const Block& block, std::span<double> values) {
    visit(block, values.size(), [&](std::size_t here, std::size_t there, bool own) {
      if (!own) values[here] = owned_[there];
    });
  }

 private:
  template <class Visit>
  void visit(const Block& block, std::size_t count, const Visit& each) {
    const std::size_t levels = block.levels(more_, count);
    owned_.resize(levels * (whole.columns + more_) * (whole.rows + more_));
    block.each(more_, levels, each);
  }
  std::size_t more_;
  std::vector<double> owned_;
};

/// The parts after a shift: owners' numbers to those who hold copies.
template <class Model>
void join(std::vector<Moved<Model>>& parts) {
  using mechanics::State;
  for (const auto& [more, numbers] : {std::pair{std::size_t{1}, &State::q}, {1, &State::u}, {0, &State::multipliers}}) {
    Exchange exchange(more);
    for (std::size_t b = 0; b < parts.size(); ++b) exchange.take(blocks[b], parts[b].state.*numbers);
    for (std::size_t b = 0; b < parts.size(); ++b) exchange.give(blocks[b], parts[b].state.*numbers);
  }
  Exchange of_nodes(1), of_cells(0);
  const auto join_all = [&](auto move) {
    for (std::size_t b = 0; b < parts.size(); ++b) {
      parts[b].model->join_shift([&](std::span<double> values) { (of_nodes.*move)(blocks[b], values); },
                                 [&](std::span<double> values) { (of_cells.*move)(blocks[b], values); });
    }
  };
  join_all(&Exchange::take);
  join_all(&Exchange::give);
}

template <class Model, class Lattice>
void shift_blocks(Check& check, const std::string& id, const std::string& text, const Lattice& lattice) {
  Moved<Model> all = made<Model>(lattice);
  for (std::size_t k = 0; k < all.state.u.size(); ++k) all.state.u[k] = 0.1 * std::sin(1.3 * static_cast<double>(k));
  for (std::size_t s = 0; s < all.model->constraints(); ++s) {
    all.state.multipliers.push_back(std::cos(0.7 * static_cast<double>(s)));
  }
  std::vector<Moved<Model>> parts;
  for (const Block& block : blocks) {
    Moved<Model>& part = parts.emplace_back(made<Model>(part_of(lattice, block)));
    part.state.u = cut(all.state.u, block, 1);
    part.state.multipliers = cut(all.state.multipliers, block, 0);
  }
  for (int shift = 0; shift < 3; ++shift) {
    all.model->shift_east(all.state);
    for (Moved<Model>& part : parts) part.model->shift_east(part.state);
    join(parts);
  }
  Worst state, first, volume, mass;
  for (std::size_t b = 0; b < parts.size(); ++b) {
    const Block& block = blocks[b];
    const auto compare = [&](
                             std::size_t more, std::span<const double> of_part, std::span<const double> of_all,
                             Worst& worst,
                             const std::function<bool(std::size_t there)>& counts = [](std::size_t) { return true; }) {
      block.each(more, block.levels(more, of_part.size()), [&](std::size_t here, std::size_t there, bool) {
        if (counts(there)) worst.add(of_part[here] - of_all[there]);
      });
    };
    compare(1, parts[b].state.q, all.state.q, state);
    compare(1, parts[b].state.u, all.state.u, state);
    compare(0, parts[b].state.multipliers, all.state.multipliers, state);
    compare(1, first_x(*parts[b].model), first_x(*all.model), first);
    compare(0, parts[b].model->first_volumes(), all.model->first_volumes(), volume);
    compare(1, masses(*parts[b].model), masses(*all.model), mass, [&](std::size_t node) {
      const std::size_t i = node % (whole.columns + 1);
      const std::size_t j = node / (whole.columns + 1) % (whole.rows + 1);
      return i >= block.west && i <= block.east && j >= block.south && j <= block.north;
    });
  }
  for (const auto& [of, what, worst] :
       {std::tuple{"state", "positions, velocities and multipliers agree with the whole, copies too.", state},
        {"first", "first positions, which masses and new columns come from, likewise.", first},
        {"volumes", "volumes of cells likewise.", volume},
        {"masses", "masses of the nodes around a block's own cells, which their coefficients need, likewise.", mass}}) {
    check.holds(fmt::format("{}-{}: {}: {}", id, of, text, what), {worst.value()},
                Roundoff{60, 10, "positions up to 12 and volumes of one, in some sixty operations"});
  }
}

TEST_CASE("blocks of a mesh are shifted by a window as the whole is", "[manufactured]") {
  Check check("shared_lattice_window", "A window that shifts the blocks of a mesh",
              "A mesh of 8 x 6 cells in four blocks, each with a ring of its neighbours' cells, is shifted by three "
              "columns; after each shift copies get the values of their owners. The blocks must agree with the whole.");
  shift_blocks<plan::Model>(check, "plan", "The 2DH model", water());
  plan::Lattice inclined = water();
  inclined.bottom = polynomial_bottom({{.coefficient = -2}, {.coefficient = 0.05, .x_power = 1}});
  shift_blocks<plan::Model>(check, "inclined", "The 2DH model over an inclined bottom", inclined);
  shift_blocks<mesh::Model>(check, "hexahedra", "Layers of hexahedra", hexahedra());
}

TEST_CASE("the potential energies of blocks add up to the energy of the whole", "[manufactured]") {
  Check check("shared_lattice_energy", "The potential energy of the blocks of a mesh",
              "Water in a canal between two shorelines, with improved dispersion, moved from its first positions. Each "
              "block counts the cells that it owns: their surfaces, the edges of the shore beside them, the slopes of "
              "their surfaces.",
              "decomposition of the mesh; distributed/decomposition.hpp");
  const auto bottom = polynomial_bottom({{.coefficient = -1}, {.coefficient = 1.0 / 16, .x_power = 2}});
  plan::Lattice lattice =
      plan::rectangular_lattice({.begin = -4,
                                 .end = 4,
                                 .north = 6,
                                 .columns = whole.columns,
                                 .rows = whole.rows,
                                 .sides = {.west = plan_lattice::ShoreSide{}, .east = plan_lattice::ShoreSide{}}});
  lattice.bottom = bottom;
  const plan::Settings settings{.inertia = 1.0 / 3 + 1.0 / 15, .gamma = 1.0 / 15};
  const plan::Model all(lattice, settings);
  std::vector<double> q = all.state().q;
  const std::size_t n = lattice.shape.nodes();
  for (std::size_t k = 0; k < n; ++k) {
    q[k] += 0.3 + 0.1 * std::cos(lattice.y[k]);
    const bool shore = k % (whole.columns + 1) % whole.columns == 0;
    q[2 * n + k] = shore ? bottom->slope(q[k], q[n + k]).elevation : wave(q[k], q[n + k]);
  }
  double together = 0;
  for (const Block& block : blocks) {
    const plan::Model part(part_of(lattice, block), settings);
    std::vector<char> own(block.shape().cells());
    block.each(0, 1, [&](std::size_t here, std::size_t, bool owned) { own[here] = owned ? 1 : 0; });
    together += part.potential_energy(cut(q, block, 1), own);
  }
  check.that("sum", "The sum of the blocks' energies equals the energy of the whole.", "difference of the energies",
             {together - all.potential_energy(q)},
             Roundoff{48 * 100.0, 1, "some hundred operations in each of 48 cells, whose sum is below one"});
}

}  // namespace seiche::verification::shared_lattice_test
