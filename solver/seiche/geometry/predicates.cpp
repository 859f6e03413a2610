#include "seiche/geometry/predicates.hpp"

#include <array>
#include <cstddef>

namespace seiche::exactly {

namespace {

/// The sum of terms that do not overlap, smallest first, none of them zero.
template <std::size_t Most>
struct Expansion {
  std::array<double, Most> term;  // NOLINT(cppcoreguidelines-pro-type-member-init): only `terms` of them are numbers
  std::size_t terms = 0;

  /// Shewchuk's grow-expansion with elimination of zeros.
  void add(double value) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < terms; ++i) {
      const double sum = value + term[i];
      const double part = sum - value;
      const double error = (value - (sum - part)) + (term[i] - part);
      if (error != 0) term[kept++] = error;
      value = sum;
    }
    if (value != 0) term[kept++] = value;
    terms = kept;
  }
  void add_product(double a, double b) {
    const double product = a * b;
    add(std::fma(a, b, -product));
    add(product);
  }
  template <std::size_t Other>
  void add(const Expansion<Other>& other, double sign = 1) {
    for (std::size_t i = 0; i < other.terms; ++i) add(sign * other.term[i]);
  }
  /// The largest term has the sign of the sum, and is within a rounding of it.
  [[nodiscard]] double value() const { return terms == 0 ? 0 : term[terms - 1]; }
};

Expansion<2> difference(double a, double b) {
  Expansion<2> result;
  result.add(a);
  result.add(-b);
  return result;
}

template <std::size_t N, std::size_t M>
Expansion<2 * N * M> product(const Expansion<N>& a, const Expansion<M>& b) {
  Expansion<2 * N * M> result;
  for (std::size_t i = 0; i < a.terms; ++i) {
    for (std::size_t j = 0; j < b.terms; ++j) result.add_product(a.term[i], b.term[j]);
  }
  return result;
}

struct Vector {
  Expansion<2> x, y;
};

Vector vector(Point from, Point to) {
  return {difference(to.x, from.x), difference(to.y, from.y)};
}

Expansion<16> cross(const Vector& a, const Vector& b) {
  Expansion<16> result;
  result.add(product(a.x, b.y));
  result.add(product(a.y, b.x), -1);
  return result;
}

Expansion<16> square(const Vector& a) {
  Expansion<16> result;
  result.add(product(a.x, a.x));
  result.add(product(a.y, a.y));
  return result;
}

}  // namespace

double orientation(Point a, Point b, Point c) {
  return cross(vector(c, a), vector(c, b)).value();
}

double in_circle(Point a, Point b, Point c, Point d) {
  const Vector da = vector(d, a);
  const Vector db = vector(d, b);
  const Vector dc = vector(d, c);
  Expansion<1536> inside;
  inside.add(product(square(da), cross(db, dc)));
  inside.add(product(square(db), cross(dc, da)));
  inside.add(product(square(dc), cross(da, db)));
  return inside.value();
}

}  // namespace seiche::exactly
