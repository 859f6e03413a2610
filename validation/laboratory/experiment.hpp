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

/// Where the origin of time is not known: one shift, of at most `range`, is found at one group and used for all: that
/// of the smallest misfit in the window, or what makes one reading as measured.
struct Clock {
  double group = 0;
  double range = 0;
  Window window = {};
  std::optional<Reading> by = {};

  [[nodiscard]] double lag(Curve computed, const Measured& measured) const;
};

struct Series {
  std::string name;   ///< of the wanted table
  std::string table;  ///< folder of reference_data
  WantedTable::Kind kind = WantedTable::Kind::series;
  std::optional<Column> group = {};
  std::vector<double> groups = {};  ///< those that count; empty: all
  Column abscissa;
  Column quantity;
  /// Columns of the table that hold it, where they are not called like the quantity. Of several the middle is taken: it
  /// may lie anywhere between them, which is a standard uncertainty of half of their distance over sqrt(3).
  std::vector<std::string> columns = {};
  std::map<std::string, double> rows = {};  ///< value of further columns in the rows that count
  std::string spread = {};                  ///< column with the standard uncertainty of each row
  std::vector<std::string> band = {};       ///< columns with the 2.5 and 97.5 % percentiles of repeats
  std::optional<Window> still = {};         ///< in which the quantity's mean is its zero
  double input = 0;                         ///< relative standard uncertainty of the incident wave
  std::string input_reason = {};
  double telling = 0;     ///< largest expanded uncertainty of a time, place or statistic that still decides
  double useful = 0.5;    ///< ... of everything else, over what is measured
  double origin = 0;      ///< what arrivals are counted from in the summary
  double highest = 1e30;  ///< abscissae beyond it do not count
  std::optional<Clock> clock = {};
  std::vector<Reading> readings;
  long alike = 0;  ///< pairs of neighbouring groups that the readings cannot tell apart
  std::string alike_reason = "every group has a record of its own";
};

/// Claims that are known to fail, or cannot be decided, and what is known of the cause: "cause unknown" where no
/// evidence is. How far each is off is in the evidence of record.
struct Cause {
  std::string reason;
  std::vector<std::string> claims;  ///< by id
};

struct Experiment {
  std::string source;  ///< citation
  std::vector<Series> parts;
  std::vector<std::string> files = {};  ///< of reference_data, which say the geometry and what drives the flow
  /// A model of our own. @param coarsening  how much coarser than the parameters say
  std::function<Submitted(const Run&, double coarsening)> compute = {};
  std::string model = {};  ///< its name
  /// Parameters of it that no source states, known to within this factor: what each changes is part of u_input.
  std::map<std::string, double> known_within = {};
  std::vector<Cause> misses = {};     ///< of it
  std::vector<Cause> undecided = {};  ///< what its spacings cannot decide
};

/// A part of kind scalars is one row of a table; its abscissa tells which and is not asked for.
///
/// Measured curves of a part, group by group. Values at the same place are repeats: their mean, with their standard
/// deviation for uncertainty.
std::vector<Measured> measured(const Series& part, const Values& values);

/// As tables that others are asked for.
std::vector<WantedTable> wanted(const Experiment& experiment, const Values& values);

}  // namespace seiche::validation::laboratory
