// Catch2 on several processes: all run the tests, the first one reports and writes the records.
#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_session.hpp>
#else
#define CATCH_CONFIG_RUNNER
#include <catch2/catch.hpp>
#endif

#include <vector>

#include "distributed/decomposition.hpp"
#include "distributed/petsc.hpp"

int main(int argc, char** argv) {
  const seiche::distributed::Runtime runtime(argc, argv);
  std::vector<const char*> words(argv, argv + argc);
  if (seiche::distributed::rank() > 0) words.insert(words.end(), {"--out", "/dev/null"});
  const int failed = Catch::Session().run(static_cast<int>(words.size()), words.data());
  return seiche::distributed::Decomposition::largest(failed) > 0 ? 1 : 0;
}
