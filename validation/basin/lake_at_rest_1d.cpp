/*
Still water over any bathymetry is an equilibrium. A model may preserve it to truncation error, to round-off, or
exactly. The dispersive shallow-water model measures elevation from the still-water level, so that at rest every force,
multiplier and velocity is exactly zero.

**Set-up.** Two lakes with randomly spaced nodes. The first has a polygonal bed with corners at random positions inside
the cells, between a wall and a shoreline; the second a cosine bed, between walls and in a periodic channel. Each runs
until `time` with every scheme, with fourth-order compositions, and with both kinetic energies.

**What is compared.** Maximum velocity, elevation and displacement of any node at any step with zero, exactly.

**What to look at.** The figure: the amplitude of the bed's roughness is the parameter `roughness`.
*/
#include <memory>
#include <numbers>
#include <random>

#include <fmt/format.h>

#include "seiche/models/dispersive_shallow_water_1d/flow.hpp"
#include "seiche/samples.hpp"
#include "validation/case/case.hpp"
#include "validation/case/literature.hpp"
#include "validation/case/reference_case.hpp"
#include "validation/instruments/cosine_bottom.hpp"
#include "validation/instruments/each.hpp"

namespace seiche::validation::cases::lake_at_rest_1d {

namespace model = dispersive_shallow_water_1d;

constexpr double length = 20;

struct Random {
  std::minstd_rand engine;

  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine); }
};

/// Ascending places from `begin` to `end` whose distances vary by a factor of five about `mean`.
std::vector<double> random_places(Random& random, double begin, double end, double mean) {
  std::vector<double> places = {begin};
  while (places.back() + 1.8 * mean < end) places.push_back(places.back() + mean * random.between(1.0 / 3, 5.0 / 3));
  places.push_back(end);
  return places;
}

struct Lake {
  std::string id;
  std::string name;
  model::Channel channel;
  std::vector<double> markers;
};

Lake broken_lake(Random& random, double spacing, double roughness) {
  std::vector<double> knots = random_places(random, -length, -2, 0.7);
  std::vector<double> elevation;
  for (std::size_t k = 0; k < knots.size(); ++k) elevation.push_back(-1 + roughness * random.between(-1, 1));
  knots.insert(knots.end(), {0, 5});  // the shore is a knot, so that the tip is where the bottom is 0 exactly
  elevation.insert(elevation.end(), {0, 1});
  return {"broken",
          "polygonal bed, wall and shoreline",
          {.bottom = std::make_shared<PiecewiseLinearBottom>(knots, elevation), .right = model::End::tip},
          random_places(random, -length, 0, spacing)};
}

Lake smooth_lake(Random& random, double spacing, double roughness, bool periodic) {
  Lake lake{periodic ? "periodic" : "smooth",
            periodic ? "cosine bed, periodic" : "cosine bed, walls",
            {.bottom = std::make_shared<CosineBottom>(1, roughness, 6 * std::numbers::pi / length, 0.3)},
            random_places(random, -length, 0, spacing)};
  if (periodic) {
    lake.channel.period = length;
    lake.markers.pop_back();
  }
  return lake;
}

std::vector<Lake> lakes(const Values& values) {
  Random random{std::minstd_rand(static_cast<std::minstd_rand::result_type>(values.integer("seed")))};
  const double h = values.real("h");
  const double roughness = values.real("roughness");
  return {broken_lake(random, h, roughness), smooth_lake(random, h, roughness, false),
          smooth_lake(random, h, roughness, true)};
}

struct NamedScheme {
  std::string name;
  model::Scheme scheme;
};

std::vector<NamedScheme> schemes(const std::string& chosen) {
  std::vector<NamedScheme> result;
  for (const std::string stepping : {"one_step", "one_step_feedback", "conservative"}) {
    if (chosen != "all" && chosen != stepping) continue;
    for (const std::string composition : {"none", "triple_jump", "suzuki"}) {
      result.push_back(
          {composition == "none" ? stepping : fmt::format("{}, {}", stepping, composition),
           {.stepping = model::stepping_named(stepping), .composition = model::composition_named(composition)}});
    }
  }
  return result;
}

/// Largest values at any step.
struct Unrest {
  Worst velocity, elevation, displacement;
  long steps = 0;

  void include(const Unrest& other) {
    velocity.add(other.velocity);
    elevation.add(other.elevation);
    displacement.add(other.displacement);
    if (other.steps > steps) steps = other.steps;
  }
};

Unrest watch(const Lake& lake, model::Kinetics kinetics, const model::Scheme& scheme, double time, double tau) {
  model::Channel channel = lake.channel;
  channel.kinetics = kinetics;
  model::Flow flow(channel, model::still_markers(channel, lake.markers), scheme);
  Unrest unrest;
  march(flow, time, stable_steps(flow, tau), [&] {
    unrest.velocity.add(worst(flow.p()), flow.time());
    unrest.velocity.add(worst(flow.r()), flow.time());
    unrest.elevation.add(worst(flow.y()), flow.time());
    for (std::size_t i = 0; i < lake.markers.size(); ++i) {
      unrest.displacement.add(flow.x()[i] - lake.markers[i], flow.time());
    }
  });
  unrest.steps = flow.steps();
  return unrest;
}

struct OfLake {
  std::size_t markers = 0;
  std::vector<Unrest> by_scheme;

  [[nodiscard]] Unrest largest() const {
    Unrest all;
    for (const Unrest& unrest : by_scheme) all.include(unrest);
    return all;
  }
  [[nodiscard]] std::string resolution() const { return fmt::format("{} nodes, {} steps", markers, largest().steps); }
};

void claims(const Values& values, const Claims<std::vector<OfLake>>& claims) {
  const std::vector<Lake> all = lakes(values);
  for (std::size_t k = 0; k < all.size(); ++k) {
    const auto of = claims.entry(k).at(&OfLake::resolution).from("heights counted from the still-water level");
    const auto exactly_zero = [&](const std::string& id, const std::string& text, const std::string& quantity,
                                  Worst Unrest::*member) {
      of.check(
          all[k].id + "-" + id, fmt::format("{} ({}).", text, all[k].name), quantity,
          [member](const OfLake& lake) { return (lake.largest().*member).value(); },
          Bound{0, "every force is a product with an elevation, which is zero"});
    };
    exactly_zero("velocity", "Velocities of water at rest are zero", "largest rate [(g H)^(1/2)]", &Unrest::velocity);
    exactly_zero("elevation", "Elevations of water at rest are zero", "largest elevation [H]", &Unrest::elevation);
    exactly_zero("displacement", "Displacements of nodes in water at rest are zero", "largest displacement [H]",
                 &Unrest::displacement);
  }
}

std::vector<OfLake> compute(const Run& run) {
  const std::vector<Lake> all = lakes(run);
  const std::vector<NamedScheme> named = schemes(run.text("scheme"));
  const auto parts = static_cast<double>(all.size() * named.size());
  double done = 0;
  std::vector<OfLake> r;
  for (const Lake& lake : all) {
    OfLake& of = r.emplace_back();
    of.markers = lake.markers.size();
    for (const auto& [name, scheme] : named) {
      Unrest& unrest = of.by_scheme.emplace_back();
      for (const auto kinetics : {model::Kinetics::frank, model::Kinetics::green_naghdi}) {
        unrest.include(watch(lake, kinetics, scheme, run.real("time"), run.real("h") / 2));
      }
      run.progress(++done / parts);
    }
  }
  return r;
}

void show(const std::vector<OfLake>& r, const Values& values, evidence::Exhibit& exhibit) {
  const std::vector<Lake> all = lakes(values);
  const std::vector<NamedScheme> named = schemes(values.text("scheme"));
  evidence::Table& table =
      add_table(exhibit, "unrest", "Largest values at any step", "Over all nodes and both kinetic energies.",
                {"lake", "scheme", "steps [1]", "velocity [(g H)^(1/2)]", "elevation [H]", "displacement [H]"});
  auto& figure = exhibit.figure("lakes", "The lakes", "Beds, still water, and the surface nodes.");
  for (std::size_t k = 0; k < all.size(); ++k) {
    const Lake& lake = all[k];
    for (std::size_t j = 0; j < named.size(); ++j) {
      const Unrest& unrest = r[k].by_scheme[j];
      table.rows.push_back({lake.name, named[j].name, static_cast<double>(unrest.steps), unrest.velocity.value(),
                            unrest.elevation.value(), unrest.displacement.value()});
    }
    if (lake.channel.periodic()) continue;
    const std::vector<double> x = evenly(-length, lake.channel.right == model::End::tip ? 2 : 0, 881);
    const auto bed = each(x, [&](double at) { return lake.channel.bottom->elevation(at); });
    auto& panel = figure.panel({.x = "x", .y = "elevation", .title = lake.name});
    panel.fill("water", x, each(bed, [](double level) { return level > 0 ? level : 0.0; }), Role::water);
    panel.fill("bottom", x, bed, Role::bed);
    panel.points("markers", lake.markers, std::vector<double>(lake.markers.size(), 0.0), Role::computed);
  }
}

void lake_at_rest_1d(Case& c) {
  c.title = "Lake at rest under the dispersive model";
  c.source = literature::frank + ", chapter 3; E. Audusse et al., SIAM J. Sci. Comput. 25 (2004) 2050";
  c.parameters = {
      real("h", 0.25, "H", {0.02, 2}, "mean node spacing"),
      real("roughness", 0.8, "H", {0, 0.95}, "largest deviation of the bed from its mean depth 1"),
      integer("seed", 1L, {1, 1e9}, "of the random bed and nodes"),
      real("time", {100, 1000, 10000}, "(H/g)^(1/2)", {1, 1e6}, "length of the run"),
      choice("scheme", "all", {"all", "one_step", "one_step_feedback", "conservative"},
             "stepping, alone and in compositions"),
  };
  c.study = Study(claims, compute, show);
}

}  // namespace seiche::validation::cases::lake_at_rest_1d
