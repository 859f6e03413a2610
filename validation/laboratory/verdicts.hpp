/// Readings of an experiment as claims, judged for others and for a model of our own alike.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "validation/laboratory/experiment.hpp"

namespace seiche::validation::laboratory {

/// One reading with everything that judging it needs.
class Question {
 public:
  Question(std::string source, const Series& part, const Reading& reading, std::shared_ptr<const Measured> measured);

  [[nodiscard]] const Series& part() const { return part_; }
  [[nodiscard]] const Reading& reading() const { return reading_; }
  [[nodiscard]] double expected() const { return expected_; }
  [[nodiscard]] double data_uncertainty() const { return u_data_; }
  [[nodiscard]] double input_uncertainty() const { return u_input_; }
  /// Largest expanded uncertainty that still decides.
  [[nodiscard]] double useful() const { return useful_; }
  [[nodiscard]] evidence::Claim claim() const;
  [[nodiscard]] Uncertainty criterion() const;
  /// What a computed record gives. NaN where the part or the group is not there.
  [[nodiscard]] double answer(const Submitted& computed) const;
  /// Standard, from what is stated of the columns; none where nothing is.
  [[nodiscard]] std::optional<double> stated(const std::map<std::string, StatedUncertainty>& uncertainty) const;
  /// With an input uncertainty that the run tells.
  [[nodiscard]] Uncertainty criterion_of_run() const;
  /// A record that answers with no uncertainty of its own would pass.
  [[nodiscard]] bool passes(double answer) const;
  [[nodiscard]] const Measured& measured() const { return *measured_; }
  /// The same of that part of the window for which a record is there; none where no measured point is in it.
  [[nodiscard]] std::optional<Question> within(const SubmittedGroup& record) const;

 private:
  Series part_;
  Reading reading_;
  std::string source_;
  std::shared_ptr<const Measured> measured_;
  double expected_ = 0, u_data_ = 0, u_input_ = 0, useful_ = 0;
};

/// @param calibration  those of what sets the model's input, which are shown, instead of those that are judged
std::vector<Question> questions(const Experiment& experiment, const Values& values, bool calibration = false);

/// The same with the clock of every part that has one set by its group; the shift is told to `shifts` by part.
Submitted on_the_clock(const Experiment& experiment, const Values& values, const Submitted& computed,
                       std::map<std::string, double>& shifts);

/// What the report's summary over experiments is made of: a row per reading.
/// @param numerical  standard, per question; none: not known
/// @param solver     whose they are
void show_readings(const std::vector<Question>& all, const Submitted& computed,
                   const std::vector<std::optional<double>>& numerical, const std::string& solver,
                   evidence::Exhibit& exhibit);

/// Readings of what sets the input, beside what was measured.
void show_calibration(const Experiment& experiment, const Values& values, const Submitted& computed,
                      evidence::Exhibit& exhibit);

/// Judges a foreign result.
void judge(const Experiment& experiment, const Values& values, const Submitted& submitted, const SolverFacts& facts,
           evidence::Record& record);

}  // namespace seiche::validation::laboratory
