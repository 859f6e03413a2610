/// Reflection of a solitary wave at a wall in the Kadomtsev-Petviashvili equation, at every point and time.
///
/// Long waves of small amplitude that travel nearly along x (c0 = sqrt(g h), elevation eta above still water):
///
///     (eta_t + c0 eta_x + (3 c0/2h) eta eta_x + (c0 h^2/6) eta_xxx)_x + (c0/2) eta_yy = 0
///
/// With X = (x - c0 t)/h, Y = y/h, T = 2 c0 t/(3 h) and eta = (2h/3) u this is (4 u_T + 6 u u_X + u_XXX)_X + 3 u_YY =
/// 0, solved by u = 2 (ln tau)_XX. Wronskians of two sums of e_j = exp(k_j X + k_j^2 Y - k_j^3 T) are tau = sum C_ij
/// e_i e_j with the line solitons [i, j],
///
///     amplitude h (k_j - k_i)^2/3,   crest X + (k_i + k_j) Y - (k_i^2 + k_i k_j + k_j^2) T = const.
///
/// For a wave of amplitude a that meets the wall y = 0 at the angle psi (between its direction and the wall), with
/// S = sqrt(3a/h), kappa = tan(psi)/S, K = (S + tan psi)/2, q = (S - tan psi)/2:
///
///     wall, kappa < 1   k = (-K, -q, q, K): incident [1,3], reflected [3,4], on the wall a stem [1,4] ("(3142)-type"),
///                       tau = e1 e3 + e1 e4 + e2 e3 + e3 e4 + e2 e4/(1 - kappa^2)
///     wall, kappa > 1   k = (-K, q, -q, K): incident [1,2], reflected [3,4] ("O-type"),
///                       tau = e1 e3 + e2 e4 + sqrt(1 - kappa^-2) (e1 e4 + e2 e3)
///     resonant triad    the three crests of the stem's end alone, kappa < 1: tau = e1 e3 + e1 e4 + e3 e4
///
/// These are symmetric about the wall. In the stem a_w = (1 + kappa)^2 a; the reflected wave has kappa^2 a and
/// tan psi_r = S; the stem's end moves away from the wall at (2/3) q c0, all of it Miles's theory, here with the whole
/// surface. The stem reaches its height like exp(-settling_rate t): slowly next to kappa = 1, where it needs a time
/// of 3 h/(c0 S^3 kappa (1 - kappa)).
///
/// At t = 0 the three crests of the triad meet at x = y = 0. Before that a reflection with a stem comes from another
/// pattern: use it for t >= 0 as a model of a wall that the wave has met.
///
/// When not to use it: as a reference for Euler or Green-Naghdi equations. The equation's own errors are O(a/h) and
/// O(tan^2 psi), it has no waves to -x, and its kappa is neither psi/S (Miles) nor tan psi/(S cos psi) (which makes it
/// agree with the oblique solitary wave of the Euler equations).
///
/// References: Kadomtsev and Petviashvili, On the stability of solitary waves in weakly dispersing media, Sov. Phys.
/// Dokl. 15 (1970) 539; Miles, Resonantly interacting solitary waves, J. Fluid Mech. 79 (1977) 171; Kodama, KP
/// solitons in shallow water, J. Phys. A 43 (2010) 434004; Kodama and Yeh, The KP theory and Mach reflection, J. Fluid
/// Mech. 800 (2016) 766.
#pragma once

#include "seiche/exact/exponential_sum.hpp"
#include "seiche/exact/reference_solution.hpp"

namespace seiche::exact {

class KadomtsevPetviashvili {
 public:
  enum class Pattern { wall_reflection, resonant_triad };

  /// A crest far from the others: x = offset + lean y + speed t, y >= 0.
  struct Crest {
    double amplitude;  ///< [m]
    double lean;       ///< dx/dy; positive where the crest runs ahead away from the wall
    double speed;      ///< dx/dt along the wall [m/s]
    double offset;     ///< [m]

    [[nodiscard]] double at(double y, double t) const { return offset + lean * y + speed * t; }
    /// Between the crest and the normal of the wall, positive [rad].
    [[nodiscard]] double angle() const;
  };

  struct Point {
    double x, y;
  };

  /// @param amplitude  of the incident wave [m];  @param angle  psi [rad], 0 < psi < pi/2
  /// |kappa - 1| >= 1e-6; the resonant triad needs kappa < 1. Throws std::invalid_argument.
  KadomtsevPetviashvili(double amplitude, double angle, double depth = 1, double gravity = 1,
                        Pattern pattern = Pattern::wall_reflection);

  /// Above still water [m]; for a wall reflection also at y < 0, the mirror image.
  [[nodiscard]] double elevation(double x, double y, double t) const;

  /// tan(psi)/sqrt(3 a/h).
  [[nodiscard]] double kappa() const { return kappa_; }
  [[nodiscard]] bool has_stem() const { return kappa_ < 1; }
  [[nodiscard]] const Crest& incident() const { return incident_; }
  [[nodiscard]] const Crest& reflected() const { return reflected_; }
  /// On the wall: the stem, or where the crests cross; its amplitude is the limit for t -> infinity.
  [[nodiscard]] const Crest& wall() const { return wall_; }
  /// Where the crests of incident wave, reflected wave and stem meet. Throws std::logic_error if kappa > 1.
  [[nodiscard]] Point triple_point(double t) const;
  /// Rate at which the elevation on the wall approaches its limit [1/s]; 0 without a stem: it does not change.
  [[nodiscard]] double settling_rate() const;

  /// Left-hand side of the equation from derivatives of the tau-function, over its largest term.
  [[nodiscard]] double equation_defect(double x, double y, double t) const;

  static Provenance provenance();
  [[nodiscard]] double uncertainty() const;
  [[nodiscard]] SelfTest self_test() const;

 private:
  [[nodiscard]] ExponentialSum::Triple scaled(double x, double y, double t) const;
  /// Crest between the regions of the exponentials with k_i and k_j; `shift` in units of the depth.
  [[nodiscard]] Crest crest(double k_i, double k_j, double shift = 0) const;
  [[nodiscard]] ExponentialSum tau_function(Pattern pattern) const;

  double depth_;
  double celerity_;  ///< c0
  double kappa_;
  double outer_;  ///< K
  double inner_;  ///< q, negative without a stem
  Pattern pattern_;
  ExponentialSum tau_;
  Crest incident_;
  Crest reflected_;
  Crest wall_;
};

}  // namespace seiche::exact
