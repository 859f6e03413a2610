// Operators of smoothed particles on a manufactured field: orders and floors, on lattices and on disordered particles.
#include <array>
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

using wcsph::CubicSpline;

constexpr double two_pi = 2 * std::numbers::pi;
const std::string source = "Quinlan, Basa and Lastiwka, Int. J. Numer. Meth. Eng. 66 (2006) 2064";

/// An operator beside what it approximates, everywhere.
class Compared {
 public:
  void add(double found, double exact) { add(Eigen::Vector2d(found, 0), Eigen::Vector2d(exact, 0)); }
  void add(const Eigen::Vector2d& found, const Eigen::Vector2d& exact) {
    squares_ += (found - exact).squaredNorm();
    products_ += found.dot(exact);
    norm_ += exact.squaredNorm();
  }
  /// In L2, over the norm of what is approximated.
  [[nodiscard]] double error() const { return std::sqrt(squares_ / norm_); }
  /// That the operator multiplies it by.
  [[nodiscard]] double factor() const { return products_ / norm_; }

 private:
  double squares_ = 0, products_ = 0, norm_ = 0;
};

/// Of f = sin(2 pi x) cos(2 pi z).
struct Errors {
  Compared interpolation, difference, symmetric, laminar, moving_least_squares;
};

Errors errors(std::size_t n, double jitter, double smoothing) {
  const Cloud cloud = unit_square(n, jitter);
  const std::size_t count = cloud.x.size();
  std::vector<double> f(count);
  for (std::size_t a = 0; a < count; ++a) f[a] = std::sin(two_pi * cloud.x[a]) * std::cos(two_pi * cloud.z[a]);
  const std::vector<Operators> computed = operators<CubicSpline>(cloud, smoothing / static_cast<double>(n), f);
  Errors e;
  for (std::size_t a = 0; a < count; ++a) {
    const Operators& at = computed[a];
    const Eigen::Vector2d gradient =
        two_pi * Eigen::Vector2d(std::cos(two_pi * cloud.x[a]) * std::cos(two_pi * cloud.z[a]),
                                 -std::sin(two_pi * cloud.x[a]) * std::sin(two_pi * cloud.z[a]));
    e.interpolation.add(at.interpolation, f[a]);
    e.moving_least_squares.add(at.moving_least_squares, f[a]);
    e.difference.add(at.difference, gradient);
    e.symmetric.add(at.symmetric, gradient);
    e.laminar.add(at.laminar, -2 * two_pi * two_pi * f[a]);
  }
  return e;
}

const std::vector<double> spacings = widths(1, {32, 48, 64, 96, 128});

TEST_CASE("on a square lattice operators converge to their lattice sums at second order", "[manufactured]") {
  Check check("wcsph_operators_lattice", "Operators of particles on a square lattice",
              "$f = \\sin 2\\pi x\\,\\cos 2\\pi z$ on the periodic unit square, cubic spline, $h/dx = 1.3$. A plane "
              "wave remains one: each operator multiplies it by a factor, which tends with order 2 not to 1 but to the "
              "operator's sum over the lattice, so that the error of the first derivative tends to $|M-1| = "
              "1.05\\,\\%$ (changing its sign on the way). Moving least squares alone has the factor 1 exactly.",
              source);
  const LatticeSums sums = lattice_sums<CubicSpline>(1.3);
  const Order second{2, 0.05, "the next term of the expansion in (k h)^2 changes the slope by about 0.02 at N = 32"};
  refine(
      check, {"dx", spacings},
      {{"interpolation-order", "The factor of interpolation tends to sum V W with order 2.", second},
       {"difference-order", "The factor of the difference gradient tends to M with order 2.", second},
       {"laminar-order", "The factor of the laminar operator converges to its lattice sum at second order.", second},
       {"mls-order", "Moving least squares is of order 2.", second}},
      [&](double dx) {
        const std::size_t n = cells_of(1, dx);
        const Errors e = errors(n, 0, 1.3);
        check.holds(
            fmt::format("The moving least squares interpolant on a regular arrangement equals the kernel interpolant "
                        "over its sum (N = {}).",
                        n),
            {e.moving_least_squares.error()},
            Roundoff{2.0 / 3 * static_cast<double>(n * n) + 100, 1,
                     "the factor is a quotient of two sums over N^2 particles, whose partial sums have a third of the "
                     "square of the whole in the mean; two sums of 21 terms and a 3 x 3 solution, some 100 roundings "
                     "of numbers up to 1",
                     1 - e.interpolation.factor() / sums.zeroth});
        return std::array{std::abs(e.interpolation.factor() - sums.zeroth),
                          std::abs(e.difference.factor() - sums.first), std::abs(e.laminar.factor() - sums.laminar),
                          e.moving_least_squares.error()};
      });
}

TEST_CASE("on disordered particles only moving least squares retains its order", "[manufactured]") {
  Check check("wcsph_operators_disordered", "Operators of particles on disordered particles",
              "The same with every particle moved by up to 0.2 dx. At fixed $h/dx$ interpolation and the difference "
              "gradient have order 0, the symmetric gradient, which does not vanish for a constant, and the laminar "
              "operator order -1; moving least squares retains order 2. A claim of second order at fixed $h/dx$ on "
              "disordered particles would be wrong.",
              source);
  const auto about = [](double theory) {
    return Order{theory, 0.25, "scatter of 3 sqrt(20)/N per norm over a factor of 4 in the spacing"};
  };
  refine(check, {"dx", spacings},
         {{"interpolation-order", "The error of interpolation on disordered particles is of order 0 in the spacing.",
           about(0)},
          {"difference-order",
           "The error of the difference gradient on disordered particles is of order 0 in the spacing.", about(0)},
          {"symmetric-order", "The symmetric gradient grows as 1/dx.", about(-1)},
          {"laminar-order", "The laminar operator grows as 1/dx.", about(-1)},
          {"mls-order", "Moving least squares is of order 2.",
           Order{2, 0.05, "an error of the smooth field, without scatter"}}},
         [](double dx) {
           const Errors e = errors(cells_of(1, dx), 0.2, 1.3);
           return std::array{e.interpolation.error(), e.difference.error(), e.symmetric.error(), e.laminar.error(),
                             e.moving_least_squares.error()};
         });
}

TEST_CASE("operators converge on disordered particles when the number of neighbours grows", "[manufactured]") {
  Check check("wcsph_operators_growing_support", "Operators with a growing number of neighbours",
              "Disorder of 0.2 dx and $h/dx = 1.3\\sqrt{N/32}$: h tends to 0 as the square root of the spacing, so "
              "that errors of order $h^2$ appear with order 1.",
              source);
  const Order first{1, 0.25, "order 2 in h; scatter and discrete sums of few neighbours at the coarse end"};
  refine(check, {"dx", spacings},
         {{"difference-order", "The difference gradient is of order 1.", first},
          {"interpolation-order", "Interpolation with growing support is of order 1.", first},
          {"mls-order", "Moving least squares is of order 1.",
           Order{1, 0.05, "an error of the smooth field, without scatter"}}},
         [](double dx) {
           const Errors e = errors(cells_of(1, dx), 0.2, 1.3 * std::sqrt(1 / (32 * dx)));
           return std::array{e.difference.error(), e.interpolation.error(), e.moving_least_squares.error()};
         });
}

}  // namespace seiche::verification::wcsph_operators_test
