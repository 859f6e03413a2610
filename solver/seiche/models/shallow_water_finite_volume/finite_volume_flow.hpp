/// Shallow water on a fixed grid of n equal cells by one of four finite-volume schemes: the peers that particle methods
/// are measured against.
///
/// @f[ U_i^{n+1} = U_i^n - \frac{\tau}{\Delta x} (F_{i+1} - F_i) + \frac{\tau}{\Delta x} S_i, \qquad U = (h, q = h u)
/// @f]
///
///     lax_friedrichs   F = (F_L + F_R)/2 - nu dx/(2 tau) (U_R - U_L)
///     mac_cormack      F = (F(U_R) + F(U*_L))/2 - entropy correction, U* the forward predictor
///     roe              F = (F_L + F_R)/2 - (1/2) sum psi(lam_k) alpha_k r_k
///     muscl_hll        HLL flux of limited edge values, hydrostatic reconstruction over a bed, Heun's step in time
///
/// Mass and momentum that pass the ends, and the impulses of bed and friction, are booked: what is left over is
/// round-off. A step that fails leaves the flow as it was. Results do not depend on the number of threads.
///
/// When not to use it: dispersive waves; MacCormack on a dry bed (it breaks down with seiche::Divergence); any scheme
/// but muscl_hll on an uneven bed (refused). Lax-Friedrichs at a small Courant number: its viscosity is of the size
/// dx^2/tau.
///
/// References: Toro, Shock-capturing methods for free-surface shallow flows (2001); Harten and Hyman, J. Comput. Phys.
/// 50 (1983) 235; Einfeldt, SIAM J. Numer. Anal. 25 (1988) 294; Audusse et al., SIAM J. Sci. Comput. 25 (2004) 2050;
/// Bogomolov, Zakharov and Zerkal, Modelling of shallow-water waves by the particle method, section 7.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "seiche/compensated_sum.hpp"
#include "seiche/geometry/bottom_profile.hpp"
#include "seiche/model.hpp"
#include "seiche/ranges.hpp"
#include "seiche/shallow_water/relations.hpp"

namespace seiche::shallow_water_finite_volume {

enum class Scheme { lax_friedrichs, mac_cormack, roe, muscl_hll };
std::string_view name(Scheme scheme);

/// What lies beyond an end of the channel.
struct End {
  enum class Kind {
    wall,    ///< mirror image: passes no mass
    free,    ///< copy of the last cell: waves leave
    inflow,  ///< a state that is held: supercritical inflow, the state behind a bore, an outflow of known depth
  };
  Kind kind = Kind::wall;
  shallow_water::State state;

  static End wall() { return {Kind::wall, {}}; }
  static End free() { return {Kind::free, {}}; }
  static End inflow(shallow_water::State state) { return {Kind::inflow, state}; }
};

/// What has entered the channel since the start, per unit width and density.
struct Ledger {
  double mass_left = 0;         ///< through the left end [m^2]
  double mass_right = 0;        ///< through the right end, positive inwards
  double impulse_left = 0;      ///< momentum flux with thrust through the left end [m^3/s]
  double impulse_right = 0;     ///< the same through the right end, positive in +x
  double impulse_bed = 0;       ///< reaction of an uneven bed
  double impulse_friction = 0;  ///< friction
};

/// Where cells are: h [m], q [m^2/s], u, 0 below the dry depth, and c = sqrt(g h) [m/s]. Cell i is entry i; ghosts and
/// neighbours lie before and behind.
struct CellsView {
  double *h, *q, *u, *c;
  [[nodiscard]] CellsView from(std::ptrdiff_t i) const { return {h + i, q + i, u + i, c + i}; }
};
inline constexpr std::size_t ghosts = 2;  ///< at either end, and the reach of a stage in cells
struct Strip;

class FiniteVolumeFlow {
 public:
  struct Settings {
    Scheme scheme = Scheme::muscl_hll;
    double gravity = 9.81;
    double courant = 0.4;      ///< of stable_step()
    double viscosity = 0.9;    ///< nu of Lax-Friedrichs
    double theta = 1.5;        ///< limiter of muscl_hll
    double manning = 0;        ///< Manning's n [s/m^(1/3)], semi-implicit
    double dry_depth = 1e-12;  ///< below it the velocity counts as 0 [m]
    End left = End::wall();
    End right = End::wall();

    static constexpr auto ranges() {
      return std::array{Number{"gravity", &Settings::gravity, Range::positive()},
                        Number{"courant", &Settings::courant, Range::within(1e-6, 1)},
                        Number{"viscosity", &Settings::viscosity, Range::within(1e-3, 1)},
                        Number{"theta", &Settings::theta, Range::within(1, 2)},
                        Number{"manning", &Settings::manning, Range::not_negative()},
                        Number{"dry_depth", &Settings::dry_depth, Range::positive()}};
    }
  };

  /// @param start, end        the channel [m]
  /// @param depth, discharge  cell means h [m] >= 0 and h u [m^2/s], at least 4 cells, same length
  /// @param bed               only with muscl_hll; flat if absent
  /// Throws std::invalid_argument.
  FiniteVolumeFlow(const Settings& settings, double start, double end, std::span<const double> depth,
                   std::span<const double> discharge, const std::optional<Bed>& bed = {});

  /// One step of length tau [s]. Throws std::invalid_argument if the first step exceeds courant_limit();
  /// seiche::Divergence when a later one does, or when a depth turns negative or a number non-finite.
  void advance(double tau);

  void arrive(double time) { time_ = time; }
  /// That of the Courant number of the settings, or of the limit where that is smaller.
  [[nodiscard]] double stable_step() const { return std::min(settings_.courant, courant_limit()) / courant_number(1); }
  /// max(|u| + c) tau/dx of the present state and of what flows in.
  [[nodiscard]] double courant_number(double tau) const { return fastest_ * tau / dx_; }
  /// Largest Courant number of a stable step: 1; sqrt(viscosity) for Lax-Friedrichs.
  [[nodiscard]] double courant_limit() const;
  /// Largest Courant number of any step so far.
  [[nodiscard]] double largest_courant() const { return largest_courant_; }

  [[nodiscard]] double time() const { return time_; }
  [[nodiscard]] long steps() const { return steps_; }
  [[nodiscard]] std::size_t cells() const { return n_; }
  /// The n + 1 faces [m].
  [[nodiscard]] std::vector<double> edges() const;
  [[nodiscard]] std::span<const double> depth() const { return inner(now_.depth); }
  [[nodiscard]] std::span<const double> discharge() const { return inner(now_.discharge); }
  [[nodiscard]] std::span<const double> velocity() const { return inner(now_.velocity); }

  [[nodiscard]] double mass() const { return dx_ * compensated_sum(depth()); }          ///< [m^2]
  [[nodiscard]] double momentum() const { return dx_ * compensated_sum(discharge()); }  ///< [m^3/s]
  [[nodiscard]] Ledger ledger() const;
  /// What the ledger does not explain: present minus initial minus booked.
  [[nodiscard]] double mass_defect() const;
  [[nodiscard]] double momentum_defect() const;
  [[nodiscard]] std::vector<Invariant> invariants() const;

 private:
  struct Cells {  // with ghosts
    std::vector<double> depth, discharge, velocity, celerity;
    [[nodiscard]] CellsView from(std::size_t i) {
      i += ghosts;
      return {&depth[i], &discharge[i], &velocity[i], &celerity[i]};
    }
  };
  /// What a strip of cells reports of a step: for each stage what passed its first and last face and the reaction of
  /// its bed, then the change of its discharges by friction, and the first cell that broke down.
  struct Report {
    struct Stage {
      double mass_first, mass_last, thrust_first, thrust_last, reaction;
    };
    std::array<Stage, 2> stages{};
    double friction = 0, fastest = 0;
    std::optional<std::size_t> broken;
    bool finite = true;  // there
  };

  [[nodiscard]] std::span<const double> inner(const std::vector<double>& all) const {
    return {all.data() + ghosts, n_};
  }
  void fill_ghosts(const CellsView& cells, std::size_t n, bool left, bool right) const;
  void advance_strip(std::size_t begin, std::size_t end, double tau, Report& report);
  void stage(Strip& strip, std::size_t number, std::size_t first, std::size_t last, const CellsView& from,
             const CellsView& to, double tau, Report& report);
  void book(double tau);

  Settings settings_;
  double start_, dx_;
  std::size_t n_;
  std::vector<double> bed_;  // cell means, with ghosts; empty if flat
  Cells now_, next_;
  std::vector<Report> reports_;           // of the strips
  std::array<CompensatedSum, 6> booked_;  // in the order of the Ledger
  double depth_scale_ = 0, fastest_inflow_ = 0, fastest_ = 0, initial_mass_ = 0, initial_momentum_ = 0;
  double time_ = 0, largest_courant_ = 0;
  long steps_ = 0;
};

}  // namespace seiche::shallow_water_finite_volume
