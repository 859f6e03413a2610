#include "seiche/exact/stokes_wave.hpp"

#include <algorithm>

#include <boost/math/special_functions/ellint_rf.hpp>

#include "seiche/exact/entry.hpp"
#include "seiche/require.hpp"

namespace seiche::exact {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::VectorXd;
using std::numbers::pi;
constexpr long double long_pi = std::numbers::pi_v<long double>;

constexpr double round_off_exponent = 38;  // e^-38 = 3e-17

/// Kernel of -i tanh(k d) on 2 pi periodic functions.
class PeriodicKernel {
 public:
  explicit PeriodicKernel(double depth) : depth_(depth) {
    if (depth >= shallow) {
      for (int k = 1; 2 * k * depth < round_off_exponent; ++k) correction_.push_back(4 / (std::exp(2 * k * depth) + 1));
    } else {
      images_ = static_cast<int>(std::ceil(round_off_exponent * depth / (pi * pi))) + 1;
    }
  }

  [[nodiscard]] double operator()(double x) const {
    if (depth_ >= shallow) {
      double sum = 1 / std::tan(0.5 * x);
      for (std::size_t k = 0; k < correction_.size(); ++k) {
        sum -= correction_[k] * std::sin(static_cast<double>(k + 1) * x);
      }
      return sum / (2 * pi);
    }
    const double nearest = x > pi ? x - 2 * pi : x;
    double sum = cosech(nearest);
    for (int n = 1; n <= images_; ++n) sum += cosech(nearest + 2 * pi * n) + cosech(nearest - 2 * pi * n);
    return sum / (2 * depth_);
  }

 private:
  static constexpr double shallow = 2.5;

  [[nodiscard]] double cosech(double x) const {
    const double argument = pi * x / (2 * depth_);
    return std::abs(argument) > 90 ? 0 : 1 / std::sinh(argument);
  }

  double depth_;
  std::vector<double> correction_;
  int images_ = 0;
};

/// Lagrange's formula in the variable sin^2(s/2) on the nodes s_j = pi j/N, j = 0..N, of 2 pi periodic functions.
class TrigonometricInterpolation {
 public:
  TrigonometricInterpolation(const VectorXd& elevation, const VectorXd& displacement, const VectorXd& stretch) {
    const Index intervals = elevation.size() - 1;
    for (Index j = 0; j <= intervals; ++j) {
      const double s = std::numbers::pi * static_cast<double>(j) / static_cast<double>(intervals);
      const double half = std::sin(0.5 * s);
      const bool end = j == 0 || j == intervals;
      const double weight = (j % 2 == 0 ? 1 : -1) * (end ? 0.5 : 1.0);
      position_.push_back(half * half);
      weight_.push_back(weight);
      elevation_.push_back(weight * elevation[j]);
      displacement_.push_back(end ? 0 : weight * displacement[j] * std::sin(s));
      stretch_.push_back(weight * stretch[j]);
    }
  }

  /// @param s  in [0, pi]
  [[nodiscard]] SurfaceSample operator()(double s) const {
    const double half = std::sin(0.5 * s);
    const double position = half * half;
    double elevation = 0;
    double displacement = 0;
    double stretch = 0;
    double total = 0;
    double sine = std::sin(s);
#pragma omp simd reduction(+ : elevation, displacement, stretch, total)
    for (std::size_t j = 0; j < position_.size(); ++j) {
      const double kernel = 1 / (position_[j] - position);
      total += weight_[j] * kernel;
      elevation += elevation_[j] * kernel;
      displacement += displacement_[j] * kernel;
      stretch += stretch_[j] * kernel;
    }
    if (!std::isfinite(total)) {  // a node's own place
      std::size_t j = 0;
      while (position_[j] != position) ++j;
      sine = 2 * std::sqrt(position * (1 - position));
      total = weight_[j];
      elevation = elevation_[j];
      displacement = displacement_[j];
      stretch = stretch_[j];
    }
    return {elevation / total, sine > 0 ? displacement / (total * sine) : 0, stretch / total};
  }

 private:
  std::vector<double> position_, weight_, elevation_, displacement_, stretch_;
};

/// tan(phi/2) = k' sn(u)/cn(u), u = s K/pi, with Jacobi's functions of the complementary modulus k' (width) and its
/// quarter period K: 2 pi periodic and odd, the identity for k' = 1.
class PeriodicNodes : public ConformalNodes {
 public:
  PeriodicNodes(double speed_squared, double crest_speed, double depth, Resolution resolution)
      : ConformalNodes(true, depth),
        // The nearest singularity lies q^3 c^2 above the crest.
        width_(std::min(1.0, resolution.clustering * std::pow(crest_speed, 3) * speed_squared)),
        quarter_period_(boost::math::ellint_rf(0.0L, width_ * width_, 1.0L)) {
    const auto quarter = static_cast<double>(quarter_period_);
    // Half the number of nodes: resolution of the surface, and steps below 0.15 depth for the kernel.
    const double half_count = std::max(56 * quarter / pi + 20, 2 * quarter / (0.15 * depth));
    const double intervals = std::ceil(resolution.refinement * half_count);
    place(static_cast<Index>(intervals) + 1, pi / intervals);
  }

  [[nodiscard]] Node at(double s) const override {
    const long double u = static_cast<long double>(s) / long_pi * quarter_period_;
    const long double scale = 2 * quarter_period_ / long_pi;
    if (2 * u < quarter_period_) {
      const auto [sn, cn, dn] = jacobi(u);
      return {2 * std::atan2(width_ * sn, cn), static_cast<double>(scale * width_ / dn)};
    }
    // sn(u) = cn(v)/dn(v), cn(u) = k' sn(v)/dn(v), dn(u) = k'/dn(v) with v = K - u: no loss where cn(u) is small.
    const auto [sn, cn, dn] = jacobi(std::max(quarter_period_ - u, 0.0L));
    return {2 * std::atan2(cn, sn), static_cast<double>(scale * dn)};
  }

  /// The incomplete integral F(psi, k), tan psi = tan(phi/2)/k', in Carlson's form.
  [[nodiscard]] double label(double potential) const override {
    const long double sine = std::sin(static_cast<long double>(potential) / 2);
    const long double cosine = width_ * std::cos(static_cast<long double>(potential) / 2);
    const long double length = std::hypot(sine, cosine);
    const long double square = std::pow(cosine / length, 2);
    const long double u =
        sine / length * boost::math::ellint_rf(square, square + std::pow(width_ * sine / length, 2), 1.0L);
    return static_cast<double>(u / quarter_period_ * long_pi);
  }

  [[nodiscard]] Matrix derivative() const override {
    return folded([last = static_cast<long double>(count() - 1)](Index m) {
      return (m % 2 == 0 ? 0.5L : -0.5L) / std::tan(long_pi / 2 * static_cast<long double>(m) / last);
    });
  }
  [[nodiscard]] Matrix conjugate() const override { return on_alternate_points(PeriodicKernel(depth())); }
  [[nodiscard]] Interpolation between(const VectorXd& elevation, const VectorXd& displacement,
                                      const VectorXd& stretch) const override {
    return TrigonometricInterpolation(elevation, displacement, stretch);
  }

 private:
  struct Jacobi {
    long double sn, cn, dn;
  };
  /// By the descending arithmetic-geometric mean from k' itself: 1 - k'^2 would lose it.
  [[nodiscard]] Jacobi jacobi(long double u) const {
    constexpr int levels = 12;
    std::array<long double, levels> ratio{};
    long double a = 1;
    long double b = width_;
    long double angle = u;
    int last = 0;
    while (last < levels && std::abs(a - b) > 1e-20L * a) {
      const long double mean = (a + b) / 2;
      ratio[static_cast<std::size_t>(last++)] = (a - b) / 2 / mean;
      b = std::sqrt(a * b);
      a = mean;
      angle *= 2;
    }
    angle *= a;
    while (last > 0) angle = (angle + std::asin(ratio[static_cast<std::size_t>(--last)] * std::sin(angle))) / 2;
    const long double sn = std::sin(angle);
    const long double cn = std::cos(angle);
    return {sn, cn, std::sqrt(cn * cn + width_ * width_ * sn * sn)};
  }

  long double width_, quarter_period_;
};

/// Waves of this half height, or crest, and conformal depth.
WaveFamily family_of(WaveCrest crest, double depth, Resolution resolution) {
  const double amplitude = crest.height ? *crest.height / 2 : -std::log(*crest.speed);
  return {
      .nodes =
          [=](double speed_squared, double crest_speed, bool fine) {
            const double refinement = (fine ? 1 : 0.5) * resolution.refinement;
            return std::make_shared<const PeriodicNodes>(speed_squared, crest_speed, depth,
                                                         Resolution{refinement, resolution.clustering});
          },
      .least_speed = 1.2e-3,
      .limit = fmt::format("k amplitude = {:.17g} is above the limiting Stokes wave for k times conformal depth = {:g}",
                           amplitude, depth),
      .described = fmt::format("k amplitude = {:.17g}, k depth = {:g}", amplitude, depth),
      .share = 0.5};
}

/// Continuation in the crest's speed from a linear wave, or from `nearby` where one is given. Throws
/// std::invalid_argument above the limiting wave.
ConformalSolution solve_stokes_wave(WaveCrest crest, double depth, Resolution resolution,
                                    const ConformalSolution* nearby = nullptr) {
  const WaveFamily family = family_of(crest, depth, resolution);
  if (nearby) return refined(family, crest, *nearby);
  const double linear = std::tanh(depth);  // c^2
  const double wanted = crest.height ? *crest.height / 2 / linear : -std::log(*crest.speed);
  const double start = std::min({0.05, 0.5 * depth * depth, 0.8 * wanted});
  const auto nodes = family.nodes(linear, std::exp(-start), false);
  const VectorXd tau = -start * nodes->potential().array().cos();
  return refined(family, crest, approach(family, crest, solve_on(nodes, {{}, std::exp(-start)}, tau, linear)));
}

/// Integral from 0 of an even periodic function on s_j = pi j/m, without the part of its mean.
VectorXd odd_integral(const VectorXd& even) {
  const Index last = even.size() - 1;
  const auto angle = [&](Index product) {
    return pi * static_cast<double>(product % (2 * last)) / static_cast<double>(last);
  };
  VectorXd result = VectorXd::Zero(even.size());
  for (Index k = 1; k < last; ++k) {
    double coefficient = 0.5 * (even[0] + (k % 2 == 0 ? 1 : -1) * even[last]);
    for (Index j = 1; j < last; ++j) coefficient += even[j] * std::cos(angle(j * k));
    coefficient *= 2 / (static_cast<double>(last) * static_cast<double>(k));
    for (Index j = 1; j < last; ++j) result[j] += coefficient * std::sin(angle(j * k));
  }
  return result;
}

/// Wavenumber of a medium in which the wave exists.
double checked_wavenumber(double wavelength, double depth, const char* depth_name, double gravity,
                          Resolution resolution) {
  require_all_positive({{"wavelength", wavelength}, {"gravity", gravity}});
  require_resolution(resolution);
  if (!(depth > 0)) require_positive(depth_name, depth);
  const double wavenumber = 2 * pi / wavelength;
  constexpr double shallowest = 0.2;
  require_that(wavenumber * depth >= shallowest,
               "k {} = {:.17g}, k = 2 pi/wavelength, is out of range: must be at least {}; the crests of longer waves "
               "are solitary waves: use SolitaryWave",
               depth_name, wavenumber * depth, shallowest);
  return wavenumber;
}

WaveCrest checked_crest(double amplitude, double wavenumber) {
  require_positive("amplitude", amplitude);
  require_within("k amplitude", wavenumber * amplitude, 1e-4, 0.4432);  // the limiting deep wave has 0.44316
  return {2 * wavenumber * amplitude, {}};
}

}  // namespace

StokesSurface::StokesSurface(ConformalSolution solution) : ConformalSurface(std::move(solution), "k ", "") {
  const auto& [nodes, tau, theta, speed_squared, correction] = solution_;
  const VectorXd& stretch = nodes->stretch();
  const Index count = tau.size();
  const Index last = count - 1;
  const auto mean = [&](const VectorXd& even) {
    return (even.sum() - 0.5 * (even[0] + even[last])) / static_cast<double>(last);
  };
  const VectorXd inverse_speed = (-tau.array()).exp();
  const VectorXd advance = stretch.array() * theta.array().cos() * inverse_speed.array();
  const VectorXd climb = stretch.array() * theta.array().sin() * inverse_speed.array();
  const VectorXd head = -0.5 * speed_squared * (2 * tau.array()).unaryExpr([](double t) { return std::expm1(t); });
  const double mean_head = mean(head.cwiseProduct(advance));
  elevation_ = head.array() - mean_head;
  bernoulli_ = 0.5 * speed_squared - mean_head;
  const VectorXd periodic = odd_integral(advance);
  position_.resize(count);
  for (Index j = 0; j < count; ++j) position_[j] = static_cast<double>(j) * nodes->spacing() + periodic[j];
  interpolation_ = nodes->between(elevation_, periodic, advance);
  const double conformal_mean = mean(elevation_.cwiseProduct(stretch));
  depth_ = nodes->depth() - conformal_mean;
  integrals_.impulse = -speed_ * conformal_mean;
  integrals_.kinetic_energy = -0.5 * speed_squared * mean((position_ - nodes->potential()).cwiseProduct(climb));
  integrals_.potential_energy = 0.5 * mean(elevation_.cwiseProduct(elevation_).cwiseProduct(advance));
  add_nodes_to_contour();
}

StokesSurface StokesSurface::with_mean_depth(WaveCrest crest, double mean_depth, Resolution resolution) {
  if (std::isinf(mean_depth)) return StokesSurface(solve_stokes_wave(crest, mean_depth, resolution));
  double depth = mean_depth;
  StokesSurface wave(solve_stokes_wave(crest, depth, resolution));
  double excess = wave.depth() - mean_depth;
  double slope = 1;
  constexpr int most_steps = 12;
  for (int step = 0; step < most_steps && std::abs(excess) > 2e-16 * mean_depth; ++step) {
    const double change = -excess / slope;
    const ConformalSolution nearby = wave.solution();
    wave = StokesSurface(solve_stokes_wave(crest, depth + change, resolution, &nearby));
    depth += change;
    const double next = wave.depth() - mean_depth;
    if (std::abs(next) >= 0.5 * std::abs(excess)) break;
    slope = (next - excess) / change;
    excess = next;
  }
  return wave;
}

std::complex<double> StokesSurface::pole(std::complex<double> z) const {
  if (!bottom_matters()) return std::exp(Complex(0, 1) * z);
  const Complex root = std::sin(0.5 * (z + Complex(0, depth_)));
  return root * root;
}

StokesSurface::Point StokesSurface::point(double label) const {
  const SurfaceSample sample = interpolation_(label);
  return {label, label + sample.displacement, sample.displacement, sample.elevation, sample.stretch};
}

double StokesSurface::potential(double x) const {
  const double place = reduced(x);
  const Point surface = find(std::abs(place));
  return std::copysign(speed_ * (surface.x - static_cast<double>(solution_.nodes->at(surface.label).potential)), place);
}

StokesWave::StokesWave(double amplitude, double wavelength, double mean_depth, double gravity, Resolution resolution)
    : StokesWave(
          [&] {
            const double k = checked_wavenumber(wavelength, mean_depth, "mean_depth", gravity, resolution);
            return StokesSurface::with_mean_depth(checked_crest(amplitude, k), k * mean_depth, resolution);
          }(),
          2 * pi / wavelength, gravity) {}

StokesWave StokesWave::from_conformal_depth(double amplitude, double wavelength, double conformal_depth, double gravity,
                                            Resolution resolution) {
  const double k = checked_wavenumber(wavelength, conformal_depth, "conformal_depth", gravity, resolution);
  return {StokesSurface(solve_stokes_wave(checked_crest(amplitude, k), k * conformal_depth, resolution)), k, gravity};
}

StokesWave StokesWave::from_crest_speed(double crest_speed, double wavelength, double conformal_depth, double gravity,
                                        Resolution resolution) {
  const double k = checked_wavenumber(wavelength, conformal_depth, "conformal_depth", gravity, resolution);
  require_within("crest_speed", crest_speed, 0.0015, 0.9999);
  return {StokesSurface(solve_stokes_wave({{}, crest_speed}, k * conformal_depth, resolution)), k, gravity};
}

double StokesWave::uncertainty() const {
  // q^2 = 2 (B - y)/c^2 is a difference near the limiting wave: its rounding is divided by 2 q.
  constexpr double rounding = 1e-14;
  const double steep = std::max(1.0, 0.5 / crest_speed());
  const double gentle = std::max(1.0, 0.01 / surface_->crest());  // y is a difference of Bernoulli's constant
  return rounding * steep * gentle;
}

SelfTest StokesWave::self_test() const {
  const auto& integrals = surface_->integrals();
  const double c = surface_->speed();
  const double limit = 5 * uncertainty();
  const double scale = std::max(2 * integrals.kinetic_energy, 1e-3);
  const double deepest = std::min(surface_->depth(), 40.0);
  const double crest = section_flux(*surface_, -deepest);
  const int points =
      64 * static_cast<int>(std::ceil(1 / std::min(deepest, 1.0)));  // crests as sharp as the water is shallow
  const double level = std::max(0.5 * (surface_->trough() - deepest), -1.0 + surface_->trough());
  double mean = 0;
  for (int j = 0; j < points; ++j) mean += surface_->velocity(2 * pi * j / points, level).u / points;
  return {
      {"2 T = c I", std::abs(2 * integrals.kinetic_energy - c * integrals.impulse) / scale, limit,
       "means over the nodes of values good to the stated uncertainty; relative to 2 T or 0.001"},
      {"volume flux through the crest section = c eta + I",
       std::abs(crest - c * surface_->crest() - integrals.impulse) / crest, limit,
       "280 Gauss points of velocities good to the stated uncertainty"},
      {"mean Eulerian velocity below the troughs = 0", std::abs(mean) / (c * -std::expm1(surface_->solution().tau[0])),
       limit, "64/min(1, k d) equally spaced velocities, relative to the velocity at the crest"}};
}

ExactSolution stokes_entry() {
  return Entry<StokesWave>{
      .name = "stokes",
      .title = "Periodic progressive wave of the full Euler equations, with the velocities inside",
      .citation =
          "Schwartz, Computer extension and analytic continuation of Stokes' expansion for gravity waves, J. Fluid "
          "Mech. 62 (1974) 553; Cokelet, Steep gravity waves in water of arbitrary uniform depth, Phil. Trans. R. Soc. "
          "A 286 (1977) 183; Longuet-Higgins, Integral properties of periodic gravity waves, Proc. R. Soc. A 342 "
          "(1975) 157",
      .formula =
          "theta = T tau with the symbol -i tanh(k d), c^2/2 d(q^2)/dphi + sin(theta)/q = 0, q = exp(tau), int "
          "cos(theta)/q dphi = 2 pi; f = c (1 - dW/dz) inside by a quotient of Cauchy sums",
      .parameters = {{"amplitude", "m", 0.1, 1e-9, 1e6, "half the height from trough to crest"},
                     wavelength_parameter(),
                     depth_parameter(infinite, infinite),
                     {"conformal_depth", "m", 0, 0, infinite,
                      "discharge under the wave over its speed; where positive it takes the place of depth"},
                     gravity_parameter()},
      .inputs = {position_x, height_y, time_t},
      .outputs = {{"eta", "m", "surface elevation above the mean level"}, velocity_u, velocity_v},
      .scalars = {{"c", "m/s", "phase speed, mean velocity below the troughs zero", &StokesWave::phase_speed},
                  {"mean_depth", "m", "mean depth", &StokesWave::mean_depth},
                  {"conformal_depth", "m", "conformal depth", &StokesWave::conformal_depth},
                  {"crest_elevation", "m", "crest above the mean level", &StokesWave::crest_elevation},
                  {"trough_elevation", "m", "trough, negative", &StokesWave::trough_elevation},
                  {"bernoulli_constant", "m^2/s^2", "q^2/2 + g eta on the surface, seen from the wave",
                   &StokesWave::bernoulli_constant},
                  {"impulse", "m^2/s", "mean impulse, density 1", &StokesWave::impulse},
                  {"kinetic", "m^3/s^2", "mean kinetic energy, density 1", &StokesWave::kinetic_energy},
                  {"potential", "m^3/s^2", "mean potential energy, density 1", &StokesWave::potential_energy},
                  {"crest_velocity", "m/s", "horizontal velocity at the crest", &StokesWave::crest_velocity},
                  {"maximum_slope", "rad", "largest inclination of the surface", &StokesWave::maximum_slope}},
      .make = made_by(
          [](double amplitude, double wavelength, double depth, double conformal, double gravity) {
            return conformal > 0 ? StokesWave::from_conformal_depth(amplitude, wavelength, conformal, gravity)
                                 : StokesWave(amplitude, wavelength, depth, gravity);
          },
          "amplitude", "wavelength", "depth", "conformal_depth", "gravity"),
      .row = wave_row<StokesWave>};
}

}  // namespace seiche::exact
