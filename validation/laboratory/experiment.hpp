/// A laboratory experiment as a case: what was measured, how well, and what of it is judged.
///
/// An experiment is a list of parts, each a table of reference_data with readings (reading.hpp). What is asked of
/// others, how they are judged, and how a model of our own is judged where one computes it, follow from that. All
/// readings together are one claim by uncertainty (verdicts.hpp): u_data from source.toml or from repeats in the table,
/// u_input from what the incident wave is not known to.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "validation/case/case.hpp"
#include "validation/laboratory/reading.hpp"

namespace seiche::validation::laboratory {

/// Where the origin of time is not known: one shift, of at most `range`, is found at one group and used for all: that
/// of the smallest misfit in the window, or what makes one reading as measured.
struct Clock {
  double group = 0;
  double range = 0;
  Window window = {};
  std::optional<Reading> by = {};

  [[nodiscard]] double lag(Curve computed, const Measured& measured) const;
};

/// What was measured over one abscissa: records of gauges, unless it says otherwise.
struct Series {
  std::string name = "gauges";  ///< of the wanted table
  std::string table;            ///< folder of reference_data
  WantedTable::Kind kind = WantedTable::Kind::series;
  std::optional<Column> group = {};
  std::vector<double> groups = {};  ///< those that count; empty: all
  Column abscissa;
  Column quantity = {"eta", "m", "surface elevation"};
  /// Columns of the table that hold it, where they are not called like the quantity. Of several the middle is taken: it
  /// may lie anywhere between them, which is a standard uncertainty of half of their distance over sqrt(3).
  std::vector<std::string> columns = {};
  std::map<std::string, double> rows = {};  ///< value of further columns in the rows that count
  std::string spread = {};                  ///< column with the standard uncertainty of each row
  std::vector<std::string> band = {};       ///< columns with the 2.5 and 97.5 % percentiles of repeats
  std::optional<Window> still = {};         ///< in which the quantity's mean is its zero
  double input = 0;                         ///< relative standard uncertainty of the incident wave
  std::string input_reason = {};
  double telling = 1e30;  ///< largest expanded uncertainty of a computed time or place that still decides
  double origin = 0;      ///< what arrivals are counted from in the summary
  double highest = 1e30;  ///< abscissae beyond it do not count
  std::optional<Clock> clock = {};
  /// Groups that set the model's input: but for misfits, what is read there is shown, and no claim.
  std::vector<double> calibrating = {};
  std::vector<Reading> readings = {};

  void read(std::initializer_list<Reading> more) { readings.insert(readings.end(), more); }
};

struct Experiment {
  std::string source;  ///< citation
  std::vector<Series> parts;
  std::vector<std::string> files = {};  ///< of reference_data, which say the geometry and what drives the flow
  /// Largest common factor, less 1, that may go unnoticed: a result is inconclusive where its uncertainty hides more.
  double ceiling = 0.2;
  std::string ceiling_reason = "an error of 20 % is unacceptable for any use of such a measurement";
  /// A model of our own. @param coarsening  how much coarser than the parameters say
  std::function<Submitted(const Run&, double coarsening)> compute = {};
  std::string model = {};                       ///< its name
  double order = 2;                             ///< theoretical, of its convergence
  std::vector<double> coarsenings = {1, 2, 4};  ///< with which it is computed: two, or three for an observed order
  /// Why it is known to fail, or "cause unknown" and what would tell; empty where it passes.
  std::string miss = {};
};

/// A part of kind scalars is one row of a table; its abscissa tells which and is not asked for.
///
/// Measured curves of a part, group by group. Values at the same place are repeats: their mean, with their standard
/// deviation for uncertainty.
std::vector<Measured> measured(const Series& part, const Values& values);

/// Takes the mean of y where x is in the window off y; nothing where no x is.
void set_zero(const std::vector<double>& x, std::vector<double>& y, Window still);

/// As tables that others are asked for.
std::vector<WantedTable> wanted(const Experiment& experiment, const Values& values);

}  // namespace seiche::validation::laboratory
