/// A flow of the plan model whose lattice is rezoned: put back, now and then, to where its columns do not crumple.
///
/// Lagrangian columns go with the water. The thin edge of the water slides along a shore, piles up where it meets and
/// crumples where it runs down, until the lattice tangles, though the water does nothing of the kind.
///
/// In a rezoned lattice the nodes slide along their rows, back to the lines that the columns were at the beginning.
/// Rows stay lines of the same water, so that thin sheets thin out no more than they do of themselves, and the columns
/// do not shear. What a row has of the pattern + - + - across it, by its fourth difference along it,
///
/// @f[ \frac{r_{i-2} - 4 r_{i-1} + 6 r_i - 4 r_{i+1} + r_{i+2}}{16}, @f]
///
/// is taken away: by it the edge of the water crumples where it piles up. Along its column no cell gets narrower than
/// a quarter of what it was: rows that come too near to each other are put farther out.
///
/// Water that runs down leaves a film behind, which is thinner the longer it gets, until columns fall dry. Where the
/// depth over the width of the cells from the shoreline to a row is less than `edge_slope`, the nodes within are drawn
/// back along their column until it is that: the water of the film, with its momentum, comes to what has run ahead.
///
/// Where a bore runs along a shore the shoreline goes down by a step that columns do not resolve, and the tongue of
/// water above it shears them. No marker of the shoreline is farther up than the next ones by more than `shore_slope`
/// times the distance of their columns: it is drawn back, and with it the nodes of its column, the nearer ones the
/// more, over so many rows that no cell is pressed by more than 0.3.
///
/// As soon as a node is farther from its place than `drift` of its cells, all are put there. Where that is
/// not possible the lattice goes on as it is. A lake at rest is left alone.
///
/// Steps in which an edge of a cell would change by more than 0.3 are divided, by eight at most. One that cannot
/// be made is made in halves, of a lattice that is rezoned before.
///
/// Reference: C. W. Hirt, A. A. Amsden, J. L. Cook, J. Comput. Phys. 14 (1974) 227.
#pragma once

#include <memory>
#include <vector>

#include "seiche/models/dispersive_shallow_water_2d/flow.hpp"
#include "seiche/plan_lattice/swept_remap.hpp"

namespace seiche::validation {

struct RezoneSettings {
  double drift = 0.2;  ///< of a cell
  /// A film of 8 mm may be 0.1 m long; 0: as thin as it gets. The highest run-up on a slope of 1:4 has 2 % less of it
  /// than with 0.01, of which films are so thin that lattices tangle when bores run over them.
  double edge_slope = 0.08;
  double shore_slope = 2;  ///< of the shoreline against its columns, in plan; 0: as it comes
};

/// Places of the nodes of a lattice that follows the shoreline on its south side.
class ShoreFollowing {
 public:
  using Places = plan_lattice::RezonedPlaces;

  /// @param first  with a shoreline on its south side
  explicit ShoreFollowing(const dispersive_shallow_water_2d::Lattice& first, RezoneSettings settings = {});
  /// For a flow whose nodes are at q.
  /// @param volumes  of the cells
  [[nodiscard]] Places places(mechanics::Input q, mechanics::Input volumes) const;
  /// Farthest of a node from its place, over the shortest edge at the node's place.
  [[nodiscard]] double drift(mechanics::Input q, const Places& places) const {
    return plan_lattice::farthest(shape_, q, places);
  }

 private:
  [[nodiscard]] Point outer(std::size_t column) const { return first_[shape_.node(column, shape_.rows)]; }
  void draw_back(std::size_t column, std::size_t row, double part, Places& places) const;
  void draw_back_films(mechanics::Input q, mechanics::Input volumes, Places& places) const;
  void cut_tongues(Places& places) const;
  void keep_widths(Places& places) const;

  plan_lattice::Shape shape_;
  RezoneSettings settings_;
  std::vector<Point> first_;  ///< places of all nodes
  std::vector<Point> line_;   ///< directions of the columns
};

class RezonedFlow {
 public:
  /// As Flow, without what moves or drives sides.
  RezonedFlow(dispersive_shallow_water_2d::Lattice lattice,
              const dispersive_shallow_water_2d::InitialVelocity& velocity, mechanics::Scheme scheme,
              dispersive_shallow_water_2d::Settings settings, RezoneSettings rezone);

  /// A step of Flow, divided where it must be. Throws std::invalid_argument for tau; Divergence with the time since the
  /// beginning, and the flow is then as it was at that time.
  void advance(double tau);
  void arrive(double time) { begin_ += time - this->time(); }

  /// As it is now; its time counts from the last rezoning.
  [[nodiscard]] const dispersive_shallow_water_2d::Flow& flow() const { return *flow_; }
  [[nodiscard]] double time() const { return begin_ + flow_->time(); }
  [[nodiscard]] long steps() const { return steps_ + flow_->steps(); }
  [[nodiscard]] double stable_step() const { return flow_->stable_step(); }
  /// What rezoning took from the energy is booked; of the rest the values alone are of the whole run.
  [[nodiscard]] std::vector<Invariant> invariants() const;
  /// Times the lattice was rezoned.
  [[nodiscard]] long rezoned() const { return rezoned_; }
  /// Kinetic and potential, zero for still water.
  [[nodiscard]] double energy() const { return base_ + flow_->energy(); }
  /// Times it could not be.
  [[nodiscard]] long refused() const { return refused_; }
  /// Steps that were made in halves.
  [[nodiscard]] long halved() const { return halved_; }
  /// Energy that rezoning took in all.
  [[nodiscard]] double lost() const { return lost_; }
  /// Water that remaps put elsewhere than their lattices swept it, in all [m^3].
  [[nodiscard]] double displaced() const { return displaced_; }

 private:
  [[nodiscard]] double rate_of_strain() const;
  void follow(bool anyway);
  void rezone(const ShoreFollowing::Places& places);

  ShoreFollowing following_;
  mechanics::Scheme scheme_;
  RezoneSettings settings_;
  std::unique_ptr<dispersive_shallow_water_2d::Flow> flow_;
  double begin_ = 0;
  double base_ = 0;
  double lost_ = 0;
  double displaced_ = 0;
  long steps_ = 0;
  long rezoned_ = 0;
  long refused_ = 0;
  long halved_ = 0;
};

}  // namespace seiche::validation
