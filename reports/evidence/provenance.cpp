#include "reports/evidence/provenance.hpp"

#include <array>
#include <ctime>
#include <fstream>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <thread>

#include <H5public.h>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <gsl/gsl_version.h>
#include <omp.h>
#include <openssl/evp.h>
#include <sys/utsname.h>
#include <boost/version.hpp>
#include <nlohmann/json.hpp>

#include "reports/evidence/build_facts.hpp"
#include "seiche/io/atomic_file.hpp"

namespace seiche::evidence {
namespace {

std::string processor_name() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown";
}

std::string system_name() {
  utsname names{};
  if (uname(&names) != 0) return "unknown";
  return fmt::format("{} {} {}", names.sysname, names.release, names.machine);
}

}  // namespace

Provenance provenance() {
  Provenance p;
  p.version = build_facts::version;
  p.commit = build_facts::commit;
  p.dirty = build_facts::dirty;
  p.compiler = build_facts::compiler;
  p.flags = build_facts::flags;
  p.build_type = build_facts::build_type;
  p.libraries = {
      {"Boost", fmt::format("{}.{}.{}", BOOST_VERSION / 100000, BOOST_VERSION / 100 % 1000, BOOST_VERSION % 100)},
      {"Catch2", std::string(build_facts::catch2_version)},
      {"fmt", fmt::format("{}.{}.{}", FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100)},
      {"GSL", GSL_VERSION},
      {"HDF5", fmt::format("{}.{}.{}", H5_VERS_MAJOR, H5_VERS_MINOR, H5_VERS_RELEASE)},
      {"nlohmann-json",
       fmt::format("{}.{}.{}", NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR, NLOHMANN_JSON_VERSION_PATCH)}};
  p.processor = processor_name();
  p.cores = static_cast<int>(std::thread::hardware_concurrency());
  p.threads = omp_get_max_threads();
  p.system = system_name();
  p.date = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)));
  return p;
}

std::string sha256(std::string_view bytes) {
  const std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> context(EVP_MD_CTX_new(), EVP_MD_CTX_free);
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int length = 0;
  if (EVP_DigestInit_ex(context.get(), EVP_sha256(), nullptr) != 1 ||
      EVP_DigestUpdate(context.get(), bytes.data(), bytes.size()) != 1 ||
      EVP_DigestFinal_ex(context.get(), digest.data(), &length) != 1) {
    throw std::runtime_error("SHA-256 is not available in this OpenSSL");
  }
  std::string text;
  for (unsigned int k = 0; k < length; ++k) fmt::format_to(std::back_inserter(text), "{:02x}", digest[k]);
  return text;
}

std::string sha256_of_file(const std::filesystem::path& path) {
  return sha256(io::read_file(path));
}

}  // namespace seiche::evidence
