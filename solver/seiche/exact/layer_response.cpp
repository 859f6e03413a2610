#include "seiche/exact/layer_response.hpp"

#include <cmath>

namespace seiche::exact {

double layer_response(double sine, double cosine, std::size_t rows, double inertia) {
  const auto n = static_cast<double>(rows);
  // The factor 1 - T cancels; where T is large all is in r = 1/T, with t_n(T) = t_n(r) = r * ratio.
  if (sine <= cosine) {
    const double t = sine / cosine;
    const double t_n = std::tanh(2 * n * std::atanh(t));
    const double q = std::pow((1 - t) / (1 + t), 2 * n - 1);
    const double p = q * (1 - t) / (1 + t);
    return t * (1 + t) * t_n / ((1 + q) / (1 + p) + 2 * inertia * t * (1 + t) * t_n);
  }
  const double r = cosine / sine;
  const double ratio = r == 0 ? 2 * n : std::tanh(2 * n * std::atanh(r)) / r;
  const double q = std::pow((1 - r) / (1 + r), 2 * n - 1);
  const double p = q * (1 - r) / (1 + r);
  return (1 + r) * ratio / (r * (1 - q) / (1 + p) + 2 * inertia * (1 + r) * ratio);
}

/// Inner rows: (T^2 - 1) (L_{j-1} + L_{j+1}) + 2 (T^2 + 1) L_j = 0; bottom: L_{-1} = L_0. d = 1 - L_{j-1}/L_j for
/// T <= 1 and 1 + L_{j-1}/L_j beyond, where signs alternate, obeys a recurrence of positive terms. Top row: X =
/// 4 T^2 + (1 - T^2) (1 - L_{n-2}/L_{n-1}), and the motion of the surface, R = (X/2)/(1 + b X).
double layer_response_by_rows(double sine, double cosine, std::size_t rows, double inertia) {
  const bool alternating = sine > cosine;
  const double u = alternating ? cosine / sine : sine / cosine;
  const double a = 1 - u * u;
  double d = alternating ? 2 : 0;
  for (std::size_t j = 1; j < rows; ++j) d = (d * a + 4 * u * u) / ((1 + d) * a + 4 * u * u);
  // X, or X/T^2 beside 1/T^2
  const double x = alternating ? 2 + 2 * u * u + a * d : 4 * u * u + a * d;
  const double one = alternating ? u * u : 1;
  return 0.5 * x / (one + inertia * x);
}

}  // namespace seiche::exact
