#pragma once

#include <cmath>

namespace seiche::finite_volume {

/// Running sum with Neumaier's compensation: its error does not grow with the number of terms, so that a balance over a
/// million steps shows the scheme and not the bookkeeping.
class CompensatedSum {
 public:
  void add(double term) {
    const double next = total_ + term;
    lost_ += std::abs(total_) >= std::abs(term) ? (total_ - next) + term : (term - next) + total_;
    total_ = next;
  }
  [[nodiscard]] double value() const { return total_ + lost_; }

 private:
  double total_ = 0;
  double lost_ = 0;
};

}  // namespace seiche::finite_volume
