#include "validation/studies/variable_mass/solitary_run.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/QR>

#include "seiche/free_lagrangian/cell_water.hpp"
#include "seiche/samples.hpp"
#include "validation/instruments/processor_time.hpp"

namespace seiche::validation {

using variable_mass::Flow;

std::vector<long> rows_up_to(long own, std::span<const long> ladder) {
  std::vector<long> rows;
  for (const long n : ladder) {
    if (n < own) rows.push_back(n);
  }
  rows.push_back(own);
  return rows;
}

variable_mass::Start solitary_start(const exact::SolitaryWave& wave, double crest) {
  const auto elevation = [&wave, crest](double x) { return wave.elevation(x - crest); };
  return {.elevation = elevation, .velocity = [&wave, crest, elevation](Point place) {
            // A surface node may be above the exact surface by its rounding.
            const double y = std::min(place.y, elevation(place.x));
            const auto [u, v] = wave.velocity(place.x - crest, y);
            return Point{u, v};
          }};
}

CurveCrest SurfaceLine::highest(double from, double to) const {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  CurveCrest top{nan, nan};
  for (const CurveCrest& one : crests(-std::numeric_limits<double>::infinity(), from, to)) {
    if (!(one.height <= top.height)) top = one;
  }
  return top;
}

std::vector<CurveCrest> SurfaceLine::crests(double threshold, double from, double to) const {
  std::vector<CurveCrest> found = crests_above(threshold, x, y);
  std::erase_if(found, [&](const CurveCrest& one) { return !(one.place >= from && one.place <= to); });
  return found;
}

std::vector<CurveCrest> SurfaceLine::waves(double threshold, double apart, double from, double to) const {
  std::vector<CurveCrest> found = crests(threshold, from, to);
  std::erase_if(found, [&](const CurveCrest& one) {
    const auto begin = std::lower_bound(x.begin(), x.end(), one.place - apart) - x.begin();
    const auto end = std::upper_bound(x.begin(), x.end(), one.place + apart) - x.begin();
    return std::any_of(y.begin() + begin, y.begin() + end, [&](double height) { return height > one.height; });
  });
  return found;
}

double SurfaceLine::smoothed_height(double place, double within) const {
  const auto begin = std::lower_bound(x.begin(), x.end(), place - within) - x.begin();
  const auto end = std::upper_bound(x.begin(), x.end(), place + within) - x.begin();
  Eigen::MatrixXd powers(end - begin, 3);
  Eigen::VectorXd heights(end - begin);
  for (auto k = begin; k < end; ++k) {
    const double s = (x[static_cast<std::size_t>(k)] - place) / within;
    powers.row(k - begin) << 1, s, s * s;
    heights[k - begin] = y[static_cast<std::size_t>(k)];
  }
  const Eigen::Vector3d c = powers.colPivHouseholderQr().solve(heights);
  return c[0] - c[1] * c[1] / (4 * c[2]);
}

SurfaceLine surface_line(const Flow& flow) {
  SurfaceLine line{.time = flow.time(), .x = {}, .y = {}};
  for (const int k : flow.control().surface().nodes()) {
    const Point r = flow.nodes()[k];
    line.x.push_back(r.x);
    line.y.push_back(r.y);
  }
  return line;
}

const SurfaceLine& SolitaryRun::at(double when) const {
  return *std::min_element(surfaces.begin(), surfaces.end(), [&](const SurfaceLine& a, const SurfaceLine& b) {
    return std::abs(a.time - when) < std::abs(b.time - when);
  });
}

SolitaryRun follow_solitary(Flow& flow, const free_lagrangian::Mesh& rest, long rows, double time, double tau,
                            double interval, const std::function<void(double)>& progress) {
  SolitaryRun run{.rows = rows, .nodes = static_cast<long>(rest.nodes())};
  const double still = free_lagrangian::potential_energy(rest.places(), rest.outline, flow.water().weight());
  const double kinetic = flow.kinetic_energy();
  const double energy = flow.energy();
  const double mass = flow.water().mass();
  const auto keep = [&] {
    run.surfaces.push_back(surface_line(flow));
    run.time.push_back(flow.time());
    run.kinetic.push_back(flow.kinetic_energy() / kinetic);
    run.potential.push_back((flow.potential_energy() - still) / kinetic);
    run.dissipated.push_back((flow.stabilisation_loss() - flow.drift_work()) / kinetic);
  };
  keep();
  Worst energies;
  Worst masses;
  const double begin = processor_seconds();
  const auto parts = static_cast<long>(std::ceil(time / interval));
  for (long part = 1; part <= parts; ++part) {
    march(flow, time * static_cast<double>(part) / static_cast<double>(parts), tau, [&] {
      energies.add((flow.energy() + flow.stabilisation_loss() - flow.drift_work() - energy) / kinetic);
      masses.add(flow.water().mass() - mass);
    });
    keep();
    if (progress) progress(static_cast<double>(part) / static_cast<double>(parts));
  }
  run.energy_defect = std::abs(energies.value());
  run.mass_defect = std::abs(masses.value());
  run.drift = flow.largest_drift() * static_cast<double>(rows * rows);
  run.steps = flow.steps();
  run.seconds = (processor_seconds() - begin) / static_cast<double>(run.steps);
  return run;
}

}  // namespace seiche::validation
