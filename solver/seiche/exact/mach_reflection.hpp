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
#pragma once

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
  [[nodiscard]] double reflected_angle() const;
  [[nodiscard]] double stem_angle() const;
  /// Relative error of amplitudes to be expected of the theory itself: of the order of the incident amplitude.
  [[nodiscard]] double theory_uncertainty() const { return amplitude_; }

  static double reflected_ratio(double kappa);
  static double wall_ratio(double kappa);

  static Provenance provenance();
  [[nodiscard]] double uncertainty() const;
  [[nodiscard]] SelfTest self_test() const;

 private:
  double amplitude_;
  double angle_;
  double kappa_;
};

}  // namespace seiche::exact
