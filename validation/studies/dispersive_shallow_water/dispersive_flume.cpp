#include "validation/studies/dispersive_shallow_water/dispersive_flume.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <boost/math/tools/roots.hpp>

#include "seiche/exact/model_waves.hpp"
#include "seiche/models/dispersive_shallow_water_1d/water_surface.hpp"
#include "validation/instruments/agreement.hpp"
#include "validation/instruments/wave_source.hpp"

namespace seiche::validation::laboratory {
namespace {

using dispersive::Channel;
using dispersive::End;
using dispersive::Flow;
using dispersive::SurfaceMotion;

constexpr double courant = 0.3;  // of the longest stable step

/// From 0 to 1 over about a wavelength that begins at s = 0.
double fade(double s, double length) {
  return 0.5 * (1 + std::tanh(4 * s / length - 2));
}

/// What moved water needs, from its elevation and velocity alone: slopes and areas by differences.
Flow moved_water(const Flume& flume, const std::function<double(double)>& elevation,
                 const std::function<double(double)>& velocity) {
  const Channel channel = flume.channel();
  const double begin = flume.bed_x.front() + 1;  // what the waves add may move the first marker
  const double end = flume.shoreline ? 0 : flume.bed_x.back();
  const auto cells = static_cast<std::size_t>(std::round((end - begin) / flume.spacing));
  const double fine = flume.spacing / 8;
  std::vector<double> places{begin - 1};
  std::vector<double> area{0};
  while (places.back() < end + 1) {
    const double next = places.back() + fine;
    area.push_back(area.back() + 0.5 * fine * (elevation(places.back()) + elevation(next)));
    places.push_back(next);
  }
  const auto excess = [&](double x) { return linear_at({places, area}, std::clamp(x, places.front(), places.back())); };
  const auto motion = [&](double x) {
    const double slope = (velocity(x + fine) - velocity(x - fine)) / (2 * fine);
    const double eta = elevation(x);
    return SurfaceMotion{eta, velocity(x), -(eta - channel.bottom->elevation(x)) * slope};
  };
  return {channel, dispersive::moved_markers(channel, dispersive::equal_labels(channel, begin, end, cells), motion,
                                             excess, end)};
}

}  // namespace

Channel Flume::channel() const {
  Channel channel{.bottom = std::make_shared<PiecewiseLinearBottom>(bed_x, bed_z),
                  .left = End::wall,
                  .right = shoreline ? End::tip : End::wall,
                  .gravity = gravity,
                  .kinetics = dispersive::Kinetics::green_naghdi};
  channel.gamma = gamma;
  channel.alpha = 1.0 / 3 + gamma;
  channel.friction = friction;
  channel.breaking = breaking;
  return channel;
}

Parameter dispersion_parameter() {
  return choice("dispersion", "one-parameter", {"improved", "one-parameter", "serre"},
                "law of the model's linear waves");
}

double gamma_of(const std::string& dispersion) {
  if (dispersion == "one-parameter") return one_parameter;
  return dispersion == "improved" ? improved : 0;
}

double wavenumber(double depth, double period, double gravity, double gamma) {
  // nu (1 + alpha s) = s (1 + gamma s), s = (k h)^2
  const double nu = std::pow(2 * std::numbers::pi / period, 2) * depth / gravity;
  const double linear = 1 - (1.0 / 3 + gamma) * nu;
  const double root = std::sqrt(linear * linear + 4 * gamma * nu);
  return std::sqrt(gamma > 0 ? (root - linear) / (2 * gamma) : nu / linear) / depth;
}

Flow regular_waves(const Flume& flume, const Train& train) {
  const double k = wavenumber(train.depth, train.period, flume.gravity, flume.gamma);
  const double speed = 2 * std::numbers::pi / (train.period * k);
  const double length = 2 * std::numbers::pi / k;
  // Of the markers, whose wave keeps its form.
  const double amplitude = train.amplitude / dispersive::surface_of_wave(flume.gamma, k * train.depth);
  const Channel channel = flume.channel();
  const double second =
      amplitude / train.depth *
      dispersive::bound_second_harmonic(channel.alpha, channel.gamma, channel.depth_power, k * train.depth);
  const auto elevation = [=](double x) {
    const double phase = k * (x - train.to);
    return amplitude * fade(x - train.from, length) * fade(train.to - x, length) *
           (std::cos(phase) + second * std::cos(2 * phase));
  };
  const auto velocity = [=](double x) { return speed * elevation(x) / (train.depth + elevation(x)); };
  return moved_water(flume, elevation, velocity);
}

Flow cnoidal_waves(const Flume& flume, const Cnoidal& train) {
  const auto wave_of = [&](double length) {
    return exact::SerreCnoidal(train.height, length, train.depth, flume.gravity);
  };
  // Without a mean discharge the wave runs with Q/depth.
  const auto period_of = [&](double length) { return length * train.depth / wave_of(length).discharge(); };
  const double longest = train.period * std::sqrt(flume.gravity * (train.depth + train.height));
  const auto [below, above] =
      boost::math::tools::bisect([&](double length) { return period_of(length) - train.period; }, longest / 2, longest,
                                 boost::math::tools::eps_tolerance<double>(40));
  const exact::SerreCnoidal wave = wave_of(0.5 * (below + above));
  const auto elevation = [=, length = wave.wavelength()](double x) {
    return fade(x - train.from, length) * fade(train.to - x, length) * wave.elevation(x - train.to);
  };
  const auto velocity = [=, flux = wave.discharge() / train.depth](double x) {
    return flux * elevation(x) / (train.depth + elevation(x));
  };
  return moved_water(flume, elevation, velocity);
}

Flow solitary_waves(const Flume& flume, const std::vector<Solitary>& waves) {
  const auto one = [&](const Solitary& wave, double x) {
    return exact::SerreSolitary(wave.amplitude, wave.depth, flume.gravity).elevation(x - wave.crest);
  };
  const auto elevation = [&](double x) {
    double sum = 0;
    for (const Solitary& wave : waves) sum += one(wave, x);
    return sum;
  };
  const auto velocity = [&](double x) {
    double sum = 0;
    for (const Solitary& wave : waves) {
      const double eta = one(wave, x);
      sum += wave.direction * exact::SerreSolitary(wave.amplitude, wave.depth, flume.gravity).speed() * eta /
             (wave.depth + eta);
    }
    return sum;
  };
  return moved_water(flume, elevation, velocity);
}

Flow smooth_bore(const Flume& flume, double depth, double jump, double width) {
  const auto elevation = [=](double x) { return 0.5 * jump * depth * (1 - std::tanh(x / width)); };
  const auto velocity = [=, g = flume.gravity](double x) {
    const double behind = depth * (1 + jump);
    const double flux = std::sqrt(g * (behind + depth) / (2 * depth * behind)) * behind;  // of the bore, per elevation
    const double eta = elevation(x);
    return flux * eta / (depth + eta);
  };
  return moved_water(flume, elevation, velocity);
}

std::vector<SubmittedGroup> gauge_records(Flow& flow, const Flume& flume, const std::vector<double>& groups,
                                          const std::vector<double>& places, double interval, double end,
                                          double origin) {
  std::vector<SubmittedGroup> records;
  for (const double group : groups) records.push_back({.value = group});
  const auto note = [&] {
    const std::vector<double> eta = dispersive::water_surface_at(flow, places);
    for (std::size_t k = 0; k < records.size(); ++k) {
      records[k].abscissa.push_back(flow.time() - origin);
      records[k].values["eta"].push_back(eta[k]);
    }
  };
  note();
  const double start = flow.time();
  const long samples = std::lround((end - start) / interval);
  for (long k = 1; k <= samples; ++k) {
    march(flow, start + static_cast<double>(k) * interval, stable_steps(flow, flume.tau, courant));
    note();
  }
  return records;
}

}  // namespace seiche::validation::laboratory
