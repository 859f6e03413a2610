// Waves that lose height or phase on their way are told, by any solver.
#include <cmath>
#include <functional>

#include "seiche/exact/stokes_wave.hpp"
#include "validation/case/registry.hpp"
#include "validation/scoring/diagnosis.hpp"
#include "verification/check.hpp"
#include "verification/evidence/says.hpp"
#include "verification/evidence/submissions.hpp"

namespace seiche::verification::attenuation_scores_test {

using namespace validation;

/// What the case of attenuation asks for in a tank of its kind, and its exact wave.
struct Tank {
  explicit Tank(const std::string& kind) : values(one.values(Tier::quick)) {
    values.set("tank", kind);
    wanted = one.submission.tables(values);
  }
  [[nodiscard]] exact::StokesWave wave() const {
    return exact::StokesWave(values.real("height") / 2, values.real("length"), 1, 1);
  }

  const Case& one = find_case("wave_attenuation");
  Values values;
  std::vector<WantedTable> wanted;
};

/// The exact wave, changed, at the centres of cells of a wavelength.
evidence::Record scored(const std::function<double(const exact::StokesWave&, double x, double t)>& eta) {
  const Tank tank("box");
  const exact::StokesWave wave = tank.wave();
  Submitted submitted;
  for (const double t : *tank.wanted.front().groups) {
    SubmittedGroup group{.value = t};
    constexpr int cells = 200;
    for (int k = 0; k < cells; ++k) {
      const double x = wave.wavelength() * (k + 0.5) / cells;
      group.abscissa.push_back(x);
      group.values["eta"].push_back(eta(wave, x, t));
    }
    submitted["surface"].push_back(group);
  }
  return verification::scored(tank.one, tank.values, tank.wanted, submitted, {.cell = 0.1, .seconds = 20});
}

/// The same at gauges along a flume, 37 times in a period.
evidence::Record scored_flume(double rate, double slow) {
  const Tank tank("flume");
  const exact::StokesWave wave = tank.wave();
  const double period = wave.wavelength() / wave.phase_speed();
  Submitted submitted;
  for (const double x : *tank.wanted.front().groups) {
    SubmittedGroup group{.value = x};
    for (int k = 0; k <= 4 * 37; ++k) {
      const double t = period * k / 37;
      group.abscissa.push_back(t);
      group.values["eta"].push_back(std::exp(-rate * x / wave.wavelength()) *
                                    wave.elevation((1 + slow) * x - wave.phase_speed() * t));
    }
    submitted["gauges"].push_back(group);
  }
  return verification::scored(tank.one, tank.values, tank.wanted, submitted);
}

TEST_CASE("the loss of height and the phase lag of a wave are reported per wavelength", "[evidence]") {
  Check check("attenuation_scores", "Waves that lose on their way",
              "The exact wave after every three quarters of a period, at the centres of 200 cells, with a known loss "
              "of height or phase.");
  const auto measured = [&](const std::string& text, const evidence::Record& record, const std::string& quantity,
                            double expected) {
    check.holds(text, {record.measurements().at(quantity)},
                Bound{1e-4, "straight lines between 200 points, the same for every period", expected});
  };
  const auto is = [&](const std::string& text, const evidence::Record& record, const std::string& claim,
                      const std::string& expected) { says(check, text, verdict_of(record, claim), expected); };
  const evidence::Record right = scored([](const auto& wave, double x, double t) { return wave.elevation(x, t); });
  measured("The decay read off the exact wave is zero.", right, "decay_per_wavelength", 0);
  measured("The phase lead read off the exact wave is zero.", right, "lead_per_wavelength", 0);
  measured("The number of cells over the height is measured.", right, "cells_per_height", 2);
  measured("The measured time is the time of one wavelength.", right, "seconds_per_wavelength", 20 / 9.75);
  is("The exact wave passes the attenuation score.", right, "decay", "pass");
  const auto dying = [](double rate) {
    return scored([rate](const auto& wave, double x, double t) {
      return wave.elevation(x, t) * std::exp(-rate * t * wave.phase_speed() / wave.wavelength());
    });
  };
  measured("The measured loss is 0.8 % per wavelength.", dying(0.008), "decay_per_wavelength", 0.008);
  is("A wave that loses 0.8 % of its height per wavelength fails the score.", dying(0.008), "decay", "fail");
  is("A wave that loses 0.3 % of its height per wavelength passes the score.", dying(0.003), "decay", "pass");
  is("A wave whose height grows fails the score.", dying(-0.008), "decay", "fail");
  // More than half a wavelength late at the end: the phase is followed from period to period.
  const evidence::Record slow =
      scored([](const auto& wave, double x, double t) { return wave.elevation(x - 0.92 * wave.phase_speed() * t); });
  measured("The measured lag of a wave with a celerity 8 % low is 0.08 wavelengths per wavelength.", slow,
           "lead_per_wavelength", -0.08);
  is("A wave that is 8 % too slow fails the score.", slow, "phase", "fail");
  const evidence::Record frozen = scored([](const auto& wave, double x, double) { return wave.elevation(x); });
  is("A stationary wave fails the score.", frozen, "phase", "fail");
  const evidence::Record back =
      scored([](const auto& wave, double x, double t) { return wave.elevation(x + wave.phase_speed() * t); });
  is("A wave that travels in the opposite direction fails the score.", back, "phase", "fail");

  measured("The measured loss of the exact wave in a flume is zero.", scored_flume(0, 0), "decay_per_wavelength", 0);
  measured("The loss in a flume is measured per wavelength travelled.", scored_flume(0.008, 0), "decay_per_wavelength",
           0.008);
  measured("The measured lag of waves 1 % too short is 0.01 wavelengths per wavelength.", scored_flume(0, 0.01),
           "lead_per_wavelength", -0.01);
  is("A wave that runs towards the wavemaker of a flume fails the score.", scored_flume(0, -2), "phase", "fail");

  // After three periods the surface is the same: one that is right but for rounding is not taken for another's.
  const Tank box("box");
  const double three = 4 * box.wanted.front().groups->front();
  const Submitted exact = submission(box.wanted, [&](const WantedQuantity& q, Place p) {
    return q.reference({p.group + three, p.abscissa});
  });
  check.holds("The diagnosis of a correct wave is empty.", {static_cast<double>(diagnosis(box.wanted, exact).size())},
              Bound{0, "nothing differs"});
}

}  // namespace seiche::verification::attenuation_scores_test
