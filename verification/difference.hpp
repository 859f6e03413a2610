/// Derivatives by differences, which know nothing of the formulas that they are held against.
#pragma once

namespace seiche::verification {

/// f'(0) by fourth-order central differences of half-width `span`.
template <class F>
double difference(const F& f, double span) {
  return (8 * (f(0.5 * span) - f(-0.5 * span)) - (f(span) - f(-span))) / (6 * span);
}

}  // namespace seiche::verification
