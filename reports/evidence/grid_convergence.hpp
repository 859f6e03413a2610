/// Numerical uncertainty from a grid-convergence study.
///
/// References: Roache, Perspective: a method for uniform reporting of grid refinement studies, J. Fluids Eng. 116
/// (1994) 405; Celik et al., Procedure for estimation and reporting of uncertainty due to discretization in CFD
/// applications, J. Fluids Eng. 130 (2008) 078001; Eca and Hoekstra, A procedure for the estimation of the numerical
/// uncertainty of CFD calculations based on grid refinement studies, J. Comput. Phys. 262 (2014) 104.
#pragma once

#include <string>
#include <vector>

namespace seiche::evidence {

struct GridConvergence {
  double extrapolated = 0;  ///< estimate of the value at zero mesh width
  double order = 0;         ///< order used for it
  double uncertainty = 0;   ///< 95 % half-width for the value on the finest mesh; infinite if it cannot be estimated
  std::string note;
};

/// Fits value(h) = extrapolated + a h^p by least squares over all resolutions and returns 1.25 (well-behaved order) or
/// 3 times the remaining error plus the scatter of the fit, for the finest mesh.
///
/// With exactly three resolutions the fit is exact (Richardson extrapolation) and the result is the grid convergence
/// index. An observed order outside [0.5, theory + 0.5] is not trusted: the theoretical order replaces one that is
/// too high, and the factor is 3. Values that do not change at all have uncertainty zero; one that is not a finite
/// number makes all results NaN.
///
/// @param sizes   mesh widths, at least three different ones, positive
/// @param values  computed values, same length
/// @param theory  theoretical order of the method
/// @throws std::invalid_argument for fewer than three resolutions
GridConvergence grid_convergence(const std::vector<double>& sizes, const std::vector<double>& values, double theory);

}  // namespace seiche::evidence
