#pragma once

namespace seiche::io {

/// Ends a forked child at once: what its parent would destroy or print at its own end is left to the parent.
///
/// Where lines are counted (SEICHE_COVERAGE) the child's counts are written first.
[[noreturn]] void leave(int status);

}  // namespace seiche::io
