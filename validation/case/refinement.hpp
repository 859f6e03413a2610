/// Errors of several quantities on a sequence of meshes: their orders, their digits, a table and a figure.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reports/evidence/record.hpp"

namespace seiche::validation {

/// An error of an independent implementation, as printed: "1.63e-3".
struct PrintedError {
  long n;
  std::string value;

  [[nodiscard]] double number() const;
  /// Of the last digit.
  [[nodiscard]] double unit() const;
};

struct RefinedQuantity {
  std::string id;
  std::string name;                      ///< "pressure", in legends and tables
  std::string statement;                 ///< of the claim about its order
  std::optional<evidence::Order> order;  ///< none: the order is measured, not judged
  std::vector<PrintedError> printed = {};
};

class Refinement {
 public:
  /// @param source  of the claims
  Refinement(std::vector<RefinedQuantity> quantities, std::string source);

  /// The errors on a mesh of n cells across, in the order of the quantities; n ascends.
  void add(long n, const std::vector<double>& errors);

  [[nodiscard]] const std::vector<double>& errors(std::size_t quantity) const { return errors_.at(quantity); }
  [[nodiscard]] double finest(std::size_t quantity) const { return errors_.at(quantity).back(); }

  /// Claims "order-<id>" and measurements "order_<id>".
  /// @param coarsest  meshes of fewer cells are left out
  void claim_orders(evidence::Record& record, long coarsest = 0) const;
  /// Claims "digits-<id>" that the printed errors are ours. Throws std::logic_error for an n that was not added.
  void claim_digits(evidence::Record& record) const;
  void tabulate(evidence::Record& record) const;
  /// With lines of slopes 1 and 2.
  void draw(evidence::Panel& panel) const;

 private:
  [[nodiscard]] double error_on(long n, std::size_t quantity) const;

  std::vector<RefinedQuantity> quantities_;
  std::string source_;
  std::vector<double> n_;
  std::vector<std::vector<double>> errors_;  ///< [quantity][mesh]
};

}  // namespace seiche::validation
