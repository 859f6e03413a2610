#include "seiche/exact/conformal_wave.hpp"

#include <algorithm>
#include <array>

#include <Eigen/LU>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/tools/minima.hpp>

#include "seiche/require.hpp"
#include "seiche/require_that.hpp"

namespace seiche::exact {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Extended = Eigen::Matrix<long double, Eigen::Dynamic, 1>;

/// exp(x) - 1 of every value, without cancellation.
template <class Values>
auto expm1(const Values& values) {
  return values.unaryExpr([](auto value) { return std::expm1(value); });
}

/// 1 - q exp(-i theta) without cancellation in gentle waves.
Complex velocity_defect(double log_speed, double inclination) {
  const double half = std::sin(0.5 * inclination);
  const double speed = std::exp(log_speed);
  return {-std::expm1(log_speed) + 2 * speed * half * half, speed * std::sin(inclination)};
}

/// Unknowns tau_0..tau_N, c^2; equations: the crest, the streamline along the surface at j = 1..N, the end. At a
/// trough, where the streamline says nothing, the wavelength; the end is then that of a sawtooth, else tau_N = 0.
///
/// The residual is evaluated with extended precision: dy/dphi and theta of a long wave balance up to the square of its
/// amplitude, so that rounding is divided by it.
class StreamlineEquations {
 public:
  StreamlineEquations(const ConformalNodes& nodes, WaveCrest crest)
      : crest_(crest),
        periodic_(nodes.periodic()),
        last_(nodes.count() - 1),
        stretch_(nodes.stretch()),
        derivative_(nodes.derivative()),
        conjugate_(nodes.conjugate()),
        weight_(VectorXd::Constant(nodes.count(), 1 / static_cast<double>(last_))) {
    weight_[0] = weight_[last_] *= 0.5;
    end_ = weight_;
    for (Index j = 1; j <= last_; j += 2) end_[j] = -end_[j];
    if (!periodic_) end_ = VectorXd::Unit(last_ + 1, last_);
  }

  [[nodiscard]] bool admissible(const VectorXd& unknowns) const {
    return unknowns[last_ + 1] > 0 && unknowns.head(last_ + 1).lpNorm<Eigen::Infinity>() < 12;
  }

  [[nodiscard]] VectorXd inclination(const VectorXd& tau) const {
    return (conjugate_ * tau.cast<long double>()).cast<double>();
  }

  [[nodiscard]] VectorXd residual(const VectorXd& unknowns) const {
    const Extended tau = unknowns.head(last_ + 1).cast<long double>();
    const Extended theta = conjugate_ * tau;
    const Extended squares = expm1(2 * tau);
    const Extended inverse_speed = (-tau.array()).exp();
    const Extended climb = stretch_.cast<long double>().array() * theta.array().sin() * inverse_speed.array();
    const double speed_squared = unknowns[last_ + 1];
    VectorXd result(last_ + 2);
    result.head(last_ + 1) = (speed_squared / 2.0L * (derivative_ * squares) + climb).cast<double>();
    result[0] = crest_.height ? static_cast<double>(speed_squared * (squares[last_] - squares[0]) / 2) - *crest_.height
                              : unknowns[0] - std::log(*crest_.speed);
    if (periodic_) {
      // cos(theta)/q - 1
      const Extended excess = expm1(-tau).array() - 2 * (theta.array() / 2).sin().square() * inverse_speed.array();
      result[last_] = weight_.cwiseProduct(stretch_).dot(excess.cast<double>());
    }
    result[last_ + 1] = end_.dot(unknowns.head(last_ + 1));
    return result;
  }

  void jacobian(const VectorXd& unknowns, MatrixXd& matrix) const {
    const Index count = last_ + 1;
    const VectorXd tau = unknowns.head(count);
    const double speed_squared = unknowns[count];
    const VectorXd theta = inclination(tau);
    const VectorXd speeds = (2 * tau.array()).exp();
    const VectorXd squares = expm1(2 * tau);
    const VectorXd inverse_speed = (-tau.array()).exp();
    const VectorXd along = stretch_.array() * theta.array().cos() * inverse_speed.array();
    const VectorXd across = stretch_.array() * theta.array().sin() * inverse_speed.array();
    matrix.setZero(count + 1, count + 1);
    for (Index j = 0; j < count; ++j) {
      matrix.col(j).head(count) = speed_squared * speeds[j] * derivative_.col(j).cast<double>() +
                                  along.cwiseProduct(conjugate_.col(j).cast<double>());
      matrix(j, j) -= across[j];
      if (periodic_) {
        matrix(last_, j) = -weight_[j] * along[j] - weight_.cwiseProduct(across).dot(conjugate_.col(j).cast<double>());
      }
    }
    matrix.col(count).head(count) = (derivative_ * squares.cast<long double>()).cast<double>() / 2;
    if (periodic_) matrix(last_, count) = 0;
    matrix.row(0).setZero();
    if (crest_.height) {
      matrix(0, 0) = -speed_squared * speeds[0];
      matrix(0, last_) = speed_squared * speeds[last_];
      matrix(0, count) = (squares[last_] - squares[0]) / 2;
    } else {
      matrix(0, 0) = 1;
    }
    matrix.row(count).head(count) = end_.transpose();
  }

 private:
  WaveCrest crest_;
  bool periodic_;
  Index last_;
  VectorXd stretch_;
  ConformalNodes::Matrix derivative_, conjugate_;
  VectorXd weight_, end_;  ///< of the mean over a period, and of the equation of the end
};

/// Newton's method with an exact Jacobian: steps are halved until they are admissible; once the correction is below
/// 1e-3 the factors are kept and iterated until the correction no longer shrinks: the rounding of the residual.
///
/// @returns the last correction (maximum norm), infinite without convergence
double solve_newton(const StreamlineEquations& system, VectorXd& unknowns) {
  constexpr int most_steps = 30;
  constexpr double refine_below = 1e-3;
  MatrixXd jacobian;
  for (int step = 0; step < most_steps; ++step) {
    system.jacobian(unknowns, jacobian);
    const Eigen::PartialPivLU<Eigen::Ref<MatrixXd>> factors(jacobian);
    VectorXd correction = factors.solve(system.residual(unknowns));
    double size = correction.lpNorm<Eigen::Infinity>();
    if (!std::isfinite(size)) break;
    double damping = 1;
    while (damping > 1e-6 && !system.admissible(unknowns - damping * correction)) damping /= 2;
    unknowns -= damping * correction;
    if (size > refine_below) continue;
    for (int refinement = 0; refinement < 20; ++refinement) {
      correction = factors.solve(system.residual(unknowns));
      const double previous = size;
      size = correction.lpNorm<Eigen::Infinity>();
      if (!(size < 0.5 * previous)) break;
      unknowns -= correction;
    }
    return size;
  }
  return std::numeric_limits<double>::infinity();
}

/// tau of a wave at other nodes, scaled to another crest; 0 beyond its last node.
VectorXd transfer(const ConformalSolution& from, const ConformalNodes& to, double crest_tau) {
  const VectorXd none = VectorXd::Zero(from.tau.size());
  const Interpolation between = from.nodes->between(from.tau, none, none);
  const double last = from.nodes->spacing() * static_cast<double>(from.tau.size() - 1);
  return to.potential().unaryExpr([&](double potential) {
    const double s = from.nodes->label(potential);
    return s <= last * (1 + 1e-12) ? between(s).elevation * crest_tau / from.tau[0] : 0;  // a trough's own label
  });
}

}  // namespace

void require_resolution(Resolution resolution) {
  require_within("resolution.refinement", resolution.refinement, 0.5, 2);
  require_within("resolution.clustering", resolution.clustering, 0.25, 4);
}

void ConformalNodes::place(Index count, double spacing) {
  spacing_ = spacing;
  potential_.resize(count);
  stretch_.resize(count);
  for (Index j = 0; j < count; ++j) {
    const Node node = at(static_cast<double>(j) * spacing_);
    potential_[j] = static_cast<double>(node.potential);
    stretch_[j] = node.stretch;
  }
}

ConformalNodes::Matrix ConformalNodes::folded(const Sequence& sequence) const {
  const Index last = count() - 1;
  std::vector<long double> value;
  for (Index m = 0; m <= 2 * last; ++m) value.push_back(m == 0 ? 0 : sequence(m));
  const auto at = [&](Index m) {
    return m < 0 ? -value[static_cast<std::size_t>(-m)] : value[static_cast<std::size_t>(m)];
  };
  Matrix matrix = Matrix::Zero(last + 1, last + 1);
  for (Index j = 0; j <= last; ++j) {
    const bool own_image = j == 0 || (periodic_ && j == last);
    for (Index i = 1; i <= (periodic_ ? last - 1 : last); ++i) {
      matrix(i, j) = own_image ? at(i - j) : at(i - j) + at(i + j);
    }
  }
  return matrix;
}

ConformalNodes::Matrix ConformalNodes::on_alternate_points(const std::function<double(double)>& kernel) const {
  const Index last = count() - 1;
  std::vector<long double> potential;
  for (Index j = 0; j <= last; ++j) potential.push_back(at(static_cast<double>(j) * spacing_).potential);
  const auto phi = [&](Index j) { return potential[static_cast<std::size_t>(j)]; };
  Matrix matrix = Matrix::Zero(last + 1, last + 1);
  for (Index j = 0; j <= last; ++j) {
    for (Index i = (j + 1) % 2; i < j; i += 2) {
      // Differences in extended precision: under a steep crest they are many orders below phi far away.
      const double behind = kernel(static_cast<double>(phi(j) - phi(i)));
      const double ahead = i > 0 && !(periodic_ && j == last) ? kernel(static_cast<double>(phi(i) + phi(j))) : 0;
      matrix(i, j) = 2 * spacing_ * stretch_[j] * (ahead - behind);
      matrix(j, i) = 2 * spacing_ * stretch_[i] * (ahead + behind);
    }
  }
  matrix.row(0).setZero();
  if (periodic_) matrix.row(last).setZero();
  return matrix;
}

ConformalSolution solve_on(const std::shared_ptr<const ConformalNodes>& nodes, WaveCrest crest, const VectorXd& tau,
                           double speed_squared) {
  VectorXd unknowns(nodes->count() + 1);
  unknowns << tau, speed_squared;
  const StreamlineEquations equations(*nodes, crest);
  const double correction = solve_newton(equations, unknowns);
  const VectorXd solved = unknowns.head(nodes->count());
  return {nodes, solved, equations.inclination(solved), unknowns[nodes->count()], correction};
}

ConformalSolution approach(const WaveFamily& family, WaveCrest crest, ConformalSolution wave) {
  constexpr double step = 0.105;  // q falls by a tenth
  constexpr double converged = 1e-6;
  const auto reached = [&] {
    return crest.height ? wave.height() >= *crest.height * (1 - 1e-9) : wave.tau[0] <= std::log(*crest.speed) + 1e-12;
  };
  ConformalSolution last = wave;
  while (!reached()) {
    const double slope = std::min(-1.6 * wave.tau[0], step - wave.tau[0]);
    const double speed = std::max(std::exp(-slope), crest.speed.value_or(0));
    // Near the limiting wave no more than about c^2 q^2/2 is left of the height.
    const double left = 2 * wave.speed_squared * std::exp(2 * wave.tau[0]);
    const bool beyond = crest.height && wave.crest_speed() < 0.1 && *crest.height > wave.height() + left;
    const bool good = wave.correction < converged;
    if (good) last = wave;
    require_that(speed >= family.least_speed && good && !beyond,
                 "{}: the last wave that converged has {:.8g}, with the speed {:.3g} c at its crest", family.limit,
                 family.share * last.height(), last.crest_speed());
    const auto nodes = family.nodes(wave.speed_squared, speed, false);
    wave = solve_on(nodes, {{}, speed}, transfer(wave, *nodes, std::log(speed)), wave.speed_squared);
  }
  if (!crest.height) return wave;
  ConformalSolution close = solve_on(wave.nodes, crest, wave.tau, wave.speed_squared);
  return close.correction < converged ? close : wave;
}

ConformalSolution refined(const WaveFamily& family, WaveCrest crest, const ConformalSolution& nearby) {
  const auto nodes = family.nodes(nearby.speed_squared, nearby.crest_speed(), true);
  ConformalSolution wave = solve_on(nodes, crest, transfer(nearby, *nodes, nearby.tau[0]), nearby.speed_squared);
  require_that(wave.correction < 1e-8,
               "{}: Newton's method stopped at a correction of {:.1e}; lower the amplitude or raise the resolution",
               family.described, wave.correction);
  return wave;
}

ConformalSurface::Point ConformalSurface::find(double x) const {
  const auto* begin = position_.data();
  const auto* end = begin + position_.size();
  const auto right = std::clamp<std::ptrdiff_t>(std::upper_bound(begin, end, x) - begin, 1, end - begin - 1);
  const double fraction = (x - position_[right - 1]) / (position_[right] - position_[right - 1]);
  const double last_label = solution_.nodes->periodic() ? std::numbers::pi : std::numeric_limits<double>::infinity();
  const auto inside = [&](double label) { return std::clamp(label, 0.0, last_label); };
  // The map is monotone and nearly linear between nodes: Newton's method converges from the chord.
  Point result = point(inside((static_cast<double>(right - 1) + fraction) * solution_.nodes->spacing()));
  constexpr double accuracy = 1e-9;  // the step after it is exact to round-off
  for (int step = 0; step < 8; ++step) {
    const double correction = (x - result.x) / result.stretch;
    const bool last = std::abs(correction) < accuracy;
    result = point(inside(result.label + correction));
    if (last) break;
  }
  return result;
}

double ConformalSurface::elevation(double x) const {
  const double distance = std::abs(reduced(x));
  return distance >= end_ ? 0 : find(distance).elevation;
}

void ConformalSurface::add_to_contour(Complex z, double log_speed, double inclination, double stretch) {
  const Complex tangent = stretch * std::polar(std::exp(-log_speed), inclination);
  velocity_.add(pole(z), pole_slope(z) * tangent, speed_ * velocity_defect(log_speed, inclination));
  contour_.push_back(z.real());
}

void ConformalSurface::add_nodes_to_contour() {
  const Index last = position_.size() - 1;
  for (Index j = 0; j <= last; ++j) {
    const bool on_axis = j == 0 || (solution_.nodes->periodic() && j == last);
    add_to_contour({position_[j], elevation_[j]}, solution_.tau[j], solution_.inclination[j],
                   (on_axis ? 0.5 : 1) * solution_.nodes->stretch()[j]);
  }
}

double ConformalSurface::maximum_slope() const {
  const VectorXd none = VectorXd::Zero(position_.size());
  const Interpolation between = solution_.nodes->between(none, solution_.inclination, none);
  Index node = 0;
  solution_.inclination.minCoeff(&node);
  const double spacing = solution_.nodes->spacing();
  const double s = static_cast<double>(node) * spacing;
  return -boost::math::tools::brent_find_minima([&](double label) { return between(label).displacement; }, s - spacing,
                                                s + spacing, 40)
              .second;
}

Velocity ConformalSurface::velocity(double x, double y) const {
  const double place = reduced(x);
  const double distance = std::abs(place);
  constexpr double rounding = 1e-13;  // elevation(x) itself counts as inside
  const auto* begin = position_.data();
  const auto right = std::min<std::ptrdiff_t>(std::upper_bound(begin, begin + position_.size(), distance) - begin,
                                              position_.size() - 1);
  if (y > elevation_[right]) {
    const double surface = elevation(distance);
    require_that<OutsideFluid>(
        y <= surface + rounding,
        "{0}y{1} = {2:.17g} is above the surface: at {0}x{1} = {3:.17g} it must be in [{4:.17g}, {5:.17g}]", before_,
        after_, y, x, -depth_, surface);
  }
  require_that<OutsideFluid>(y >= -depth_ * (1 + rounding),
                             "{0}y{1} = {2:.17g} is below the bottom: it must be at least {3:.17g}", before_, after_, y,
                             -depth_);
  constexpr double calm = -100;  // velocities are below exp(-100)
  if (y < calm || distance >= end_) return {};
  const auto index = [&](double bound) {
    return static_cast<std::size_t>(std::lower_bound(contour_.begin(), contour_.end(), bound) - contour_.begin());
  };
  const Complex value = velocity_.at(pole({distance, y}), index(distance - reach_), index(distance + reach_));
  return {value.real(), place < 0 ? value.imag() : -value.imag()};
}

double section_flux(const ConformalSurface& wave, double bottom) {
  constexpr int panels = 14;
  constexpr double ratio = 0.4;
  const double top = wave.crest();
  double sum = 0;
  for (int panel = 0; panel < panels; ++panel) {
    const double far = (top - bottom) * std::pow(ratio, panel);
    const double near = panel + 1 < panels ? ratio * far : 0;
    sum += boost::math::quadrature::gauss<double, 20>::integrate(
        [&](double depth) { return wave.velocity(0, top - depth).u; }, near, far);
  }
  return sum;
}

}  // namespace seiche::exact
