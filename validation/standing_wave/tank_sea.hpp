/// Waves of many lengths in a tank, computed with six models beside the exact flow; over bars with the three that can
/// follow them. Depth, gravity and density are 1.
#pragma once

#include <string>

#include "seiche/exact/overturning/overturning_wave.hpp"
#include "validation/case/case.hpp"
#include "validation/studies/side_by_side/contest.hpp"

namespace seiche::validation::tank_sea {

inline const std::string source =
    "potential flow by Cauchy's integral; Frank, Discrete models of incompressible fluid (1994)";

constexpr double length = 6;  ///< of the tank

struct Comparison {
  exact::WavesInTank::Parameters sea;  ///< `wavelength` and `last_time` are set here
  double end = 1;                      ///< when errors are compared
  double last = 1;                     ///< until which the models are followed
  std::string instant;                 ///< "at the focus"
  double resolved = 0.25;              ///< share of the yardstick below which a model resolves what it measures
  double soon = 10;                    ///< longer runs differ from linear theory by less than the grids' phase errors
  bool tangles = false;                ///< the mesh, before the end, of waves that are not higher than others

  [[nodiscard]] bool barred() const { return sea.bar_height > 0; }
};

struct Results {
  Contest contest;
  /// What a model is to resolve: rms of the difference, at the end, of the exact surface from linear theory, or over
  /// bars from the exact surface without them; over the amplitude.
  double yardstick = 0;
  double highest = 0;  ///< of the exact surface at the end, over the amplitude
};

/// A case's own parameters and the sizes of the six models, or of the three that can follow bars.
/// @param mesh  rows of the finest mesh
std::vector<Parameter> with_sizes(std::vector<Parameter> own, ByTier<long> mesh, bool barred = false);

void claims(const Values& values, const Claims<Results>& all, const Comparison& comparison);

Results compute(const Run& run, const Comparison& comparison);

void show(const Results& results, const Values& values, evidence::Exhibit& exhibit);

/// The study of a case. @tparam comparison  Comparison (const Values&)
template <auto comparison>
Study study() {
  return Study(
      +[](const Values& values, const Claims<Results>& all) { claims(values, all, comparison(values)); },
      +[](const Run& run) { return compute(run, comparison(run)); }, show, source);
}

}  // namespace seiche::validation::tank_sea
