/// The exact outline of a round drop of radius 1 whose motion is affine.
#pragma once

#include "reports/evidence/figure.hpp"
#include "validation/instruments/exact/affine_drop.hpp"

namespace seiche::validation {

void draw_outline(evidence::Panel& panel, const exact::AffineDrop& drop, double time);

}  // namespace seiche::validation
