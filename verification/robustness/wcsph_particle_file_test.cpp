// Particle files: what ParaView opens is read back, array by array.
#include <algorithm>
#include <filesystem>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include <H5Cpp.h>
#include <pugixml.hpp>

#include "seiche/io/atomic_file.hpp"
#include "seiche/models/wcsph/particle_file.hpp"
#include "seiche/models/wcsph/scene.hpp"
#include "verification/robustness/refusals.hpp"
#include "verification/scratch_folder.hpp"

namespace seiche::verification::wcsph_particle_file_test {

using namespace wcsph;

Scene scene() {
  return flume({.length = 0.4, .depth = 0.1, .stroke = 0.05, .frequency = 6, .spacing = 0.02}, {.sound_speed = 20});
}

std::vector<double> pressure_of(const Particles& particles) {
  std::vector<double> pressure;
  for (const double density : particles.density) pressure.push_back(400 * (density - 1000));
  return pressure;
}

/// (x, 0, z) of each.
std::vector<double> in_space(const std::vector<double>& x, const std::vector<double>& z) {
  std::vector<double> all;
  for (std::size_t i = 0; i < x.size(); ++i) all.insert(all.end(), {x[i], 0, z[i]});
  return all;
}

template <class Value>
std::vector<double> numbers(const std::vector<Value>& values) {
  std::vector<double> all;
  for (const Value value : values) all.push_back(static_cast<double>(value));
  return all;
}

/// The same particles, the last first.
Particles reversed(const Particles& particles) {
  Particles result;
  for (std::size_t i = particles.size(); i-- > 0;) {
    result.add(particles.x[i], particles.z[i], particles.mass[i], particles.density[i], particles.kind[i],
               particles.u[i], particles.w[i], particles.body[i]);
    result.identity.back() = particles.identity[i];
  }
  return result;
}

void write(const std::filesystem::path& stem, const Particles& first, const Particles& second) {
  ParticleFile file(stem);
  file.frame(0, first, pressure_of(first));
  file.frame(0.125, second, pressure_of(second));
  file.close();
}

struct Dataset {
  std::vector<hsize_t> shape;
  bool integer = false;
  std::vector<double> values;
};

/// What a DataItem of the XDMF leads to.
Dataset opened(const std::filesystem::path& folder, const std::string& location) {
  const std::size_t colon = location.find(':');
  const H5::H5File file((folder / location.substr(0, colon)).string(), H5F_ACC_RDONLY);
  const H5::DataSet set = file.openDataSet(location.substr(colon + 1));
  Dataset result;
  result.shape.resize(static_cast<std::size_t>(set.getSpace().getSimpleExtentNdims()));
  set.getSpace().getSimpleExtentDims(result.shape.data());
  result.integer = set.getTypeClass() == H5T_INTEGER;
  result.values.resize(static_cast<std::size_t>(set.getSpace().getSimpleExtentNpoints()));
  set.read(result.values.data(), H5::PredType::NATIVE_DOUBLE);
  return result;
}

std::string dimensions(const Dataset& set) {
  std::string text;
  for (const hsize_t extent : set.shape) text += (text.empty() ? "" : " ") + std::to_string(extent);
  return text;
}

TEST_CASE("a particle file is read back through its XDMF", "[robustness]") {
  Check check("wcsph_particle_file", "Particle files for ParaView",
              "Two frames of a flume, the particles of the second in another order: every DataItem of the XDMF leads "
              "to an HDF5 dataset of the shape and type it states, values and order included; the same particles give "
              "the same bytes; without close no file remains.");
  const ScratchFolder scratch("seiche_wcsph_particle_file_test");
  const Particles particles = scene().particles;
  write(scratch.path() / "waves", particles, reversed(particles));

  pugi::xml_document document;
  REQUIRE(document.load_file((scratch.path() / "waves.xdmf").c_str()));
  const pugi::xml_node series = document.child("Xdmf").child("Domain").child("Grid");
  CHECK(series.attribute("CollectionType").value() == std::string("Temporal"));
  const std::size_t count = particles.size();
  std::vector<double> times;
  double mismatches = 0, wrong_values = 0;
  bool polyvertex = true;
  for (const pugi::xml_node grid : series.children("Grid")) {
    times.push_back(grid.child("Time").attribute("Value").as_double());
    const pugi::xml_node topology = grid.child("Topology");
    polyvertex = polyvertex && topology.attribute("TopologyType").value() == std::string("Polyvertex") &&
                 topology.attribute("NumberOfElements").as_ullong() == count;
    const auto visit = [&](const pugi::xml_node& parent) {
      const pugi::xml_node item = parent.child("DataItem");
      const Dataset set = opened(scratch.path(), item.text().get());
      const bool integer = item.attribute("NumberType").value() == std::string("Int");
      if (dimensions(set) != item.attribute("Dimensions").value() || integer != set.integer) ++mismatches;
      return set;
    };
    const auto compare = [&](const Dataset& set, const std::vector<double>& expected) {
      REQUIRE(set.values.size() == expected.size());
      for (std::size_t i = 0; i < expected.size(); ++i) wrong_values += set.values[i] != expected[i] ? 1 : 0;
    };
    compare(visit(grid.child("Geometry")), in_space(particles.x, particles.z));
    std::map<std::string, std::vector<double>> left{{"density", particles.density},
                                                    {"identity", numbers(particles.identity)},
                                                    {"kind", numbers(particles.kind)},
                                                    {"pressure", pressure_of(particles)},
                                                    {"velocity", in_space(particles.u, particles.w)}};
    for (const pugi::xml_node attribute : grid.children("Attribute")) {
      const std::string name = attribute.attribute("Name").value();
      INFO(name);
      REQUIRE(left.count(name) == 1);
      compare(visit(attribute), left.extract(name).mapped());
      CHECK((name == "velocity") == (attribute.attribute("AttributeType").value() == std::string("Vector")));
    }
    CHECK(left.empty());
  }
  check.holds("Both frames of the run are in the file.", {static_cast<double>(times.size())}, Bound{0, "a count", 2});
  CHECK(times == std::vector<double>{0, 0.125});
  check.holds("Every particle is a vertex of the XDMF topology.", {polyvertex ? 1.0 : 0.0},
              Qualitative{"attributes of Topology", "the type that ParaView draws as points"});
  check.holds("Shape and type of every dataset agree with the XDMF.", {mismatches},
              Bound{0, "ParaView rejects arrays of other sizes"});
  check.holds("The values read equal those written, in the order of the identities.", {wrong_values},
              Bound{0, "they are copied"});

  write(scratch.path() / "again", reversed(particles), particles);
  const auto bytes = [&](const std::string& name) { return io::read_file(scratch.path() / name); };
  check.holds("The same particles give the same bytes, whatever their order in memory.",
              {bytes("waves.h5") == bytes("again.h5") ? 1.0 : 0.0},
              Qualitative{"comparison of the two files", "results must be comparable by their files"});

  {
    ParticleFile abandoned(scratch.path() / "abandoned");
    abandoned.frame(0, particles, pressure_of(particles));
  }
  long left = 0;
  for (const auto& entry : std::filesystem::directory_iterator(scratch.path())) {
    if (entry.path().filename().string().find("abandoned") != std::string::npos) ++left;
  }
  check.holds("A run that ends without closing its file leaves no file.", {static_cast<double>(left)},
              Bound{0, "readers never see half a file"});

  Refusals refusals(check);
  ParticleFile file(scratch.path() / "bad");
  file.frame(1, particles, pressure_of(particles));
  refusals.refused({"time = 1", "later than 1"}, [&] { file.frame(1, particles, pressure_of(particles)); });
  refusals.refused({"time", "nan"},
                   [&] { file.frame(std::numeric_limits<double>::quiet_NaN(), particles, pressure_of(particles)); });
  refusals.refused({"1 pressures", "must be as many"}, [&] { file.frame(2, particles, std::vector<double>(1)); });
  CHECK_THROWS_AS(ParticleFile("/proc/nowhere/file"), std::runtime_error);
}

}  // namespace seiche::verification::wcsph_particle_file_test
