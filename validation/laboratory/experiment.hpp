/// A laboratory experiment as a case: what was measured, how well, and what of it is judged.
///
/// An experiment is a list of parts, each a table of reference_data with readings (reading.hpp). What is asked of
/// others, how they are judged, and how a model of our own is judged where one computes it, follow from that; the
/// claims are the same. Every reading is a claim by uncertainty (ASME V&V 20-2009),
///
///     |computed - measured| <= 2 sqrt(u_data^2 + u_input^2 + u_num^2),
///
/// u_data from source.toml or from repeats in the table, u_input from what the incident wave is not known to.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "validation/case/case.hpp"
#include "validation/laboratory/reading.hpp"

namespace seiche::validation::laboratory {

/// Where the origin of time is not known: one shift, of at most `range`, is fitted at one group and used for all.
struct Clock {
  double group = 0;
  double range = 0;
  Window window = {};
};

struct Series {
  std::string name;   ///< of the wanted table
  std::string table;  ///< folder of reference_data
  WantedTable::Kind kind = WantedTable::Kind::series;
  std::optional<Column> group = {};
  std::vector<double> groups = {};  ///< those that count; empty: all
  Column abscissa;
  Column quantity;
  /// Columns of the table that hold it, where they are not called like the quantity. The mean of several is taken, and
  /// half of the distance between them is a standard uncertainty of it.
  std::vector<std::string> columns = {};
  std::map<std::string, double> rows = {};  ///< value of further columns in the rows that count
  std::string spread = {};                  ///< column with the standard uncertainty of each row
  std::vector<std::string> band = {};       ///< columns with the 2.5 and 97.5 % percentiles of repeats
  std::optional<Window> still = {};         ///< in which the quantity's mean is its zero
  double input = 0;                         ///< relative standard uncertainty of the incident wave
  std::string input_reason = {};
  double telling = 0;     ///< largest expanded uncertainty of a time or place that still decides
  double useful = 0.5;    ///< ... of everything else, over what is measured
  double origin = 0;      ///< what arrivals are counted from in the summary
  double highest = 1e30;  ///< abscissae beyond it do not count
  std::optional<Clock> clock = {};
  std::vector<Reading> readings;
  long alike = 0;  ///< pairs of neighbouring groups that the readings cannot tell apart
  std::string alike_reason = "every group has a record of its own";
};

struct Experiment {
  std::string source;  ///< citation
  std::vector<Series> parts;
  std::vector<std::string> files = {};  ///< of reference_data, which say the geometry and what drives the flow
  /// A model of our own. @param coarsening  how much coarser than the parameters say
  std::function<Submitted(const Run&, double coarsening)> compute = {};
  std::string model = {};                                     ///< its name
  std::map<std::string, evidence::KnownFailure> misses = {};  ///< of it, by the claim's id
  std::map<std::string, std::string> undecided = {};          ///< what its spacings cannot decide, and why
};

/// A part of kind scalars is one row of a table; its abscissa tells which and is not asked for.
///
/// Measured curves of a part, group by group. Values at the same place are repeats: their mean, with their standard
/// deviation for uncertainty.
std::vector<Measured> measured(const Series& part, const Values& values);

/// As tables that others are asked for.
std::vector<WantedTable> wanted(const Experiment& experiment, const Values& values);

}  // namespace seiche::validation::laboratory
