/// Oblique reflection of a solitary wave from a wall: regular with two crossing crests, or Mach with a stem.
///
/// a = incident amplitude/depth, psi = angle between the incident crest and the normal of the wall [rad]:
///
///     kappa = psi/sqrt(3a)                      (Miles)
///     kappa = tan(psi)/(sqrt(3a) cos(psi))      (Kodama and Yeh: the same in the Kadomtsev-Petviashvili variables)
///
///     kappa < 1, Mach:      a_r/a_i = kappa^2,  a_w/a_i = (1 + kappa)^2,  psi_r = sqrt(3a), stem edge at
///                           psi_* = sqrt(3a)(1 - kappa)/3 from the wall
///     kappa >= 1, regular:  a_r/a_i = 1,  a_w/a_i = 4/(1 + sqrt(1 - kappa^-2)),  psi_r = psi
///
/// a_w is the amplitude at the wall, 4 a_i at kappa = 1 (with infinite slope on the regular side: compare nothing
/// within a few per cent of it). The angles of the Mach case are Miles's leading order for both.
///
/// When not to use it: as an exact reference. It is the limit of small amplitude after infinite time;
/// theory_uncertainty() gives the order of what is neglected.
///
/// References: Miles, Resonantly interacting solitary waves, J. Fluid Mech. 79 (1977) 171; Li, Yeh and Kodama, On the
/// Mach reflection of a solitary wave: revisited, J. Fluid Mech. 672 (2011) 326; Kodama and Yeh, The KP theory and Mach
/// reflection, J. Fluid Mech. 800 (2016) 766.
///
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

#include <cmath>

#include "seiche/exact/reference_solution.hpp"

namespace seiche::exact {

class MachReflection {
 public:
  enum class Theory { miles, kodama_yeh };

  /// @param amplitude  incident amplitude over depth, 0 < amplitude <= 0.8332 (the highest solitary wave)
  /// @param angle      [rad], 0 < angle < pi/2
  /// Throws std::invalid_argument.
  MachReflection(double amplitude, double angle, Theory theory = Theory::miles);

  /// Interaction parameter; Mach reflection below 1.
  [[nodiscard]] double kappa() const { return kappa_; }
  [[nodiscard]] bool has_stem() const { return kappa_ < 1; }
  /// a_r/a_i and a_w/a_i.
  [[nodiscard]] double reflected_ratio() const { return reflected_ratio(kappa_); }
  [[nodiscard]] double wall_ratio() const { return wall_ratio(kappa_); }
  /// psi_r and psi_* [rad]; the stem angle is 0 for regular reflection.
  [[nodiscard]] double reflected_angle() const { return has_stem() ? std::sqrt(3 * amplitude_) : angle_; }
  [[nodiscard]] double stem_angle() const { return has_stem() ? std::sqrt(3 * amplitude_) * (1 - kappa_) / 3 : 0; }
  /// Relative error of amplitudes to be expected of the theory itself: of the order of the incident amplitude.
  [[nodiscard]] double theory_uncertainty() const { return amplitude_; }

  static double reflected_ratio(double kappa);
  static double wall_ratio(double kappa);

  [[nodiscard]] double uncertainty() const { return 10 * epsilon; }
  [[nodiscard]] SelfTest self_test() const;

 private:
  double amplitude_, angle_, kappa_;
};

class SolitonFission {
 public:
  enum class Passage { abrupt, gradual };

  /// @param depth  of the shelf over that before it, in [0.05, 1]. Throws std::invalid_argument.
  explicit SolitonFission(double depth, Passage passage = Passage::abrupt);

  [[nodiscard]] double transmission() const { return transmission_; }  ///< T
  [[nodiscard]] double reflection() const { return reflection_; }      ///< R: of the reflected wave over a_0
  [[nodiscard]] double order() const { return order_; }                ///< nu
  [[nodiscard]] int solitons() const { return static_cast<int>(std::ceil(order_)); }
  /// a_n/a_0, n = 1 for the first and highest; 0 beyond solitons(). Throws std::invalid_argument for n < 1.
  [[nodiscard]] double amplitude(int n) const;

  [[nodiscard]] double uncertainty() const { return 1e-14; }
  [[nodiscard]] SelfTest self_test() const;

 private:
  double depth_, transmission_, reflection_, order_;
};

}  // namespace seiche::exact
