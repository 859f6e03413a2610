#include "seiche/exact/overturning/overturning_wave.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <memory>
#include <random>
#include <utility>

#include <gsl/gsl_sf_bessel.h>

#include "seiche/exact/entry.hpp"
#include "seiche/exact/overturning/evolution.hpp"
#include "seiche/exact/stokes_wave.hpp"
#include "seiche/require.hpp"
#include "seiche/samples.hpp"

namespace seiche::exact {

namespace ow = overturning;

namespace {

/// What both waves ask of their parameters.
template <class Parameters>
void require_computable(const Parameters& p) {
  require_all_positive({{"wavelength", p.wavelength},
                        {"gravity", p.gravity},
                        {"tolerance", p.tolerance},
                        {"depth", std::isinf(p.depth) && p.depth > 0 ? p.wavelength : p.depth}});
  require_at_least("markers", static_cast<long>(p.markers), 64);
  require_within("markers modulo 2", static_cast<double>(p.markers % 2), 0, 0);
  require_not_negative("last_time", p.last_time);
}

/// The second computation, up to a time.
template <class Wave>
auto coarser(typename Wave::Parameters p) {
  p.markers = std::max<std::size_t>(64, p.markers * 3 / 8 * 2);
  p.tolerance *= 10;
  return [p](double t) mutable {
    p.last_time = std::max(t, std::sqrt(p.wavelength / (2 * std::numbers::pi * p.gravity)) * 1e-3);
    return Wave(p);
  };
}

const OverturningWave::Parameters& checked(const OverturningWave::Parameters& p) {
  require_positive("amplitude", p.amplitude);
  require_computable(p);
  require_within("amplitude", p.amplitude, 0, std::min(p.wavelength / (2 * std::numbers::pi), 0.99 * p.depth));
  return p;
}

/// Frank's last frame, in units of 1/sqrt(g k).
constexpr double last_frame = 7.4;
constexpr double switched_off = std::numbers::pi;

const PressureForcedWave::Parameters& checked(const PressureForcedWave::Parameters& p) {
  require_computable(p);
  // As of Stokes waves; the markers must be closer to each other than to the bottom.
  require_that(2 * std::numbers::pi * p.depth >= 0.2 * p.wavelength,
               "depth = {:g} is out of range: must be at least 0.2 wavelength/(2 pi) = {:g}", p.depth,
               0.1 * p.wavelength / std::numbers::pi);
  require_within("amplitude", p.amplitude, 0, p.wavelength);
  require_positive("amplitude + |pressure|/gravity", p.amplitude + std::abs(p.pressure) / p.gravity);
  require_within("velocity_factor", p.velocity_factor, 0, 2);
  require_within("k pressure/gravity", 2 * std::numbers::pi / p.wavelength * p.pressure / p.gravity, -1, 1);
  return p;
}

/// In scaled units.
double surface_pressure(double strength, double x, double t) {
  return t <= switched_off ? -strength * std::sin(t) * std::sin(x - t) : 0;
}

const WavesInTank::Parameters& checked(const WavesInTank::Parameters& p) {
  require_computable(p);
  require_not_negative("focus", p.focus);
  require_within("first", p.first, 1, p.last);
  require_within("last", p.last, p.first, static_cast<double>(p.markers) / 8);
  if (p.peak != 0) require_within("peak", p.peak, p.first, p.last);
  require_not_negative("seed", p.seed);
  require_positive("amplitude", p.amplitude);
  require_within("bars", p.bars, 1, static_cast<double>(p.markers) / 8);
  const double sharp = p.wavelength / (2 * std::numbers::pi * p.bars);
  require_within("bar_height", p.bar_height, 0, std::isinf(p.depth) ? 0 : std::min(sharp, p.depth));
  require_within("amplitude", p.amplitude, 0,
                 std::min(p.wavelength / (2 * std::numbers::pi * p.last), 0.99 * p.depth - p.bar_height / 2));
  return p;
}

}  // namespace

OverturningWave::OverturningWave(const Parameters& parameters)
    : MovingSurface(checked(parameters).wavelength, parameters.gravity, parameters.amplitude,
                    coarser<OverturningWave>(parameters)),
      parameters_(parameters) {
  const double depth = parameters_.depth / length();
  const double last_time = parameters_.last_time > 0 ? parameters_.last_time
                                                     : 2 * std::numbers::pi / std::sqrt(std::tanh(depth)) * time_unit();
  compute(ow::Evolution(ow::sinusoidal_wave(parameters_.markers, parameters_.amplitude / length(), depth), depth,
                        parameters_.tolerance),
          last_time, [](double tangent) { return 0.25 * tangent; });
}

SelfTest OverturningWave::self_test() const {
  const double a = parameters_.amplitude / length();
  const double exact = 0.5 * std::numbers::pi * a * a * gsl_sf_bessel_I0(2 * a);
  const double start = evolution().moments().front().invariants.kinetic_energy;
  return balances(
      parameters_.amplitude, parameters_.tolerance,
      Identity{"kinetic energy at t = 0 is (pi/2) A^2 I_0(2A)", departure(start, exact), 1e-13,
               "integral equation solved to 1e-15, kernels rounded at neighbouring markers 0.01 apart; sum over "
               "the markers"});
}

PressureForcedWave::PressureForcedWave(const Parameters& parameters)
    : MovingSurface(checked(parameters).wavelength, parameters.gravity,
                    parameters.amplitude + std::abs(parameters.pressure) / parameters.gravity,
                    coarser<PressureForcedWave>(parameters)),
      parameters_(parameters) {
  const double depth = parameters_.depth / length();
  ow::State start = ow::still_water(parameters_.markers);
  if (parameters_.amplitude > 0) {
    const StokesWave wave(parameters_.amplitude / length(), 2 * std::numbers::pi, depth, 1);
    start = ow::from_functions(
        parameters_.markers, [&](double x) { return wave.elevation(x); },
        [&](double x) { return parameters_.velocity_factor * wave.surface_potential(x); });
    if (parameters_.velocity_factor > 0) {
      kinetic_energy_ = wave.kinetic_energy() * parameters_.wavelength * length() *
                        std::pow(parameters_.velocity_factor * velocity(), 2);
    }
  }
  const double strength = parameters_.pressure / (velocity() * velocity());
  const double last_time = parameters_.last_time > 0 ? parameters_.last_time : last_frame * time_unit();
  compute(
      ow::Evolution(std::move(start), depth, parameters_.tolerance,
                    [strength](double x, double t) { return surface_pressure(strength, x, t); }),
      last_time, [unit = time_unit()](double) { return 0.4 * unit; }, switched_off);
}

double PressureForcedWave::pressure(double x, double t) const {
  return surface_pressure(parameters_.pressure, x / length(), t / time_unit());
}

PressureForcedWave::Action PressureForcedWave::action(double t) const {
  const ow::Moment moment = evolution().at(scaled_time(t));
  const auto sums = ow::by_pressure(moment.state);
  const double area = length() * length();
  return {area * velocity() * velocity() * sums.work, area * velocity() * sums.thrust};
}

SelfTest PressureForcedWave::self_test() const {
  std::optional<Identity> start;
  if (kinetic_energy_) {
    start = Identity{
        "kinetic energy at t = 0 agrees with the Stokes wave", departure(integrals(0).kinetic_energy, *kinetic_energy_),
        1e-13,
        "integral equation solved to 1e-15, kernels rounded at neighbouring markers 0.01 apart; Stokes wave to "
        "1e-14"};
  }
  return balances(scale(), parameters_.tolerance, start);
}

std::vector<WavesInTank::Mode> WavesInTank::modes_of(const Parameters& p) {
  const double k = 2 * std::numbers::pi / p.wavelength;
  const auto frequency = [&](int n) { return std::sqrt(p.gravity * n * k * std::tanh(n * k * p.depth)); };
  std::mt19937 random(static_cast<std::mt19937::result_type>(p.seed));
  std::vector<Mode> modes;
  double sum = 0;
  for (int n = p.first; n <= p.last; ++n) {
    const double w = frequency(n);
    double a = 1;
    if (p.peak > 0) {
      const double ratio = w / frequency(p.peak);
      const double width = ratio <= 1 ? 0.07 : 0.09;
      const double spectrum = std::pow(ratio, -5) * std::exp(-1.25 * std::pow(ratio, -4)) *
                              std::pow(3.3, std::exp(-0.5 * std::pow((ratio - 1) / width, 2)));
      const double kh = n * k * p.depth;
      a = std::sqrt(spectrum * w / n * (1 + (kh < 300 ? 2 * kh / std::sinh(2 * kh) : 0)));  // c_g = (w/2nk)(...)
    }
    const double e = p.seed != 0 ? 2 * std::numbers::pi * static_cast<double>(random()) / 0x1p32 : 0;
    modes.push_back({n * k, a, w, e - w * p.focus});
    sum += a;
  }
  for (auto& mode : modes) mode.amplitude *= p.amplitude / sum;
  return modes;
}

WavesInTank::WavesInTank(const Parameters& parameters)
    : MovingSurface(checked(parameters).wavelength, parameters.gravity, parameters.amplitude,
                    coarser<WavesInTank>(parameters)),
      parameters_(parameters),
      modes_(modes_of(parameters_)),
      bars_{parameters.bar_height / 2, parameters.bars / length(), parameters.depth} {
  const auto& p = parameters_;
  const double longest = 2 * std::numbers::pi / modes_.front().frequency;
  const double last_time = p.last_time > 0 ? p.last_time : p.focus > 0 ? p.focus : longest;
  const auto elevation = [&](double x) { return linear(x * length(), 0, 0).elevation; };
  ow::State state = ow::from_functions(
      p.markers, [&](double x) { return elevation(x) / length(); },
      [&](double x) { return linear(x * length(), elevation(x), 0).potential / (length() * velocity()); });
  const ow::Bars bars{bars_.half_height / length(), static_cast<double>(p.bars), p.depth / length()};
  compute(ow::Evolution(std::move(state), p.depth / length(), p.tolerance, {}, bars), last_time,
          [](double tangent) { return 0.25 * tangent; });
}

WavesInTank::Linear WavesInTank::linear(double x, double y, double t) const {
  const double g = parameters_.gravity;
  const std::complex<double> zeta = bars_.origin({x, y});
  Linear sum;
  double rate = 0;  // of the potential
  for (const auto& [k, a, w, phase] : modes_) {
    // cosh k(y + h)/cosh kh and sinh k(y + h)/cosh kh without overflow in deep water.
    const double up = std::exp(k * zeta.imag()) / (1 + std::exp(-2 * k * parameters_.depth));
    const double down =
        std::exp(-k * (zeta.imag() + 2 * parameters_.depth)) / (1 + std::exp(-2 * k * parameters_.depth));
    const double potential = -a * g / w * std::sin(w * t + phase);
    const double across = std::sin(k * zeta.real());
    const double along = std::cos(k * zeta.real());
    sum.elevation += a * std::cos(k * x) * std::cos(w * t + phase);
    sum.potential += potential * (up + down) * along;
    rate -= a * g * std::cos(w * t + phase) * (up + down) * along;
    sum.velocity.u -= k * potential * (up + down) * across;
    sum.velocity.v += k * potential * (up - down) * along;
    sum.discharge -= potential * (up - down) * across;
  }
  const std::complex<double> velocity = std::complex(sum.velocity.u, -sum.velocity.v) / bars_.slope(zeta);
  sum.velocity = {velocity.real(), -velocity.imag()};
  sum.pressure = -rate - 0.5 * (sum.velocity.u * sum.velocity.u + sum.velocity.v * sum.velocity.v) - g * y;
  return sum;
}

double WavesInTank::significant_height() const {
  double squares = 0;
  for (const Mode& mode : modes_) squares += mode.amplitude * mode.amplitude;
  return 2 * std::sqrt(squares);
}

SelfTest WavesInTank::self_test() const {
  // The energy is that of the modes: the root of the sum of their squares is its amplitude.
  SelfTest identities = balances(significant_height() / 2, parameters_.tolerance, std::nullopt);
  const Profile now = profile(well_resolved_until());
  Worst apart;
  for (std::size_t j = 1; j < now.y.size(); ++j) apart.add(now.y[j] - now.y[now.y.size() - j]);
  // Of a tank and its mirror image the impulse is zero from the start.
  identities.back() = {"the surface is its own mirror image at the walls", apart.value() / parameters_.amplitude,
                       epsilon * static_cast<double>(parameters_.markers) * std::sqrt(static_cast<double>(steps())),
                       "a rounding of each of a marker's sums over all markers, in each step another"};
  return identities;
}

namespace {

/// A surface that may overturn, and how many points of it are asked for.
template <class Wave>
struct Profiled : Wave {
  std::size_t points;
};

/// An entry for such a wave. `parameters` and `scalars` are its own, beside those of all; `make` makes the parameters
/// that it is constructed from.
template <class Wave, class Make>
ExactSolution surface_entry(const std::string& name, const std::string& title, const std::string& citation,
                            const std::string& formula, std::vector<Parameter> parameters,
                            const std::vector<Scalar<Profiled<Wave>>>& own, Make make) {
  using W = Profiled<Wave>;
  parameters.push_back({"points", "1", 0, 0, 1e6, "points of a profile, at equal arc length; 0: at the markers"});
  std::vector<Scalar<W>> scalars{
      {"vertical_tangent_time", "s", "when the front is first vertical; NaN if it is not", &W::vertical_tangent_time},
      {"touch_down_time", "s", "when the jet meets the water below; NaN if it does not", &W::touch_down_time},
      {"end_time", "s", "last time computed", &W::end_time}};
  scalars.insert(scalars.end(), own.begin(), own.end());
  return Entry<W>{
      .name = name,
      .title = title,
      .citation = citation,
      .formula = formula,
      .parameters = parameters,
      .inputs = {time_t},
      .outputs = {{"x", "m", "along the surface, in the surface's order"},
                  {"y", "m", "elevation there"},
                  {"phi", "m^2/s", "velocity potential"},
                  velocity_u,
                  velocity_v},
      .scalars = scalars,
      .make =
          [make](const Values& p) {
            return W{Wave(make(p)), Given{"points", p.at("points")}};
          },
      .row = {},
      .curve =
          [](const W& wave, At at) {
            const auto profile = wave.profile(at[0], wave.points);
            std::vector<Row> rows;
            for (std::size_t j = 0; j < profile.x.size(); ++j) {
              rows.push_back({profile.x[j], profile.y[j], profile.potential[j], profile.u[j], profile.v[j]});
            }
            return rows;
          }};
}

}  // namespace

ExactSolution overturning_wave_entry() {
  return surface_entry<OverturningWave>(
      "overturning_wave", "A wave steepens, overturns and plunges: fully nonlinear potential flow up to touch-down",
      "Longuet-Higgins & Cokelet, The deformation of steep surface waves on water I, Proc. R. Soc. Lond. A 350 (1976) "
      "1; Baker, Meiron & Orszag, Generalized vortex methods for free-surface flow problems, J. Fluid Mech. 123 (1982) "
      "477",
      "dz/dt = conj f, dphi/dt = |f|^2/2 - g y, z_s f = phi_s + i psi_s with psi_s from Cauchy's integral; eta = A cos "
      "kx, phi = (A g/w) cosh(k(y + h))/cosh(kh) sin kx at t = 0",
      {{"amplitude", "m", 0.5, 1e-9, 1e6, "half the height of the cosine it starts from"},
       wavelength_parameter(),
       depth_parameter(infinite, infinite),
       gravity_parameter(),
       {"markers", "1", 512, 64, 4096, "markers per wavelength, even"},
       {"last_time", "s", 0, 0, 1e9, "end of the computation; 0: one period of the linear wave"}},
      {{"kinetic", "m^4/s^2", "kinetic energy per wavelength at the start, density 1",
        [](const OverturningWave& w) { return w.integrals(0).kinetic_energy; }},
       {"potential", "m^4/s^2", "potential energy per wavelength at the start, density 1",
        [](const OverturningWave& w) { return w.integrals(0).potential_energy; }}},
      made_by([](auto... given) { return OverturningWave::Parameters{given...}; }, "amplitude", "wavelength", "depth",
              "gravity", "markers", "last_time"));
}

ExactSolution pressure_forced_wave_entry() {
  return surface_entry<PressureForcedWave>(
      "pressure_forced_wave",
      "A Stokes wave is pushed by a travelling pressure until it overturns: fully nonlinear potential flow",
      "Longuet-Higgins & Cokelet, The deformation of steep surface waves on water I, Proc. R. Soc. Lond. A 350 (1976) "
      "1",
      "dz/dt = conj f, dphi/dt = |f|^2/2 - g y - p_s, z_s f = phi_s + i psi_s with psi_s from Cauchy's integral; "
      "Stokes wave at t = 0, its velocities times a factor; p_s = -p0 sin wt sin(kx - wt), w = sqrt(gk), 0 <= wt <= pi",
      {{"amplitude", "m", 0.3, 0, 1e6, "half the height of the Stokes wave; 0: water at rest"},
       wavelength_parameter(),
       depth_parameter(std::numbers::pi, infinite),
       gravity_parameter(),
       {"pressure", "m^2/s^2", 0.1, -1e6, 1e6, "amplitude p0 of the pressure over the density"},
       {"velocity_factor", "1", 1, 0, 2, "of the Stokes wave's velocities at t = 0"},
       {"markers", "1", 256, 192, 4096, "markers per wavelength, even"},
       {"last_time", "s", 0, 0, 1e9, "end of the computation; 0: 7.4/sqrt(g k)"}},
      {{"energy", "m^4/s^2", "kinetic and potential, per wavelength at the start, density 1",
        [](const PressureForcedWave& w) { return w.integrals(0).kinetic_energy + w.integrals(0).potential_energy; }},
       {"work", "m^4/s^2", "of the pressure up to the end, per wavelength, density 1",
        [](const PressureForcedWave& w) { return w.action(w.end_time()).work; }}},
      made_by([](auto... given) { return PressureForcedWave::Parameters{given...}; }, "amplitude", "wavelength",
              "depth", "gravity", "pressure", "velocity_factor", "markers", "last_time"));
}

ExactSolution waves_in_tank_entry() {
  return surface_entry<WavesInTank>(
      "waves_in_tank",
      "A wave group comes to a focus at the wall of a tank, or an irregular sea: fully nonlinear potential flow",
      "Baldock, Swan & Taylor, A laboratory study of nonlinear surface waves on water, Phil. Trans. R. Soc. Lond. A "
      "354 (1996) 649; Hasselmann et al., Dtsch. Hydrogr. Z. A 8(12) (1973); Longuet-Higgins & Cokelet, The "
      "deformation "
      "of steep surface waves on water I, Proc. R. Soc. Lond. A 350 (1976) 1",
      "dz/dt = conj f, dphi/dt = |f|^2/2 - g y, z_s f = phi_s + i psi_s with psi_s from Cauchy's integral; linear "
      "theory of the modes at t = 0: eta = sum a_n cos nkx cos(w_n(t - focus) + e_n), w_n^2 = g n k tanh nkh, between "
      "walls at x = 0 and half a wavelength",
      {{"amplitude", "m", 0.1, 1e-9, 1e6,
        "sum of the amplitudes of the modes: the crest of the focus by linear theory"},
       {"wavelength", "m", 12, 1e-9, 1e9, "twice the length of the tank"},
       depth_parameter(1, infinite),
       gravity_parameter(),
       {"first", "1", 2, 1, 100, "mode of the longest waves: so many in a wavelength"},
       {"last", "1", 7, 1, 100, "mode of the shortest waves"},
       {"focus", "s", 0, 0, 1e9, "when the crests meet at the wall by linear theory; 0: they start at rest there"},
       {"peak", "1", 0, 0, 100, "mode at the peak of JONSWAP's spectrum; 0: equal amplitudes"},
       {"seed", "1", 0, 0, 1e6, "of random phases, an irregular sea; 0: the crests meet at the focus"},
       {"bar_height", "m", 0, 0, 1e6, "of trochoidal bars on the bottom, from trough to crest; 0: a level bottom"},
       {"bars", "1", 2, 1, 100, "bars: so many in a wavelength, a crest at the wall x = 0"},
       {"markers", "1", 256, 64, 4096, "markers per wavelength, even"},
       {"last_time", "s", 0, 0, 1e9, "end of the computation; 0: the focus, or one period of the longest waves"}},
      {{"energy", "m^4/s^2", "kinetic and potential, per wavelength at the start, density 1",
        [](const WavesInTank& w) { return w.integrals(0).kinetic_energy + w.integrals(0).potential_energy; }},
       {"significant_height", "m", "four standard deviations of the elevation by linear theory",
        &WavesInTank::significant_height}},
      made_by([](auto... given) { return WavesInTank::Parameters{given...}; }, "amplitude", "wavelength", "depth",
              "gravity", "first", "last", "focus", "peak", "seed", "bar_height", "bars", "markers", "last_time"));
}

}  // namespace seiche::exact
