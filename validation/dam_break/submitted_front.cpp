#include "validation/dam_break/submitted_front.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/samples.hpp"
#include "validation/case/reference_case.hpp"
#include "validation/instruments/each.hpp"

namespace seiche::validation {
namespace {

/// Of the curve around T, as a front has many small steps [X per T].
double slope_at(Curve curve, double T) {
  constexpr double half = 0.1;
  const double from = std::max(T - half, curve.x.front());
  const double to = std::min(T + half, curve.x.back());
  return (linear_at(curve, to) - linear_at(curve, from)) / (to - from);
}

/// What counts of the published points, and how many do not, and why.
struct Counting {
  std::vector<std::size_t> used;
  std::string text;
};

Counting counting(Curve computed, const ColumnFront& data, double farthest) {
  const double latest = computed.x.back() + ShiftRange{}.lowest;
  const double earliest = known_from(computed);
  Counting count;
  std::size_t beyond = 0, later = 0, before = 0;
  for (std::size_t i = 0; i < data.T.size(); ++i) {
    if (data.X[i] > farthest) {
      ++beyond;
    } else if (data.T[i] > latest) {
      ++later;
    } else if (data.T[i] < earliest) {
      ++before;
    } else {
      count.used.push_back(i);
    }
  }
  count.text = fmt::format("{} of {} published points count", count.used.size(), data.T.size());
  if (beyond > 0) count.text += fmt::format(", {} lie beyond X/a = {:.3g}", beyond, farthest);
  if (later > 0) {
    count.text += fmt::format(", {} later than the front is known for every shift, T = {:.3g}", later, latest);
  }
  if (before > 0) count.text += fmt::format(", {} lie before it is known: begin at T = 0", before);
  return count;
}

}  // namespace

FrontFit front_fit(Curve computed, const ColumnFront& data, double farthest, std::optional<double> stated) {
  const Counting count = counting(computed, data, farthest);
  if (count.used.size() < 3) {
    throw std::invalid_argument(count.text + ": three are needed; scored_to says how far a front is scored");
  }
  FrontFit fit{.points = count.used.size()};
  // The normal matrix of shift and rate; a smooth problem, by Gauss and Newton.
  double ss = 0, sr = 0, rr = 0;
  std::vector<double> weighted_s, weighted_r;
  Mean variance;
  constexpr int iterations = 60;
  for (int k = 0; k < iterations; ++k) {
    ss = sr = rr = 0;
    weighted_s.clear();
    weighted_r.clear();
    variance = {};
    double s = 0, r = 0;  // right side
    for (const std::size_t i : count.used) {
      const double T = fit.rate * (data.T[i] - fit.shift);
      const double inside = std::clamp(T, computed.x.front(), computed.x.back());
      const double slope = slope_at(computed, inside);
      const double w = 1 / (std::pow(data.uncertainty, 2) + std::pow(slope * data.time_uncertainty, 2));
      const double by_shift = -fit.rate * slope;
      const double by_rate = (data.T[i] - fit.shift) * slope;
      const double left = data.X[i] - linear_at(computed, inside);
      ss += w * by_shift * by_shift;
      sr += w * by_shift * by_rate;
      rr += w * by_rate * by_rate;
      s += w * by_shift * left;
      r += w * by_rate * left;
      weighted_s.push_back(w * by_shift);
      weighted_r.push_back(w * by_rate);
      variance.add(1 / w);
    }
    fit.shift += (rr * s - sr * r) / (ss * rr - sr * sr);
    fit.rate += (ss * r - sr * s) / (ss * rr - sr * sr);
  }
  const double det = ss * rr - sr * sr;
  fit.shift_uncertainty = std::sqrt(rr / det);
  fit.rate_uncertainty = std::sqrt(ss / det);
  if (stated) {
    double largest_change = 0;
    for (std::size_t i = 0; i < weighted_s.size(); ++i) {
      largest_change += std::abs((ss * weighted_r[i] - sr * weighted_s[i]) / det);
    }
    fit.rate_numerical = largest_change * *stated;
  }
  fit.rms = shifted_front(computed, data.curve(), farthest).rms;
  fit.expected = std::sqrt(variance.value());
  return fit;
}

WantedTable wanted_front(const ColumnFront& data, double farthest) {
  std::vector<double> T{0}, X{1};
  // A digitisation may begin with the column at rest.
  for (std::size_t i = 0; i < data.T.size(); ++i) {
    if (data.T[i] <= 0) continue;
    T.push_back(data.T[i]);
    X.push_back(data.X[i]);
  }
  double shown = T.front();
  for (std::size_t i = 0; i < X.size(); ++i) {
    if (X[i] <= farthest) shown = T[i];
  }
  const double last = std::min(shown - ShiftRange{}.lowest, T.back());
  const std::vector<double> points = evenly(0, last, static_cast<int>(std::ceil(last / 0.05)) + 1);
  return {.name = "front",
          .kind = WantedTable::Kind::series,
          .abscissa = Column{"T", "1", data.tall ? "time t sqrt(2 g/a)" : "time t sqrt(g/a)"},
          .quantities = {{.column = {"X", "1", "front over the width a of the column, from its rear wall"},
                          .reference =
                              [T, X](Place place) {
                                return linear_at({T, X}, place.abscissa);
                              }}},
          .points = [points](double) { return points; },
          .reference_role = data.measured ? evidence::Role::data : evidence::Role::peer};
}

void judge_front(const ColumnFront& data, double farthest, double cell, const SubmittedGroup& front,
                 const SolverFacts& facts, evidence::Record& record) {
  const std::vector<double>& X = front.values.at("X");
  const Curve computed{front.abscissa, X};
  std::optional<double> stated;
  const auto add_stated = [&](const std::string& column, double size, double fastest) {
    const auto found = facts.uncertainty.find(column);
    if (found != facts.uncertainty.end()) stated = stated.value_or(0) + fastest * found->second.of(size);
  };
  add_stated("X", largest(data.X), 1);
  add_stated("T", data.T.back(), 2);  // no front of a column is faster: shallow water on a dry bed
  const FrontFit fit = front_fit(computed, data, farthest, stated);
  const std::string counted = counting(computed, data, farthest).text;
  record.measure("points", static_cast<double>(fit.points));
  record.measure("published_points", static_cast<double>(data.T.size()));
  record.measure("time_shift", fit.shift);
  record.measure("rate", fit.rate);
  record.measure("rms_as_it_stands", shifted_front(computed, data.curve(), farthest).raw_rms);
  record.measure("rms_shifted", fit.rms);

  using evidence::Bound;
  const auto times = [&](double factor) { return stated ? std::optional(factor * *fit.rate_numerical) : std::nullopt; };
  record.check(
      {"rate", "The speed of the front agrees with the published one.", "fitted rate of its time", "1", data.citation},
      {.value = fit.rate, .uncertainty = times(2), .resolution = counted},
      evidence::Uncertainty{.expected = 1,
                            .data = fit.rate_uncertainty,
                            .useful = 0.045,
                            .reason = "standard uncertainties of the points in T and X/a, through the fit of shift and "
                                      "rate; gravity 10 % too small gives 0.054, a front 5 % too fast 0.048"});
  record.check(
      {"shift",
       data.measured
           ? "The lag of the measured front is the delay of its release, 0 to 0.3 in T, within the 0.05 of its points."
           : "The time origins of both computations differ by at most 0.1 in T.",
       "shift of the time origin, in the unit of T", "1", data.citation},
      {.value = fit.shift, .resolution = counted},
      data.measured
          ? Bound{.limit = 0.2,
                  .reason =
                      "0 to 0.3, uncertain by 0.05 of the points: the melting time of the diaphragm is 0.1 to 0.3 in "
                      "the source, zero in a computed release. The shift is not free: the rate is scored beside it",
                  .expected = 0.15}
          : Bound{.limit = 0.1, .reason = "both columns are released instantaneously"});
  const auto n = static_cast<double>(fit.points);
  record.check({"rms", "The front position after one time shift agrees with the published points.",
                "rms difference of X/a", "1", data.citation},
               {.value = fit.rms, .resolution = counted},
               Bound{.limit = fit.expected * (1 + 2 / std::sqrt(2 * n)),
                     .reason = "root mean square of sqrt(u_X^2 + (X' u_T)^2) over the points, and two standard "
                               "deviations of such a mean of n, a part 1/sqrt(2n) of it each"});
  Largest reached, retreat;
  for (const double x : X) {
    reached.add(x);
    retreat.add(reached.value() - x);
  }
  record.check(
      {"advance", "The position of the front never falls back by more than one cell.", "largest retreat of X/a", "1",
       "water on a dry floor advances until it reaches a wall"},
      {.value = retreat.value(), .resolution = fmt::format("cells of {:.3g} a", cell)},
      Bound{.limit = evidence::Amount::at_most(cell, 0.1),
            .reason =
                "a front is known to one cell or particle; cells of more than a tenth of the column are inconclusive"});
  auto& panel = add_panel(record, "shifted", "Position of the front",
                          "Without a shift, and with the best fit of time shift and rate.",
                          {.x = data.tall ? "t sqrt(2g/a)" : "t sqrt(g/a)", .y = "X/a"});
  panel.line("as it stands", front.abscissa, X, evidence::Role::computed);
  panel.line(fmt::format("{:.2f} later, {:.3g} times as fast", fit.shift, fit.rate),
             each(front.abscissa, [&](double T) { return T / fit.rate + fit.shift; }), X, evidence::Role::peer);
  data.draw(panel);
}

}  // namespace seiche::validation
