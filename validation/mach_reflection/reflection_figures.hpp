/// Figures of reflections at many angles beside the theories for small waves.
#pragma once

#include <vector>

#include "reports/evidence/record.hpp"
#include "validation/case/parameter.hpp"
#include "validation/mach_reflection/reflection_sweep.hpp"

namespace seiche::validation {

/// a_w/a_i and a_r/a_i against kappa of Miles and for finite angles.
void draw_amplitudes(evidence::Exhibit& exhibit, const std::vector<ReflectionSeries>& series);
/// Regular and irregular reflection in the plane of amplitude and angle, with the theoretical boundaries.
void draw_regimes(evidence::Exhibit& exhibit, const std::vector<ReflectionSeries>& series, const Values& values);
/// a_r against the square of the angle.
void draw_angle_law(evidence::Exhibit& exhibit, const ReflectionSeries& series, const AngleLaw& law, double last);
/// psi_r against psi_i.
void draw_reflected_angles(evidence::Exhibit& exhibit, const std::vector<ReflectionSeries>& series);
/// a_w/a_i against time, a panel per amplitude.
void draw_growth(evidence::Exhibit& exhibit, const std::vector<ReflectionSeries>& series);
/// Every run with its resolution and growth.
void tabulate_reflections(evidence::Exhibit& exhibit, const std::vector<ReflectionSeries>& series);

}  // namespace seiche::validation
