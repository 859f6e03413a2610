#pragma once

namespace seiche::exact {

/// How finely a conformal wave is resolved. The defaults reach round-off; a second value of each tells the error, since
/// integral identities alone under-report it by up to three orders.
struct Resolution {
  double refinement = 1;  ///< factor on the number of nodes, [0.5, 2]
  double clustering = 1;  ///< factor on the width of the cluster of nodes under the crest, [0.25, 4]
};

}  // namespace seiche::exact
