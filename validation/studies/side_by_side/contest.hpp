/// Several models on one problem: how far off each is, what it takes, what it keeps, and where it breaks.
///
/// A contender is started on a few resolutions, coarse to fine, one after another on one thread. Each is followed to
/// `end`, where its error is taken, and on to `last`, or until it breaks down: by seiche::Divergence, or by an error
/// beyond `useless`, with which it still goes on to `end`. A breakdown is a result with its cause. Processor time is
/// that of the start and of the way to `end`, without what is read off.
#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "reports/evidence/figure.hpp"
#include "validation/case/case.hpp"

namespace seiche::validation {

/// What is read off a model at one instant.
struct Sight {
  std::vector<double> off = {};  ///< of points of the surface from where they should be; empty: nothing to compare yet
  double energy = 0;             ///< kinetic and potential, of the water
  double momentum = std::numeric_limits<double>::quiet_NaN();  ///< magnitude; NaN where walls take it
};

/// A model on its way.
struct Racer {
  std::function<void(double time)> advance_to;
  std::function<Sight()> look;
  std::function<double()> momentum = {};  ///< along x, of the water between the walls; empty: nobody asks
};

struct Contender {
  std::string id, name;
  std::string size_of;  ///< "row height", "particle spacing"
  Role role = Role::computed;
  std::vector<long> resolutions;  ///< coarse to fine
  std::function<double(long)> size;
  std::function<Racer(long)> start;
  bool may_refuse = false;  ///< std::invalid_argument at the start is the result that it cannot compute the problem
};

struct Trial {
  double end = 1;   ///< at which errors are compared
  double last = 2;  ///< until which the models are followed
  long looks = 10;  ///< up to `last`, equally spaced
  double useless = 0.1;
  std::string useless_in_words;  ///< "its surface is off by a tenth of the radius"
  double energy_scale = 1;
  double momentum_scale = 1;
  double reference_uncertainty = 0;  ///< of the error
};

/// One resolution of a model.
struct Attempt {
  double size = 0;
  double error = 0;        ///< rms of what is off at `end`; NaN where it broke down before
  double uncertainty = 0;  ///< of the error: standard error of its points, and that of the reference
  double seconds = 0;      ///< of the processor
  double energy = 0;       ///< change from the beginning to `end`, over the scale
  double momentum = 0;     ///< the same of the momentum; NaN where walls take it
  double lasted = 0;
  double asked = 0;        ///< how long it was to last
  std::string cause = {};  ///< of the breakdown; empty: none

  [[nodiscard]] bool broke() const { return !cause.empty() && lasted < asked; }
};

struct Entry {
  std::string id, name, size_of;
  Role role = Role::computed;
  std::vector<Attempt> attempts;

  [[nodiscard]] const Attempt& finest() const { return attempts.back(); }
  [[nodiscard]] evidence::ObservedOrder order() const;
};

/// Of a problem's numbers: "depth", "amplitude", "sqrt(depth/g)".
struct Units {
  std::string size, error, time;
};

class Contest {
 public:
  Contest() = default;
  Contest(std::vector<Entry> entries, Trial trial) : entries_(std::move(entries)), trial_(std::move(trial)) {}

  [[nodiscard]] const std::vector<Entry>& entries() const { return entries_; }
  /// Throws std::logic_error for a name that no entry has.
  [[nodiscard]] const Entry& of(const std::string& id) const;

  /// The table "side_by_side", which the report's page of models reads, the figure "cost" and measurements.
  void show(evidence::Exhibit& exhibit, const Units& units) const;

 private:
  std::vector<Entry> entries_;
  Trial trial_;
};

/// Throws std::invalid_argument where the models are compared later than they are followed.
Contest contest(const Run& run, const std::vector<Contender>& contenders, const Trial& trial);

/// Resolutions up to the finest, in parts of it.
std::vector<long> ladder_to(long finest, const std::vector<double>& parts);

/// Claims about an entry.
Claims<Entry> claims_of(const Claims<Contest>& claims, const std::string& id);

double error_of_finest(const Entry& entry);
double energy_of_finest(const Entry& entry);

/// A model, and what sentences call it.
struct Named {
  std::string id, name;
};
/// "<id>-lasts": on its finest resolution it is followed to the end.
void claim_lasts(const Claims<Entry>& claims, const Named& model, double last, const std::string& source);
/// "<id>-breaks": on one of its resolutions it is not. @param reason  known beforehand
void claim_breaks(const Claims<Entry>& claims, const Named& model, const std::string& reason,
                  const std::string& source);
/// "<id>-dissipates": its energy falls on every resolution. @param reason  known beforehand
void claim_dissipates(const Claims<Entry>& claims, const Named& model, const std::string& reason,
                      const std::string& source);
/// "<id>-energy": changed by round-off. @param operations  roundings of a number of the size `scale`
void claim_energy(const Claims<Entry>& claims, const Named& model, double operations, double scale,
                  const std::string& reason, const std::string& source);

}  // namespace seiche::validation
