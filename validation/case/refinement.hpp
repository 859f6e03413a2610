/// Errors of several quantities on a sequence of meshes: their orders, a table and a figure.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reports/evidence/record.hpp"
#include "validation/case/claims.hpp"

namespace seiche::validation {

/// What a sequence of meshes gave.
class Refinement {
 public:
  /// The errors on a mesh of n cells across, always in the same order of quantities; n ascends.
  void add(long n, const std::vector<double>& errors);

  [[nodiscard]] const std::vector<double>& n() const { return n_; }
  [[nodiscard]] const std::vector<double>& errors(std::size_t quantity) const { return errors_.at(quantity); }
  [[nodiscard]] double finest(std::size_t quantity) const { return errors_.at(quantity).back(); }
  /// Throws std::logic_error for an n that was not added.
  [[nodiscard]] double on(long n, std::size_t quantity) const;
  /// @param coarsest  meshes of fewer cells are left out
  [[nodiscard]] evidence::ObservedOrder order(std::size_t quantity, long coarsest) const;

 private:
  std::vector<double> n_;
  std::vector<std::vector<double>> errors_;  ///< [quantity][mesh]
};

struct RefinedQuantity {
  std::string id;
  std::string name;                 ///< "pressure", in legends and tables
  std::string statement = {};       ///< of the claim about its order
  std::optional<Order> order = {};  ///< none: the order is measured, not judged
};

/// What is claimed and shown of it.
struct RefinementStudy {
  std::vector<RefinedQuantity> quantities = {};
  std::string source;  ///< of the claims about orders
  long coarsest = 0;   ///< meshes of fewer cells do not count for the orders

  /// Ids "order-<id>".
  void claim_orders(const Claims<Refinement>& claims) const;
  /// The table of errors, and measurements "order_<id>".
  void tabulate(const Refinement& refinement, evidence::Exhibit& exhibit) const;
  /// With lines of slopes 1 and 2.
  void draw(const Refinement& refinement, evidence::Panel& panel) const;
};

}  // namespace seiche::validation
