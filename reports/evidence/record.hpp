/// The record of one case: what was claimed, what was measured, what follows, and the arrays behind it.
#pragma once

#include <deque>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "reports/evidence/claim.hpp"
#include "reports/evidence/criterion.hpp"
#include "reports/evidence/figure.hpp"
#include "reports/evidence/provenance.hpp"
#include "reports/evidence/verdict.hpp"

namespace seiche::evidence {

using Scalar = std::variant<double, long, bool, std::string>;

/// The name without extension of a record's files: the case's name, the published set ("bore@bzz-fig-6") or else the
/// tier where it is not the quick one ("bore@full"), and the solver's where it is not ours ("bore.mine"). What one of
/// them found does not overwrite what another did.
std::string stem_of(const std::string& name, const std::string& set, const std::string& tier,
                    const std::string& solver);

/// A parameter as it was used.
struct ParameterValue {
  Scalar value;
  Scalar standard;  ///< the case's default
  std::string unit;
  std::string meaning;
};

/// The parameters with which a source computed what tiles of the atlas show.
struct PublishedSet {
  std::vector<std::string> tiles;
  std::string tier;  ///< in which it is run
  std::map<std::string, Scalar> values;
  std::map<std::string, std::string> origins;    ///< of each value: "stated", "chosen" or "different"
  std::map<std::string, std::string> different;  ///< the source's value of those that are different
  std::string differs;                           ///< where the method is not the source's, and why
  std::vector<std::string> contradicted;         ///< ids of claims whose declared failure proves the source wrong
  bool here = false;                             ///< the values are those of this record
};

struct JudgedClaim {
  Claim claim;
  Criterion criterion;
  Judgement judgement;
  std::optional<KnownFailure> known_failure = {};

  [[nodiscard]] Verdict declared() const { return known_failure ? Verdict::fail : Verdict::pass; }
  /// The declared verdict, and a declared failure of the declared size.
  [[nodiscard]] bool as_declared() const {
    return judgement.verdict == declared() && (!known_failure || known_failure->holds(judgement.measured));
  }
};

/// A claim that does not apply at the parameters of this run, and why.
struct ClaimLeftOut {
  Claim claim;
  std::string reason;
};

struct Table {
  std::string id;
  std::string title;
  std::string caption;
  std::vector<std::pair<std::string, std::string>> columns;  ///< name, unit
  std::vector<std::vector<std::variant<double, std::string>>> rows;
  std::vector<std::string> atlas;
};

/// An array that no figure shows but a reader may want.
struct Array {
  std::string name;
  std::string unit;
  std::string meaning;
  std::vector<double> values;
};

/// A spatial field at one time, for ParaView: points (x, z) with values at them.
struct Snapshot {
  struct Field {
    std::string name;
    std::string unit;
    std::vector<double> values;
  };
  double time = 0;
  std::vector<double> x;
  std::vector<double> z;  ///< height at which the points are shown: the surface elevation
  std::string unit;       ///< of x and z
  std::vector<Field> fields;
  bool joined = true;  ///< by a line in the order of the points; false: particles
};

/// What a run shows: numbers, arrays, figures, tables. No verdicts.
class Exhibit {
 public:
  /// Keeps a number that no claim may use.
  void measure(const std::string& quantity, double value) { measurements_[quantity] = value; }
  void array(Array array) { arrays_.push_back(std::move(array)); }
  void snapshot(Snapshot snapshot) { snapshots_.push_back(std::move(snapshot)); }
  /// Adds a figure or a table; the reference stays valid for the exhibit's life.
  Figure& figure(const std::string& id, const std::string& figure_title, const std::string& caption,
                 const std::vector<std::string>& tiles = {});
  Table& table(Table table);

  [[nodiscard]] const std::map<std::string, double>& measurements() const { return measurements_; }
  [[nodiscard]] const std::deque<Figure>& figures() const { return figures_; }
  [[nodiscard]] const std::deque<Table>& tables() const { return tables_; }
  [[nodiscard]] const std::vector<Array>& arrays() const { return arrays_; }
  [[nodiscard]] const std::vector<Snapshot>& snapshots() const { return snapshots_; }

 private:
  std::map<std::string, double> measurements_;
  std::deque<Figure> figures_;
  std::deque<Table> tables_;
  std::vector<Array> arrays_;
  std::vector<Snapshot> snapshots_;
};

class Record : public Exhibit {
 public:
  // Identity, set by whoever owns the record.
  std::string name;                 ///< case or check: [a-z0-9_]+, also the file's name
  std::string kind = "validation";  ///< or "verification"
  std::string group;                ///< phenomenon or room
  std::string tier = "quick";
  std::string solver = "seiche";
  std::string title;
  std::string source;
  std::string article;             ///< Markdown with $formulas$
  std::vector<std::string> atlas;  ///< tiles filled by the record as a whole
  std::map<std::string, ParameterValue> parameters;
  std::string set;                      ///< the published set that it ran with, where that is not the tier's defaults
  std::vector<PublishedSet> published;  ///< of the case
  double wall_time = 0;
  std::string fingerprint;  ///< of code, toolchain, tier and parameters: equal means it need not run again
  std::map<std::string, std::string> reference_data;  ///< path of every reference table read -> SHA-256
  std::string error;                                  ///< why the run did not finish; empty if it did

  /// Judges a measurement and keeps the result. A claim judged again under the same id keeps its worst verdict.
  Verdict check(const Claim& claim, const Measurement& measurement, const Criterion& criterion);
  Verdict check(const Claim& claim, const ObservedOrder& observed, const Order& criterion);
  /// The same for a claim that the method is known not to meet.
  Verdict known_failure(const Claim& claim, const Measurement& measurement, const Criterion& criterion,
                        const KnownFailure& failure);
  Verdict known_failure(const Claim& claim, const ObservedOrder& observed, const Order& criterion,
                        const KnownFailure& failure);
  /// Keeps a claim that was judged elsewhere, or could not be.
  Verdict keep(JudgedClaim judged);
  void leave_out(ClaimLeftOut claim) { left_out_.push_back(std::move(claim)); }

  [[nodiscard]] const std::vector<JudgedClaim>& claims() const { return claims_; }
  [[nodiscard]] const std::vector<ClaimLeftOut>& left_out() const { return left_out_; }

  /// The run finished and every claim came out as declared.
  [[nodiscard]] bool as_declared() const;
  [[nodiscard]] std::string stem() const { return stem_of(name, set, tier, solver); }

 private:
  std::vector<JudgedClaim> claims_;
  std::vector<ClaimLeftOut> left_out_;
};

}  // namespace seiche::evidence
