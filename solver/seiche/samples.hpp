/// Extremes, means and counts of samples that cannot swallow an error.
///
/// std::max(worst, error) keeps `worst` where the error is not a number, and is zero where there was none at all. These
/// remember: a sample that is not a number makes the result NaN, and so does there being no sample.
#pragma once

#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>

namespace seiche {

/// The sample that comes first in an order, with the place it was found at.
template <class Order>
class Extreme {
 public:
  /// @param where  any coordinate by which the place can be found again: time, position, index
  void add(double sample, double where = std::numeric_limits<double>::quiet_NaN()) {
    ++count_;
    if (std::isnan(value_) && count_ > 1) return;
    if (count_ == 1 || std::isnan(sample) || Order{}(sample, value_)) {
      value_ = sample;
      where_ = where;
    }
  }
  /// Takes in all samples of another; one without samples adds nothing.
  void add(const Extreme& other) {
    if (other.count_ == 0) return;
    add(other.value_, other.where_);
    count_ += other.count_ - 1;
  }

  /// NaN if a sample was, or if there was none.
  [[nodiscard]] double value() const { return value_; }
  [[nodiscard]] double where() const { return where_; }
  [[nodiscard]] std::size_t count() const { return count_; }

 private:
  double value_ = std::numeric_limits<double>::quiet_NaN();
  double where_ = std::numeric_limits<double>::quiet_NaN();
  std::size_t count_ = 0;
};

using Largest = Extreme<std::greater<>>;
using Smallest = Extreme<std::less<>>;

/// The largest magnitude.
class Worst {
 public:
  void add(double sample, double where = std::numeric_limits<double>::quiet_NaN()) {
    largest_.add(std::abs(sample), where);
  }
  void add(const Worst& other) { largest_.add(other.largest_); }

  [[nodiscard]] double value() const { return largest_.value(); }
  [[nodiscard]] double where() const { return largest_.where(); }
  [[nodiscard]] std::size_t count() const { return largest_.count(); }

 private:
  Largest largest_;
};

/// Sum, mean and root mean square. A weight is the length, area or mass that a sample stands for.
class Mean {
 public:
  void add(double sample, double weight = 1) {
    ++count_;
    weight_ += weight;
    sum_ += weight * sample;
    squares_ += weight * sample * sample;
  }

  [[nodiscard]] double sum() const { return count_ == 0 ? nothing : sum_; }
  [[nodiscard]] double value() const { return count_ == 0 ? nothing : sum_ / weight_; }
  [[nodiscard]] double rms() const { return count_ == 0 ? nothing : std::sqrt(squares_ / weight_); }
  [[nodiscard]] std::size_t count() const { return count_; }

 private:
  static constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
  double sum_ = 0;
  double squares_ = 0;
  double weight_ = 0;
  std::size_t count_ = 0;
};

/// How many of the samples have a property. One that is not a number is neither with it nor without.
class Count {
 public:
  template <class Property>
  void add(double sample, Property has) {
    ++samples_;
    if (std::isnan(sample)) {
      unknown_ = true;
    } else if (has(sample)) {
      ++found_;
    }
  }

  /// NaN if a sample was, or if there was none.
  [[nodiscard]] double value() const {
    return unknown_ || samples_ == 0 ? std::numeric_limits<double>::quiet_NaN() : static_cast<double>(found_);
  }
  [[nodiscard]] std::size_t samples() const { return samples_; }

 private:
  std::size_t found_ = 0;
  std::size_t samples_ = 0;
  bool unknown_ = false;
};

/// The extremes of a range of numbers.
template <class Range>
[[nodiscard]] double largest(const Range& samples) {
  Largest found;
  for (const double sample : samples) found.add(sample);
  return found.value();
}

template <class Range>
[[nodiscard]] double smallest(const Range& samples) {
  Smallest found;
  for (const double sample : samples) found.add(sample);
  return found.value();
}

template <class Range>
[[nodiscard]] double worst(const Range& samples) {
  Worst found;
  for (const double sample : samples) found.add(sample);
  return found.value();
}

}  // namespace seiche
