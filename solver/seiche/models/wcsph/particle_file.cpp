#include "seiche/models/wcsph/particle_file.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "seiche/io/atomic_file.hpp"
#include "seiche/io/hdf5_file.hpp"
#include "seiche/require.hpp"
#include "seiche/require_that.hpp"

namespace seiche::wcsph {
namespace {

std::filesystem::path with_extension(const std::filesystem::path& stem, std::string_view extension) {
  return stem.string() + std::string(extension);
}

template <class Value>
std::vector<Value> in_order(std::span<const Value> values, const std::vector<std::size_t>& order) {
  std::vector<Value> sorted;
  sorted.reserve(order.size());
  for (const std::size_t i : order) sorted.push_back(values[i]);
  return sorted;
}

/// (a, 0, b) of each particle.
std::vector<double> in_space(const std::vector<double>& a, const std::vector<double>& b,
                             const std::vector<std::size_t>& order) {
  std::vector<double> triples;
  triples.reserve(3 * order.size());
  for (const std::size_t i : order) triples.insert(triples.end(), {a[i], 0.0, b[i]});
  return triples;
}

}  // namespace

struct ParticleFile::Series {
  explicit Series(std::filesystem::path stem_)
      : stem(std::move(stem_)), target(with_extension(stem, ".h5")), file(target.path()) {
    file.group("/frames");
  }

  std::filesystem::path stem;
  io::AtomicFile target;
  io::Hdf5File file;
  std::vector<io::XdmfFrame> frames;
};

ParticleFile::ParticleFile(const std::filesystem::path& stem) : series_(std::make_unique<Series>(stem)) {}
ParticleFile::ParticleFile(ParticleFile&&) noexcept = default;
ParticleFile& ParticleFile::operator=(ParticleFile&&) noexcept = default;
ParticleFile::~ParticleFile() = default;

void ParticleFile::frame(double time, const Particles& particles, std::span<const double> pressure) {
  require_finite("time", time);
  std::vector<io::XdmfFrame>& frames = series_->frames;
  const double last = frames.empty() ? -std::numeric_limits<double>::infinity() : frames.back().time;
  require_that(time > last, "time = {:.17g} of a frame: must be later than {:.17g}, the last one's", time, last);
  const std::size_t count = particles.size();
  require_that(pressure.size() == count, "{} pressures for {} particles: must be as many", pressure.size(), count);
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return particles.identity[a] < particles.identity[b]; });
  std::vector<std::int32_t> kinds;
  kinds.reserve(count);
  for (const std::size_t i : order) kinds.push_back(static_cast<std::int32_t>(particles.kind[i]));

  io::Hdf5File& file = series_->file;
  const std::string path = fmt::format("/frames/{:06}", frames.size());
  file.group(path);
  file.attribute(path, "time", time);
  const std::array<std::size_t, 2> triples{count, 3};
  file.array(path + "/points", in_space(particles.x, particles.z, order), triples, "points", "m", "x, y = 0, z");
  file.array(path + "/velocity", in_space(particles.u, particles.w, order), triples, "velocity", "m/s", "u, v = 0, w");
  file.array(path + "/density", in_order<double>(particles.density, order), "density", "kg/m^3", "of the particle");
  file.array(path + "/pressure", in_order<double>(pressure, order), "pressure", "Pa", "of the particle");
  file.array(path + "/identity", in_order<std::int32_t>(particles.identity, order), "identity", "1",
             "number of the particle, the same in all frames");
  file.array(path + "/kind", kinds, "kind", "1", "0 fluid, 1 wall, 2 paddle");
  frames.push_back({.time = time,
                    .points = count,
                    .points_path = path + "/points",
                    .fields = {{.name = "velocity", .path = path + "/velocity", .components = 3},
                               {.name = "density", .path = path + "/density"},
                               {.name = "pressure", .path = path + "/pressure"},
                               {.name = "identity", .path = path + "/identity", .integer = true},
                               {.name = "kind", .path = path + "/kind", .integer = true}},
                    .topology = io::XdmfFrame::Topology::polyvertex});
}

void ParticleFile::close() {
  series_->file.close();
  series_->target.commit();
  io::write_file(with_extension(series_->stem, ".xdmf"),
                 io::xdmf(with_extension(series_->stem, ".h5").filename().string(), series_->frames));
}

}  // namespace seiche::wcsph
