#include "seiche/mechanics/book_energy.hpp"

#include <algorithm>
#include <stdexcept>

namespace seiche::mechanics {

void book_energy(InvariantsLedger& ledger, double amount) {
  const auto& entries = ledger.entries();
  const auto energy = std::find_if(entries.begin(), entries.end(), [](const auto& e) { return e.name == "energy"; });
  if (energy == entries.end()) throw std::logic_error("the ledger has no entry \"energy\" to book to");
  ledger.book(static_cast<std::size_t>(energy - entries.begin()), amount);
}

}  // namespace seiche::mechanics
