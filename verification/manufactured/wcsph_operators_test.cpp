// Operators of smoothed particles on a manufactured field: orders and floors, on lattices and on disordered particles.
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "verification/check.hpp"
#include "verification/lattice_sums.hpp"
#include "verification/manufactured/particle_operators.hpp"
#include "verification/refinement.hpp"

namespace seiche::verification::wcsph_operators_test {

using evidence::Claim;
using wcsph::CubicSpline;

constexpr double two_pi = 2 * std::numbers::pi;
const std::string source =
    "Quinlan, Basa and Lastiwka, Int. J. Numer. Meth. Eng. 66 (2006) 2064; regression: digits computed once by an "
    "earlier program";

/// Errors of f = sin(2 pi x) cos(2 pi z) in L2 over the norm of what is approximated, and by what factor the operator
/// multiplies it.
struct Errors {
  double interpolation, difference, symmetric, laminar, moving_least_squares;
  double interpolation_factor, difference_factor, laminar_factor;
};

Errors errors(std::size_t n, double jitter, double smoothing) {
  const Cloud cloud = unit_square(n, jitter);
  const std::size_t count = cloud.x.size();
  std::vector<double> f(count);
  for (std::size_t a = 0; a < count; ++a) f[a] = std::sin(two_pi * cloud.x[a]) * std::cos(two_pi * cloud.z[a]);
  const std::vector<Operators> computed = operators<CubicSpline>(cloud, smoothing / static_cast<double>(n), f);
  Errors e{};
  double norm = 0, gradient_norm = 0;
  for (std::size_t a = 0; a < count; ++a) {
    const Operators& at = computed[a];
    const Eigen::Vector2d gradient =
        two_pi * Eigen::Vector2d(std::cos(two_pi * cloud.x[a]) * std::cos(two_pi * cloud.z[a]),
                                 -std::sin(two_pi * cloud.x[a]) * std::sin(two_pi * cloud.z[a]));
    const double laplacian = -2 * two_pi * two_pi * f[a];
    const auto square = [](double value) { return value * value; };
    e.interpolation += square(at.interpolation - f[a]);
    e.moving_least_squares += square(at.moving_least_squares - f[a]);
    e.difference += (at.difference - gradient).squaredNorm();
    e.symmetric += (at.symmetric - gradient).squaredNorm();
    e.laminar += square(at.laminar - laplacian);
    e.interpolation_factor += at.interpolation * f[a];
    e.difference_factor += at.difference.dot(gradient);
    e.laminar_factor += at.laminar * laplacian;
    norm += square(f[a]);
    gradient_norm += gradient.squaredNorm();
  }
  const double laplacian_norm = std::pow(2 * two_pi * two_pi, 2) * norm;
  e.interpolation = std::sqrt(e.interpolation / norm);
  e.moving_least_squares = std::sqrt(e.moving_least_squares / norm);
  e.difference = std::sqrt(e.difference / gradient_norm);
  e.symmetric = std::sqrt(e.symmetric / gradient_norm);
  e.laminar = std::sqrt(e.laminar / laplacian_norm);
  e.interpolation_factor /= norm;
  e.difference_factor /= gradient_norm;
  e.laminar_factor /= laplacian_norm;
  return e;
}

const std::vector<std::size_t> sizes{32, 48, 64, 96, 128};

std::vector<double> spacings() {
  std::vector<double> dx;
  for (const std::size_t n : sizes) dx.push_back(1 / static_cast<double>(n));
  return dx;
}

/// One number of each entry.
template <class Member>
std::vector<double> column(const std::vector<Errors>& table, Member member, double limit = 0) {
  std::vector<double> values;
  for (const Errors& e : table) values.push_back(std::abs(e.*member - limit));
  return values;
}

void draw(Check& check, const std::string& id, const std::string& title, const std::string& caption,
          const std::vector<Errors>& table, bool symmetric) {
  const std::vector<double> dx = spacings();
  auto& panel =
      check.figure(id, title, caption).panel({.x = "dx", .y = "relative L2 error", .log_x = true, .log_y = true});
  panel.points("interpolation", dx, column(table, &Errors::interpolation));
  panel.points("moving least squares", dx, column(table, &Errors::moving_least_squares), Role::exact);
  panel.points("difference gradient", dx, column(table, &Errors::difference), Role::peer);
  panel.points("laminar operator", dx, column(table, &Errors::laminar), Role::data);
  if (symmetric) panel.points("symmetric gradient", dx, column(table, &Errors::symmetric), Role::guide);
  std::vector<double> slope;
  for (const double d : dx) slope.push_back(0.02 * d * d * 32 * 32);
  panel.line("slope 2", dx, slope, Role::guide);
}

void check_order(Check& check, const std::string& id, const std::string& text, const std::vector<double>& error,
                 const Order& order) {
  check.that(Claim{.id = id, .text = text, .quantity = "order in the spacing", .source = source},
             observed_order(spacings(), error), order);
}

TEST_CASE("on a square lattice operators tend to their lattice sums with second order", "[manufactured]") {
  Check check("wcsph_operators_lattice", "Operators of particles on a square lattice",
              "$f = \\sin 2\\pi x\\,\\cos 2\\pi z$ on the periodic unit square, cubic spline, $h/dx = 1.3$. A plane "
              "wave remains one: each operator multiplies it by a factor, which tends with order 2 not to 1 but to the "
              "operator's sum over the lattice, so that the error of the first derivative tends to $|M-1| = "
              "1.05\\,\\%$ (changing its sign on the way). Moving least squares alone has the factor 1 exactly.");
  std::vector<Errors> table;
  for (const std::size_t n : sizes) table.push_back(errors(n, 0, 1.3));
  const LatticeSums sums = lattice_sums<CubicSpline>(1.3);
  const Order second{2, 0.05, "the next term of the expansion in (k h)^2 changes the slope by about 0.02 at N = 32"};
  check_order(check, "interpolation-order", "The factor of interpolation tends to sum V W with order 2.",
              column(table, &Errors::interpolation_factor, sums.zeroth), second);
  check_order(check, "difference-order", "The factor of the difference gradient tends to M with order 2.",
              column(table, &Errors::difference_factor, sums.first), second);
  check_order(check, "laminar-order", "The factor of the laminar operator tends to its lattice sum with order 2.",
              column(table, &Errors::laminar_factor, sums.laminar), second);
  check_order(check, "mls-order", "Moving least squares is of order 2.", column(table, &Errors::moving_least_squares),
              second);
  for (std::size_t k = 0; k < sizes.size(); ++k) {
    check.holds(
        fmt::format("mls-{}", sizes[k]) + ": Moving least squares on a lattice is interpolation over its own sum.",
        {table[k].moving_least_squares},
        Roundoff{
            2.0 / 3 * static_cast<double>(sizes[k] * sizes[k]) + 100, 1,
            "the factor is a quotient of two sums over N^2 particles, whose partial sums have a third of the square of "
            "the whole in the mean; two sums of 21 terms and a 3 x 3 solution, some 100 roundings of numbers up to 1",
            1 - table[k].interpolation_factor / sums.zeroth});
  }
  draw(check, "lattice", "Operators on a square lattice",
       "The error of the uncorrected gradient does not vanish with the spacing at fixed h/dx.", table, false);
}

TEST_CASE("on disordered particles only moving least squares keeps its order", "[manufactured]") {
  Check check("wcsph_operators_disordered", "Operators of particles on disordered particles",
              "The same with every particle moved by up to 0.2 dx. At fixed $h/dx$ interpolation and the difference "
              "gradient have order 0, the symmetric gradient, which does not vanish for a constant, and the laminar "
              "operator order -1; moving least squares keeps order 2. A claim of second order at fixed $h/dx$ on "
              "disordered particles would be wrong.");
  std::vector<Errors> table;
  for (const std::size_t n : sizes) table.push_back(errors(n, 0.2, 1.3));
  const auto about = [](double theory) {
    return Order{theory, 0.25, "scatter of 3 sqrt(20)/N per norm over a factor of 4 in the spacing"};
  };
  check_order(check, "interpolation-order", "Interpolation on disordered particles does not converge.",
              column(table, &Errors::interpolation), about(0));
  check_order(check, "difference-order", "The difference gradient does not converge.",
              column(table, &Errors::difference), about(0));
  check_order(check, "symmetric-order", "The symmetric gradient grows as 1/dx.", column(table, &Errors::symmetric),
              about(-1));
  check_order(check, "laminar-order", "The laminar operator grows as 1/dx.", column(table, &Errors::laminar),
              about(-1));
  check_order(check, "mls-order", "Moving least squares is of order 2.", column(table, &Errors::moving_least_squares),
              Order{2, 0.05, "an error of the smooth field, without scatter"});
  draw(check, "disordered", "Operators on disordered particles",
       "Disorder of 0.2 dx: the gradients and the laminar operator do not converge at fixed h/dx.", table, true);
}

TEST_CASE("operators converge on disordered particles when the number of neighbours grows", "[manufactured]") {
  Check check("wcsph_operators_growing_support", "Operators with a growing number of neighbours",
              "Disorder of 0.2 dx and $h/dx = 1.3\\sqrt{N/32}$: h tends to 0 as the square root of the spacing, so "
              "that errors of order $h^2$ appear with order 1.");
  std::vector<Errors> table;
  for (const std::size_t n : sizes) table.push_back(errors(n, 0.2, 1.3 * std::sqrt(static_cast<double>(n) / 32)));
  const Order first{1, 0.25, "order 2 in h; scatter and discrete sums of few neighbours at the coarse end"};
  check_order(check, "difference-order", "The difference gradient is of order 1.", column(table, &Errors::difference),
              first);
  check_order(check, "interpolation-order", "Interpolation with growing support is of order 1.",
              column(table, &Errors::interpolation), first);
  check_order(check, "mls-order", "Moving least squares is of order 1.", column(table, &Errors::moving_least_squares),
              Order{1, 0.05, "an error of the smooth field, without scatter"});
}

}  // namespace seiche::verification::wcsph_operators_test
