/// The arrays of the discrete model and the loops over them.
///
/// Marker i = 0..n-1, cell j between markers j and j+1. Every array has one ghost at each end, index -1 and one past
/// the last, so that loops need no special first and last turn: in a periodic channel the ghosts are images, at an end
/// ghost cells are empty and take no part.
///
/// Loops run over ranges, and blocks of markers know whether their bottom is level: then the frames are the identity
/// and are not even read.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "seiche/models/dispersive_shallow_water_1d/channel.hpp"

namespace seiche::dispersive_shallow_water_1d {

/// n values and a ghost on either side: index -1..n.
class GhostedArray {
 public:
  /// @param shift  cache lines by which the array is moved: large arrays begin at pages, and if all began at the same
  ///               place in them, the loops' many streams would evict each other from the caches
  void resize(std::size_t n, std::size_t shift = 0);
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] double* row() { return values_.data() + first_; }
  [[nodiscard]] const double* row() const { return values_.data() + first_; }

 private:
  std::vector<double> values_;
  std::size_t size_ = 0;
  std::size_t first_ = 0;
};

/// u = xp p + xr r,  v = yp p + yr r.
struct Frame {
  double xp = 1, xr = 0, yp = 0, yr = 1;
};
Frame frame_on(Kinetics kinetics, double alpha, double slope);

/// Half-open range of markers or cells.
struct Range {
  std::ptrdiff_t first = 0;
  std::ptrdiff_t last = 0;
};

/// The bottom under the markers: its elevation and the frames on it; frames are meaningless in level blocks.
struct Bed {
  GhostedArray elevation;
  GhostedArray xp, xr, yp, yr;

  void resize(std::size_t markers);
  [[nodiscard]] std::size_t size() const { return elevation.size(); }
  void set_frame(std::ptrdiff_t marker, Frame frame);
  [[nodiscard]] Frame frame(std::ptrdiff_t marker) const;
};

struct Rows {
  // Of markers, at the configuration of the last linearisation.
  GhostedArray x, y;
  Bed bed;
  GhostedArray step_x, step_y;          // motion over the step, for discrete gradients
  GhostedArray force_x, force_y;        // -grad Pi and what else acts, in steps that are not fused
  GhostedArray star_p, star_r;          // rates after the kick, in fused steps
  GhostedArray mobility_p, mobility_r;  // 1/m and 1/(alpha m), 0 where an end
                                        // allows no motion; constant

  // Of cells.
  GhostedArray width, mean;  // dx and (y_j + y_{j+1})/2
  // Of A mu = defect: coupling[j] between cells j and j+1, and in its place the multipliers of the elimination; the
  // defect, and in its place the impulses, 0 in ghosts. Long channels live on what their passes need not fetch.
  GhostedArray diagonal, coupling, impulse;

  void resize(std::size_t markers);
};

/// Constants of the potential energy, times the density.
struct Weights {
  double gravity = 1;
  double slope_energy = 1.0 / 3;
};

/// width and mean of cells.
void measure_cells(Rows& rows, Range cells);
/// Of the markers of a range, from its first on.
struct Forces {
  double *x, *y;
};
struct GivenForces {
  const double *x, *y;
};
/// -grad Pi of markers from the cells on both sides.
void gravity_forces(const Rows& rows, Range markers, Weights weights, Forces forces);
/// What the mean of -grad Pi over a straight motion (step_x, step_y) has beyond its value at the middle.
void add_increment_forces(const Rows& rows, Range markers, Weights weights, Forces forces);
/// diagonal of cells; coupling of cells i-1 and i for the markers i of the range.
void assemble(Rows& rows, bool level, Range cells);
void couple(Rows& rows, bool level, Range markers);
/// Smallest width of cells and smallest depth over markers.
struct Smallest {
  double width, depth;
};
Smallest smallest(const Rows& rows, Range cells, Range markers);
/// The defect, -J u and, if there is a target, + target; w holds J u.
void aim(Range cells, const double* target, double* w);
/// w = J u for cells.
void rates_of_cells(const Rows& rows, bool level, Range cells, const double* p, const double* r, double* w);
/// u += h W F, u += W J^T mu for markers; mu has ghosts.
void kick_rows(const Rows& rows, bool level, Range markers, GivenForces forces, double h, double* p, double* r);
void react_rows(const Rows& rows, bool level, Range markers, const double* mu, double* p, double* r);
/// to = from + h S u for markers.
void advance_rows(const Bed& bed, bool level, Range markers, const double* x, const double* y, const double* p,
                  const double* r, double h, double* to_x, double* to_y);
/// u = 2 mean - u.
void reflect_rows(Range markers, const double* mean_p, const double* mean_r, double* p, double* r);
/// to = factor from.
void scale_row(Range cells, double factor, const double* from, double* to);

/// middle = (a + b)/2 and step = b - a.
void middle_rows(Range markers, const double* a, const double* b, double* middle, double* step);
/// to = from; the largest change and the largest magnitude.
struct RowChange {
  double change, value;
};
RowChange replace_row(Range markers, const double* from, double* to);

}  // namespace seiche::dispersive_shallow_water_1d
