/// Readings of an experiment as one verdict, of others and of a model of our own alike: the multivariate metric of ASME
/// V&V 20.1-2024,
///
///     T = E^T V^-1 E,   E = computed - measured,   V = V_data + V_input + V_num,
///
/// against chi-square. One source of error is one term of rank one in V: the incident amplitude (input of each part
/// times what a common factor changes), the zero and calibration of a gauge (half of the variance of its readings in a
/// time series; the other half is of each reading by itself), the clock of a part's records. Numerical errors are taken
/// for independent, which lets the least through. Whether they leave anything to decide is asked of them as shared by a
/// part: otherwise thirty readings known to 30 % each would pass for ones known to 5 % together.
///
/// T has two parts, independent for a perfect solver: what one factor a_p for each part of the experiment explains,
/// a^T C^-1 a with as many degrees of freedom as there are parts with readings that a factor changes, and the rest.
/// Each must be within its quantile of sqrt(0.95), so both are in 95 % of draws; T alone would let through a factor 6
/// u_a away from 1 where n = 30 readings share an incident amplitude, and one factor of all readings would let through
/// a run-up as wrong as that beside thirty readings of gauges.
///
/// The misfit of a record has no sign and no covariance with others: it adds (misfit/u)^2, whose mean is 1, after the
/// computed record has been divided by the common factor that the incident amplitude explains. Where misfits alone are
/// judged, that factor is what leaves least of them and of itself, and a common factor is told as well as misfits, each
/// by itself, would tell it.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "validation/laboratory/experiment.hpp"

namespace seiche::validation::laboratory {

/// One reading with everything that judging it needs.
struct Question {
  Question(const Series& part, const Reading& reading, std::shared_ptr<const Measured> measured);

  Series part;
  Reading reading;
  std::shared_ptr<const Measured> measured;
  double expected = 0;
  double u_data = 0;  ///< standard uncertainty of the data
  double datum = 0;   ///< what of it is the gauge's zero and calibration, with its sign
  double size = 0;    ///< what a common factor of 1 + s changes, over s: nothing of times and places

  [[nodiscard]] std::string id() const;
  [[nodiscard]] std::string unit() const;
  /// What a computed record gives, divided by a factor. NaN where the part or the group is not there.
  [[nodiscard]] double answer(const Submitted& computed, double factor = 1) const;
  /// Standard, from what is stated of the columns; none where nothing is, or where it leaves no arrival.
  [[nodiscard]] std::optional<double> stated(const std::map<std::string, StatedUncertainty>& uncertainty) const;
  /// The same of that part of the window for which a record is there; none where no measured point is in it, or where
  /// the record has too few points in it for what could be read between them.
  [[nodiscard]] std::optional<Question> within(const SubmittedGroup& record) const;
};

/// @param calibration  those of what sets the model's input, which are shown, instead of those that are judged
std::vector<Question> questions(const Experiment& experiment, const Values& values, bool calibration = false);

/// The same with the zero of every record that has one and the clock of every part that has one set by its group,
/// or where that is missing by the first that was submitted; the shift is told to `shifts` by part.
Submitted on_the_clock(const Experiment& experiment, const Values& values, const Submitted& computed,
                       std::map<std::string, double>& shifts);

/// Standard uncertainties beside those of data and incident wave, per question.
struct Sources {
  std::vector<double> numerical = {};            ///< empty: none
  std::vector<std::vector<double>> shared = {};  ///< what each changes that readings have in common
};

/// What the metric says, as a common factor of all readings.
struct Metric {
  /// That which is as far beyond its uncertainty as the readings are: the common factor itself or what the rest of them
  /// amounts to, whichever is clearer.
  double difference = 0;
  double coverage = 0;                        ///< of the common factor, in standard uncertainties
  double data = 0, input = 0, numerical = 0;  ///< standard uncertainties of a common factor
  /// The largest numerical one of a part, were its errors common; infinite where a time or place is known neither to
  /// what decides nor as well as it was measured.
  double shared = 0;
  std::vector<double> scores = {};  ///< E/u, reading by reading

  /// The smallest common factor that is noticed.
  [[nodiscard]] double noticed() const;
  [[nodiscard]] bool passes() const { return difference <= noticed(); }
};

/// sqrt of the chi-square quantile of sqrt(0.95): 2.236 standard uncertainties where a factor changes one part alone,
/// 2.712 for two parts.
double coverage(const std::vector<Question>& all);

Metric metric(const std::vector<Question>& all, const Submitted& computed, const Sources& sources);

/// Numerical uncertainty of the difference, expanded. None where it decides nothing: where a numerical error of a
/// factor beyond the ceiling could hide, and explain the difference.
std::optional<double> numerical_uncertainty(const std::vector<Question>& all, const Submitted& computed,
                                            Sources sources, double ceiling);

evidence::Claim claim_of(const Experiment& experiment);
Uncertainty criterion_of(const Experiment& experiment, Amount data, Amount input, double coverage);

/// What the report's summary over experiments is made of: a row per reading.
/// @param numerical  standard, per question; NaN: not known
/// @param solver     whose they are
void show_readings(const std::vector<Question>& all, const Submitted& computed, const std::vector<double>& numerical,
                   const std::vector<double>& scores, const std::string& solver, evidence::Exhibit& exhibit);

/// Readings of what sets the input, beside what was measured.
void show_calibration(const Experiment& experiment, const Values& values, const Submitted& computed,
                      evidence::Exhibit& exhibit);

/// Judges a foreign result.
void judge(const Experiment& experiment, const Values& values, const Submitted& submitted, const SolverFacts& facts,
           evidence::Record& record);

}  // namespace seiche::validation::laboratory
