#include "validation/instruments/plan/reflection_pattern.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/require.hpp"
#include "seiche/samples.hpp"
#include "validation/instruments/each.hpp"

namespace seiche::validation {
namespace {

constexpr std::size_t fewest_rows = 4;
constexpr ReflectionBands bands;

/// Value below which a fraction of the sorted values lies, between them linearly.
double quantile(const std::vector<double>& sorted, double fraction) {
  const double place = fraction * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return std::lerp(sorted[below], sorted[above], place - static_cast<double>(below));
}

evidence::Measurement median_height(const std::vector<Crest>& crests) {
  std::vector<double> heights = each(crests, &Crest::height);
  std::sort(heights.begin(), heights.end());
  return {.value = quantile(heights, 0.5),
          .uncertainty = 0.5 * (quantile(heights, 0.84) - quantile(heights, 0.16)),
          .resolution = fmt::format("{} rows", heights.size())};
}

StraightLine line_through(const std::vector<Crest>& crests) {
  return straight_line_of_curve(each(crests, &Crest::y), each(crests, &Crest::x));
}

struct Place {
  std::size_t column, row;
};

std::vector<Crest> refined(const SurfaceLattice& surface, const std::vector<Place>& places, double lean) {
  std::vector<Crest> crests;
  for (const Place& place : places) crests.push_back(refined_crest(surface, place.column, place.row, lean));
  return crests;
}

/// Crests at these nodes and the line through them, which says how they lean, which refines them.
struct Fitted {
  std::vector<Crest> crests;
  StraightLine line;
};
Fitted fitted(const SurfaceLattice& surface, const std::vector<Place>& places) {
  Fitted result{refined(surface, places, 0), {}};
  for (int pass = 0; pass < 2; ++pass) {
    result.line = line_through(result.crests);
    result.crests = refined(surface, places, result.line.slope);
  }
  result.line = line_through(result.crests);
  return result;
}

evidence::Measurement ratio(const evidence::Measurement& over, const evidence::Measurement& under) {
  const double value = over.value / under.value;
  return {.value = value,
          .uncertainty = std::abs(value) * std::hypot(over.half_width() / over.value, under.half_width() / under.value),
          .resolution = over.resolution};
}

/// Nodes of the front crests in the band, and of the reflected crests below it.
struct Found {
  std::vector<Place> incident, reflected;
};
Found find_crests(const SurfaceLattice& surface, double amplitude) {
  Found found;
  std::vector<std::pair<double, Place>> reflected;
  double height = 0;
  for (std::size_t i = 0; i <= surface.columns; ++i) height += surface.y[surface.node(i, surface.rows)];
  height /= static_cast<double>(surface.columns + 1);
  const double scale = std::sqrt(0.3 / amplitude);
  for (std::size_t j = 1; j <= surface.rows; ++j) {
    const std::vector<Crest> crests = row_crests(surface, j, bands.threshold * amplitude);
    if (crests.empty() || crests.front().y > bands.incident_to * height) continue;
    const Crest& front = crests.front();
    if (front.y >= bands.incident_from * height) found.incident.push_back({front.column, j});
    const Crest* highest = nullptr;
    for (const Crest& crest : crests) {
      const double behind = front.x - crest.x;
      if (behind < bands.nearest * scale || behind > bands.farthest * scale) continue;
      if (!(crest.height < bands.tallest * std::min(front.height, amplitude))) continue;
      if (!highest || crest.height > highest->height) highest = &crest;
    }
    if (highest) reflected.emplace_back(highest->height, Place{highest->column, j});
  }
  Largest tallest;
  for (const auto& [top, place] : reflected) tallest.add(top);
  for (const auto& [top, place] : reflected) {
    if (top >= bands.lowest * tallest.value()) found.reflected.push_back(place);
  }
  return found;
}

}  // namespace

evidence::Measurement ReflectionPattern::reflected_ratio() const {
  if (!reflected) throw std::logic_error("no reflected crest was found behind the front crests");
  return ratio(reflected->amplitude, incident_amplitude);
}

ReflectionPattern measured_reflection(const SurfaceLattice& surface, double amplitude) {
  require_complete(surface);
  require_positive("amplitude", amplitude);
  ReflectionPattern pattern;
  pattern.wall = wall_crest(surface, bands.wall * amplitude);
  const double finer = five_node_height(surface, pattern.wall, 0);
  pattern.wall_amplitude = {
      .value = pattern.wall.height, .uncertainty = std::abs(finer - pattern.wall.height), .resolution = {}};
  const Found found = find_crests(surface, amplitude);
  if (found.incident.size() < fewest_rows) {
    throw std::runtime_error(fmt::format(
        "{} rows between {:g} and {:g} of the grid's height have a crest: at least {} are needed for the incident wave",
        found.incident.size(), bands.incident_from, bands.incident_to, fewest_rows));
  }
  Fitted incident = fitted(surface, found.incident);
  pattern.incident_amplitude = median_height(incident.crests);
  pattern.incident_line = incident.line;
  pattern.incident_angle = incident.line.angle();
  pattern.incident = std::move(incident.crests);
  pattern.stem_length = pattern.incident_line.where(pattern.wall.x);
  if (found.reflected.size() >= fewest_rows) {
    Fitted reflected = fitted(surface, found.reflected);
    pattern.reflected = {.amplitude = median_height(reflected.crests),
                         .angle = reflected.line.angle(),
                         .line = reflected.line,
                         .crests = std::move(reflected.crests)};
  }
  return pattern;
}

}  // namespace seiche::validation
