#include "validation/instruments/wave_source.hpp"

#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/linear/fourier.hpp"
#include "seiche/require.hpp"
#include "seiche/shallow_water/dispersive_surface.hpp"

namespace seiche::dispersive_shallow_water_1d {

constexpr std::size_t finer = 4;  // samples of F for one of the record

double surface_of_wave(double gamma, double kh) {
  const double s = gamma * kh * kh;
  return (1 + DispersiveSurface::above * s) / (1 + DispersiveSurface::below * s);
}

double bound_second_harmonic(double alpha, double gamma, double power, double kh) {
  const double square = kh * kh;
  const double celerity = (1 + gamma * square) / (1 + alpha * square);  // squared
  return (celerity + (alpha * celerity + gamma * power) * square) / (4 * (1 - celerity));
}

double small_wavenumber(const Channel& channel, double depth, double omega) {
  // nu (1 + alpha s) = s (1 + gamma s), s = (k h)^2
  const double nu = omega * omega * depth / channel.gravity;
  const double linear = 1 - channel.alpha * nu;
  if (channel.gamma == 0 && !(linear > 0)) {
    throw std::invalid_argument(fmt::format("omega = {:g} is out of range: below {:g} over the depth {:g}", omega,
                                            std::sqrt(channel.gravity / (channel.alpha * depth)), depth));
  }
  const double root = std::sqrt(linear * linear + 4 * channel.gamma * nu);
  const double square = linear > 0 ? 2 * nu / (root + linear) : (root - linear) / (2 * channel.gamma);
  return std::sqrt(square) / depth;
}

WaveSource::WaveSource(const Channel& channel, const WaveSourcePlace& place, std::span<const double> record,
                       double interval, double lowest, double highest)
    : place_(place), step_(interval / finer) {
  require_positive("interval", interval);
  require_positive("depth", place.depth);
  require_positive("width", place.width);
  require_at_least("samples of the record", static_cast<long>(record.size()), 4);
  require_positive("target - source", place.target - place.source);
  require_within("highest", highest, lowest, 0.5 / interval);
  const std::size_t n = record.size();
  std::vector<std::complex<double>> samples(record.begin(), record.end());
  std::vector<std::complex<double>> spectrum(n);
  linear::Fourier(n).coefficients(samples, spectrum);
  std::vector<std::complex<double>> force(finer * n, 0.0);
  const double duration = interval * static_cast<double>(n);
  for (std::size_t i = 1; 2 * i < n; ++i) {
    const double frequency = static_cast<double>(i) / duration;
    if (frequency < lowest || frequency > highest) continue;
    const double omega = 2 * std::numbers::pi * frequency;
    const double k = small_wavenumber(channel, place.depth, omega);
    const double depth = place.depth;
    const double shape = place.width * std::sqrt(2 * std::numbers::pi) * std::exp(-0.5 * std::pow(k * place.width, 2));
    const double stiffness =
        channel.gravity * (1 + 2 * channel.gamma * std::pow(k * depth, 2)) - omega * omega * channel.alpha * depth;
    const double response = shape / (2 * stiffness) * surface_of_wave(channel.gamma, k * depth);
    const std::complex<double> earlier = std::polar(1.0, k * (place.target - place.source));
    force[i] = spectrum[i] * earlier / response;
    force[force.size() - i] = std::conj(force[i]);
  }
  linear::Fourier(force.size()).samples(force, force);
  for (const std::complex<double>& one : force) strength_.push_back(one.real());
}

double WaveSource::shape(double x) const {
  const double s = (x - place_.source) / place_.width;
  return s * s < 72 ? std::exp(-0.5 * s * s) : 0;  // below rounding
}

double WaveSource::strength(double time) const {
  const auto n = static_cast<double>(strength_.size());
  double at = time / step_;
  at -= n * std::floor(at / n);
  const auto i = static_cast<std::size_t>(at) % strength_.size();
  const double share = at - std::floor(at);
  return (1 - share) * strength_[i] + share * strength_[(i + 1) % strength_.size()];
}

double WaveSource::force(double x, double time) const {
  return shape(x) * strength(time);
}

}  // namespace seiche::dispersive_shallow_water_1d
