#include "seiche/models/gauss_particles/spline_space.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>
#include <boost/math/quadrature/gauss.hpp>

#include "seiche/linear/worth_threads.hpp"
#include "seiche/require.hpp"
#include "seiche/require_that.hpp"

namespace seiche::gauss_particles {

namespace {

constexpr std::size_t chunk = 256;               // cells whose matrices are kept at a time
constexpr double fewest_per_cell = 8;            // particles, or the sums over them are no integrals
constexpr double most_cells_per_particle = 100;  // or some of them have flown away
constexpr double largest_residual = 1e-10;
constexpr int most_corrections = 4;

/// The derivative, so many times, of a function of a cell, [m] times; z is its argument.
double derivative(const CellPolynomials& p, std::size_t order, double cell, std::size_t function, std::size_t times,
                  double z) {
  double value = 0;
  for (std::size_t power = order; power-- > times;) {
    double factor = p.function[function * order + power];
    for (std::size_t d = 0; d < times; ++d) factor *= static_cast<double>(power - d) / cell;
    value = value * z + factor;
  }
  return value;
}

}  // namespace

SplineSpace::SplineSpace(const LatticePlan& plan, Settings settings) : SplineSpace(plan.ground, plan, settings) {
  plan.check();
}

SplineSpace::SplineSpace(Ground ground, LatticeAt at, Settings settings)
    : ground_(std::move(ground)), at_(std::move(at)), settings_(settings) {
  require_ranges(settings_);
  require_that(at_ != nullptr, "no lattice; allowed: a function that gives one");
}

double SplineSpace::resolution() const {
  return lattice_.empty() ? 0 : std::min(lattice().x.cell(), lattice().y.cell());
}

template <class Work>
void SplineSpace::for_cells(Work&& work) const {
  linear::share_out(cells_.cells().size(), particles_ >= linear::worth_threads, [&](std::size_t c) {
    if (!functions_.free(c)) work(c);
  });
}

/// work(c, functions) for the cells that do not fly freely, one after the other, with the numbers of their functions.
template <class Work>
void SplineSpace::visit_cells(const Work& work) const {
  std::array<std::size_t, CellKernels::most_functions> functions{};
  for (std::size_t c = 0; c < cells_.cells().size(); ++c) {
    if (functions_.free(c)) continue;
    local_functions(c, functions.data());
    work(c, std::span<const std::size_t>(functions.data(), local_));
  }
}

void SplineSpace::require_enough(std::span<const double> mass) const {
  const double total = std::accumulate(mass.begin(), mass.end(), 0.0);
  const auto count = std::count_if(mass.begin(), mass.end(), [](double m) { return m > 0; });
  const double per_cell = full_mass_ * static_cast<double>(count) / total;
  if (!(per_cell >= fewest_per_cell)) {
    throw mechanics::Infeasible(0, "a full cell holds {:.3g} particles; allowed: at least {:g}", per_cell,
                                fewest_per_cell);
  }
}

void SplineSpace::place(mechanics::Interval when, std::span<const double> x, std::span<const double> y,
                        std::span<const double> mass, double penalty) {
  const Bounds bounds = cells_.survey(ground_, x, y);
  lattice_.assign(1, at_(when, bounds));
  const Lattice& lattice = lattice_.front();
  particles_ = x.size();
  local_ = static_cast<std::size_t>((lattice.x.degree() + 1) * (lattice.x.degree() + 1));
  full_mass_ = settings_.density * lattice.x.cell() * lattice.y.cell();
  require_enough(mass);
  const double extent = static_cast<double>(lattice.x.cells()) * static_cast<double>(lattice.y.cells());
  if (extent > most_cells_per_particle * static_cast<double>(particles_) + 1e6) {
    throw mechanics::Infeasible(
        bounds.left,
        "particles from ({:g}, {:g}) to ({:g}, {:g}): a lattice of {:.3g} cells; allowed: {:g} per particle",
        bounds.left, bounds.low, bounds.right, bounds.high, extent, most_cells_per_particle);
  }
  cells_.sort(lattice, x, mass);
  functions_.choose(lattice, cells_, full_mass_, settings_.inner_fraction);
  if (functions_.inner_cells() == 0) {
    throw mechanics::Infeasible("no cell of the lattice is full enough to be an inner one", bounds.left);
  }
  kernels_ = &cell_kernels(lattice.x.degree(), ground_.profile != nullptr);
  const double cell = std::sqrt(lattice.x.cell() * lattice.y.cell());
  penalty_factor_ = penalty * settings_.density * std::pow(cell, 3.5);
  if (penalty_factor_ != 0) penalty_.prepare(lattice);
  facts_ = {.unknowns = functions_.unknowns(), .inner_cells = functions_.inner_cells()};
  std::vector<std::uint8_t> free;
  for (std::size_t c = 0; c < cells_.cells().size(); ++c) {
    if (!functions_.free(c)) continue;
    free.resize(particles_, 0);
    const OccupiedCells::Cell& flying = cells_.cells()[c];
    for (std::size_t k = flying.begin; k < flying.begin + flying.count; ++k) {
      free[cells_.particle()[k]] = 1;
      if (cells_.mass()[k] > 0) ++facts_.free_particles;
    }
  }
  free_ = std::move(free);
  assemble();
  system_.factor();
}

CellParticles SplineSpace::particles(std::size_t c) const {
  const OccupiedCells::Cell& cell = cells_.cells()[c];
  return {.count = cell.places,
          .across = cells_.across() + cell.begin,
          .up = cells_.up() + cell.begin,
          .mass = cells_.mass() + cell.begin,
          .slope = cells_.slope() == nullptr ? nullptr : cells_.slope() + cell.begin};
}

CellSplines SplineSpace::splines(std::size_t c) const {
  const OccupiedCells::Cell& cell = cells_.cells()[c];
  const SplineAxis& x = lattice().x;
  const SplineAxis& y = lattice().y;
  return {.x = &cell_polynomials(x.degree())[x.kind(cell.x)],
          .y = &cell_polynomials(y.degree())[y.kind(cell.y)],
          .cell_x = x.cell(),
          .cell_y = y.cell()};
}

void SplineSpace::local_functions(std::size_t c, std::size_t* functions) const {
  const OccupiedCells::Cell& cell = cells_.cells()[c];
  const long degree = lattice().x.degree();
  for (long i = cell.x; i <= cell.x + degree; ++i) {
    for (long j = cell.y; j <= cell.y + degree; ++j) *functions++ = functions_.index(i, j);
  }
}

double SplineSpace::penalty_weight(std::size_t c) const {
  return penalty_factor_ * std::min(1.0, cells_.cells()[c].mass / full_mass_);
}

std::span<const double> SplineSpace::penalty_matrix(std::size_t c) {
  const OccupiedCells::Cell& cell = cells_.cells()[c];
  return penalty_.matrix(lattice().x.kind(cell.x), lattice().y.kind(cell.y));
}

template <class Use>
void SplineSpace::penalty_load(std::size_t c, std::span<const std::size_t> functions, const Use& use) {
  const std::span<const double> form = penalty_matrix(c);
  for (std::size_t a = 0; a < local_; ++a) {
    double sum = 0;
    for (std::size_t b = 0; b < local_; ++b) sum += form[a * local_ + b] * coefficients_[functions[b]];
    use(functions[a], sum);
  }
}

void SplineSpace::assemble() {
  const auto count = cells_.cells().size();
  const std::size_t size = local_ * local_;
  if (penalty_factor_ != 0) {
    // Fills the tables of all kinds of cells, which the threads then only read.
    for (std::size_t c = 0; c < count; ++c) static_cast<void>(penalty_matrix(c));
  }
  matrices_.resize(chunk * size);
  do {
    system_.begin(lattice(), functions_);
    for (std::size_t first = 0; first < count; first += chunk) {
      const std::size_t last = std::min(first + chunk, count);
      linear::share_out(last - first, particles_ >= linear::worth_threads, [&](std::size_t k) {
        const std::size_t c = first + k;
        if (functions_.free(c)) return;
        double* const matrix = matrices_.data() + k * size;
        kernels_->mass_matrix(particles(c), splines(c), matrix);
        if (penalty_factor_ != 0) {
          const std::span<const double> form = penalty_matrix(c);
          const double weight = penalty_weight(c);
          for (std::size_t i = 0; i < size; ++i) matrix[i] += weight * form[i];
        }
      });
      for (std::size_t c = first; c < last; ++c) {
        if (!functions_.free(c)) add_cell(c, matrices_.data() + (c - first) * size);
      }
    }
  } while (!system_.complete());
}

void SplineSpace::add_cell(std::size_t c, const double* matrix) {
  if (!functions_.plain(c)) {
    add_continued_cell(c, matrix);
    return;
  }
  std::array<std::size_t, CellKernels::most_functions> functions{};
  local_functions(c, functions.data());
  for (std::size_t a = 0; a < local_; ++a) functions[a] = functions_.unknown(functions[a]);
  system_.add({functions.data(), local_}, matrix);
}

/// E^T A E of a cell, over the unknowns of which its functions are made.
void SplineSpace::add_continued_cell(std::size_t c, const double* matrix) {
  std::array<std::size_t, CellKernels::most_functions> functions{};
  local_functions(c, functions.data());
  column_of_.resize(functions_.unknowns(), ActiveFunctions::none);
  involved_.clear();
  for (std::size_t a = 0; a < local_; ++a) {
    for (const ActiveFunctions::Term& term : functions_.terms(functions[a])) {
      if (column_of_[term.unknown] != ActiveFunctions::none) continue;
      column_of_[term.unknown] = involved_.size();
      involved_.push_back(term.unknown);
    }
  }
  const std::size_t n = involved_.size();
  half_.assign(local_ * n, 0.0);  // A E
  for (std::size_t b = 0; b < local_; ++b) {
    for (const ActiveFunctions::Term& term : functions_.terms(functions[b])) {
      const std::size_t column = column_of_[term.unknown];
      for (std::size_t a = 0; a < local_; ++a) half_[a * n + column] += matrix[a * local_ + b] * term.weight;
    }
  }
  reduced_.assign(n * n, 0.0);
  for (std::size_t a = 0; a < local_; ++a) {
    for (const ActiveFunctions::Term& term : functions_.terms(functions[a])) {
      double* const row = reduced_.data() + column_of_[term.unknown] * n;
      const double* const from = half_.data() + a * n;
#pragma omp simd
      for (std::size_t k = 0; k < n; ++k) row[k] += term.weight * from[k];
    }
  }
  for (const std::size_t unknown : involved_) column_of_[unknown] = ActiveFunctions::none;
  system_.add(involved_, reduced_.data());
}

void SplineSpace::evaluate() {
  coefficients_.resize(functions_.functions());
  functions_.extend(z_, coefficients_);
  for_cells([this](std::size_t c) {
    std::array<std::size_t, CellKernels::most_functions> functions;
    std::array<double, CellKernels::most_functions> local;
    local_functions(c, functions.data());
    for (std::size_t a = 0; a < local_; ++a) local[a] = coefficients_[functions[a]];
    const std::size_t begin = cells_.cells()[c].begin;
    kernels_->velocity(particles(c), splines(c), local.data(), ux_.data() + begin, uy_.data() + begin);
  });
}

/// What impulses on single particles add to the load, function by function.
void SplineSpace::take_impulses(std::span<const double> impulse_x, std::span<const double> impulse_y) {
  impulse_load_.assign(functions_.functions(), 0.0);
  if (impulse_x.empty()) return;
  const std::span<const std::size_t> particle = cells_.particle();
  dx_.assign(particle.size(), 0.0);
  dy_.assign(particle.size(), 0.0);
  ones_.assign(particle.size(), 1.0);
  for (std::size_t k = 0; k < particle.size(); ++k) {
    if (particle[k] == OccupiedCells::nobody) continue;
    dx_[k] = impulse_x[particle[k]];
    dy_[k] = impulse_y[particle[k]];
  }
  std::array<double, CellKernels::most_functions> load{};
  visit_cells([&](std::size_t c, std::span<const std::size_t> functions) {
    const std::size_t begin = cells_.cells()[c].begin;
    CellParticles at = particles(c);
    at.mass = ones_.data() + begin;
    kernels_->load(at, splines(c), dx_.data() + begin, dy_.data() + begin, load.data());
    for (std::size_t a = 0; a < local_; ++a) impulse_load_[functions[a]] += load[a];
  });
}

void SplineSpace::residual(std::span<double> r) {
  loads_.resize(cells_.cells().size() * local_);
  for_cells([this](std::size_t c) {
    const OccupiedCells::Cell& cell = cells_.cells()[c];
    for (std::size_t k = cell.begin; k < cell.begin + cell.places; ++k) {
      dx_[k] = wx_[k] - ux_[k];
      dy_[k] = wy_[k] - uy_[k];
    }
    kernels_->load(particles(c), splines(c), dx_.data() + cell.begin, dy_.data() + cell.begin,
                   loads_.data() + c * local_);
  });
  function_load_ = impulse_load_;
  visit_cells([&](std::size_t c, std::span<const std::size_t> functions) {
    const double* const load = loads_.data() + c * local_;
    for (std::size_t a = 0; a < local_; ++a) function_load_[functions[a]] += load[a];
    if (penalty_factor_ == 0) return;
    const double weight = penalty_weight(c);
    penalty_load(c, functions, [&](std::size_t f, double sum) { function_load_[f] -= weight * sum; });
  });
  functions_.restrict(function_load_, r);
}

double SplineSpace::penalty_form() {
  double total = 0;
  if (penalty_factor_ == 0) return total;
  visit_cells([&](std::size_t c, std::span<const std::size_t> functions) {
    double sum = 0;
    penalty_load(c, functions, [&](std::size_t f, double row) { sum += coefficients_[f] * row; });
    total += penalty_weight(c) * sum;
  });
  return total;
}

void SplineSpace::project(std::span<double> u, std::span<double> v, std::span<const double> impulse_x,
                          std::span<const double> impulse_y) {
  take_impulses(impulse_x, impulse_y);
  const std::span<const std::size_t> particle = cells_.particle();
  for (std::vector<double>* const w : {&wx_, &wy_, &ux_, &uy_, &dx_, &dy_}) w->assign(particle.size(), 0.0);
  double square = 0;
  for (std::size_t k = 0; k < particle.size(); ++k) {
    if (particle[k] == OccupiedCells::nobody) continue;
    wx_[k] = u[particle[k]];
    wy_[k] = v[particle[k]];
    square += cells_.mass()[k] * (wx_[k] * wx_[k] + wy_[k] * wy_[k]);
  }
  z_.assign(functions_.unknowns(), 0.0);
  r_.resize(z_.size());
  coefficients_.assign(functions_.functions(), 0.0);
  residual(r_);
  double last = system_.correct(r_, z_);
  // Of the velocities, or where these are small of what the impulses make of them.
  const double norm = std::max(std::sqrt(square), last);
  evaluate();
  for (int k = 0; k < most_corrections && norm > 0; ++k) {
    residual(r_);
    const double now = system_.scaled_largest(r_);
    facts_.residual = now / norm;
    // As small as its own rounding, or no longer falling.
    if (!(now > std::numeric_limits<double>::epsilon() * norm) || (k > 0 && now > 0.25 * last)) break;
    last = system_.correct(r_, z_);
    evaluate();
  }
  if (!(facts_.residual <= largest_residual)) {
    throw mechanics::Infeasible(0, "normal equations solved to {:.2g} only; allowed: {:g}", facts_.residual,
                                largest_residual);
  }
  facts_.penalty = penalty_form();
  for (std::size_t c = 0; c < cells_.cells().size(); ++c) {
    if (functions_.free(c)) continue;
    const OccupiedCells::Cell& cell = cells_.cells()[c];
    for (std::size_t k = cell.begin; k < cell.begin + cell.count; ++k) {
      u[particle[k]] = ux_[k];
      v[particle[k]] = uy_[k];
    }
  }
}

void VorticityPenalty::prepare(const Lattice& lattice) {
  const bool same = degree_ == lattice.x.degree() && cell_x_ == lattice.x.cell() && cell_y_ == lattice.y.cell();
  degree_ = lattice.x.degree();
  cell_x_ = lattice.x.cell();
  cell_y_ = lattice.y.cell();
  if (!same) matrices_.assign(lattice.x.kinds() * lattice.y.kinds(), {});
}

std::span<const double> VorticityPenalty::matrix(std::size_t kind_x, std::size_t kind_y) {
  std::vector<double>& matrix = matrices_[kind_x * cell_polynomials(degree_).size() + kind_y];
  if (!matrix.empty()) return matrix;
  const auto order = static_cast<std::size_t>(degree_) + 1;
  // Integral over a cell of derivative r of function i times derivative s of function k.
  const auto along = [&](std::size_t kind, double cell) {
    return [&p = cell_polynomials(degree_)[kind], order, cell](std::size_t r, std::size_t s, std::size_t i,
                                                               std::size_t k) {
      using Rule = boost::math::quadrature::gauss<double, highest_degree + 1>;  // exact for the product
      return cell *
             Rule::integrate(
                 [&](double z) { return derivative(p, order, cell, i, r, z) * derivative(p, order, cell, k, s, z); },
                 -0.5, 0.5);
    };
  };
  const auto x = along(kind_x, cell_x_);
  const auto y = along(kind_y, cell_y_);
  matrix.resize(order * order * order * order);
  // grad lap Phi = (B_i''' B_j + B_i' B_j'', B_i'' B_j' + B_i B_j''')
  struct Product {
    std::size_t x, y;
  };
  constexpr std::array<std::array<Product, 2>, 2> gradient{{{{{3, 0}, {1, 2}}}, {{{2, 1}, {0, 3}}}}};
  std::size_t entry = 0;
  for (std::size_t i = 0; i < order; ++i) {
    for (std::size_t j = 0; j < order; ++j) {
      for (std::size_t k = 0; k < order; ++k) {
        for (std::size_t l = 0; l < order; ++l) {
          double sum = 0;
          for (const auto& component : gradient) {
            for (const Product a : component) {
              for (const Product b : component) sum += x(a.x, b.x, i, k) * y(a.y, b.y, j, l);
            }
          }
          matrix[entry++] = sum;
        }
      }
    }
  }
  return matrix;
}

}  // namespace seiche::gauss_particles
