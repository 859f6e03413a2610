/// Errors of a sequence of resolutions: their orders as claims, and their figure.
#pragma once

#include <cmath>
#include <set>
#include <string>
#include <type_traits>
#include <vector>

#include "reports/evidence/slope_guide.hpp"
#include "verification/check.hpp"

namespace seiche::verification {

/// One of the errors that are refined together.
struct Refined {
  std::string id, text;  ///< of the claim
  Order order;
};

struct Refinement {
  std::string axis;                                                   ///< what the sizes are
  std::vector<double> sizes;                                          ///< mesh widths or steps
  std::string id = "convergence", title = "Errors under refinement";  ///< of the figure; without a title there is none
  double floor = 0;                                                   ///< errors at or below it are round-off
};

/// Claims the order of every error and draws them all against the sizes, beside lines of the slopes of theory.
///
/// @param errors_at  errors_at(size): a number for each of `all`, or the only one
/// @returns the errors: of each of `all`, with the sizes
template <class ErrorsAt>
std::vector<std::vector<double>> refine(Check& check, const Refinement& refinement, const std::vector<Refined>& all,
                                        const ErrorsAt& errors_at) {
  const std::vector<double>& sizes = refinement.sizes;
  std::vector<std::vector<double>> errors(all.size());
  for (const double size : sizes) {
    const auto found = errors_at(size);
    for (std::size_t i = 0; i < all.size(); ++i) {
      if constexpr (std::is_arithmetic_v<decltype(errors_at(size))>) {
        errors[i].push_back(found);
      } else {
        errors[i].push_back(found[i]);
      }
    }
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto& [id, text, order] = all[i];
    check.that(id, text, "observed order", observed_order(sizes, errors[i], refinement.floor), order);
  }
  if (refinement.title.empty()) return errors;
  auto& panel = check.figure(refinement.id, refinement.title, "Grey lines have the slopes of theory.")
                    .panel({.x = refinement.axis, .y = "error", .log_x = true, .log_y = true});
  std::set<int> slopes;
  for (std::size_t i = 0; i < all.size(); ++i) {
    panel.line(all[i].id, sizes, errors[i]);
    const int slope = static_cast<int>(std::lround(all[i].order.theory));
    if (slopes.insert(slope).second) validation::slope_guide(panel, slope, sizes, 1.5 * errors[i].back());
  }
  return errors;
}

/// Sizes of so many cells of a length.
inline std::vector<double> widths(double length, const std::vector<int>& cells) {
  std::vector<double> sizes;
  for (const int n : cells) sizes.push_back(length / n);
  return sizes;
}
inline std::size_t cells_of(double length, double width) {
  return static_cast<std::size_t>(std::lround(length / width));
}
/// So many sizes, each the last one over a factor.
inline std::vector<double> falling(double first, int count, double factor = 2) {
  std::vector<double> sizes{first};
  for (int n = 1; n < count; ++n) sizes.push_back(sizes.back() / factor);
  return sizes;
}

}  // namespace seiche::verification
