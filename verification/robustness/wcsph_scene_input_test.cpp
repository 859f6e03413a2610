// What the scenes of WCSPH, their paddles and the reading of their surfaces refuse, and how they say so.
#include <limits>
#include <string>
#include <vector>

#include "seiche/models/wcsph/scene.hpp"
#include "validation/instruments/particles/sph_free_surface.hpp"
#include "validation/instruments/particles/sph_front.hpp"
#include "verification/robustness/refusals.hpp"

namespace wcsph_scene_input_test {

using namespace seiche;
using namespace seiche::wcsph;
using namespace seiche::verification;

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

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

TEST_CASE("bad scenes are refused with name, value and range", "[robustness]") {
  Check check("wcsph_bad_scenes", "Bad scenes of WCSPH",
              "Dam break, tank, flume, periodic layer and patch with one thing wrong at a time.");
  Refusals refusals(check);
  const auto bad_dam = [&](const std::string& text, const std::vector<std::string>& words, auto change) {
    refusals.refused(text, words, [&] {
      DamBreak wrong = dam();
      Settings settings = water;
      change(wrong, settings);
      dam_break(wrong, settings);
    });
  };
  bad_dam("No spacing.", {"spacing", "= 0", "positive"}, [](DamBreak& d, Settings&) { d.spacing = 0; });
  bad_dam("A negative spacing.", {"spacing", "-0.05", "positive"}, [](DamBreak& d, Settings&) { d.spacing = -0.05; });
  bad_dam("A spacing that is not a number.", {"spacing", "nan"},
          [](DamBreak& d, Settings&) { d.spacing = not_a_number; });
  bad_dam("A column of no width.", {"width", "= 0", "positive"}, [](DamBreak& d, Settings&) { d.width = 0; });
  bad_dam("A column thinner than half a spacing.", {"width", "0.01", "at least 1"},
          [](DamBreak& d, Settings&) { d.width = 0.01; });
  bad_dam("A column wider than its tank.", {"width", "= 2.5", "1.95"}, [](DamBreak& d, Settings&) { d.width = 2.5; });
  bad_dam("A column higher than its walls.", {"height", "= 1.6", "1.5"},
          [](DamBreak& d, Settings&) { d.height = 1.6; });
  bad_dam("Water of a negative depth ahead.", {"water_ahead", "-0.1", "[0, 1]"},
          [](DamBreak& d, Settings&) { d.water_ahead = -0.1; });
  bad_dam("Water ahead that is higher than the column.", {"water_ahead", "= 1.2", "[0, 1]"},
          [](DamBreak& d, Settings&) { d.water_ahead = 1.2; });
  bad_dam("Water ahead thinner than half a spacing.", {"water_ahead", "0.01", "at least 1"},
          [](DamBreak& d, Settings&) { d.water_ahead = 0.01; });
  bad_dam("An endless tank.", {"tank_length", "inf"}, [](DamBreak& d, Settings&) { d.tank_length = infinity; });
  bad_dam("A spacing that would need more particles than there is memory.", {"1e+09"},
          [](DamBreak& d, Settings&) { d.spacing = 1e-7; });
  bad_dam("Walls without rows.", {"wall_rows", "= 0", "[1, 3]"}, [](DamBreak& d, Settings&) { d.wall_rows = 0; });
  bad_dam("Walls of four rows.", {"wall_rows", "= 4", "[1, 3]"}, [](DamBreak& d, Settings&) { d.wall_rows = 4; });
  bad_dam("Gravity upwards.", {"gravity", "-9.81"}, [](DamBreak&, Settings& s) { s.gravity = -9.81; });
  bad_dam("No speed of sound.", {"sound", "= 0", "positive"}, [](DamBreak&, Settings& s) { s.sound_speed = 0; });
  bad_dam("No density.", {"density", "= 0", "positive"}, [](DamBreak&, Settings& s) { s.density = 0; });
  bad_dam("An exponent below 1.", {"exponent", "0.5", "[1"}, [](DamBreak&, Settings& s) { s.exponent = 0.5; });
  bad_dam("Water so compressible that its weight more than doubles the base of Tait's law.", {"2"},
          [](DamBreak&, Settings& s) { s.sound_speed = 2; });

  refusals.refused("A tank without water.", {"depth", "= 0"},
                   [] { tank({.width = 1, .depth = 0, .spacing = 0.1}, water); });
  refusals.refused("Walls lower than the water.", {"wall_height", "0.2", "at least 5"},
                   [] { tank({.width = 1, .depth = 0.5, .wall_height = 0.2, .spacing = 0.1}, water); });

  const auto bad_flume = [&](const std::string& text, const std::vector<std::string>& words, auto change) {
    refusals.refused(text, words, [&] {
      Flume wrong = flap_flume();
      change(wrong);
      flume(wrong, water);
    });
  };
  bad_flume("A stroke longer than the flume.", {"stroke", "= 1.2", "[0, 1]"}, [](Flume& f) { f.stroke = 1.2; });
  bad_flume("A paddle that goes behind the end of its bottom.", {"stroke", "= 0.10", "[0, 0.08]"},
            [](Flume& f) { f.sweep = 0.04; });
  bad_flume("A stroke that is not a number.", {"stroke", "nan"}, [](Flume& f) { f.stroke = not_a_number; });
  bad_flume("A paddle without a frequency.", {"frequency", "= 0", "positive"}, [](Flume& f) { f.frequency = 0; });
  bad_flume("A hinge above the bottom.", {"hinge", "0.05"}, [](Flume& f) { f.hinge = 0.05; });
  bad_flume("A paddle lower than the water.", {"paddle_height", "0.1", "at least 10"},
            [](Flume& f) { f.paddle_height = 0.1; });
  bad_flume("A paddle without rows.", {"paddle_rows", "= 0", "[1, 3]"}, [](Flume& f) { f.paddle_rows = 0; });

  const auto bad_layer = [&](const std::string& text, const std::vector<std::string>& words, auto change) {
    refusals.refused(text, words, [&] {
      PeriodicLayer wrong = layer();
      change(wrong);
      periodic_layer(wrong, water);
    });
  };
  bad_layer("A period of no length.", {"period", "= 0", "positive"}, [](PeriodicLayer& l) { l.period = 0; });
  bad_layer("A period of two spacings.", {"period", "0.04", "at least 3"}, [](PeriodicLayer& l) { l.period = 0.04; });
  bad_layer("A layer of no depth.", {"depth", "-0.2", "positive"}, [](PeriodicLayer& l) { l.depth = -0.2; });
  bad_layer("A layer thinner than half a spacing.", {"depth", "at least 1"}, [](PeriodicLayer& l) { l.depth = 0.005; });
  bad_layer("A surface below the bottom.", {"elevation", "-0.3", "above -0.2"},
            [](PeriodicLayer& l) { l.elevation = [](double) { return -0.3; }; });
  bad_layer("A surface that is not a number.", {"elevation", "nan"},
            [](PeriodicLayer& l) { l.elevation = [](double) { return not_a_number; }; });

  refusals.refused("A patch without a radius.", {"radius", "= 0", "positive"}, [] { patch({.spacing = 0.1}, water); });
  refusals.refused("A patch in which no lattice point lies.", {"particles in the patch", "= 0"}, [] {
    patch({.inside = [](double, double) { return false; }, .box = {-1, 1, -1, 1}, .spacing = 0.1}, water);
  });
  refusals.refused("A lattice that does not exist.", {"hexagonal", "square", "body_centred"},
                   [] { lattice_named("hexagonal"); });
  refusals.refused("A wall that is no whole number of spacings.", {"2.5", "whole number"}, [] {
    wall(std::vector<Place>{{0, 0}, {0.25, 0}}, 0.1);
  });
}

TEST_CASE("the reading of surfaces refuses what has no answer", "[robustness]") {
  Check check("wcsph_bad_surfaces", "Bad questions about surfaces",
              "Volume fraction, contours, fronts with one thing wrong at a time.");
  Refusals refusals(check);
  const Scene scene = dam_break(dam(), water);
  const VolumeFraction fraction(scene.particles, 0.065);
  refusals.refused("No smoothing length.", {"smoothing_length", "= 0", "positive"},
                   [&] { VolumeFraction wrong(scene.particles, 0); });
  refusals.refused("A particle that is nowhere.", {"x of a fluid particle", "nan", "finite"}, [&] {
    Particles lost = scene.particles;
    lost.x[0] = not_a_number;
    VolumeFraction wrong(lost, 0.065);
  });
  refusals.refused("A particle that is lost far away.", {"supports wide", "1e+07"}, [&] {
    Particles lost = scene.particles;
    lost.x[0] = 1e12;
    VolumeFraction wrong(lost, 0.065);
  });
  refusals.refused("A grid without a step.", {"step", "= 0", "positive"}, [&] {
    free_surface(fraction, {0, 1, 0, 1}, 0);
  });
  refusals.refused("A box of no width.", {"width of the box", "= 0", "positive"}, [&] {
    free_surface(fraction, {1, 1, 0, 1}, 0.1);
  });
  refusals.refused("Values that do not fill their grid.", {"3 values", "2 x 2"}, [] {
    level_curves({.step = 1, .columns = 2, .rows = 2, .values = {0, 1, 2}}, 0.5);
  });
  refusals.refused("A strip of no width.", {"right - left", "= 0"},
                   [&] { column_height(scene.particles, 0.065, 0.3, 0.3); });
  CHECK_FALSE(fraction.elevation(7).has_value());
  CHECK_FALSE(fraction.mean_elevation(7, 8).has_value());
  CHECK(VolumeFraction(Particles{}, 0.1).at(0, 0) == 0);
}

}  // namespace wcsph_scene_input_test
