/// The subcommands of `seiche` and what the command line says to each; main.cpp alone reads the command line, and says
/// there what each option means. Each returns the exit status: 0 all as declared, 1 a check failed, 2 wrong usage or
/// input, 3 the run could not finish.
#pragma once

#include <algorithm>
#include <string>
#include <thread>
#include <vector>

#include "validation/case/runner.hpp"

namespace seiche::command {

struct ListOptions {
  bool json = false;
  bool published = false;
  bool scores = false;
  std::string claims;  ///< name of the case
  std::string tier;
  std::vector<std::string> settings;
  std::string ctest;
  std::string evidence;
  long most_seconds = 0;  ///< of the tests written to ctest; 0: each case's own limit
};
int list(const ListOptions& options);

struct RunOptions {
  std::vector<std::string> cases;
  std::string tier;
  std::string as;  ///< name of a published set
  std::vector<std::string> settings;
  std::string config;
  bool help_parameters = false;
  validation::RunOptions run = {.jobs = std::max(1U, std::thread::hardware_concurrency())};
};
int run(const RunOptions& options);

struct ReportOptions {
  std::string evidence = "evidence";
  std::string out;
  std::string pdf;
  bool with_data = false;
  unsigned jobs = std::max(1U, std::thread::hardware_concurrency());
};
int report(const ReportOptions& options);

struct ExactOptions {
  std::string name;
  std::vector<std::string> settings, points;
  std::string grid;
  std::string format = "csv";
  std::string out;
  bool integrals = false;
  bool self_test = false;
  std::string write;  ///< a solver, whose input is written
  std::string centres;
  std::string up = "z";
  std::vector<double> origin;  ///< where the solution's x = 0 and its height 0 are in the solver
  double width = 1;            ///< of a strip in plan, where the solution knows no y

  [[nodiscard]] double origin_x() const { return origin.empty() ? 0 : origin[0]; }
  [[nodiscard]] double origin_up() const { return origin.empty() ? 0 : origin[1]; }
};
int exact_command(const ExactOptions& options);

struct ScoreOptions {
  std::string name;
  std::vector<std::string> data;
  std::vector<std::string> files;  ///< without --data
  std::string solver = "yours";
  std::vector<std::string> map, uncertainty, settings;
  std::string config;
  std::string out = "evidence";
  std::string table;
  std::string format = "auto";
  std::string columns;              ///< separated by commas
  std::vector<std::string> gauges;  ///< "WG1=6,..."
  double cell = 0;                  ///< [m], 0: not said
  std::vector<double> sizes;        ///< of a ladder: so many files for each, [m]
  std::vector<double> seconds;      ///< none: not said; one, or one for each size
  long threads = 0;                 ///< 0: not said
  std::size_t repeats = 1;          ///< runs of one set-up: so many files for each
  bool template_only = false;
  bool resolving_power = false;
  std::string baseline;  ///< folder with earlier records
  bool bless = false;    ///< write this score there
  bool json = false;
};
int score(const ScoreOptions& options);

struct CompareOptions {
  std::string before;
  std::string after;  ///< folder, or with `record` the table; empty: the project's own
  double factor = 1.2;
  bool record = false;  ///< compare with the evidence of record
  bool whole = false;   ///< records of it that the folder has not count as changed
  std::string tier = "quick";
};
int compare(const CompareOptions& options);
int compare_with_record(const CompareOptions& options);

struct RecordOptions {
  std::string evidence = "evidence";
  std::string tier = "quick";
  std::string out;
};
int record(const RecordOptions& options);

}  // namespace seiche::command
