#include "seiche/linear/conjugate_gradients.hpp"

#include <fmt/format.h>

namespace seiche::linear {

NotConverged::NotConverged(int iterations, double relative_residual, double tolerance)
    : std::runtime_error(
          fmt::format("conjugate gradients: relative residual {:.3g} after {} iterations; wanted: {:.3g}",
                      relative_residual, iterations, tolerance)) {}

NotPositiveDirection::NotPositiveDirection(const char* form, double value, int iteration)
    : std::runtime_error(fmt::format("conjugate gradients: {} = {:.6g} in iteration {}; the matrix and the "
                                     "preconditioner must be positive definite and all entries finite",
                                     form, value, iteration)) {}

}  // namespace seiche::linear
