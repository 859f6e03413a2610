#include "validation/mach_reflection/kept_reflection.hpp"

#include <fmt/format.h>

namespace seiche::validation {
namespace {

/// Every number of what is run.
std::string name_of(const ReflectionRun& what) {
  return fmt::format("{} {} a {} psi {} h {} tau {} t {} height {} tolerance {} excess {}",
                     what.model == WaveModel::plan ? "plan" : "hexahedra", what.layers, what.amplitude, what.angle,
                     what.spacing, what.tau(), what.duration(), what.height, what.tolerance, what.excess);
}

}  // namespace

void exchange(Tape& tape, Measurement& m) {
  tape(m.value, m.uncertainty, m.resolution, m.where, m.told);
}

void exchange(Tape& tape, ReflectedCrest& crest) {
  tape(crest.amplitude, crest.angle, crest.line, crest.crests);
}

void exchange(Tape& tape, ReflectionPattern& p) {
  tape(p.wall_amplitude, p.wall, p.incident_amplitude, p.incident_angle, p.incident_line, p.incident, p.stem_length,
       p.reflected);
}

void exchange(Tape& tape, SurfacePart& surface) {
  tape(surface.columns, surface.rows, surface.x, surface.y, surface.z);
}

void exchange(Tape& tape, WallLimit& limit) {
  tape(limit.amplitude, limit.growth, limit.exponential, limit.algebraic);
}

void exchange(Tape& tape, Reflection& r) {
  tape(r.run, r.time, r.wall, r.ripple, r.pattern, r.surface, r.limit, r.stem, r.worst_corner, r.cells, r.iterations,
       r.seconds);
}

Reflection reflect_as_part(const Run& run, const ReflectionRun& what) {
  return run.part(name_of(what)).result<Reflection>([&] { return reflect(what); });
}

}  // namespace seiche::validation
