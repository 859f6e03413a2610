/// The experiment of the dam break over water behind a gate: what several models of our own are judged by.
#pragma once

#include <string>

#include "validation/laboratory/experiment.hpp"

namespace seiche::validation::laboratory {

inline const std::string gated_dam_break_source =
    "I. M. Janosi, D. Jan, K. G. Szabo, T. Tel, Exp. Fluids 37 (2004) 219-229";

/// As built [m].
struct GatedDam {
  static constexpr double gate = 0.38;    ///< from the closed end
  static constexpr double behind = 0.15;  ///< depths
  static constexpr double ahead = 0.038;
  static constexpr double mark = 0.055;  ///< the front is the largest x where the surface exceeds it
};

/// Without a model.
Experiment gated_dam_break_experiment();

/// The front at every hundredth of a second until 0.7 s, as far as the shift of time may look.
/// @param front_at  front [m] at a time [s], asked for in ascending order
Submitted gated_fronts(const std::function<double(double time)>& front_at);

/// By shallow water on 2 m; the run must have the parameter cell [m].
/// @param scheme  as make_flow names it
Experiment gated_dam_break_in_shallow_water(const std::string& scheme, const std::string& model);

}  // namespace seiche::validation::laboratory
