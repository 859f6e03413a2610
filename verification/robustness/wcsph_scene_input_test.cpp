// What the scenes of WCSPH, their paddles and the reading of their surfaces refuse, and how they say so.
#include <string>
#include <vector>

#include "seiche/models/wcsph/scene.hpp"
#include "validation/instruments/particles/sph_free_surface.hpp"
#include "validation/instruments/particles/sph_front.hpp"
#include "verification/robustness/refusals.hpp"

namespace seiche::verification::wcsph_scene_input_test {

using namespace wcsph;

DamBreak dam() {
  return {.width = 0.5, .height = 1, .tank_length = 2, .wall_height = 1.5, .spacing = 0.05};
}

Flume flap_flume() {
  return {.length = 1, .depth = 0.2, .stroke = 0.1, .frequency = 6, .spacing = 0.02};
}

PeriodicLayer layer() {
  return {.period = 1, .depth = 0.2, .spacing = 0.02};
}

const Settings water{.sound_speed = 50};

TEST_CASE("bad scenes are rejected with name, value and range", "[robustness]") {
  Check check("wcsph_bad_scenes", "Bad scenes of WCSPH",
              "Dam break, tank, flume, periodic layer and patch with one error at a time.");
  Refusals refusals(check);
  const auto bad_dam = [&](const std::vector<std::string>& words, auto change) {
    refusals.refused(words, [&] {
      DamBreak wrong = dam();
      Settings settings = water;
      change(wrong, settings);
      dam_break(wrong, settings);
    });
  };
  bad_dam({"spacing", "= 0", "positive"}, [](DamBreak& d, Settings&) { d.spacing = 0; });
  bad_dam({"spacing", "-0.05", "positive"}, [](DamBreak& d, Settings&) { d.spacing = -0.05; });
  bad_dam({"spacing", "nan"}, [](DamBreak& d, Settings&) { d.spacing = not_a_number; });
  bad_dam({"width", "= 0", "positive"}, [](DamBreak& d, Settings&) { d.width = 0; });
  bad_dam({"width", "0.01", "at least 1"}, [](DamBreak& d, Settings&) { d.width = 0.01; });
  bad_dam({"width", "= 2.5", "1.95"}, [](DamBreak& d, Settings&) { d.width = 2.5; });
  bad_dam({"height", "= 1.6", "1.5"}, [](DamBreak& d, Settings&) { d.height = 1.6; });
  bad_dam({"water_ahead", "-0.1", "[0, 1]"}, [](DamBreak& d, Settings&) { d.water_ahead = -0.1; });
  bad_dam({"water_ahead", "= 1.2", "[0, 1]"}, [](DamBreak& d, Settings&) { d.water_ahead = 1.2; });
  bad_dam({"water_ahead", "0.01", "at least 1"}, [](DamBreak& d, Settings&) { d.water_ahead = 0.01; });
  bad_dam({"tank_length", "inf"}, [](DamBreak& d, Settings&) { d.tank_length = infinity; });
  bad_dam({"1e+09"}, [](DamBreak& d, Settings&) { d.spacing = 1e-7; });
  bad_dam({"wall_rows", "= 0", "[1, 3]"}, [](DamBreak& d, Settings&) { d.wall_rows = 0; });
  bad_dam({"wall_rows", "= 4", "[1, 3]"}, [](DamBreak& d, Settings&) { d.wall_rows = 4; });
  bad_dam({"gravity", "-9.81"}, [](DamBreak&, Settings& s) { s.gravity = -9.81; });
  bad_dam({"sound", "= 0", "positive"}, [](DamBreak&, Settings& s) { s.sound_speed = 0; });
  bad_dam({"density", "= 0", "positive"}, [](DamBreak&, Settings& s) { s.density = 0; });
  bad_dam({"2"}, [](DamBreak&, Settings& s) { s.sound_speed = 2; });

  refusals.refused({"depth", "= 0"}, [] { tank({.width = 1, .depth = 0, .spacing = 0.1}, water); });
  refusals.refused({"wall_height", "0.2", "at least 5"},
                   [] { tank({.width = 1, .depth = 0.5, .wall_height = 0.2, .spacing = 0.1}, water); });

  const auto bad_flume = refusals.of(flap_flume(), [](const Flume& wrong) { flume(wrong, water); });
  bad_flume({"stroke", "= 1.2", "[0, 1]"}, [](Flume& f) { f.stroke = 1.2; });
  bad_flume({"stroke", "nan"}, [](Flume& f) { f.stroke = not_a_number; });
  bad_flume({"frequency", "= 0", "positive"}, [](Flume& f) { f.frequency = 0; });
  bad_flume({"paddle_height", "0.1", "at least 10"}, [](Flume& f) { f.paddle_height = 0.1; });
  bad_flume({"paddle_rows", "= 0", "[1, 3]"}, [](Flume& f) { f.paddle_rows = 0; });

  const auto bad_layer = refusals.of(layer(), [](const PeriodicLayer& wrong) { periodic_layer(wrong, water); });
  bad_layer({"period", "= 0", "positive"}, [](PeriodicLayer& l) { l.period = 0; });
  bad_layer({"period", "0.04", "at least 3"}, [](PeriodicLayer& l) { l.period = 0.04; });
  bad_layer({"depth", "-0.2", "positive"}, [](PeriodicLayer& l) { l.depth = -0.2; });
  bad_layer({"depth", "at least 1"}, [](PeriodicLayer& l) { l.depth = 0.005; });
  bad_layer({"elevation", "-0.3", "above -0.2"}, [](PeriodicLayer& l) { l.elevation = [](double) { return -0.3; }; });
  bad_layer({"elevation", "nan"}, [](PeriodicLayer& l) { l.elevation = [](double) { return not_a_number; }; });

  refusals.refused({"radius", "= 0", "positive"}, [] { patch({.spacing = 0.1}, water); });
  refusals.refused({"particles in the patch", "= 0"}, [] {
    patch({.inside = [](double, double) { return false; }, .box = {-1, 1, -1, 1}, .spacing = 0.1}, water);
  });
  refusals.refused({"hexagonal", "square", "body_centred"}, [] { lattice_named("hexagonal"); });
  refusals.refused({"2.5", "whole number"}, [] { wall(std::vector<Place>{{0, 0}, {0.25, 0}}, 0.1); });
}

TEST_CASE("the reading of surfaces rejects undefined cases", "[robustness]") {
  Check check("wcsph_bad_surfaces", "Bad questions about surfaces",
              "Volume fraction, contours, fronts with one error at a time.");
  Refusals refusals(check);
  const Scene scene = dam_break(dam(), water);
  const VolumeFraction fraction(scene.particles, 0.065);
  refusals.refused({"smoothing_length", "= 0", "positive"}, [&] { VolumeFraction wrong(scene.particles, 0); });
  refusals.refused({"x of a fluid particle", "nan", "finite"}, [&] {
    Particles lost = scene.particles;
    lost.x[0] = not_a_number;
    VolumeFraction wrong(lost, 0.065);
  });
  refusals.refused({"supports wide", "1e+07"}, [&] {
    Particles lost = scene.particles;
    lost.x[0] = 1e12;
    VolumeFraction wrong(lost, 0.065);
  });
  refusals.refused({"step", "= 0", "positive"}, [&] { free_surface(fraction, {0, 1, 0, 1}, 0); });
  refusals.refused({"width of the box", "= 0", "positive"}, [&] { free_surface(fraction, {1, 1, 0, 1}, 0.1); });
  refusals.refused({"3 values", "2 x 2"}, [] {
    level_curves({.step = 1, .columns = 2, .rows = 2, .values = {0, 1, 2}}, 0.5);
  });
  refusals.refused({"right - left", "= 0"}, [&] { column_height(scene.particles, 0.065, 0.3, 0.3); });
  CHECK_FALSE(fraction.elevation(7).has_value());
  CHECK_FALSE(fraction.mean_elevation(7, 8).has_value());
  CHECK(VolumeFraction(Particles{}, 0.1).at(0, 0) == 0);
}

}  // namespace seiche::verification::wcsph_scene_input_test
