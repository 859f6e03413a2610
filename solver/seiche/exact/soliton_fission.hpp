/// Into how many solitary waves, and how high, one solitary wave falls apart on a shelf: inverse scattering of the
/// Korteweg-de Vries equation.
///
/// The wave comes from depth 1, has amplitude a_0, and passes onto a shelf of depth h. At an abrupt step its amplitude
/// is multiplied by that of long waves (Lamb), and its length by sqrt(h); over a gradual slope by Green's factor:
///
/// @f[ T = \frac{2}{1 + \sqrt{h}}, \quad R = \frac{1 - \sqrt{h}}{1 + \sqrt{h}} \qquad \text{or} \qquad
///     T = h^{-1/4}, \quad R = 0 . @f]
///
/// There it is no solitary wave any more but the potential -nu (nu + 1) sech^2 of Schroedinger's equation, whose bound
/// states are the solitary waves to come:
///
/// @f[ \nu (\nu + 1) = \frac{2 T}{h^2}, \qquad \frac{a_n}{a_0} = h^2 (\nu - n + 1)^2, \quad n = 1, 2, \dots < \nu + 1 .
/// @f]
///
/// Their ratios do not depend on a_0. Corrections are of relative order a_n/h, and of the order of the reflected part.
///
/// When not to use it: waves that are not small in the depth of the shelf; places before the waves have parted.
///
/// References: Madsen & Mei, J. Fluid Mech. 39 (1969) 781; Johnson, Proc. Camb. Phil. Soc. 73 (1973) 183, for slopes;
/// Goring, Tsunamis - the propagation of long waves onto a shelf, Caltech KH-R-38 (1978), for steps; Lamb,
/// Hydrodynamics (1932), 176.
#pragma once

#include "seiche/exact/reference_solution.hpp"

namespace seiche::exact {

class SolitonFission {
 public:
  enum class Passage { abrupt, gradual };

  /// @param depth  of the shelf over that before it, in [0.05, 1]. Throws std::invalid_argument.
  explicit SolitonFission(double depth, Passage passage = Passage::abrupt);

  [[nodiscard]] double transmission() const { return transmission_; }  ///< T
  [[nodiscard]] double reflection() const { return reflection_; }      ///< R: of the reflected wave over a_0
  [[nodiscard]] double order() const { return order_; }                ///< nu
  [[nodiscard]] int solitons() const;
  /// a_n/a_0, n = 1 for the first and highest; 0 beyond solitons(). Throws std::invalid_argument for n < 1.
  [[nodiscard]] double amplitude(int n) const;

  static Provenance provenance();
  [[nodiscard]] double uncertainty() const;
  [[nodiscard]] SelfTest self_test() const;

 private:
  double depth_;
  double transmission_;
  double reflection_;
  double order_;
};

}  // namespace seiche::exact
