#include "seiche/exact/overturning/wall_column.hpp"

#include <numbers>

#include <boost/math/quadrature/gauss.hpp>

namespace seiche::exact::overturning {

namespace {

using Complex = std::complex<double>;

/// P of z + ih - pi, and its derivative.
Complex pole(Complex place) {
  const Complex sine = std::sin(0.5 * place);
  return sine * sine;
}
Complex pole_slope(Complex place) {
  return 0.5 * std::sin(place);
}

/// The function of the label whose derivative is given at the markers, 0 at the one in the middle.
std::vector<double> integrated(const Eigen::VectorXd& slope) {
  const auto n = static_cast<std::size_t>(slope.size());
  linear::Fourier fourier(n);
  std::vector<Complex> work(n);
  for (std::size_t j = 0; j < n; ++j) work[j] = slope[static_cast<Eigen::Index>(j)];
  fourier.coefficients(work, work);
  for (std::size_t k = 0; k < n; ++k) {
    const bool lost = k == 0 || fourier.is_sawtooth(k);
    work[k] = lost ? 0 : work[k] / Complex(0, fourier.wavenumber(k));
  }
  fourier.samples(work, work);
  std::vector<double> values(n);
  for (std::size_t j = 0; j < n; ++j) values[j] = work[j].real() - work[n / 2].real();
  return values;
}

}  // namespace

WallColumn::WallColumn(const Moment& moment, double depth, SurfaceVelocity& equation) : depth_(depth) {
  const auto surface = view(moment.state);
  const auto rate = view(moment.rate);
  const std::size_t n = surface.size();
  State of_rate = moment.state;
  const auto phi_t = view(of_rate).potential;
  for (std::size_t j = 0; j < n; ++j) {
    phi_t[j] = -0.5 * std::norm(Complex(rate.displacement[j], rate.y[j])) - surface.y[j];
  }
  Eigen::VectorXd slope = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(n));
  equation.solve(view(std::as_const(of_rate)), slope);
  const std::vector<double> psi_t = integrated(slope);
  const std::vector<double> psi = integrated(moment.psi_s);
  for (std::size_t j = n / 2; j <= n; ++j) {
    const std::size_t marker = j % n;
    const double x = label(j, n) + surface.displacement[marker];
    const Complex place(x - std::numbers::pi, surface.y[marker] + depth);
    const bool own_conjugate = marker == 0 || marker == n / 2;
    const Complex slope_of_pole = pole_slope(place);
    // i dP: of the images, which are passed the other way, the conjugate.
    const Complex weight = Complex(0, own_conjugate ? 0.5 : 1.0) * slope_of_pole * equation.tangent(marker);
    const Complex velocity(rate.displacement[marker], -rate.y[marker]);
    potential_.add(pole(place), weight, {surface.potential[marker], psi[marker]});
    rate_.add(pole(place), weight, {phi_t[marker], psi_t[marker]});
    slope_.add(pole(place), weight, velocity / slope_of_pole);
  }
  level_ = surface.y[n / 2];
  opposite_level_ = surface.y[0];
  // int psi dx from wall to wall: the integrand is a sum of sines of the label.
  linear::Fourier fourier(n);
  std::vector<Complex> work(n);
  for (std::size_t j = 0; j < n; ++j) work[j] = psi[j] * equation.tangent(j).real();
  fourier.coefficients(work, work);
  for (std::size_t k = 1; k < n / 2; k += 2) impulse_ -= 4 * work[k].imag() / static_cast<double>(k);
}

double WallColumn::pressure(Complex place, double y) const {
  const Complex at = pole(place);
  const double v = -(slope_.at(at, 0, slope_.size()) * pole_slope(place)).imag();
  return -rate_.at(at, 0, rate_.size()).real() - 0.5 * v * v - y;
}

double WallColumn::force(double x, double level) const {
  const auto at = [&](double y) { return pressure({x, y + depth_}, y); };
  return boost::math::quadrature::gauss<double, 30>::integrate(at, -depth_, level);
}

}  // namespace seiche::exact::overturning
