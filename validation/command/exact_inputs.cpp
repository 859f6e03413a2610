#include "validation/command/exact_inputs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "seiche/io/atomic_file.hpp"
#include "validation/command/exact_points.hpp"
#include "validation/command/settings.hpp"
#include "validation/scoring/solver_inputs.hpp"

namespace seiche::command {
namespace {

using exact::ExactSolution;
namespace fs = std::filesystem;

/// Index of an input or output.
template <class Named>
std::optional<std::size_t> index_of(const std::vector<Named>& all, std::string_view name) {
  const auto found = std::ranges::find(all, name, &Named::name);
  return found == all.end() ? std::nullopt : std::optional(static_cast<std::size_t>(found - all.begin()));
}

bool is_height(const exact::Coordinate& input) {
  return input.name == "y" && std::isnan(input.default_value);
}

/// A solution as water over a bed: what a solver's initial state is made of.
///
/// | output | bed |
/// |---|---|
/// | z | z |
/// | h without z | 0 |
/// | eta without z | -mean_depth (a scalar), -depth (a parameter), or none: infinitely deep |
class Water {
 public:
  /// Velocity along x, across and up: 0 along axes that the solution leaves out.
  struct Flow {
    double bed, surface;
    validation::Vector3 velocity;
  };

  Water(const ExactSolution& solution, const std::map<std::string, double>& parameters)
      : solution_(solution), x_(index_of(solution.inputs, "x")), t_(index_of(solution.inputs, "t")) {
    const auto y = index_of(solution.inputs, "y");
    if (y) (is_height(solution.inputs[*y]) ? height_ : across_) = y;
    const auto output = [&](const char* name) { return index_of(solution.outputs, name); };
    surface_ = output("eta"), depth_ = output("h"), bed_ = output("z"), velocity_ = {output("u"), {}, {}};
    velocity_[height_ ? 2 : 1] = y ? output("v") : std::nullopt;
    if (!x_ || !(surface_ || depth_)) {
      fail("{}: cannot write initial conditions, this solution does not define the free surface as a function of x",
           solution.name);
    }
    if (!velocity_[0]) fail("{}: has no velocity field, needed for initial conditions", solution.name);
    evaluator_ = solution.evaluator(parameters);
    const auto depth = parameters.find("depth");
    const auto mean = index_of(solution.scalars, "mean_depth");
    if (surface_ && mean) {
      flat_bed_ = -evaluator_.scalars()[*mean];
    } else if (surface_) {
      flat_bed_ = depth == parameters.end() ? -std::numeric_limits<double>::infinity() : -depth->second;
    }
  }

  [[nodiscard]] bool in_plan() const { return across_.has_value(); }
  void at(double time) { time_ = time; }

  /// At a height, or at the surface.
  [[nodiscard]] Flow flow(double x, double across = 0, std::optional<double> height = {}) const {
    Point point = default_point(solution_);
    point[*x_] = x;
    if (t_) point[*t_] = time_;
    if (height_ && height) point[*height_] = *height;
    if (across_) point[*across_] = across;
    const std::vector<double> row = evaluator_.eval(point);
    Flow flow{.bed = bed_ ? row[*bed_] : flat_bed_, .surface = 0, .velocity = {}};
    flow.surface = surface_ ? row[*surface_] : flow.bed + row[*depth_];
    for (std::size_t axis = 0; axis < 3; ++axis) flow.velocity[axis] = velocity_[axis] ? row[*velocity_[axis]] : 0;
    return flow;
  }
  /// Along x and across, over the depth, by Gauss and Legendre's rule of three points in eight layers.
  [[nodiscard]] std::array<double, 2> discharge(double x, double across) const {
    const Flow top = flow(x, across);
    const double depth = top.surface - top.bed;
    if (!height_) return {depth * top.velocity[0], depth * top.velocity[1]};
    constexpr int layers = 8;
    constexpr std::array nodes{-0.7745966692414834, 0.0, 0.7745966692414834};
    constexpr std::array weights{5.0 / 9, 8.0 / 9, 5.0 / 9};
    const double half = 0.5 * depth / layers;
    double sum = 0;
    for (int k = 0; k < layers; ++k) {
      for (std::size_t j = 0; j < nodes.size(); ++j) {
        sum += weights[j] * half * flow(x, across, top.bed + half * (2 * k + 1 + nodes[j])).velocity[0];
      }
    }
    return {sum, 0};
  }

 private:
  const ExactSolution& solution_;
  exact::Evaluator evaluator_;
  std::optional<std::size_t> x_, t_, height_, across_;
  std::optional<std::size_t> surface_, depth_, bed_;
  std::array<std::optional<std::size_t>, 3> velocity_;
  double flat_bed_ = 0;
  double time_ = 0;
};

/// The instant of --at, 0 where none is given.
double instant(const ExactSolution& solution, const ExactOptions& options) {
  const auto t = index_of(solution.inputs, "t");
  return options.points.empty() || !t ? 0 : points_at(solution, options.points).front()[*t];
}

fs::path write(const ExactOptions& options, const std::string& name, const std::string& text) {
  const fs::path folder = options.out.empty() ? "." : options.out;
  fs::create_directories(folder);
  fs::path file = folder / name;
  io::write_file(file, text);
  return file;
}

std::vector<fs::path> write_openfoam(Water& water, const ExactOptions& options) {
  if (options.centres.empty())
    fail("--write openfoam: --centres FILE is missing: the field C that 'postProcess -func writeCellCentres' writes");
  const std::size_t up = options.up == "y" ? 1 : 2;
  const std::size_t across = 3 - up;
  const double hand = up == 2 ? 1 : -1;  // x, across, up are right-handed in both
  const std::vector<validation::Vector3> centres = validation::read_openfoam_centres(options.centres);
  const auto edges = validation::heights_of_cells(centres, up);
  std::vector<double> share;
  std::vector<validation::Vector3> velocity;
  for (std::size_t i = 0; i < centres.size(); ++i) {
    const double x = centres[i][0] - options.origin_x();
    const double low = edges[i].first - options.origin_up();
    const double high = edges[i].second - options.origin_up();
    const double y = hand * centres[i][across];
    const Water::Flow column = water.flow(x, y);
    if (centres[i][up] - options.origin_up() < column.bed) {
      fail("--centres {}: cell {} at ({:g}) lies below the bed, at {:g} there: its centre must be water or air",
           options.centres, i, fmt::join(centres[i], " "), column.bed + options.origin_up());
    }
    share.push_back(std::clamp((column.surface - low) / (high - low), 0.0, 1.0));
    validation::Vector3 moving{};
    if (share.back() > 0) {
      // In the middle of the cell's water; the round-off of a surface must not put it into the air.
      const double height = std::max(0.5 * (low + std::min(high, column.surface)), column.bed);
      const validation::Vector3 there = water.flow(x, y, height).velocity;
      moving[0] = there[0];
      moving[across] = hand * there[1];
      moving[up] = there[2];
    }
    velocity.push_back(moving);
  }
  return {write(options, "alpha.water.internalField", validation::openfoam_field(share)),
          write(options, "U.internalField", validation::openfoam_field(velocity))};
}

/// Different values of an input over the grid's points, ascending; empty where the solution has it not.
std::vector<double> along(const ExactSolution& solution, const std::vector<Point>& grid, const std::string& name) {
  std::set<double> values;
  if (const auto k = index_of(solution.inputs, name)) {
    for (const Point& point : grid) {
      if (!std::isnan(point[*k])) values.insert(point[*k]);
    }
  }
  return {values.begin(), values.end()};
}

std::vector<Point> grid_of(const ExactSolution& solution, const ExactOptions& options) {
  if (options.grid.empty()) fail("--write {}: --grid is missing", options.write);
  std::vector<Point> grid = points_on_grid(solution, options.grid);
  if (along(solution, grid, "t").size() > 1) fail("--grid {}: must be one instant, as t=0", options.grid);
  return grid;
}

std::vector<fs::path> write_geoclaw(Water& water, const ExactSolution& solution, const ExactOptions& options) {
  const std::vector<Point> grid = grid_of(solution, options);
  const std::vector<double> times = along(solution, grid, "t");
  water.at(times.empty() ? 0 : times.front());
  const std::vector<double> x = along(solution, grid, "x");
  std::vector<double> y = water.in_plan() ? along(solution, grid, "y") : std::vector<double>{0, options.width};
  if (x.size() < 2 || y.size() < 2) {
    fail("--grid {}: GeoClaw needs two points or more along x{}", options.grid, water.in_plan() ? " and y" : "");
  }
  const std::array names{"topo.xyz", "eta.xyz", "hu.xyz", "hv.xyz"};
  std::array<std::vector<double>, 4> fields;
  for (const double at_y : y) {
    const double across = water.in_plan() ? at_y : 0;
    for (const double at_x : x) {
      const Water::Flow flow = water.flow(at_x, across);
      if (!std::isfinite(flow.bed))
        fail("{}: is infinitely deep and has no bed for topo.xyz: GeoClaw needs a finite depth", solution.name);
      const auto [hu, hv] = water.discharge(at_x, across);
      const std::array values{flow.bed + options.origin_up(), flow.surface + options.origin_up(), hu, hv};
      for (std::size_t k = 0; k < values.size(); ++k) fields[k].push_back(values[k]);
    }
  }
  std::vector<double> shifted = x;
  for (double& one : shifted) one += options.origin_x();
  std::vector<fs::path> files;
  for (std::size_t k = 0; k < (water.in_plan() ? 4 : 3); ++k) {
    files.push_back(write(options, names[k], validation::geoclaw_grid(shifted, y, fields[k])));
  }
  return files;
}

std::vector<fs::path> write_vtk(const ExactSolution& solution, const std::map<std::string, double>& parameters,
                                const ExactOptions& options) {
  const std::vector<Point> grid = grid_of(solution, options);
  const exact::Evaluator evaluator = solution.evaluator(parameters);
  std::array<std::size_t, 3> counts{1, 1, 1};
  std::array<std::optional<std::size_t>, 3> place;
  for (std::size_t k = 0; k < solution.inputs.size(); ++k) {
    const exact::Coordinate& input = solution.inputs[k];
    if (input.name == "t") continue;
    const std::size_t axis = is_height(input) ? 2 : place[0] ? 1 : 0;
    place.at(axis) = k;
    counts.at(axis) = std::max<std::size_t>(along(solution, grid, input.name).size(), 1);
  }
  if (evaluator.curve) fail("{}: is a curve and no field", solution.name);
  std::vector<validation::Vector3> points;
  std::vector<validation::NamedField> fields;
  for (const exact::Quantity& output : solution.outputs) fields.push_back({output.name, {}});
  for (const Point& point : grid) {
    validation::Vector3 at{options.origin_x(), 0, options.origin_up()};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double moved = place.at(axis) ? point[*place.at(axis)] : 0;
      at.at(axis) += std::isnan(moved) ? 0 : moved;
    }
    points.push_back(at);
    std::vector<double> values(fields.size(), validation::nan);
    try {
      values = evaluator.eval(point);
    } catch (const exact::OutsideFluid&) {  // a rectangle never fits a wave
    }
    for (std::size_t k = 0; k < fields.size(); ++k) fields[k].values.push_back(values[k]);
  }
  return {write(options, solution.name + ".vtk", validation::legacy_vtk(solution.title, counts, points, fields))};
}

/// A piston that makes a wave of permanent form moves with the mean velocity behind it, c eta/(d + eta), which takes
/// the wave's own eta at the piston (Goring 1978). From where the surface is a ten thousandth of the crest to where it
/// is again; time 0 is the beginning.
struct Piston {
  std::vector<double> times, positions;

  void add(double time, double position) {
    times.push_back(time);
    positions.push_back(position);
  }
};

Piston solitary_piston(Water& water, double speed, double depth, std::optional<std::vector<double>> times) {
  water.at(0);
  const double crest = water.flow(0).surface;
  double reach = depth;
  while (water.flow(reach).surface > 1e-4 * crest) reach += 0.01 * depth;
  const double start = reach / speed;  // the crest passes the piston's first place then
  const auto rate = [&](double t, double position) {
    water.at(t - start);
    const double eta = water.flow(position).surface;
    return speed * eta / (depth + eta);
  };
  const double step = 1e-3 * depth / speed;
  double t = 0;
  double position = 0;
  Piston fine{{0}, {0}};
  while (t < start || rate(t, position) > 1e-4 * speed * crest / (depth + crest)) {
    const double k1 = rate(t, position);
    const double k2 = rate(t + step / 2, position + step / 2 * k1);
    const double k3 = rate(t + step / 2, position + step / 2 * k2);
    const double k4 = rate(t + step, position + step * k3);
    position += step * (k1 + 2 * k2 + 2 * k3 + k4) / 6;
    t += step;
    fine.add(t, position);
  }
  Piston piston;
  if (!times) {
    for (std::size_t k = 0; k < fine.times.size(); k += 20) piston.add(fine.times[k], fine.positions[k]);
    return piston;
  }
  const std::vector<double>& x = fine.positions;
  for (const double at : *times) {
    const double place = std::clamp(at / step, 0.0, static_cast<double>(x.size() - 1));
    const auto k = std::min(static_cast<std::size_t>(place), x.size() - 2);
    piston.add(at, std::lerp(x[k], x[k + 1], place - static_cast<double>(k)));
  }
  return piston;
}

std::vector<fs::path> write_dualsphysics(const ExactSolution& solution, const std::map<std::string, double>& parameters,
                                         const ExactOptions& options) {
  std::optional<std::vector<double>> times;
  if (!options.grid.empty()) times = along(solution, points_on_grid(solution, options.grid), "t");
  if (times && (times->size() < 2 || times->front() != 0)) {
    fail("--grid {}: t must be two times or more, the first 0: a paddle starts from rest then", options.grid);
  }
  Piston piston;
  if (solution.name == "solitary" || solution.name == "solitary_asymptotic") {
    Water water(solution, parameters);
    const double speed = solution.evaluator(parameters).scalars().front();
    piston = solitary_piston(water, speed, parameters.at("depth"), times);
  } else if (solution.name == "wavemaker" && parameters.at("kind") == 0) {
    const std::vector<double> scalars = solution.evaluator(parameters).scalars();
    const double stroke = scalars.at(1);
    const double period = scalars.at(3);
    if (!times) times = along(solution, points_on_grid(solution, fmt::format("t=0:{:.17g}:1001", 10 * period)), "t");
    for (const double t : *times) {
      // Over the first period the stroke grows from 0: position, velocity and acceleration are continuous.
      const double grown = t < period ? std::pow(std::sin(0.5 * std::numbers::pi * t / period), 2) : 1;
      piston.add(t, grown * 0.5 * stroke * std::sin(2 * std::numbers::pi * t / period));
    }
  } else {
    fail(
        "--write dualsphysics: {} has no piston: must be one of solitary, solitary_asymptotic, wavemaker with "
        "kind=piston",
        solution.name);
  }
  for (double& position : piston.positions) position += options.origin_x();
  return {write(options, "paddle.csv", validation::dualsphysics_motion(piston.times, piston.positions))};
}

}  // namespace

const std::vector<std::string>& input_formats() {
  static const std::vector<std::string> formats{"openfoam", "dualsphysics", "geoclaw", "vtk", "csv"};
  return formats;
}

std::vector<fs::path> write_inputs(const ExactSolution& solution, const std::map<std::string, double>& parameters,
                                   const ExactOptions& options) {
  if (options.write == "dualsphysics") return write_dualsphysics(solution, parameters, options);
  if (options.write == "vtk") return write_vtk(solution, parameters, options);
  Water water(solution, parameters);
  if (options.write == "geoclaw") return write_geoclaw(water, solution, options);
  water.at(instant(solution, options));
  return write_openfoam(water, options);
}

}  // namespace seiche::command
