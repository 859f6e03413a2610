/// Random numbers of the checks.
#pragma once

#include <cstddef>
#include <cstdint>
#include <random>

namespace seiche::verification {

/// Uniform in [-1, 1), the same on every machine.
class Noise {
 public:
  explicit Noise(std::uint64_t seed) : generator_(seed) {}
  double operator()() { return 0x1p-52 * static_cast<double>(generator_() >> 11) - 1; }

 private:
  std::mt19937_64 generator_;
};

/// Particles in a plane, each moved at random along either axis by no more than `by`.
template <class Particles>
Particles shaken(Particles particles, double by, std::uint64_t seed) {
  Noise noise(seed);
  for (std::size_t k = 0; k < particles.size(); ++k) {
    particles.x[k] += by * noise();
    particles.y[k] += by * noise();
  }
  return particles;
}

}  // namespace seiche::verification
