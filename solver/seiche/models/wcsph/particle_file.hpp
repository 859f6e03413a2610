/// Time series of particles for ParaView: `<stem>.h5` and, through which it is opened, `<stem>.xdmf`.
///
///     ParticleFile file(folder / "dam_break");
///     file.frame(flow.time(), flow.particles(), flow.pressure());   // as often as wanted
///     file.close();
///
/// Per frame: points (x, 0, z), velocity (u, 0, w), density, pressure, identity, kind (0 fluid, 1 wall, 2 paddle), in
/// the order of the identities. The same data give the same bytes. Both files appear when they are whole, at close().
#pragma once

#include <filesystem>
#include <memory>
#include <span>

#include "seiche/models/wcsph/particles.hpp"

namespace seiche::wcsph {

class ParticleFile {
 public:
  /// @param stem  path without extension. Throws std::runtime_error when the file cannot be written.
  explicit ParticleFile(const std::filesystem::path& stem);
  ParticleFile(const ParticleFile&) = delete;
  ParticleFile& operator=(const ParticleFile&) = delete;
  ParticleFile(ParticleFile&&) noexcept;
  ParticleFile& operator=(ParticleFile&&) noexcept;
  /// Without close() nothing is left behind.
  ~ParticleFile();

  /// Throws std::invalid_argument: lengths that differ, times that do not increase.
  void frame(double time, const Particles& particles, std::span<const double> pressure);
  void close();

 private:
  struct Series;
  std::unique_ptr<Series> series_;
};

}  // namespace seiche::wcsph
