/// What the entries of the catalogue are put together from. An entry stands at the end of its solution's file.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/tools/toms748_solve.hpp>

#include "seiche/exact/catalogue.hpp"
#include "seiche/exact/reference_solution.hpp"
#include "seiche/require.hpp"
#include "seiche/require_that.hpp"
#include "seiche/samples.hpp"

namespace seiche::exact {

using Values = std::map<std::string, double>;
using Row = Evaluator::Row;
using At = std::span<const double>;

inline constexpr double infinite = std::numeric_limits<double>::infinity();
inline constexpr double none_given = std::numeric_limits<double>::quiet_NaN();

inline const Coordinate position_x{"x", "m", 0, "horizontal position"};
inline const Coordinate time_t{"t", "s", 0, "time"};
inline const Coordinate height_y{"y", "m", none_given,
                                 "height above the undisturbed level; the surface where none is given"};
inline const Coordinate wavenumber_k{"k", "1/m", none_given, "wavenumber; that of the wavelength where none is given"};

inline Parameter gravity_parameter() {
  return {"gravity", "m/s^2", 9.81, 1e-6, 1e6, "acceleration of gravity; 1 where everything is scaled"};
}
inline Parameter depth_parameter(double default_value, double maximum) {
  return {"depth", "m", default_value, 1e-9, maximum, "depth of the water at rest"};
}
inline Parameter wavelength_parameter() {
  return {"wavelength", "m", 2 * std::numbers::pi, 1e-9, 1e9, "wavelength"};
}

/// What a member gives, a member of that, and so on; NaN for a number that there may not be.
inline double chained(const std::optional<double>& value) {
  return value.value_or(none_given);
}
template <class Value, class First, class... Then>
double chained(const Value& value, First first, Then... then) {
  return chained(std::invoke(first, value), then...);
}

/// A number that belongs to the solution as a whole: a member or a function of it, a member of what that gives, ...
template <class S>
struct Scalar : Quantity {
  template <class... Members>
  Scalar(std::string name, std::string unit, std::string meaning, Members... members)
      : Quantity{std::move(name), std::move(unit), std::move(meaning)},
        of([=](const S& solution) { return chained(solution, members...); }) {}

  std::function<double(const S&)> of;
};

/// An entry of the catalogue for the solution S.
template <ReferenceSolution S>
struct Entry {
  std::string name;
  std::string title;
  std::string citation;
  std::string formula;
  std::vector<Parameter> parameters;
  std::vector<Coordinate> inputs;
  std::vector<Quantity> outputs;
  std::vector<Scalar<S>> scalars;
  std::function<S(const Values&)> make;
  std::function<Row(const S&, At)> row;
  /// Where the solution is a curve at every point: its rows in place of `row`.
  std::function<std::vector<Row>(const S&, At)> curve = {};

  operator ExactSolution() const {  // NOLINT(google-explicit-constructor)
    const auto factory = [make = make, row = row, curve = curve, scalars = scalars](const Values& values) {
      const auto kept = std::make_shared<const S>(make(values));
      Evaluator evaluator;
      evaluator.eval = [kept, row](At at) { return row(*kept, at); };
      evaluator.uncertainty = [kept] { return kept->uncertainty(); };
      evaluator.self_test = [kept] { return kept->self_test(); };
      evaluator.scalars = [kept, scalars] {
        Row numbers;
        for (const Scalar<S>& scalar : scalars) numbers.push_back(scalar.of(*kept));
        return numbers;
      };
      if (curve) {
        evaluator.curve = [kept, curve](At at) { return curve(*kept, at); };
        evaluator.eval = [kept, curve](At at) { return curve(*kept, at).front(); };
      }
      return evaluator;
    };
    return {name, title, citation, formula, parameters, inputs, outputs, {scalars.begin(), scalars.end()}, factory};
  }
};

/// The value of a parameter on its way to a constructor: a number, a whole one, or the one chosen.
struct Given {
  std::string name;
  double value;

  template <class T>
  requires(std::is_arithmetic_v<T> || std::is_enum_v<T>) operator T() const {  // NOLINT(google-explicit-constructor)
    if constexpr (std::is_integral_v<T>) {
      require_that(value == std::floor(value), "{} = {:g} is out of range: must be a whole number", name, value);
    }
    return static_cast<T>(value);
  }
};

/// What a function makes of the parameters of these names, in this order; S from those of its constructor.
template <class Function, class... Names>
auto made_by(Function make, Names... names) {
  return [=](const Values& values) { return make(Given{names, values.at(names)}...); };
}
template <class S, class... Names>
auto from(Names... names) {
  return made_by([](const auto&... given) { return S(given...); }, names...);
}

inline const Quantity surface_eta{"eta", "m", "surface elevation"};
inline const Quantity velocity_u{"u", "m/s", "horizontal velocity"};
inline const Quantity velocity_v{"v", "m/s", "vertical velocity"};
inline const Quantity mean_velocity_u{"u", "m/s", "horizontal velocity, mean over the depth"};
inline const Quantity pressure_p{"p", "m^2/s^2", "pressure over density"};
inline const Quantity depth_h{"h", "m", "depth"};

/// Each of the numbers by its name, in this order.
inline void require_all_positive(std::initializer_list<std::pair<std::string_view, double>> named) {
  for (const auto& [name, value] : named) require_positive(name, value);
}

/// Relative departure of a value from the one expected, for self-tests.
inline double departure(double value, double expected) {
  return std::abs(value / expected - 1);
}

/// Rows of what many solutions yield: depth and velocity of shallow water, the same over its bed, and elevation and
/// velocity at a height or, where none is given, on the surface.

template <class S>
Row state_row(const S& solution, At at) {
  const auto state = solution.at(at[0], at[1]);
  return {state.depth, state.velocity};
}

template <class S>
Row steady_row(const S& solution, At at) {
  const auto state = solution.at(at[0]);
  return {state.depth, state.velocity, solution.elevation(at[0])};
}

template <class S>
Row wave_row(const S& wave, At at) {
  const double eta = wave.elevation(at[0], at[2]);
  const auto [u, v] = wave.velocity(at[0], std::isnan(at[1]) ? eta : at[1], at[2]);
  return {eta, u, v};
}

/// Elevation and velocity of a wave that keeps its shape and travels to +x.
template <class S>
Row travelling_row(const S& wave, double speed, At at) {
  const double x = at[0] - speed * at[1];
  return {wave.elevation(x), wave.depth_averaged_velocity(x)};
}

// What self-tests are made of: largest defects, integrals, identities that several solutions share.

/// The largest magnitude of f(i), i = first .. last; NaN if one is.
template <class Function>
double worst(int first, int last, Function f) {
  Worst largest;
  for (int i = first; i <= last; ++i) largest.add(f(i));
  return largest.value();
}

/// Integral by Gauss's rule of so many points on equal panels.
template <int points, class Function>
double integral(Function f, double from, double to, int panels) {
  double sum = 0;
  for (int k = 0; k < panels; ++k) {
    sum += boost::math::quadrature::gauss<double, points>::integrate(f, from + (to - from) * k / panels,
                                                                     from + (to - from) * (k + 1) / panels);
  }
  return sum;
}

/// What nothing but the time steps changes, over the amplitude.
/// @param tolerance  of a step of a pair of fourth and fifth order, over the amplitude
/// @param times      2 of a square
inline Identity kept_by_steps(const std::string& name, double defect, double steps, double tolerance,
                              double times = 1) {
  return {name, defect, times * steps * std::pow(tolerance, 1.2),
          fmt::format("{:g} steps whose errors of fourth order are kept at {:.2g} of the amplitude and add up; the "
                      "solution of fifth order that is carried on errs less by a step, the fifth root of that; {} "
                      "times as much",
                      steps, tolerance, times)};
}

/// The group speed integrates to the frequency: largest relative defect over the eighths of [0, k_highest].
template <class Law>
Identity group_speed_identity(const Law& law, double k_highest) {
  double sum = 0;
  const double defect = worst(1, 8, [&](int i) {
    const double to = k_highest * i / 8;
    sum += integral<30>([&](double k) { return law.group_speed(k); }, k_highest * (i - 1) / 8, to, 1);
    return sum / law.frequency(to) - 1;
  });
  return {"integral of the group speed over k = frequency", defect, 4 * epsilon * std::sqrt(90),
          "30-point Gauss on eighths of the interval resolves the law to round-off; 90 roundings: 38 additions, the "
          "abscissae, weights and values of the points, the frequency"};
}

/// The wavenumber of a frequency has that frequency, for k doubling from `lowest` to `highest`. (The wavenumbers
/// themselves are as much worse known as the group speed is below the phase speed.)
template <class Law>
Identity wavenumber_identity(const Law& law, double lowest, double highest) {
  Worst defect;
  for (double k = lowest; k <= highest; k *= 2) {
    const double omega = law.frequency(k);
    defect.add(law.frequency(law.wavenumber(omega)) / omega - 1);
  }
  return {"frequency(wavenumber(omega)) = omega", defect.value(), 4e-15, "18 ulp: 15 roundings there and back"};
}

// Roots to round-off within a bracket (Alefeld, Potra and Shi, algorithm 748). For sources: it needs Boost.

/// The last bracket of a root of f, which changes its sign between `from` and `to`.
template <class Function>
std::pair<double, double> last_bracket(const Function& f, double from, double to) {
  std::uintmax_t iterations = 200;
  return boost::math::tools::toms748_solve(f, from, to, boost::math::tools::eps_tolerance<double>(), iterations);
}

/// Its middle.
template <class Function>
double root(const Function& f, double from, double to) {
  const auto [low, high] = last_bracket(f, from, to);
  return 0.5 * (low + high);
}

/// Its end with the smaller residual.
template <class Function>
double root_at_end(const Function& f, double from, double to) {
  const auto [low, high] = last_bracket(f, from, to);
  return std::abs(f(low)) < std::abs(f(high)) ? low : high;
}

}  // namespace seiche::exact
