#include "seiche/exact/lattice_dispersion.hpp"

#include <algorithm>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/exact/entry.hpp"
#include "seiche/require.hpp"
#include "seiche/require_that.hpp"

namespace seiche::exact {
namespace {

using std::numbers::pi;

/// R for theta = sine/cosine, both not negative and not both 0: theta may be infinite.
double layer_response(double sine, double cosine, std::size_t layers, double inertia) {
  const auto n = static_cast<double>(layers);
  // The factor 1 - theta cancels; where theta is large all is in r = 1/theta, with t_n(theta) = t_n(r) = r * ratio.
  const bool large = sine > cosine;
  const double t = large ? cosine / sine : sine / cosine;
  const double q = std::pow((1 - t) / (1 + t), 2 * n - 1);
  const double p = q * (1 - t) / (1 + t);
  if (!large) {
    const double t_n = std::tanh(2 * n * std::atanh(t));
    return t * (1 + t) * t_n / ((1 + q) / (1 + p) + 2 * inertia * t * (1 + t) * t_n);
  }
  const double ratio = t == 0 ? 2 * n : std::tanh(2 * n * std::atanh(t)) / t;
  return (1 + t) * ratio / (t * (1 - q) / (1 + p) + 2 * inertia * (1 + t) * ratio);
}

/// The same without the closed form, layer by layer from the bottom.
///
/// Inner layers: (theta^2 - 1) (L_{j-1} + L_{j+1}) + 2 (theta^2 + 1) L_j = 0; bottom: L_{-1} = L_0. d = 1 - L_{j-1}/L_j
/// for theta <= 1 and 1 + L_{j-1}/L_j beyond, where signs alternate, obeys a recurrence of positive terms. Top: X =
/// 4 theta^2 + (1 - theta^2) (1 - L_{n-2}/L_{n-1}), and the motion of the surface, R = (X/2)/(1 + b X).
double layer_response_by_layers(double sine, double cosine, std::size_t layers, double inertia) {
  const bool alternating = sine > cosine;
  const double u = alternating ? cosine / sine : sine / cosine;
  const double a = 1 - u * u;
  double d = alternating ? 2 : 0;
  for (std::size_t j = 1; j < layers; ++j) d = (d * a + 4 * u * u) / ((1 + d) * a + 4 * u * u);
  // X, or X/theta^2 beside 1/theta^2
  const double x = alternating ? 2 + 2 * u * u + a * d : 4 * u * u + a * d;
  const double one = alternating ? u * u : 1;
  return 0.5 * x / (one + inertia * x);
}

const std::string round_18 = "18 ulp for as many roundings";
const std::string round_90 =
    "90 ulp: 40 roundings, the shortest of the waves makes a rounding of the phase ten of the tangent";

/// The largest of a defect over the sixteenths of the resolved wavenumbers along x, and those along y with 0.
template <class Defect>
double over_waves(double shortest_x, double shortest_y, Defect defect) {
  return worst(1, 16, [&](int i) {
    return worst(0, 16, [&](int j) { return defect(shortest_x * i / 16, shortest_y * j / 16); });
  });
}

/// @param square  of their speed;  @param longest  wavenumber
template <class Law>
Identity long_waves(const Law& law, double square, double longest) {
  const double defect = worst(0, 8, [&](int i) {
    const double direction = 0.5 * pi * i / 8;
    return law.phase_speed(longest * std::cos(direction), longest * std::sin(direction)) / std::sqrt(square) - 1;
  });
  return {"long waves in every direction: omega = k sqrt(g H)", defect, 4e-15,
          round_18 + "; the next term of the law is 1e-18"};
}

}  // namespace

PlanSymbol plan_symbol(double kx, double ky, double hx, double hy) {
  const double rounded_pi = pi * (1 + 1e-15);
  require_within("wavenumber_x", kx, -rounded_pi / hx, rounded_pi / hx);
  require_within("wavenumber_y", ky, -rounded_pi / hy, rounded_pi / hy);
  require_positive("wavenumber", std::hypot(kx, ky));
  const double s1 = std::sin(0.5 * kx * hx);
  const double s2 = std::sin(0.5 * ky * hy);
  const double c1 = std::abs(std::cos(0.5 * kx * hx));  // beyond pi by a rounding it would be negative
  const double c2 = std::abs(std::cos(0.5 * ky * hy));
  return {c1 * c2, 2 * std::hypot(s1 * c2 / hx, s2 * c1 / hy), (2 + std::cos(kx * hx)) * (2 + std::cos(ky * hy)) / 9};
}

FrankDispersion::FrankDispersion(double gravity, double depth, double spacing, Parameters parameters)
    : gravity_(gravity), depth_(depth), spacing_(spacing), parameters_(parameters) {
  require_all_positive({{"gravity", gravity}, {"depth", depth}, {"spacing", spacing}, {"alpha", parameters.alpha}});
  require_finite("beta", parameters.beta);
  require_finite("gamma", parameters.gamma);
  // The potential energy is linear in cos k s: positive at k s = pi is positive everywhere.
  const double h = spacing / depth;
  require_positive("1 - 2 beta + 4 gamma (depth/spacing)^2", 1 - 2 * parameters.beta + 4 * parameters.gamma / (h * h));
}

FrankDispersion FrankDispersion::tuned(double gravity, double depth, double spacing, double time_step) {
  require_all_positive({{"gravity", gravity}, {"depth", depth}, {"spacing", spacing}});
  require_not_negative("time_step", time_step);
  const double h2 = spacing * spacing / (depth * depth);
  const double tau2 = time_step * time_step * gravity / depth;
  // Coefficients that nu must have in nu = kappa^2 (1 + c1 kappa^2 + c2 kappa^4) so that Omega is Airy's.
  const double c1 = -1.0 / 3 - tau2 / 12;
  const double c2 = 2.0 / 15 - c1 * tau2 / 6 - tau2 * tau2 / 90;
  const double gamma = (c2 - 7 * h2 * h2 / 720 - c1 * h2 / 6 - c1 * c1) / (-c1 - h2 / 12);
  return {gravity, depth, spacing, {.alpha = gamma - c1, .beta = 1.0 / 3, .gamma = gamma}};
}

double FrankDispersion::phase_speed(double k) const {
  require_positive("wavenumber", k);
  require_that(
      k * spacing_ < pi,
      "wavenumber = {:.17g} is out of range: must be below pi/spacing = {:g}, the shortest wave that markers resolve",
      k, pi / spacing_);
  const auto& [alpha, beta, gamma] = parameters_;
  const double h = spacing_ / depth_;
  const double kappa = k * depth_;
  const double sine = std::sin(0.5 * kappa * h);
  const double slope = 2 * sine / h;
  const double rise = 2 * std::tan(0.5 * kappa * h) / (h * kappa);  // -> 1 for long waves
  const double potential = 1 - 2 * beta * sine * sine + gamma * slope * slope;
  const double inertia = 1 + alpha * rise * rise * kappa * kappa;
  return rise * std::sqrt(gravity_ * depth_ * potential / inertia);
}

double FrankDispersion::group_speed(double k) const {
  const double omega = frequency(k);
  const auto& [alpha, beta, gamma] = parameters_;
  const double h = spacing_ / depth_;
  const double angle = k * spacing_;
  const double sine = std::sin(0.5 * angle);
  const double t = 2 * std::tan(0.5 * angle) / h;
  const double potential = 1 - 2 * beta * sine * sine + 4 * gamma * sine * sine / (h * h);
  const double inertia = 1 + alpha * t * t;
  // nu = potential t^2/inertia, dt/dkappa = 1 + (h t/2)^2
  const double potential_slope = (2 * gamma / h - beta * h) * std::sin(angle);
  const double t_slope = 1 + 0.25 * h * h * t * t;
  const double nu_slope = potential_slope * t * t / inertia + potential * 2 * t * t_slope / (inertia * inertia);
  return 0.5 * gravity_ * nu_slope / omega;
}

SelfTest FrankDispersion::self_test() const {
  // The frequency of the middle wave, k s = pi/2, is algebraic.
  const double h2 = spacing_ * spacing_ / (depth_ * depth_);
  const double nu = (1 - parameters_.beta + 2 * parameters_.gamma / h2) * 4 / (4 * parameters_.alpha + h2);
  const double omega = frequency(0.5 * pi / spacing_);
  return {group_speed_identity(*this, std::min(0.9 * pi / spacing_, 6 / depth_)),
          {"frequency at k s = pi/2 in closed form", departure(omega * omega * depth_, gravity_ * nu), 1e-14,
           "45 ulp for 25 roundings, squared"}};
}

double discrete_frequency(double omega, double time_step, TimeScheme scheme) {
  require_all_positive({{"frequency", omega}, {"time_step", time_step}});
  const double half = 0.5 * omega * time_step;
  if (scheme == TimeScheme::conservative) return 2 * std::atan(half) / time_step;
  require_that(half <= 1,
               "time_step = {:.17g} is out of range: the one-step scheme needs frequency * time_step <= 2, here {:g}",
               time_step, omega * time_step);
  return 2 * std::asin(half) / time_step;
}

PlanDispersion::PlanDispersion(double gravity, double depth, double spacing_x, double spacing_y, double alpha)
    : gravity_(gravity), depth_(depth), spacing_x_(spacing_x), spacing_y_(spacing_y), alpha_(alpha) {
  require_all_positive(
      {{"gravity", gravity}, {"depth", depth}, {"spacing_x", spacing_x}, {"spacing_y", spacing_y}, {"alpha", alpha}});
}

double PlanDispersion::frequency(double kx, double ky) const {
  const PlanSymbol symbol = plan_symbol(kx, ky, spacing_x_, spacing_y_);
  const double slope = depth_ * symbol.gradient;
  return slope * std::sqrt(gravity_ / depth_ * symbol.potential / (symbol.mean * symbol.mean + alpha_ * slope * slope));
}

SelfTest PlanDispersion::self_test() const {
  const double shortest_x = pi / spacing_x_;
  const double shortest_y = pi / spacing_y_;
  const FrankDispersion chain(gravity_, depth_, spacing_x_, {.alpha = alpha_, .beta = 1.0 / 3, .gamma = 0});
  const PlanDispersion turned(gravity_, depth_, spacing_y_, spacing_x_, alpha_);
  // Algebraic at k_i h_i = pi/2: T_i = 2/h_i, G = 4/9.
  const double k2 = 4 / (spacing_x_ * spacing_x_) + 4 / (spacing_y_ * spacing_y_);
  const double middle = std::sqrt(4 * gravity_ * depth_ * k2 / (9 * (1 + alpha_ * depth_ * depth_ * k2)));
  return {{"along an axis: formula (13)",
           worst(1, 15,
                 [&](int i) { return frequency(shortest_x * i / 16, 0) / chain.frequency(shortest_x * i / 16) - 1; }),
           2e-14, round_90},
          {"mirrored and with the axes exchanged: the same",
           over_waves(shortest_x, shortest_y,
                      [&](double kx, double ky) { return frequency(kx, -ky) / turned.frequency(ky, kx) - 1; }),
           4e-15, round_18},
          {"frequency at k_i h_i = pi/2 in closed form",
           departure(frequency(0.5 * shortest_x, 0.5 * shortest_y), middle), 1e-14, "45 ulp for 25 roundings"},
          {"shortest waves in x: omega^2 = g (2 + cos k2 h2)/(9 alpha H)",
           departure(frequency(shortest_x, 0.5 * shortest_y), frequency_bound() * std::numbers::sqrt2 / 3),
           4e-15 + std::pow(epsilon * spacing_x_ / depth_, 2) / alpha_,
           round_18 + "; the law is stationary there in 1/(K H), which is 0 to a rounding of pi h1/H"},
          long_waves(*this, gravity_ * depth_, 1e-9 / std::max({depth_, spacing_x_, spacing_y_}))};
}

HexahedralDispersion::HexahedralDispersion(double gravity, double depth, double spacing_x, double spacing_y,
                                           std::size_t layers, SurfaceInertia inertia)
    : gravity_(gravity), depth_(depth), spacing_x_(spacing_x), spacing_y_(spacing_y), layers_(layers) {
  require_all_positive({{"gravity", gravity}, {"depth", depth}, {"spacing_x", spacing_x}, {"spacing_y", spacing_y}});
  require_at_least("layers", static_cast<long>(layers), 1);
  inertia_ = 0.5 - (inertia == SurfaceInertia::tuned ? 1 / (6 * static_cast<double>(layers)) : 0.0);
}

double HexahedralDispersion::frequency(double kx, double ky) const {
  const PlanSymbol symbol = plan_symbol(kx, ky, spacing_x_, spacing_y_);
  return std::sqrt(2 * gravity_ / layer_height() * symbol.potential *
                   layer_response(0.5 * layer_height() * symbol.gradient, symbol.mean, layers_, inertia_));
}

double HexahedralDispersion::surface_response(double kx, double ky) const {
  const PlanSymbol symbol = plan_symbol(kx, ky, spacing_x_, spacing_y_);
  return 2 * inertia_ * layer_response(0.5 * layer_height() * symbol.gradient, symbol.mean, layers_, inertia_);
}

SelfTest HexahedralDispersion::self_test() const {
  const double shortest_x = pi / spacing_x_;
  const double shortest_y = pi / spacing_y_;
  const auto inertia = inertia_ < 0.5 ? SurfaceInertia::tuned : SurfaceInertia::nodal;
  const HexahedralDispersion one_layer(gravity_, depth_, spacing_x_, spacing_y_, 1, inertia);
  const PlanDispersion markers(gravity_, depth_, spacing_x_, spacing_y_, one_layer.inertia_);
  const auto by_layers = [&](double kx, double ky) {
    const PlanSymbol symbol = plan_symbol(kx, ky, spacing_x_, spacing_y_);
    return std::sqrt(2 * gravity_ / layer_height() * symbol.potential *
                     layer_response_by_layers(0.5 * layer_height() * symbol.gradient, symbol.mean, layers_, inertia_));
  };
  return {
      {"frequency from the layers one by one",
       over_waves(shortest_x, shortest_y,
                  [&](double kx, double ky) { return by_layers(kx, ky) / frequency(kx, ky) - 1; }),
       epsilon * (20 + 1.5 * static_cast<double>(layers_)),
       "half an ulp for each of 20 roundings in either formula; 6 more per layer, under the root"},
      {"one layer: the plan law with alpha = b",
       over_waves(shortest_x, shortest_y,
                  [&](double kx, double ky) { return one_layer.frequency(kx, ky) / markers.frequency(kx, ky) - 1; }),
       1e-14, "45 ulp for 20 roundings in either law"},
      {"shortest wave: omega^2 = g/(9 b h3)", departure(3 * frequency(shortest_x, shortest_y), frequency_bound()),
       4e-15 + std::pow(epsilon * std::max(spacing_x_, spacing_y_) / layer_height(), 2),
       round_18 + "; the law is stationary there in 1/T, which is 0 to a rounding of pi h1/h3"},
      long_waves(*this, gravity_ * depth_, 1e-9 / std::max({depth_, spacing_x_, spacing_y_}))};
}

LagrangianMeshDispersion::LagrangianMeshDispersion(double gravity, double depth, double column_width, std::size_t rows,
                                                   SurfaceInertia inertia)
    : gravity_(gravity),
      depth_(depth),
      column_width_((require_positive("column_width", column_width), column_width)),
      inertia_((require_at_least("rows", static_cast<long>(rows), 1), inertia)),
      section_(gravity, depth, column_width, column_width, rows, inertia) {}

double LagrangianMeshDispersion::resolved(double wavenumber) const {
  require_positive("wavenumber", wavenumber);
  require_within("wavenumber", wavenumber, 0, pi / column_width_ * (1 + 1e-15));
  return wavenumber;
}

double LagrangianMeshDispersion::largest_frequency() const {
  return worst(1, 2000, [&](int i) { return frequency(pi / column_width_ * i / 2000); });
}

SelfTest LagrangianMeshDispersion::self_test() const {
  const double shortest = pi / column_width_;
  const LagrangianMeshDispersion one_row(gravity_, depth_, column_width_, 1, inertia_);
  const FrankDispersion markers(gravity_, depth_, column_width_,
                                {.alpha = one_row.section_.surface_inertia(), .beta = 1.0 / 3, .gamma = 0});
  SelfTest identities = section_.self_test();
  identities.push_back(
      {"one row: formula (13) with alpha = b",
       worst(1, 15,
             [&](int i) { return one_row.frequency(shortest * i / 16) / markers.frequency(shortest * i / 16) - 1; }),
       2e-14, round_90});
  return identities;
}

namespace {

/// A discrete dispersion law in space, in one direction, then in time: what the entries of such laws evaluate.
template <class Law>
struct LawInTime {
  Law law;
  double time_step, wavenumber, cosine, sine;
  TimeScheme scheme;

  /// omega and omega/k; of the wavelength where k is NaN.
  [[nodiscard]] Row row(double given) const {
    const double k = std::isnan(given) ? wavenumber : given;
    double omega = 0;
    if constexpr (requires { law.frequency(k); })
      omega = law.frequency(k);
    else
      omega = law.frequency(k * cosine, k * sine);
    if (time_step > 0) omega = discrete_frequency(omega, time_step, scheme);
    return {omega, omega / k};
  }
  [[nodiscard]] double uncertainty() const { return law.uncertainty(); }
  [[nodiscard]] SelfTest self_test() const { return law.self_test(); }
};

const Parameter direction{"direction", "degrees", 0, -180, 180, "of the wavenumber, from the x axis"};
const Parameter spacing_x{"spacing_x", "m", 0.5, 1e-9, 1e6, "distance of the markers along x"};
const Parameter spacing_y{"spacing_y", "m", 0.5, 1e-9, 1e6, "distance of the markers along y"};
const Parameter tuned{"tuned", "1", 0, 0, 1, "vertical inertia of surface nodes", {"nodal", "tuned"}};

/// An entry for a law; `own` are the parameters after wavelength, depth and gravity.
template <class Law, class Make>
ExactSolution law_entry(const std::string& name, const std::string& title, const std::string& citation,
                        const std::string& formula, const std::vector<Parameter>& own, Make make) {
  std::vector<Parameter> parameters{wavelength_parameter(), depth_parameter(1, 1e6), gravity_parameter()};
  parameters.insert(parameters.end(), own.begin(), own.end());
  parameters.push_back({"time_step", "s", 0, 0, 1e6, "time step of the scheme; 0: continuous in time"});
  parameters.push_back({"scheme", "1", 0, 0, 1, "scheme in time", {"one_step", "conservative"}});
  using Timed = LawInTime<Law>;
  return Entry<Timed>{
      .name = name,
      .title = title,
      .citation = citation,
      .formula = formula,
      .parameters = parameters,
      .inputs = {wavenumber_k},
      .outputs = {{"omega", "1/s", "angular frequency"}, {"phase_speed", "m/s", "omega/k"}},
      .scalars = {{"omega", "1/s", "angular frequency of the wavelength",
                   [](const Timed& law) { return law.row(none_given)[0]; }},
                  {"phase_speed", "m/s", "its phase speed", [](const Timed& law) { return law.row(none_given)[1]; }}},
      .make =
          [make](const Values& p) {
            const double angle = p.contains("direction") ? p.at("direction") * pi / 180 : 0;
            return Timed{make(p),         p.at("time_step"), 2 * pi / p.at("wavelength"),
                         std::cos(angle), std::sin(angle),   Given{"scheme", p.at("scheme")}};
          },
      .row = [](const Timed& law, At at) { return law.row(at[0]); }};
}

}  // namespace

ExactSolution frank_dispersion_entry() {
  return law_entry<FrankDispersion>(
      "frank_dispersion", "Dispersion of Frank's discrete dispersive shallow water, formula (13), and with a time step",
      "Frank, Discrete models of incompressible fluids (1994), ch. 3, formula (13); general beta, gamma derived",
      "omega^2 = (g/H) (1 - beta (1 - cos ks) + 4 gamma sin^2(ks/2)/h^2) 4 t^2/(4 alpha t^2 + h^2), t = tan(ks/2), h = "
      "s/H",
      {{"spacing", "m", 0.1, 1e-9, 1e6, "distance of the markers"},
       {"alpha", "1", 1.0 / 3, 0, 10, "factor of the vertical kinetic energy"},
       {"beta", "1", 1.0 / 3, -10, 10, "factor of the potential energy of a cell's slope"},
       {"gamma", "1", 0, -10, 10, "factor of an added potential energy of slopes"}},
      made_by(
          [](double g, double depth, double spacing, double alpha, double beta, double gamma) {
            return FrankDispersion(g, depth, spacing, {alpha, beta, gamma});
          },
          "gravity", "depth", "spacing", "alpha", "beta", "gamma"));
}

ExactSolution lagrangian_mesh_dispersion_entry() {
  return law_entry<LagrangianMeshDispersion>(
      "lagrangian_mesh_dispersion", "Dispersion of Frank's two-dimensional Lagrangian mesh, and with a time step",
      "Frank, Discrete models of incompressible fluid (1994), ch. 2; closed form derived from the linearised rows",
      "omega^2 = (2g/h2) ((2 + cos k h1)/3) T (1 - T^2) t_n/(1 - T t_n + 2 b T (1 - T^2) t_n), T = (h2/h1) tan(k "
      "h1/2), t_n = tanh(2 n artanh T), h2 = H/n, b = 1/2 or 1/2 - 1/(6n)",
      {{"column_width", "m", 0.25, 1e-9, 1e6, "width of a column of cells"},
       {"rows", "1", 4, 1, 1e4, "rows of cells"},
       tuned},
      from<LagrangianMeshDispersion>("gravity", "depth", "column_width", "rows", "tuned"));
}

ExactSolution plan_dispersion_entry() {
  return law_entry<PlanDispersion>(
      "plan_dispersion", "Dispersion of the discrete dispersive shallow water in plan, and with a time step",
      "Frank, Discrete models of incompressible fluids (1994), ch. 3, formula (13), and section 4.2; closed form in "
      "plan derived from the linearised cells",
      "omega^2 = g H G K^2/(1 + alpha H^2 K^2), K^2 = sum ((2/h_i) tan(k_i h_i/2))^2, G = product (2 + cos k_i h_i)/3",
      {direction, spacing_x, spacing_y, {"alpha", "1", 1.0 / 3, 0, 10, "factor of the vertical kinetic energy"}},
      from<PlanDispersion>("gravity", "depth", "spacing_x", "spacing_y", "alpha"));
}

ExactSolution hexahedral_dispersion_entry() {
  return law_entry<HexahedralDispersion>(
      "hexahedral_dispersion", "Dispersion of Frank's three-dimensional Lagrangian mesh, and with a time step",
      "Frank, Discrete models of incompressible fluid (1994), section 4.1; closed form derived from the linearised "
      "layers",
      "omega^2 = (2g/h3) G T (1 - T^2) t_n/(1 - T t_n + 2 b T (1 - T^2) t_n), T = K h3/2, K^2 = sum ((2/h_i) tan(k_i "
      "h_i/2))^2, G = product (2 + cos k_i h_i)/3, t_n = tanh(2 n artanh T), h3 = H/n, b = 1/2 or 1/2 - 1/(6n)",
      {direction,
       {"spacing_x", "m", 0.5, 1e-9, 1e6, "side of a cell along x"},
       {"spacing_y", "m", 0.5, 1e-9, 1e6, "side of a cell along y"},
       {"layers", "1", 2, 1, 1e4, "layers of cells"},
       tuned},
      from<HexahedralDispersion>("gravity", "depth", "spacing_x", "spacing_y", "layers", "tuned"));
}

}  // namespace seiche::exact
