/// Shallow water on a fixed grid of n equal cells by one of four finite-volume schemes: the peers that particle methods
/// are measured against.
///
/// @f[ U_i^{n+1} = U_i^n - \frac{\tau}{\Delta x} (F_{i+1} - F_i) + \frac{\tau}{\Delta x} S_i, \qquad U = (h, h u) @f]
///
/// Mass and momentum that pass the ends, and the impulses of bed and friction, are booked: what is left over is
/// round-off.
///
/// A step goes through the channel block by block, each small enough to stay near the core for all of the step. A block
/// takes its neighbours as they were before: every number is the same as in one piece, with any number of threads.
///
/// When not to use it: dispersive waves; MacCormack on a dry bed (it breaks down with seiche::Divergence); any scheme
/// but muscl_hll on an uneven bed (refused). Lax-Friedrichs at a small Courant number: its viscosity is of the size
/// dx^2/tau.
///
/// References: fluxes.hpp.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "seiche/compensated_sum.hpp"
#include "seiche/geometry/bed.hpp"
#include "seiche/models/shallow_water_finite_volume/fluxes.hpp"
#include "seiche/models/shallow_water_finite_volume/scheme.hpp"
#include "seiche/shallow_water/relations.hpp"

namespace seiche::shallow_water_finite_volume {

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

class FiniteVolumeFlow {
 public:
  struct Settings {
    Scheme scheme = Scheme::muscl_hll;
    double gravity = 9.81;
    double viscosity = 0.9;    ///< nu of Lax-Friedrichs, in (0, 1]
    double theta = 1.5;        ///< limiter of muscl_hll, in [1, 2]
    double manning = 0;        ///< Manning's n [s/m^(1/3)], semi-implicit
    double dry_depth = 1e-12;  ///< below it the velocity counts as 0 [m]
    End left = End::wall();
    End right = End::wall();
  };

  /// @param start, end        the channel [m]
  /// @param depth, discharge  cell means h [m] >= 0 and h u [m^2/s], at least 4 cells, same length
  /// @param bed               only with muscl_hll; flat if absent
  /// Throws std::invalid_argument.
  FiniteVolumeFlow(const Settings& settings, double start, double end, std::span<const double> depth,
                   std::span<const double> discharge, const std::optional<Bed>& bed = {});

  /// One step of length tau [s]. Throws std::invalid_argument if the first step exceeds courant_limit();
  /// seiche::Divergence when a later one does, or when a depth turns negative or a number non-finite.
  void step(double tau);

  /// Steps of courant dx/max(|u| + c), the last one cut to end at `time`. Returns how many. Throws like step().
  long advance_to(double time, double courant = 0.4);

  /// max(|u| + c) tau/dx of the present state and of what flows in.
  [[nodiscard]] double courant_number(double tau) const;
  /// Largest Courant number of a stable step: 1; sqrt(viscosity) for Lax-Friedrichs.
  [[nodiscard]] double courant_limit() const;
  /// Largest Courant number of any step so far.
  [[nodiscard]] double largest_courant() const { return largest_courant_; }

  [[nodiscard]] double time() const { return time_; }
  [[nodiscard]] long steps() const { return steps_; }
  [[nodiscard]] std::size_t cells() const { return n_; }
  [[nodiscard]] double spacing() const { return dx_; }
  [[nodiscard]] double centre(std::size_t i) const { return start_ + (static_cast<double>(i) + 0.5) * dx_; }
  /// The n + 1 faces [m].
  [[nodiscard]] std::vector<double> edges() const;
  [[nodiscard]] std::span<const double> depth() const { return {now_.depth.data() + ghosts, n_}; }
  [[nodiscard]] std::span<const double> discharge() const { return {now_.discharge.data() + ghosts, n_}; }
  [[nodiscard]] std::span<const double> velocity() const { return {now_.velocity.data() + ghosts, n_}; }
  /// Mean bed elevation of each cell; empty on a flat bed.
  [[nodiscard]] std::span<const double> bed() const;
  [[nodiscard]] const Settings& settings() const { return settings_; }

  [[nodiscard]] double mass() const;      ///< [m^2]
  [[nodiscard]] double momentum() const;  ///< [m^3/s]
  [[nodiscard]] double energy() const;    ///< of the cell means, sum dx (h u^2/2 + g h^2/2 + g h z) [m^4/s^2]
  [[nodiscard]] Ledger ledger() const;
  /// What the ledger does not explain: present minus initial minus booked.
  [[nodiscard]] double mass_defect() const;
  [[nodiscard]] double momentum_defect() const;

 private:
  /// What a block needs for a step, one for each thread.
  struct Workspace {
    Workspace(std::size_t most, Scheme scheme, bool uneven)
        : cells(most),
          old_depth(most),
          old_discharge(most),
          fluxes(most, uneven),
          mac_cormack(scheme == Scheme::mac_cormack ? most : 0),
          muscl_hll(scheme == Scheme::muscl_hll ? most : 0, uneven) {}

    Cells cells;
    std::vector<double> old_depth, old_discharge;  // of the step's start, for Heun's mean
    Fluxes fluxes;
    MacCormackFluxes mac_cormack;
    MusclHllFluxes muscl_hll;
  };

  /// What passed a block's first and last face in a stage of a step, the reaction of its bed, and what broke down.
  struct Stage {
    double mass_first = 0, mass_last = 0, thrust_first = 0, thrust_last = 0;
    double reaction = 0;
    bool broken = false;
    std::optional<std::size_t> where = {};
    bool finite = true;  ///< there
  };

  struct Block {
    std::size_t begin = 0;
    std::size_t end = 0;
    std::array<Stage, 2> stages;
    double friction = 0;  ///< change of the discharges' sum
    double fastest = 0;
  };

  [[nodiscard]] std::size_t stages() const { return settings_.scheme == Scheme::muscl_hll ? 2 : 1; }
  void fill_ghosts(const CellsView& cells, std::size_t n, bool left, bool right) const;
  void save_seams();
  [[nodiscard]] CellsView seam(std::size_t block);
  [[nodiscard]] CellsView load(std::size_t block, std::size_t from, std::size_t to, Cells& into);
  void advance(std::size_t block, double tau, Workspace& work);
  void compute_fluxes(double ratio, const CellsView& cells, std::size_t first, std::size_t n, Workspace& work) const;
  [[nodiscard]] Stage booked(const Block& block, std::size_t first, const Fluxes& fluxes) const;
  void find_breakdown(const Block& block, std::size_t first, const CellsView& cells, const Fluxes& fluxes,
                      Stage& stage) const;
  void refuse_breakdown(double tau) const;
  void book(double tau);

  Settings settings_;
  double start_;
  double dx_;
  std::size_t n_;
  std::vector<double> bed_;  // with ghosts; empty if flat
  Cells now_;
  std::vector<Block> blocks_;
  Cells seams_;  // what lies before and behind each block but the first, as it was at the step's start
  std::vector<Workspace> workspaces_;
  CompensatedSum mass_left_, mass_right_, impulse_left_, impulse_right_, impulse_bed_, impulse_friction_;
  double depth_scale_ = 0;
  double fastest_ = 0;         // |u| + c
  double fastest_inflow_ = 0;  // of the states beyond ends
  double initial_mass_ = 0;
  double initial_momentum_ = 0;
  double time_ = 0;
  long steps_ = 0;
  double largest_courant_ = 0;
};

}  // namespace seiche::shallow_water_finite_volume
