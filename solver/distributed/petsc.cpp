#include "distributed/petsc.hpp"

#include <chrono>
#include <string_view>
#include <thread>
#include <vector>

#include <fmt/format.h>

namespace seiche::distributed {

void check(PetscErrorCode code) {
  if (code == 0) return;
  const char* text = nullptr;
  char* specific = nullptr;
  PetscErrorMessage(code, &text, &specific);
  throw PetscFailure(fmt::format("PETSc error {}: {}{}{}", static_cast<int>(code), text == nullptr ? "" : text,
                                 specific != nullptr && *specific != '\0' ? ": " : "",
                                 specific == nullptr ? "" : specific));
}

Runtime::Runtime(int& argc, char** argv) {
  // PETSc sees the program's name and what follows "--", and the program what precedes it.
  int end = 1;
  while (end < argc && std::string_view(argv[end]) != "--") ++end;
  std::vector<char*> words{argv[0]};
  for (int k = end + 1; k < argc; ++k) words.push_back(argv[k]);
  argc = end;
  auto count = static_cast<int>(words.size());
  words.push_back(nullptr);
  char** given = words.data();
  check(PetscInitialize(&count, &given, nullptr, nullptr));
  // Errors become exceptions (check), so that PETSc shall not print them too.
  check(PetscPushErrorHandler(PetscIgnoreErrorHandler, nullptr));
  check(MPI_Comm_dup(PETSC_COMM_WORLD, &failures_));
}

bool Runtime::all_failed() const {
  constexpr std::chrono::seconds patience{5};
  MPI_Request all = MPI_REQUEST_NULL;
  MPI_Ibarrier(failures_, &all);
  int are_here = 0;
  const auto begin = std::chrono::steady_clock::now();
  MPI_Test(&all, &are_here, MPI_STATUS_IGNORE);
  while (are_here == 0 && std::chrono::steady_clock::now() - begin < patience) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    MPI_Test(&all, &are_here, MPI_STATUS_IGNORE);
  }
  return are_here != 0;
}

Runtime::~Runtime() {
  MPI_Comm_free(&failures_);
  PetscPopErrorHandler();
  PetscFinalize();
}

int rank() {
  PetscMPIInt rank = 0;
  MPI_Comm_rank(PETSC_COMM_WORLD, &rank);
  return rank;
}

int ranks() {
  PetscMPIInt size = 1;
  MPI_Comm_size(PETSC_COMM_WORLD, &size);
  return size;
}

}  // namespace seiche::distributed
