#include "validation/instruments/particles/sph_volume_fraction.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/tools/toms748_solve.hpp>

#include "seiche/require.hpp"
#include "seiche/samples.hpp"

namespace seiche::wcsph {
namespace {

constexpr double surface_fraction = 0.5;

/// Strips that fit no memory come from particles that are lost.
constexpr double most_strips = 1e7;

/// Weight of a kernel on one side of a straight line, against the distance in h, -2 <= s <= 2: a table with linear
/// interpolation, exact to 3e-6.
template <class Kernel>
class HalfPlane {
 public:
  HalfPlane() {
    using Rule = boost::math::quadrature::gauss<double, 15>;
    const auto across = [](double s) {
      const double reach = std::sqrt(support * support - s * s);
      return 2 * Rule::integrate([s](double y) { return weight<Kernel>(std::hypot(s, y), 1.0); }, 0.0, reach);
    };
    for (std::size_t i = 0; i + 1 < table_.size(); ++i) {
      table_[i + 1] = table_[i] + Rule::integrate(across, at(i), at(i + 1));
    }
    for (double& value : table_) value = 0.5 + 0.5 * value / table_.back();
  }
  double operator()(double s) const {
    if (s < 0) return 1 - (*this)(-s);
    if (s >= support) return 1;
    const double place = s / at(1);
    const auto i = static_cast<std::size_t>(place);
    return table_[i] + (place - static_cast<double>(i)) * (table_[i + 1] - table_[i]);
  }

 private:
  static double at(std::size_t i) { return support * static_cast<double>(i) / intervals; }

  static constexpr std::size_t intervals = 500;
  std::array<double, intervals + 1> table_{};
};

double half_plane(KernelName kernel, double s) {
  static const HalfPlane<CubicSpline> cubic;
  static const HalfPlane<WendlandC2> wendland;
  return kernel == KernelName::cubic_spline ? cubic(s) : wendland(s);
}

double wrapped(double x, double period) {
  return std::isinf(period) ? x : x - period * std::floor(x / period);
}

}  // namespace

VolumeFraction::VolumeFraction(const Particles& particles, double smoothing_length, const Box& basin, KernelName kernel,
                               const Period& period)
    : h_(smoothing_length), basin_(basin), kernel_(kernel), period_(period) {
  require_positive("smoothing_length", h_);
  sort(samples_of(particles));
}

std::vector<VolumeFraction::Sample> VolumeFraction::samples_of(const Particles& particles) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  extents_ = {infinity, -infinity, infinity, -infinity};
  std::vector<Sample> samples;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    if (particles.kind[i] != Kind::fluid) continue;
    const Sample sample{wrapped(particles.x[i], period_.x), wrapped(particles.z[i], period_.z),
                        particles.mass[i] / particles.density[i]};
    require_finite("x of a fluid particle", sample.x);
    require_finite("z of a fluid particle", sample.z);
    extents_ = {std::min(extents_.left, sample.x), std::max(extents_.right, sample.x),
                std::min(extents_.bottom, sample.z), std::max(extents_.top, sample.z)};
    samples.push_back(sample);
  }
  const double reach = support * h_;
  const auto add_images = [&](double Sample::*coordinate, double length) {
    if (std::isinf(length)) return;
    const std::size_t originals = samples.size();
    for (std::size_t i = 0; i < originals; ++i) {
      for (const double shift : {-length, length}) {
        Sample image = samples[i];
        image.*coordinate += shift;
        if (image.*coordinate > -reach && image.*coordinate < length + reach) samples.push_back(image);
      }
    }
  };
  add_images(&Sample::x, period_.x);
  add_images(&Sample::z, period_.z);
  return samples;
}

void VolumeFraction::sort(std::vector<Sample> samples) {
  if (samples.empty()) {
    extents_ = {};
    return;
  }
  const double strip = support * h_;
  const auto by_x = [](const Sample& a, const Sample& b) { return a.x < b.x; };
  const auto [first, last] = std::minmax_element(samples.begin(), samples.end(), by_x);
  left_ = first->x;
  const double strips = (last->x - left_) / strip;
  if (strips > most_strips) {
    throw std::invalid_argument(
        fmt::format("fluid from x = {:g} to {:g} with smoothing_length = {:g}: must be at most "
                    "{:g} supports wide",
                    left_, last->x, h_, most_strips));
  }
  const auto strip_of = [&](const Sample& s) { return static_cast<std::size_t>((s.x - left_) / strip); };
  std::sort(samples.begin(), samples.end(), [&](const Sample& a, const Sample& b) {
    const std::size_t of_a = strip_of(a);
    const std::size_t of_b = strip_of(b);
    if (of_a != of_b) return of_a < of_b;
    return a.z < b.z || (a.z == b.z && a.x < b.x);
  });
  begin_.assign(static_cast<std::size_t>(strips) + 2, 0);
  for (const Sample& sample : samples) ++begin_[strip_of(sample) + 1];
  for (std::size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
  samples_ = std::move(samples);
}

double VolumeFraction::coverage(double x, double z) const {
  const auto part = [&](double before, double after) {
    return half_plane(kernel_, before / h_) + half_plane(kernel_, after / h_) - 1;
  };
  return part(x - basin_.left, basin_.right - x) * part(z - basin_.bottom, basin_.top - z);
}

double VolumeFraction::at(double x, double z) const {
  if (samples_.empty() || x < basin_.left || x > basin_.right || z < basin_.bottom || z > basin_.top) return 0;
  const double px = wrapped(x, period_.x);
  const double pz = wrapped(z, period_.z);
  const double reach = support * h_;
  const double middle = std::floor((px - left_) / reach);
  const double last = static_cast<double>(begin_.size()) - 2;
  const auto weight_of = [this](double distance) {
    return kernel_ == KernelName::cubic_spline ? weight<CubicSpline>(distance, h_) : weight<WendlandC2>(distance, h_);
  };
  double sum = 0;
  for (double strip = std::max(middle - 1, 0.0); strip <= std::min(middle + 1, last); ++strip) {
    const auto k = static_cast<std::size_t>(strip);
    const auto begin = samples_.begin() + static_cast<std::ptrdiff_t>(begin_[k]);
    const auto end = samples_.begin() + static_cast<std::ptrdiff_t>(begin_[k + 1]);
    const auto lowest =
        std::lower_bound(begin, end, pz - reach, [](const Sample& s, double level) { return s.z < level; });
    for (auto sample = lowest; sample != end && sample->z < pz + reach; ++sample) {
      const double dx = px - sample->x;
      const double dz = pz - sample->z;
      const double square = dx * dx + dz * dz;
      if (square < reach * reach) sum += sample->volume * weight_of(std::sqrt(square));
    }
  }
  return sum / coverage(x, z);
}

std::vector<double> VolumeFraction::on_grid(double left, double bottom, double step, long columns, long rows) const {
  std::vector<double> values(static_cast<std::size_t>(columns * rows));
#pragma omp parallel for schedule(static)
  for (long j = 0; j < rows; ++j) {
    for (long i = 0; i < columns; ++i) {
      values[static_cast<std::size_t>(j * columns + i)] =
          at(left + static_cast<double>(i) * step, bottom + static_cast<double>(j) * step);
    }
  }
  return values;
}

std::optional<double> VolumeFraction::elevation(double x) const {
  const double step = h_ / 4;
  const double lowest = std::max(extents_.bottom - support * h_, basin_.bottom);
  double above = std::min(extents_.top + support * h_, basin_.top);
  if (at(x, above) >= surface_fraction) return above;
  while (above > lowest) {
    const double z = std::max(above - step, lowest);
    if (at(x, z) >= surface_fraction) {
      std::uintmax_t evaluations = 100;
      const auto [low, high] = boost::math::tools::toms748_solve(
          [&](double level) { return at(x, level) - surface_fraction; }, z, above,
          [this](double a, double b) { return std::abs(a - b) < 1e-12 * h_; }, evaluations);
      return (low + high) / 2;
    }
    above = z;
  }
  return std::nullopt;
}

std::optional<double> VolumeFraction::mean_elevation(double left, double right) const {
  require_finite("left", left);
  require_positive("right - left", right - left);
  const auto count = static_cast<long>(std::ceil((right - left) / (h_ / 2)));
  Mean mean;
  bool wet = false;
  for (long k = 0; k < count; ++k) {
    const std::optional<double> here =
        elevation(left + (right - left) * (static_cast<double>(k) + 0.5) / static_cast<double>(count));
    wet = wet || here;
    if (here || std::isfinite(basin_.bottom)) mean.add(here.value_or(basin_.bottom));
  }
  return wet ? std::optional(mean.value()) : std::nullopt;
}

}  // namespace seiche::wcsph
