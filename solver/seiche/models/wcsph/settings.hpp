/// What a computation by weakly compressible SPH consists of.
#pragma once

#include <array>
#include <limits>
#include <variant>

#include "seiche/models/wcsph/kernel.hpp"
#include "seiche/ranges.hpp"

namespace seiche::wcsph {

/// No viscosity at all: acoustics grows slowly (the midpoint rule has no stability interval).
struct Inviscid {
  static constexpr std::array<Number<Inviscid>, 0> ranges() { return {}; }
};

/// Monaghan's artificial viscosity on approaching pairs (3): Pi = -alpha c mu/rho. Its kinematic viscosity is about
/// 0.08 alpha c_0 h, not the alpha c h/8 of the two-sided form.
struct ArtificialViscosity {
  double alpha = 0.1;

  static constexpr auto ranges() {
    return std::array{Number{"alpha", &ArtificialViscosity::alpha, Range::not_negative()}};
  }
};

/// Laminar viscosity and sub-particle-scale stress (4); smagorinsky = isotropic = 0 leaves the laminar part alone.
struct LaminarSps {
  double kinematic_viscosity = 1e-6;  ///< nu_0 [m^2/s]
  double smagorinsky = 0.12;          ///< C_S
  double isotropic = 0.00066;         ///< C_I

  static constexpr auto ranges() {
    return std::array{Number{"kinematic_viscosity", &LaminarSps::kinematic_viscosity, Range::not_negative()},
                      Number{"smagorinsky", &LaminarSps::smagorinsky, Range::not_negative()},
                      Number{"isotropic", &LaminarSps::isotropic, Range::not_negative()}};
  }
};

using Viscosity = std::variant<Inviscid, ArtificialViscosity, LaminarSps>;

/// What wall particles push with.
enum class WallPressure {
  dynamic,  ///< their own density, advanced by (2)
  clamped,  ///< the same, never below rho_0: walls do not suck
  /// From the fluid next to them, with its hydrostatic gradient (Adami, Hu and Adams 2012). The walls of a scene then
  /// continue the lattice of the fluid for a support; staggered rows, twice as dense, would push too hard. Their
  /// smoothing length is h_0, so that their density is that of the fluid, whatever it was before.
  extrapolated,
};

/// Extents of a box that repeats itself [m], from the origin; infinite: open in that direction.
struct Period {
  double x = std::numeric_limits<double>::infinity();
  double z = std::numeric_limits<double>::infinity();
};

struct Settings {
  KernelName kernel = KernelName::cubic_spline;
  double smoothing = 1.3;  ///< h_0 over the spacing; h_a = h_0 (rho_0/rho_a)^(1/2), pairs use the mean
  double gravity = 9.81;   ///< [m/s^2], downwards
  double density = 1000;   ///< rho_0 [kg/m^3]
  double sound_speed = 0;  ///< c_0 [m/s]; must be given, see sound_speed_for
  Viscosity viscosity = ArtificialViscosity{};
  double xsph = 0.5;               ///< epsilon of (6)
  int filter_every = 0;            ///< steps between density filters (MLS of first order); 0: never
  double density_diffusion = 0;    ///< delta of delta-SPH, 0: none; 0.1 is usual
  bool particle_shifting = false;  ///< Lind et al. (2012), Sun et al. (2017), without the free surface
  WallPressure walls = WallPressure::dynamic;
  /// dt = courant h/(c + sigma). The midpoint rule lets sound of angular frequency omega grow by (omega dt)^4/8 a step:
  /// what has no artificial viscosity and takes ten thousand steps wants 0.2.
  double courant = 0.3;
  Period period;
  /// Particles side by side at most: 2 (any machine), 4 (AVX2) or 8 (AVX-512); the widest registers of the machine.
  int lanes = 8;

  static constexpr auto ranges() {
    return std::array{Number{"smoothing", &Settings::smoothing, Range::within(0.9, 3)},
                      Number{"gravity", &Settings::gravity, Range::not_negative()},
                      Number{"density", &Settings::density, Range::positive()},
                      Number{"sound_speed", &Settings::sound_speed, Range::positive()},
                      Number{"xsph", &Settings::xsph, Range::within(0, 1)},
                      Number{"density_diffusion", &Settings::density_diffusion, Range::not_negative()},
                      Number{"courant", &Settings::courant, Range::within(1e-6, 1)}};
  }
};

/// Part of the support by which candidate lists are wider, so that they last several steps.
inline constexpr double skin = 0.15;
/// A step this much shorter than the acoustic one means that the run has broken down.
inline constexpr double shortest_step = 1e-3;
/// Of the limit of a step by viscosity, dt <= 0.125 h^2/nu_0.
inline constexpr double viscous_courant = 0.125;

/// The rule of the SPHysics generator: coefficient sqrt(g H). The front of a dam break moves at up to 2 sqrt(g H), and
/// spray where it strikes a wall faster still: Extremes::mach says how much of the sound speed that was.
double sound_speed_for(double gravity, double height, double coefficient = 10);

/// Throws std::invalid_argument naming the parameter, its value and range.
void validate(const Settings& settings);

/// Tait's equation of state of a weakly compressible fluid.
///
/// @f[ P = B \left( s^\gamma - 1 \right), \qquad s = \frac{\rho}{\rho_0}, \qquad
///     B = \frac{\rho_0 c_0^2}{\gamma}, \qquad c = c_0 \, s^{(\gamma - 1)/2} \tag{5} @f]
/// @f[ e = \frac{B}{\rho_0} \left( \frac{s^{\gamma - 1}}{\gamma - 1} + \frac{1}{s} - \frac{\gamma}{\gamma - 1} \right),
///     \qquad de = \frac{P}{\rho^2} \, d\rho @f]
///
/// Reference: Batchelor, An introduction to fluid dynamics (1967), section 1.8; Monaghan, Simulating free surface flows
/// with SPH, J. Comput. Phys. 110 (1994) 399.
class TaitFluid {
 public:
  static constexpr double exponent = 7;  ///< gamma

  /// @param density      rho_0 [kg/m^3]
  /// @param sound_speed  c_0 [m/s] at rho_0
  /// Throws std::invalid_argument.
  TaitFluid(double density, double sound_speed);

  [[nodiscard]] double pressure(double density) const;        ///< [Pa]
  [[nodiscard]] double density_at(double pressure) const;     ///< inverse of pressure [kg/m^3]
  [[nodiscard]] double sound_speed(double density) const;     ///< [m/s]
  [[nodiscard]] double elastic_energy(double density) const;  ///< per unit mass, 0 at rho_0 [J/kg]
  /// Density in still water, `depth` below the surface: P = rho_0 g depth. Throws std::invalid_argument where the base
  /// 1 + rho_0 g depth/B exceeds 2.
  [[nodiscard]] double hydrostatic_density(double gravity, double depth) const;

  [[nodiscard]] double reference_density() const { return density_; }
  [[nodiscard]] double stiffness() const { return stiffness_; }  ///< B [Pa]

 private:
  double density_;
  double sound_speed_;
  double stiffness_;
};

}  // namespace seiche::wcsph
