// Fixed sections that water passes: books, and the steady flow over a bump that they must keep.
#include <cmath>

#include <fmt/format.h>

#include "seiche/exact/shallow_water/steady_flow.hpp"
#include "seiche/models/shallow_water_particles/particle_flow.hpp"
#include "seiche/models/shallow_water_particles/particles.hpp"
#include "validation/instruments/error_measures.hpp"
#include "verification/check.hpp"
#include "verification/refinement.hpp"

namespace seiche::verification::particles_open_section_test {

using namespace shallow_water_particles;

Open prescribed(std::optional<double> discharge, std::optional<double> depth) {
  Open open;
  if (discharge) open.discharge = [q = *discharge](double) { return q; };
  if (depth) open.depth = [h = *depth](double) { return h; };
  return open;
}

TEST_CASE("steady subcritical flow over a bump between open sections", "[conservation]") {
  Check check("particles_steady_bump", "Steady flow over a bump between open sections",
              "Particles enter at x = 0 with a given discharge, cross the bump and leave at x = 25 against a given "
              "depth: no particle stays, yet the exact steady flow must stay. Mass and momentum that pass the sections "
              "are booked, and the error of the depth after 40 s falls with the square of the particle width.",
              "Delestre et al., SWASHES, Int. J. Numer. Meth. Fluids 72 (2013) 269");
  const exact::SteadyBump exact(9.81, 4.42, 2);
  const auto error_of = [&](double width) {
    const std::size_t count = cells_of(25, width);
    const Particles start = particles_from_profile(
        equal_width_edges(0, 25, count), [&](double x) { return exact.at(x).depth; },
        [&](double x) { return exact.at(x).velocity; });
    Forcing forcing;
    forcing.bed = exact.bed();
    ParticleFlow flow(start, {prescribed(4.42, {}), prescribed({}, 2)}, forcing);
    march(flow, 40);
    const auto error = cell_error(
        flow.measured_profile(), [&](double x) { return exact.at(x); }, exact.breakpoints());
    check.holds(fmt::format("mass_{}", count) + ": Mass equals what has passed the sections.", {flow.mass_defect()},
                Roundoff{6, flow.ledger().left_mass.value(),
                         "the books of the two sections, their sum, and what is left of three numbers are rounded "
                         "once, as large as the mass that has entered; sums are compensated, and one particle at a "
                         "section, of 1/80 of that mass at most, is rounded per step"});
    check.holds(fmt::format("momentum_{}", count) + ": Momentum equals the booked impulses.", {flow.momentum_defect()},
                Roundoff{6 + static_cast<double>(flow.steps()) / static_cast<double>(count) *
                                 std::pow(flow.momentum() / flow.ledger().left_impulse.value(), 2),
                         flow.ledger().left_impulse.value(),
                         "the books of the sections and of the bed, their sum, and what is left of three numbers are "
                         "rounded once, as large as the impulse at a section, for sums are compensated; and every step "
                         "rounds the momentum of each particle"});
    return error.depth.l1;
  };
  refine(check, {"particle width [m]", widths(25, {25, 50, 100, 200})},
         {{"order",
           "The depth over the bump converges at second order.",
           {2, 0.5,
            "the ends of the bump have a kink in z', where the limited slopes are of first order over a region that "
            "shrinks with the width"}}},
         error_of);
}

}  // namespace seiche::verification::particles_open_section_test
