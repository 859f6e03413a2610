#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

namespace seiche::evidence {

/// Where a record comes from: code, tools and machine.
struct Provenance {
  std::string version;
  std::string commit;  ///< "unknown" outside a git checkout
  bool dirty = false;  ///< the checkout had uncommitted changes when it was built
  std::string compiler;
  std::string flags;
  std::string build_type;
  std::map<std::string, std::string> libraries;
  std::string processor;
  int cores = 0;
  int threads = 0;  ///< threads one case may use
  std::string system;
  std::string date;  ///< now, ISO 8601, UTC
};

/// The facts about this executable and this machine.
Provenance provenance();

/// SHA-256 in hexadecimal.
std::string sha256(std::string_view bytes);
std::string sha256_of_file(const std::filesystem::path& path);

}  // namespace seiche::evidence
