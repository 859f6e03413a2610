// Detectors of breaking on shapes whose overhang, jet and cavity are known, filled with particles.
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "seiche/models/wcsph/scene.hpp"
#include "seiche/samples.hpp"
#include "validation/instruments/particles/sph_free_surface.hpp"
#include "verification/check.hpp"

namespace seiche::verification::wcsph_breaking_test {

using namespace wcsph;
using std::numbers::pi;

const Settings water{.sound_speed = 40};
constexpr double spacing = 0.01;

/// A cosine sheared by q/(A k): x = X + (q/k) cos kX. It turns over at q = 1; then x decreases between the phases
/// asin(1/q) and its supplement.
struct ShearedWave {
  double q;
  bool towards_right = true;
  static constexpr Box box{-0.5, 0.5, -0.4, 0.3};
  static constexpr double amplitude = 0.15;
  static constexpr double wavenumber = 2 * pi;

  [[nodiscard]] bool inside(double x, double z) const {
    const double shear = q / (amplitude * wavenumber) * (towards_right ? 1 : -1);
    return z < amplitude * std::cos(wavenumber * (x - shear * z));
  }
  [[nodiscard]] double overhang() const {
    if (q <= 1) return 0;
    const double phase = std::asin(1 / q);
    return (2 * q * std::cos(phase) - (pi - 2 * phase)) / wavenumber;
  }
  /// The crest is at x = q/k, the tip where x is largest; both for a wave towards +x.
  [[nodiscard]] Place tip() const {
    const double phase = std::asin(1 / q);
    const double x = (phase + q * std::cos(phase)) / wavenumber;
    return {towards_right ? x : -x, amplitude * std::cos(phase)};
  }
};

/// Water below z = 0 and a tongue that grows out of it along a half ring, over the top, down to an angle above the
/// level in front: with 0 it has landed and shuts off half a disc of air.
struct Tongue {
  double angle;
  bool towards_right = true;
  static constexpr Box box{-0.8, 0.8, -0.4, 0.6};
  static constexpr double inner = 0.25;
  static constexpr double outer = 0.4;

  [[nodiscard]] bool inside(double x, double z) const {
    const double forward = towards_right ? x : -x;
    const double r = std::hypot(x, z);
    return z < 0 || (r > inner && r < outer && std::atan2(z, forward) > angle);
  }
};

std::vector<Contour> contours_of(const std::function<bool(double, double)>& inside, const Box& box) {
  const double margin = 4 * spacing;
  const Scene scene =
      patch({.inside = inside, .box = {box.left - margin, box.right + margin, box.bottom, box.top}, .spacing = spacing},
            water);
  const Box window{box.left, box.right, box.bottom + margin, box.top + margin};
  return free_surface(VolumeFraction(scene.particles, 1.3 * spacing), window, spacing / 2);
}

/// Of a ShearedWave or a Tongue.
template <class Shape>
std::vector<Contour> contours_of(const Shape& shape) {
  return contours_of([shape](double x, double z) { return shape.inside(x, z); }, Shape::box);
}

TEST_CASE("a wave overturns when its front is past the vertical", "[geometry]") {
  Check check("wcsph_overturning", "Detector of overturning",
              "A cosine that is sheared more and more, to either side, as particles of spacing 1/100 of its length: "
              "overhang and tip against the curve's, and the time of overturning by the detector.");
  check.source("x = X + (q/k) cos kX: geometry of the curve");
  Largest overhang_error, tip_error;
  bool sides = true;
  Largest missed, false_alarm;
  std::vector<double> q_drawn, drawn, exact;
  for (const bool towards_right : {true, false}) {
    for (double q = 0; q < 3.01; q += 0.25) {
      const ShearedWave wave{q, towards_right};
      const std::vector<Contour> curves = contours_of(wave);
      REQUIRE(main_surface(curves) != nullptr);
      const Overhang found = overhang(*main_surface(curves));
      if (towards_right) {
        q_drawn.push_back(q);
        drawn.push_back(found.extent);
        exact.push_back(wave.overhang());
      }
      overhang_error.add(std::abs(found.extent - wave.overhang()) / spacing);
      const bool detected = overturns(curves, spacing);
      if (wave.overhang() == 0) false_alarm.add(detected ? 1 : 0);
      missed.add(detected ? 0 : wave.overhang() / spacing);
      if (wave.overhang() < 3 * spacing) continue;
      sides = sides && found.towards_right == towards_right;
      tip_error.add(std::abs(found.tip.x - wave.tip().x) / spacing);
    }
  }
  check.that("overhang", "The overhang agrees with the curve within 1.5 dx.", "largest error over dx",
             {overhang_error.value()},
             Bound{1.5,
                   "two extrema of x, each known to the contour's largest distance, 0.71 dx: whether a cell is water "
                   "is decided by its middle"});
  check.that("tip", "The tip of the jet agrees with the tip of the curve within 0.75 dx.",
             "largest error of its x over dx", {tip_error.value()}, Bound{0.75, "one such extremum, 0.71 dx"});
  check.that("side", "The direction in which it breaks is found.", "directions right", {sides ? 1.0 : 0.0},
             Qualitative{"overhang().towards_right", "the tip turns to the right, the hollow to the left"});
  check.that("no-alarm", "The number of single-valued waves reported as overturning is zero.", "false alarms",
             {false_alarm.value()},
             Qualitative{"overturns(curves, dx) at q <= 1", "noise of the contour is below dx", false});
  check.that("missed", "Every wave that overhangs by two and a half spacings is found.",
             "largest overhang that was not, over dx", {missed.value()},
             Bound{2.5, "the threshold dx and the error of the overhang, 1.5 dx"});
  auto& figure = check.figure("sheared", "Overturning of a sheared cosine",
                              "Left: the contour of the particles at q = 3. Right: overhang against the curve's.");
  const std::vector<Contour> last = contours_of(ShearedWave{3});
  auto& shape = figure.panel({.x = "x [m]", .y = "z [m]", .equal_aspect = true});
  std::vector<double> curve_x, curve_z;
  for (double phase = -4.6; phase <= 4.6; phase += 0.02) {
    const double x = (phase + 3 * std::cos(phase)) / ShearedWave::wavenumber;
    if (std::abs(x) > 0.5) continue;
    curve_x.push_back(x);
    curve_z.push_back(ShearedWave::amplitude * std::cos(phase));
  }
  shape.points("curve", curve_x, curve_z, evidence::Role::exact);
  shape.line("from the particles", last.front().x, last.front().z);
  auto& growth = figure.panel({.x = "q", .y = "overhang [m]"});
  growth.line("curve", q_drawn, exact, evidence::Role::exact);
  growth.points("from the particles", q_drawn, drawn);
}

TEST_CASE("a jet has landed when it encloses air", "[geometry]") {
  Check check("wcsph_touch_down", "Detector of touching down",
              "A tongue of water grows along a half ring over the level and lands; to either side; and air enclosed by "
              "a wall of the box. Compared are the detected time of landing and the area of enclosed air.");
  constexpr double hole = 4 * spacing * spacing;
  check.source("geometry of half a ring");
  const double half_disc = pi / 2 * Tongue::inner * Tongue::inner;
  Largest early;
  double late = 0;
  Worst cavity;
  Largest tip;
  for (const bool towards_right : {true, false}) {
    for (double gap = 0; gap < 12; gap += 0.5) {
      // The inner corner of the tongue is `gap` spacings above the level.
      const Tongue tongue{std::asin(gap * spacing / Tongue::inner), towards_right};
      const std::vector<Contour> curves = contours_of(tongue);
      const bool landed = touches_down(curves, hole);
      early.add(landed ? gap : 0);
      if (!landed && gap == 0) late = 1;
      if (gap == 0) cavity.add(cavity_area(curves, hole) / half_disc - 1);
      if (landed) continue;
      const Overhang found = overhang(*main_surface(curves));
      const double forward = found.tip.x * (towards_right ? 1 : -1);
      tip.add(std::abs(forward - Tongue::outer * std::cos(tongue.angle)) / spacing);
      CHECK(found.towards_right == towards_right);
    }
  }
  check.that("landed", "The air under a tongue that has reached the level is enclosed.", "missed", {late},
             Qualitative{"touches_down(curves, 4 dx^2)", "water touches water", false});
  check.that("not-early", "The widest gap that is called closed is at most 2.6 dx, the support of the kernel.",
             "widest gap said to be closed, over dx", {early.value()},
             Bound{2.6, "below 2h = 2.6 dx the weights of both sides overlap"});
  check.that("cavity", "The air enclosed is half a disc.", "relative error of the area", {cavity.value()},
             Bound{0.71 * spacing * (pi + 2) * Tongue::inner / half_disc,
                   "the contour's largest distance, 0.71 dx, all around"});
  check.that("tip", "The tip before impact agrees with the tongue within 1.5 dx.", "largest error of its x over dx",
             {tip.value()}, Bound{1.5, "a corner of 90 degrees is rounded over h, besides 0.71 dx"});

  // Air in a corner, under water that leans against the wall on the right; and water that lies in such a corner.
  const Box box{-0.5, 0.5, -0.4, 0.6};
  const auto pocket = [](double x, double z) { return z < 0.4 && std::hypot(x - 0.5, z + 0.36) > 0.3; };
  const double quarter = pi / 4 * 0.3 * 0.3;
  check.from("a quarter of a disc")
      .that("pocket",
            "The area of air in a corner of the box agrees with its quarter circle within 0.71 dx along the arc.",
            "area [m^2]", {cavity_area(contours_of(pocket, box), hole)},
            Bound{0.71 * spacing * pi / 2 * 0.3, "0.71 dx along the arc", quarter});
  const auto heap = [](double x, double z) { return std::hypot(x - 0.5, z + 0.36) < 0.3; };
  CHECK(cavity_area(contours_of(heap, box), hole) == 0);
  CHECK_FALSE(overturns({}, spacing));
  CHECK(main_surface({}) == nullptr);
}

}  // namespace seiche::verification::wcsph_breaking_test
