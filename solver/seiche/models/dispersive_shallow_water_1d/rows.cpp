#include "seiche/models/dispersive_shallow_water_1d/rows.hpp"

#include <cmath>
#include <limits>

#include "seiche/simd_clones.hpp"

// Like SEICHE_INLINE, behind the parameters of a lambda.
#define SEICHE_INLINE_LAMBDA __attribute__((always_inline))

namespace seiche::dispersive_shallow_water_1d {

Frame frame_on(Kinetics kinetics, double alpha, double slope) {
  if (kinetics == Kinetics::frank) {
    const double c = 1 / std::sqrt(1 + slope * slope);
    const double s = slope * c;
    return {.xp = c, .xr = -s, .yp = s, .yr = c};
  }
  const double kappa = (1 - 2 * alpha) / (2 * alpha);
  const double mu = alpha - alpha * kappa * kappa;
  const double along = 1 / std::sqrt(1 + mu * slope * slope);
  return {.xp = along, .xr = 0, .yp = -kappa * slope * along, .yr = 1};
}

void GhostedArray::resize(std::size_t n, std::size_t shift) {
  constexpr std::size_t doubles_per_line = 8;
  first_ = shift * doubles_per_line + 1;
  size_ = n;
  values_.assign(first_ + n + 1, 0.0);
}

void Rows::resize(std::size_t markers) {
  constexpr std::size_t block_lines = 34;  // a block of markers and two more
  std::size_t shift = 0;
  for (GhostedArray* array :
       {&x,     &y,    &step_x,  &step_y,   &force_x,  &force_y,       &star_p, &star_r, &mobility_p, &mobility_r,
        &width, &mean, &impulse, &diagonal, &coupling, &bed.elevation, &bed.xp, &bed.xr, &bed.yp,     &bed.yr}) {
    array->resize(markers, shift);
    shift += block_lines;
  }
}

void Bed::resize(std::size_t markers) {
  for (GhostedArray* array : {&elevation, &xp, &xr, &yp, &yr}) array->resize(markers);
}

void Bed::set_frame(std::ptrdiff_t marker, Frame frame) {
  xp.row()[marker] = frame.xp;
  xr.row()[marker] = frame.xr;
  yp.row()[marker] = frame.yp;
  yr.row()[marker] = frame.yr;
}

Frame Bed::frame(std::ptrdiff_t marker) const {
  return {xp.row()[marker], xr.row()[marker], yp.row()[marker], yr.row()[marker]};
}

namespace {

/// Frames of a block: the identity, or read.
template <bool is_level>
struct Frames {
  static constexpr bool level = is_level;
  const double *xp, *xr, *yp, *yr;
  explicit Frames(const Bed& bed) : xp(bed.xp.row()), xr(bed.xr.row()), yp(bed.yp.row()), yr(bed.yr.row()) {}
  [[nodiscard]] Frame at(std::ptrdiff_t i) const {
    if constexpr (level) {
      return {};
    } else {
      return {xp[i], xr[i], yp[i], yr[i]};
    }
  }
};

/// What the loops read besides.
struct Given {
  const double *width, *mean, *bed, *wp, *wr;
  explicit Given(const Rows& rows)
      : width(rows.width.row()),
        mean(rows.mean.row()),
        bed(rows.bed.elevation.row()),
        wp(rows.mobility_p.row()),
        wr(rows.mobility_r.row()) {}
};

/// S W S^T of a marker, symmetric.
struct Mobility {
  double xx, xy, yy;
};

template <bool level>
SEICHE_INLINE Mobility mobility_at(const Frames<level>& frames, const Given& at, std::ptrdiff_t i) {
  if constexpr (level) {
    return {at.wp[i], 0, at.wr[i]};
  } else {
    const Frame f = frames.at(i);
    return {at.wp[i] * f.xp * f.xp + at.wr[i] * f.xr * f.xr, at.wp[i] * f.xp * f.yp + at.wr[i] * f.xr * f.yr,
            at.wp[i] * f.yp * f.yp + at.wr[i] * f.yr * f.yr};
  }
}

/// loop(k, frames) over a range, compiled for blocks that are level and for those that are not.
template <class Loop>
SEICHE_INLINE void over(Range range, bool level, const Bed& bed, const Loop& loop) {
  const Frames<true> identity(bed);
  const Frames<false> tilted(bed);
  if (level) {
#pragma omp simd
    for (std::ptrdiff_t k = range.first; k < range.last; ++k) loop(k, identity);
  } else {
#pragma omp simd
    for (std::ptrdiff_t k = range.first; k < range.last; ++k) loop(k, tilted);
  }
}

}  // namespace

SEICHE_SIMD_CLONES void measure_cells(Rows& rows, Range cells) {
  const double* const x = rows.x.row();
  const double* const y = rows.y.row();
  double* const width = rows.width.row();
  double* const mean = rows.mean.row();
#pragma omp simd
  for (std::ptrdiff_t j = cells.first; j < cells.last; ++j) {
    width[j] = x[j + 1] - x[j];
    mean[j] = 0.5 * (y[j] + y[j + 1]);
  }
}

SEICHE_SIMD_CLONES void gravity_forces(const Rows& rows, Range markers, Weights weights, Forces forces) {
  const double half = 0.5 * weights.gravity;
  const double beta = weights.slope_energy;
  const double* const y = rows.y.row();
  const double* const width = rows.width.row();
  const double* const mean = rows.mean.row();
#pragma omp simd
  for (std::ptrdiff_t i = markers.first; i < markers.last; ++i) {
    const double before = y[i] - y[i - 1];
    const double after = y[i + 1] - y[i];
    const double pushed = mean[i - 1] * mean[i - 1] + 0.25 * beta * before * before;
    const double pushing = mean[i] * mean[i] + 0.25 * beta * after * after;
    forces.x[i - markers.first] = half * (pushing - pushed);
    forces.y[i - markers.first] =
        -half * (width[i - 1] * (mean[i - 1] + 0.5 * beta * before) + width[i] * (mean[i] - 0.5 * beta * after));
  }
}

SEICHE_SIMD_CLONES void assemble(Rows& rows, bool level, Range cells) {
  const Given at(rows);
  double* const diagonal = rows.diagonal.row();
  over(cells, level, rows.bed, [=](std::ptrdiff_t j, auto frames) SEICHE_INLINE_LAMBDA {
    const Mobility a = mobility_at(frames, at, j);
    const Mobility b = mobility_at(frames, at, j + 1);
    const double left = at.bed[j] - at.mean[j];       // dV/dx of the left marker
    const double right = at.mean[j] - at.bed[j + 1];  // and of the right one
    const double up = 0.5 * at.width[j];              // dV/dy of both
    diagonal[j] = left * left * a.xx + right * right * b.xx + up * up * (a.yy + b.yy);
    if constexpr (!frames.level) diagonal[j] += 2 * up * (left * a.xy + right * b.xy);
  });
}

SEICHE_SIMD_CLONES void couple(Rows& rows, bool level, Range markers) {
  const Given at(rows);
  double* const coupling = rows.coupling.row();
  over(markers, level, rows.bed, [=](std::ptrdiff_t i, auto frames) SEICHE_INLINE_LAMBDA {
    const Mobility k = mobility_at(frames, at, i);
    const double before = at.mean[i - 1] - at.bed[i];  // dV/dx of the cell before the marker, and of the one after it
    const double after = at.bed[i] - at.mean[i];
    coupling[i - 1] = before * after * k.xx + 0.25 * at.width[i - 1] * at.width[i] * k.yy;
    if constexpr (!frames.level) coupling[i - 1] += 0.5 * (before * at.width[i] + after * at.width[i - 1]) * k.xy;
  });
}

SEICHE_SIMD_CLONES void rates_of_cells(const Rows& rows, bool level, Range cells, const double* p, const double* r,
                                       double* w) {
  const Given at(rows);
  over(cells, level, rows.bed, [=](std::ptrdiff_t j, auto frames) SEICHE_INLINE_LAMBDA {
    const Frame a = frames.at(j);
    const Frame b = frames.at(j + 1);
    const double u_a = a.xp * p[j] + a.xr * r[j];
    const double v_a = a.yp * p[j] + a.yr * r[j];
    const double u_b = b.xp * p[j + 1] + b.xr * r[j + 1];
    const double v_b = b.yp * p[j + 1] + b.yr * r[j + 1];
    w[j] = (at.mean[j] - at.bed[j + 1]) * u_b - (at.mean[j] - at.bed[j]) * u_a + 0.5 * at.width[j] * (v_a + v_b);
  });
}

SEICHE_SIMD_CLONES void kick_rows(const Rows& rows, bool level, Range markers, GivenForces forces, double h, double* p,
                                  double* r) {
  const Given at(rows);
  over(markers, level, rows.bed, [=](std::ptrdiff_t i, auto frames) SEICHE_INLINE_LAMBDA {
    const Frame f = frames.at(i);
    p[i] += h * at.wp[i] * (f.xp * forces.x[i - markers.first] + f.yp * forces.y[i - markers.first]);
    r[i] += h * at.wr[i] * (f.xr * forces.x[i - markers.first] + f.yr * forces.y[i - markers.first]);
  });
}

SEICHE_SIMD_CLONES void react_rows(const Rows& rows, bool level, Range markers, const double* mu, double* p,
                                   double* r) {
  const Given at(rows);
  over(markers, level, rows.bed, [=](std::ptrdiff_t i, auto frames) SEICHE_INLINE_LAMBDA {
    const Frame f = frames.at(i);
    const double ix = mu[i - 1] * (at.mean[i - 1] - at.bed[i]) - mu[i] * (at.mean[i] - at.bed[i]);
    const double iy = 0.5 * (mu[i - 1] * at.width[i - 1] + mu[i] * at.width[i]);
    p[i] += at.wp[i] * (f.xp * ix + f.yp * iy);
    r[i] += at.wr[i] * (f.xr * ix + f.yr * iy);
  });
}

SEICHE_SIMD_CLONES void advance_rows(const Bed& bed, bool level, Range markers, const double* x, const double* y,
                                     const double* p, const double* r, double h, double* to_x, double* to_y) {
  over(markers, level, bed, [=](std::ptrdiff_t i, auto frames) SEICHE_INLINE_LAMBDA {
    const Frame f = frames.at(i);
    const double u = f.xp * p[i] + f.xr * r[i];
    const double v = f.yp * p[i] + f.yr * r[i];
    to_x[i] = x[i] + h * u;
    to_y[i] = y[i] + h * v;
  });
}

SEICHE_SIMD_CLONES Smallest smallest(const Rows& rows, Range cells, Range markers) {
  const double* const width = rows.width.row();
  const double* const y = rows.y.row();
  const double* const bed = rows.bed.elevation.row();
  double narrowest = std::numeric_limits<double>::infinity();
  double shallowest = std::numeric_limits<double>::infinity();
#pragma omp simd reduction(min : narrowest)
  for (std::ptrdiff_t j = cells.first; j < cells.last; ++j) narrowest = width[j] < narrowest ? width[j] : narrowest;
#pragma omp simd reduction(min : shallowest)
  for (std::ptrdiff_t i = markers.first; i < markers.last; ++i) {
    const double depth = y[i] - bed[i];
    shallowest = depth < shallowest ? depth : shallowest;
  }
  return {narrowest, shallowest};
}

SEICHE_SIMD_CLONES void aim(Range cells, const double* target, double* w) {
#pragma omp simd
  for (std::ptrdiff_t j = cells.first; j < cells.last; ++j) w[j] = (target == nullptr ? -0.0 : target[j]) - w[j];
}

SEICHE_SIMD_CLONES void add_increment_forces(const Rows& rows, Range markers, Weights weights, Forces forces) {
  const double part = weights.gravity / 24;
  const double beta = weights.slope_energy;
  const double* const dx = rows.step_x.row();
  const double* const dy = rows.step_y.row();
#pragma omp simd
  for (std::ptrdiff_t i = markers.first; i < markers.last; ++i) {
    const double before = dy[i] - dy[i - 1];
    const double after = dy[i + 1] - dy[i];
    const double mean_before = 0.5 * (dy[i] + dy[i - 1]);
    const double mean_after = 0.5 * (dy[i + 1] + dy[i]);
    forces.x[i - markers.first] +=
        part * (mean_after * mean_after - mean_before * mean_before + 0.25 * beta * (after * after - before * before));
    forces.y[i - markers.first] -= part * ((dx[i] - dx[i - 1]) * (mean_before + 0.5 * beta * before) +
                                           (dx[i + 1] - dx[i]) * (mean_after - 0.5 * beta * after));
  }
}

SEICHE_SIMD_CLONES void reflect_rows(Range markers, const double* mean_p, const double* mean_r, double* p, double* r) {
#pragma omp simd
  for (std::ptrdiff_t i = markers.first; i < markers.last; ++i) {
    p[i] = 2 * mean_p[i] - p[i];
    r[i] = 2 * mean_r[i] - r[i];
  }
}

SEICHE_SIMD_CLONES void scale_row(Range cells, double factor, const double* from, double* to) {
#pragma omp simd
  for (std::ptrdiff_t j = cells.first; j < cells.last; ++j) to[j] = factor * from[j];
}

SEICHE_SIMD_CLONES void middle_rows(Range markers, const double* a, const double* b, double* middle, double* step) {
#pragma omp simd
  for (std::ptrdiff_t i = markers.first; i < markers.last; ++i) {
    middle[i] = 0.5 * (a[i] + b[i]);
    step[i] = b[i] - a[i];
  }
}

SEICHE_SIMD_CLONES RowChange replace_row(Range markers, const double* from, double* to) {
  double change = 0;
  double value = 0;
#pragma omp simd reduction(max : change, value)
  for (std::ptrdiff_t i = markers.first; i < markers.last; ++i) {
    const double by = std::abs(from[i] - to[i]);
    const double size = std::abs(from[i]);
    change = by > change ? by : change;
    value = size > value ? size : value;
    to[i] = from[i];
  }
  return {change, value};
}

}  // namespace seiche::dispersive_shallow_water_1d
