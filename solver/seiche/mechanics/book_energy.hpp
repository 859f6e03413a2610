/// Energy that leaves or enters by a known amount, in the ledger of a run.
#pragma once

#include "seiche/mechanics/invariants.hpp"

namespace seiche::mechanics {

/// Books an amount [J/m, as the model's energy] that has come to the entry "energy", negative where it was lost.
/// Throws std::logic_error for a ledger without that entry.
void book_energy(InvariantsLedger& ledger, double amount);

}  // namespace seiche::mechanics
