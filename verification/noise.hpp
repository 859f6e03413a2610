/// Random numbers of the checks.
#pragma once

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

}  // namespace seiche::verification
