/// What the Stokes wave and the solitary wave of the Euler equations share: nodes that gather under the crest, Newton's
/// method, the surface between its nodes, and the velocity inside.
///
/// Waves are symmetric about the crest s = 0 and solved on s >= 0, in units of their own. The changes of variable
/// phi(s) are analytic in a strip around the real s axis whose width does not shrink as the cluster becomes narrower,
/// so that series in s converge at the same rate for every steepness and the number of nodes grows like the logarithm
/// of the width only.
///
/// References: Stenger, Numerical Methods Based on Sinc and Analytic Functions (1993); Berrut & Trefethen, Barycentric
/// Lagrange interpolation, SIAM Rev. 46 (2004) 501.
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "seiche/exact/reference_solution.hpp"
#include "seiche/require.hpp"

namespace seiche::exact {

/// Velocity inside a wave from its values on the surface, by the quotient of two Cauchy sums.
///
/// Cauchy's formula with a kernel of simple pole z, summed by the trapezoidal rule along the closed contour, over the
/// same sum for the constant 1: errors of the rule near the pole cancel in the quotient, so that it is uniformly
/// accurate up to the surface (a barycentric formula). Waves symmetric about the crest have a contour of pairs with
/// conjugate poles and conjugate weights; in a variable p(z), even about the bottom where there is one, the mirror
/// image is contained in the sum:
///
///     f(z) = sum_j [w_j f_j/(p_j - p) + conj] / sum_j [w_j/(p_j - p) + conj].
///
/// References: Helsing & Ojala, On the evaluation of layer potentials close to their sources, J. Comput. Phys. 227
/// (2008) 2899; Berrut & Trefethen, Barycentric Lagrange interpolation, SIAM Rev. 46 (2004) 501.
class CauchyVelocity {
 public:
  using Complex = std::complex<double>;

  /// @param pole    p_j;  @param weight  w_j, halved where a pole is its own conjugate;  @param value  f_j = u - i v
  void add(Complex pole, Complex weight, Complex value) {
    pole_re_.push_back(pole.real());
    pole_im_.push_back(pole.imag());
    weight_re_.push_back(weight.real());
    weight_im_.push_back(weight.imag());
    moment_re_.push_back((weight * value).real());
    moment_im_.push_back((weight * value).imag());
    values_.push_back(value);
  }
  [[nodiscard]] std::size_t size() const { return values_.size(); }

  /// f where the variable is p, from the nodes first <= j < last.
  [[nodiscard]] Complex at(Complex p, std::size_t first, std::size_t last) const {
    double numerator_re = 0;
    double numerator_im = 0;
    double denominator_re = 0;
    double denominator_im = 0;
    const double im_sum = -2 * p.imag();
#pragma omp simd reduction(+ : numerator_re, numerator_im, denominator_re, denominator_im)
    for (std::size_t j = first; j < last; ++j) {
      const double a_re = pole_re_[j] - p.real();
      const double a_im = pole_im_[j] - p.imag();
      const double b_im = -pole_im_[j] - p.imag();
      // 1/((p_j - p)(conj p_j - p)), then w (conj p_j - p) + conj(w) (p_j - p).
      const double product_re = a_re * a_re - a_im * b_im;
      const double product_im = a_re * im_sum;
      const double scale = 1 / (product_re * product_re + product_im * product_im);
      const double inverse_re = product_re * scale;
      const double inverse_im = -product_im * scale;
      const double difference = 2 * pole_im_[j];
      const double w_re = 2 * weight_re_[j] * a_re + weight_im_[j] * difference;
      const double w_im = weight_re_[j] * im_sum;
      const double m_re = 2 * moment_re_[j] * a_re + moment_im_[j] * difference;
      const double m_im = moment_re_[j] * im_sum;
      denominator_re += w_re * inverse_re - w_im * inverse_im;
      denominator_im += w_re * inverse_im + w_im * inverse_re;
      numerator_re += m_re * inverse_re - m_im * inverse_im;
      numerator_im += m_re * inverse_im + m_im * inverse_re;
    }
    const Complex quotient = Complex(numerator_re, numerator_im) / Complex(denominator_re, denominator_im);
    if (std::isfinite(quotient.real()) && std::isfinite(quotient.imag())) return quotient;
    return at_node(p, first, last);
  }

 private:
  /// The value of the node that coincides with p.
  [[nodiscard]] Complex at_node(Complex p, std::size_t first, std::size_t last) const {
    const auto apart = [&](std::size_t j, double side) {
      return std::abs(Complex(pole_re_[j], side * pole_im_[j]) - p);
    };
    std::size_t nearest = first;
    for (std::size_t j = first; j < last; ++j) {
      if (std::min(apart(j, 1), apart(j, -1)) < std::min(apart(nearest, 1), apart(nearest, -1))) nearest = j;
    }
    return apart(nearest, 1) <= apart(nearest, -1) ? values_[nearest] : std::conj(values_[nearest]);
  }

  std::vector<double> pole_re_, pole_im_, weight_re_, weight_im_, moment_re_, moment_im_;
  std::vector<Complex> values_;
};

/// How finely a conformal wave is resolved. The defaults reach round-off; a second value of each tells the error, since
/// integral identities alone under-report it by up to three orders.
struct Resolution {
  double refinement = 1;  ///< factor on the number of nodes, [0.5, 2]
  double clustering = 1;  ///< factor on the width of the cluster of nodes under the crest, [0.25, 4]
};
void require_resolution(Resolution resolution);

/// One of the two is given: the height of the crest above the lowest water, or the speed of the water at the crest,
/// seen from the wave, relative to the wave's.
struct WaveCrest {
  std::optional<double> height;
  std::optional<double> speed;
};

struct SurfaceSample {
  double elevation = 0;     ///< even in s
  double displacement = 0;  ///< odd in s
  double stretch = 0;       ///< even in s: the derivative by which x(s) is inverted
};

/// A wave's surface between its nodes: the even function elevation(s) and the odd function x(s), stored without the
/// part that does not decay (or is not periodic), which the caller adds.
using Interpolation = std::function<SurfaceSample(double s)>;

/// Nodes s_j = j spacing, j = 0..N, what they do to the potential phi(s), and the operators on functions of s.
class ConformalNodes {
 public:
  using Sequence = std::function<long double(Eigen::Index)>;
  using Matrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;
  struct Node {
    long double potential;  ///< phi(s)
    double stretch;         ///< dphi/ds
  };

  ConformalNodes(const ConformalNodes&) = delete;
  ConformalNodes& operator=(const ConformalNodes&) = delete;
  virtual ~ConformalNodes() = default;

  [[nodiscard]] virtual Node at(double s) const = 0;
  [[nodiscard]] virtual double label(double potential) const = 0;  ///< s(phi)
  /// d/ds of even functions, rows of the nodes that are not ends of a period.
  [[nodiscard]] virtual Matrix derivative() const = 0;
  /// theta = T tau in the same rows: the inclination vanishes at crest and trough.
  [[nodiscard]] virtual Matrix conjugate() const = 0;
  [[nodiscard]] virtual Interpolation between(const Eigen::VectorXd& elevation, const Eigen::VectorXd& displacement,
                                              const Eigen::VectorXd& stretch) const = 0;

  [[nodiscard]] bool periodic() const { return periodic_; }  ///< the last node is the trough
  [[nodiscard]] Eigen::Index count() const { return stretch_.size(); }
  [[nodiscard]] double spacing() const { return spacing_; }
  [[nodiscard]] double depth() const { return depth_; }                          ///< conformal
  [[nodiscard]] const Eigen::VectorXd& potential() const { return potential_; }  ///< phi_j
  [[nodiscard]] const Eigen::VectorXd& stretch() const { return stretch_; }

 protected:
  ConformalNodes(bool periodic, double depth) : periodic_(periodic), depth_(depth) {}
  void place(Eigen::Index count, double spacing);
  /// Convolution of even values with an odd sequence c(m), folded onto j >= 0; the result is odd.
  [[nodiscard]] Matrix folded(const Sequence& sequence) const;
  /// The principal value of an integral with an odd kernel by the trapezoidal rule on alternate points, spectrally
  /// accurate.
  [[nodiscard]] Matrix on_alternate_points(const std::function<double(double)>& kernel) const;

 private:
  bool periodic_;
  double depth_;
  double spacing_ = 0;
  Eigen::VectorXd potential_, stretch_;
};

/// A wave on its nodes, tau = log q.
struct ConformalSolution {
  std::shared_ptr<const ConformalNodes> nodes;
  Eigen::VectorXd tau, inclination;
  double speed_squared = 1;
  double correction = 0;  ///< last correction of Newton's method

  [[nodiscard]] double crest_speed() const { return std::exp(tau[0]); }
  /// c^2 (q_end^2 - q_crest^2)/2
  [[nodiscard]] double height() const {
    return 0.5 * speed_squared * (std::expm1(2 * tau[tau.size() - 1]) - std::expm1(2 * tau[0]));
  }
};

/// What tells one family of waves from another on the way to the crest asked for.
struct WaveFamily {
  /// Nodes for a wave of about this speed and crest; coarse ones to get there on.
  std::function<std::shared_ptr<const ConformalNodes>(double speed_squared, double crest_speed, bool fine)> nodes;
  double least_speed;     ///< at the crest of a wave that is tried
  std::string limit;      ///< which wave is above which limiting wave, for the message
  std::string described;  ///< the wave asked for, for the message
  double share;           ///< amplitude over height
};

/// The wave on these nodes, from a first guess of its values and of the square of its speed.
ConformalSolution solve_on(const std::shared_ptr<const ConformalNodes>& nodes, WaveCrest crest,
                           const Eigen::VectorXd& tau, double speed_squared);
/// Continuation in the crest's speed on coarse nodes, from a wave on such nodes to the crest asked for. Throws
/// std::invalid_argument above the limiting wave.
ConformalSolution approach(const WaveFamily& family, WaveCrest crest, ConformalSolution wave);
/// The wave asked for on fine nodes, from one nearby. Throws std::invalid_argument if Newton's method stops too early.
ConformalSolution refined(const WaveFamily& family, WaveCrest crest, const ConformalSolution& nearby);

/// The surface of a solved wave, and the water below it.
class ConformalSurface {
 public:
  virtual ~ConformalSurface() = default;

  [[nodiscard]] const ConformalSolution& solution() const { return solution_; }
  [[nodiscard]] double speed() const { return speed_; }
  [[nodiscard]] double crest_speed() const { return solution_.crest_speed(); }
  [[nodiscard]] double depth() const { return depth_; }  ///< mean, or undisturbed
  [[nodiscard]] double crest() const { return elevation_[0]; }
  [[nodiscard]] double elevation(double x) const;
  [[nodiscard]] double maximum_slope() const;
  [[nodiscard]] Velocity velocity(double x, double y) const;

  /// Of a line, or means over a wavelength: excess mass, impulse, energies and circulation, those that there are.
  struct Integrals {
    double mass = 0, impulse = 0, kinetic_energy = 0, potential_energy = 0, circulation = 0;
  };
  [[nodiscard]] const Integrals& integrals() const { return integrals_; }

 protected:
  struct Point {
    double label, x, displacement, elevation, stretch;
  };
  /// @param before, after  what makes a length dimensionless, for messages: "k x", "x/depth"
  ConformalSurface(ConformalSolution solution, std::string before, std::string after)
      : solution_(std::move(solution)),
        speed_(std::sqrt(solution_.speed_squared)),
        before_(std::move(before)),
        after_(std::move(after)) {}
  ConformalSurface(const ConformalSurface&) = default;
  ConformalSurface& operator=(const ConformalSurface&) = default;
  ConformalSurface(ConformalSurface&&) = default;
  ConformalSurface& operator=(ConformalSurface&&) = default;

  /// The surface point at x, not negative.
  [[nodiscard]] Point find(double x) const;
  /// Adds the nodes to the contour of Cauchy's integral.
  void add_nodes_to_contour();
  /// Adds one more: there q, theta and dphi/ds, or half of it on the axis.
  void add_to_contour(std::complex<double> z, double log_speed, double inclination, double stretch);

  ConformalSolution solution_;
  double speed_;
  double depth_ = 1;
  Eigen::VectorXd elevation_;
  Eigen::VectorXd position_;     ///< x_j
  Interpolation interpolation_;  ///< of y, the part of x that it can, dx/ds
  Integrals integrals_;
  double end_ = std::numeric_limits<double>::infinity();    ///< water rests from there on
  double reach_ = std::numeric_limits<double>::infinity();  ///< of the kernel of Cauchy's integral
  std::vector<double> contour_;                             ///< x of its nodes

 private:
  [[nodiscard]] virtual Point point(double label) const = 0;
  /// The variable p(z) of the quotient of Cauchy sums, and what dp/dz is proportional to.
  [[nodiscard]] virtual std::complex<double> pole(std::complex<double> z) const = 0;
  [[nodiscard]] virtual std::complex<double> pole_slope(std::complex<double> z) const = 0;
  /// x of the same place of the wave next to the crest.
  [[nodiscard]] virtual double reduced(double x) const { return x; }

  std::string before_, after_;
  CauchyVelocity velocity_;
};

/// A wave on a solved surface in the units of its user.
template <class Surface>
class ScaledWave {
 public:
  [[nodiscard]] double gravity() const { return gravity_; }                     ///< [m/s^2]
  [[nodiscard]] double speed() const { return celerity_ * surface_->speed(); }  ///< phase speed c [m/s]
  /// Speed of the water at the crest in the frame of the wave, relative to c.
  [[nodiscard]] double crest_speed() const { return surface_->crest_speed(); }

  /// Surface [m] at the distance x from the crest, or at x at time t of the wave with its crest at x = 0 at t = 0.
  [[nodiscard]] double elevation(double x) const {
    require_finite("x", x);
    return surface_->elevation(wavenumber_ * x) / wavenumber_;
  }
  [[nodiscard]] double elevation(double x, double t) const { return elevation(x - speed() * t); }
  /// Velocity potential on the surface [m^2/s], laboratory frame, 0 at the crest; odd in x.
  [[nodiscard]] double surface_potential(double x) const {
    require_finite("x", x);
    return celerity_ / wavenumber_ * surface_->potential(wavenumber_ * x);
  }
  /// Velocity [m/s] in the laboratory frame; throws OutsideFluid above the surface and below the bottom.
  [[nodiscard]] Velocity velocity(double x, double y) const {
    require_finite("x", x);
    require_finite("y", y);
    const Velocity scaled = surface_->velocity(wavenumber_ * x, wavenumber_ * y);
    return {celerity_ * scaled.u, celerity_ * scaled.v};
  }
  [[nodiscard]] Velocity velocity(double x, double y, double t) const { return velocity(x - speed() * t, y); }
  [[nodiscard]] double maximum_slope() const { return surface_->maximum_slope(); }  ///< of the surface [rad]

 protected:
  /// @param wavenumber  [1/m]: its inverse is the unit of length
  ScaledWave(std::shared_ptr<const Surface> surface, double wavenumber, double gravity)
      : surface_(std::move(surface)),
        wavenumber_(wavenumber),
        gravity_(gravity),
        celerity_(std::sqrt(gravity / wavenumber)) {}

  std::shared_ptr<const Surface> surface_;
  double wavenumber_, gravity_;
  double celerity_;  ///< sqrt(gravity/wavenumber)
};

/// Integral of a horizontal velocity u(y) over the section bottom <= y <= top under a crest, on panels that shrink
/// geometrically towards the crest: under a steep one the velocity varies over its distance from the limiting corner.
double section_flux(const ConformalSurface& wave, double bottom);

}  // namespace seiche::exact
