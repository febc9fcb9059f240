// SPDX-License-Identifier: MIT
#include "engine/scheduling/weighted_metric.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace impetus::inline scheduling {
namespace {

[[noreturn]] void refuse_weights(const std::string& expected, const std::string& got) {
  throw std::invalid_argument("weighted scheduler: expected " + expected + ", got " + got);
}

void check(const WeightedTerm& term) {
  const std::string of = " for \"" + term.metric + "\"";
  if (term.metric == "weighted") {
    refuse_weights("terms that are no sums themselves", "\"weighted\"");
  }
  if (!(term.weight > 0.0) || !std::isfinite(term.weight)) {
    refuse_weights("a weight above 0" + of, std::to_string(term.weight));
  }
  if (!std::isfinite(term.urgent) || !std::isfinite(term.relaxed) || term.urgent == term.relaxed) {
    refuse_weights("two different finite ends, urgent and relaxed," + of,
                   std::to_string(term.urgent) + " and " + std::to_string(term.relaxed));
  }
}

/// 0 for what is not a number, which a measure at the eye itself may be.
double brought_to_unit(double measured, double relaxed, double urgent) {
  const double share = (measured - relaxed) / (urgent - relaxed);
  return share > 0.0 ? std::min(share, 1.0) : 0.0;
}

}  // namespace

WeightedMetric::WeightedMetric(const MetricOptions& options) : PriorityMetric(Urgent::kLarge) {
  if (options.terms.empty()) {
    refuse_weights("at least one term", "none");
  }
  for (const WeightedTerm& term : options.terms) {
    check(term);
    MetricOptions own;
    own.noticing = options.noticing;
    if (takes_point(term.metric)) {
      own.point = options.point;
    }
    terms_.push_back({make_metric(term.metric, own), term.weight, term.urgent, term.relaxed});
  }
  if (options.point && std::none_of(options.terms.begin(), options.terms.end(),
                                    [](const WeightedTerm& t) { return takes_point(t.metric); })) {
    refuse_weights("no point, which none of its terms has a use for", "one");
  }
}

unsigned WeightedMetric::terms() const {
  unsigned all = 0;
  for (const Term& term : terms_) {
    all |= term.metric->terms();
  }
  return all;
}

double WeightedMetric::measure(const PairBounds& bounds, const Viewer& viewer,
                               const Fixation& fixation) const {
  double sum = 0.0;
  for (const Term& term : terms_) {
    const double measured = term.metric->measure(bounds, viewer, fixation);
    sum += term.weight * brought_to_unit(measured, term.relaxed, term.urgent);
  }
  return sum;
}

}  // namespace impetus::inline scheduling
