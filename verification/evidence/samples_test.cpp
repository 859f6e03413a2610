// Accumulators are judged: these tests use plain Catch2, not the machinery that stands on them.
#include "seiche/samples.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include "verification/check.hpp"

namespace seiche::verification::samples_test {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

TEST_CASE("a NaN first, in the middle or last makes every measure NaN", "[samples]") {
  for (std::size_t place = 0; place < 5; ++place) {
    std::vector<double> samples{0.5, -3, 2, 1, 0};
    samples[place] = not_a_number;
    Worst worst;
    Largest largest_one;
    Smallest smallest_one;
    Mean mean;
    Count count;
    for (std::size_t k = 0; k < samples.size(); ++k) {
      worst.add(samples[k], static_cast<double>(k));
      largest_one.add(samples[k]);
      smallest_one.add(samples[k]);
      mean.add(samples[k]);
      count.add(samples[k], [](double sample) { return sample > 0; });
    }
    for (const double measured :
         {worst.value(), largest_one.value(), smallest_one.value(), mean.value(), mean.rms(), mean.sum(), count.value(),
          largest(samples), smallest(samples), seiche::worst(samples)}) {
      CHECK(std::isnan(measured));
    }
    CHECK(worst.where() == static_cast<double>(place));
    CHECK(worst.count() == samples.size());
  }
}

TEST_CASE("without samples every measure is NaN", "[samples]") {
  const std::vector<double> none;
  for (const double measured : {Worst().value(), Largest().value(), Smallest().value(), Mean().value(), Mean().rms(),
                                Mean().sum(), Count().value(), largest(none), smallest(none), seiche::worst(none)}) {
    CHECK(std::isnan(measured));
  }
}

TEST_CASE("measures of numbers equal their definitions", "[samples]") {
  const std::vector<double> samples{0.5, -3, 2, 1, 0};
  CHECK(seiche::worst(samples) == 3);
  CHECK(largest(samples) == 2);
  CHECK(smallest(samples) == -3);
  Mean mean;
  mean.add(1, 3);
  mean.add(5, 1);
  CHECK(mean.sum() == 8);
  CHECK(mean.value() == 2);
  CHECK(mean.rms() == std::sqrt(7.0));
  Count count;
  for (const double sample : samples) count.add(sample, [](double one) { return one > 0; });
  CHECK(count.value() == 3);
  CHECK(count.samples() == 5);
  Worst infinite;
  infinite.add(1);
  infinite.add(-std::numeric_limits<double>::infinity());
  CHECK(std::isinf(infinite.value()));
}

TEST_CASE("extremes of parts equal the extremes of the whole, and a part without samples has no effect", "[samples]") {
  Worst whole, first, second;
  first.add(1, 10);
  second.add(-4, 20);
  second.add(2, 30);
  whole.add(first);
  whole.add(second);
  whole.add(Worst());
  CHECK(whole.value() == 4);
  CHECK(whole.where() == 20);
  CHECK(whole.count() == 3);
  Worst broken;
  broken.add(not_a_number);
  whole.add(broken);
  whole.add(first);
  CHECK(std::isnan(whole.value()));
}

}  // namespace seiche::verification::samples_test
