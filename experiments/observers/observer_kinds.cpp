// SPDX-License-Identifier: MIT
#include "experiments/observers/observer_kinds.hpp"

#include <algorithm>
#include <cmath>

#include "experiments/settings/schema_sentences.hpp"

namespace impetus::inline observers {

using nlohmann::json;
using DeclaredObserver = const ObserverKind&();
DeclaredObserver causality_observer, gap_observer, gap_thresholds_observer, gaze_observer,
    response_observer;

const std::vector<std::reference_wrapper<const ObserverKind>>& observer_kinds() {
  static const std::vector<std::reference_wrapper<const ObserverKind>> kinds{
      causality_observer(), gap_observer(), gap_thresholds_observer(), gaze_observer(),
      response_observer()};
  return kinds;
}

namespace {

double logistic(double x) { return 1.0 / (1.0 + std::exp(-x)); }

constexpr int kMostPoints = 9;  ///< of a protocol's scale

/// "cut_1_2" is the first: between the best point of the scale and the next.
std::string cut_name(std::size_t number) {
  return "cut_" + std::to_string(number) + "_" + std::to_string(number + 1);
}

/// The cuts that the file has, from the first without a gap; at least one is asked for.
std::vector<std::string> cut_names(const json& document) {
  std::vector<std::string> names{cut_name(1)};
  while (names.size() + 1 < kMostPoints && document.contains("parameters") &&
         document["parameters"].contains(cut_name(names.size() + 1))) {
    names.push_back(cut_name(names.size() + 1));
  }
  return names;
}

json number_schema(double minimum, double maximum) {
  return {{"type", "object"},
          {"additionalProperties", false},
          {"required", {"value", "unit", "source"}},
          {"properties",
           {{"value", {{"type", "number"}, {"minimum", minimum}, {"maximum", maximum}}},
            {"unit", {{"type", "string"}}},
            {"source", {{"type", "string"}, {"minLength", 1}}},
            {"note", {{"type", "string"}}}}}};
}

json observer_schema(const std::vector<ParameterEntry>& entries,
                     const std::vector<std::string>& cuts) {
  json parameters{{"type", "object"}, {"additionalProperties", false}};
  for (const ParameterEntry& entry : entries) {
    parameters["properties"][entry.name] = number_schema(entry.minimum, entry.maximum);
    if (!entry.optional) {
      parameters["required"].push_back(entry.name);
    }
  }
  for (const std::string& cut : cuts) {
    parameters["properties"][cut] = number_schema(-kAny, kAny);
    parameters["required"].push_back(cut);
  }
  return {{"type", "object"},
          {"additionalProperties", false},
          {"required", {"schema_version", "observer", "parameters"}},
          {"properties",
           {{"schema_version", {{"const", 1}}},
            {"observer", {{"type", "string"}}},
            {"note", {{"type", "string"}}},
            {"parameters", parameters}}}};
}

}  // namespace

const ObserverKind& named_kind(const JsonDocument& document) {
  json names = json::array();
  for (const ObserverKind& kind : observer_kinds()) {
    names.push_back(kind.name);
  }
  require_schema(document, {{"type", "object"},
                            {"required", {"observer"}},
                            {"properties", {{"observer", {{"enum", names}}}}}});
  const auto name = document.value["observer"].get<std::string>();
  return *std::find_if(observer_kinds().begin(), observer_kinds().end(),
                       [&](const ObserverKind& kind) { return kind.name == name; });
}

void read_parameters(const JsonDocument& document, RatingParameters& rating,
                     std::vector<ParameterEntry> own) {
  const std::vector<ParameterEntry> of_all{
      {"baseline", -kAny, kAny, &rating.baseline},
      {"effect", -kAny, kAny, &rating.effect},
      {"effect_sd", 0.0, kAny, &rating.effect_sd},
      {"intercept_sd", 0.0, kAny, &rating.intercept_sd},
      {"lapse_rate", 0.0, 1.0, &rating.lapse_rate},
      {"reaction_median_ms", 1.0, kAny, &rating.reaction_median_ms},
      {"reaction_sigma_log", 0.0, kAny, &rating.reaction_sigma_log}};
  std::vector<ParameterEntry> entries = std::move(own);
  entries.insert(entries.end(), of_all.begin(), of_all.end());
  const std::vector<std::string> cuts = cut_names(document.value);
  require_schema(document, observer_schema(entries, cuts));
  for (const ParameterEntry& entry : entries) {
    if (!entry.optional || document.value["parameters"].contains(entry.name)) {
      *entry.place = number_in(document, entry.name);
    }
  }
  for (const std::string& cut : cuts) {
    const double value = number_in(document, cut);
    if (!rating.cuts.empty() && value <= rating.cuts.back()) {
      refuse(document, "/parameters/" + cut + "/value",
             "expected more than " + cut_name(rating.cuts.size()) + ", got " +
                 document.value["parameters"][cut]["value"].dump());
    }
    rating.cuts.push_back(value);
  }
}

double number_in(const JsonDocument& document, const std::string& name) {
  return document.value["parameters"][name]["value"].get<double>();
}

// ---------------------------------------------------------------- how they answer

void RatingObserver::draw_traits() {
  intercept_ = parameters_.intercept_sd * normal();
  if (parameters_.effect_sd > 0.0) {
    slope_ = parameters_.effect_sd * normal();
  }
}

std::vector<double> RatingObserver::probabilities(double seen) const {
  const double eta = parameters_.baseline + (parameters_.effect + slope_) * seen + intercept_;
  std::vector<double> probabilities;
  double below = 0.0;
  for (const double cut : parameters_.cuts) {
    const double at_most = logistic(cut - eta);
    probabilities.push_back(at_most - below);
    below = at_most;
  }
  probabilities.push_back(1.0 - below);
  const double lapse = parameters_.lapse_rate;
  for (double& probability : probabilities) {
    probability = (1.0 - lapse) * probability + lapse / static_cast<double>(probabilities.size());
  }
  return probabilities;
}

void RatingObserver::witnessed(const AttemptRecord& shown, const StagedScene& scene) {
  const bool second = !shown.frames.empty() && shown.frames.back().interval == 2;
  if (!second) {
    seen_.clear();
  }
  seen_.push_back(seen(shown, scene));
}

double RatingObserver::yes_probability(double seen) const {
  const double guess = parameters_.yes_guess_rate;
  return guess + (1.0 - guess - parameters_.yes_miss_rate) * seen;
}

double RatingObserver::first_probability(double seen_first, double seen_second) const {
  return 0.5 + 0.5 * (1.0 - parameters_.lapse_rate) * (seen_first - seen_second);
}

Answer RatingObserver::ask(const Page& page) {
  Answer answer;
  answer.device = "simulated";
  answer.shown_ns = clock_->now_ns();
  answer.fields.assign(page.fields.size(), "");
  double reaction_ms = parameters_.reaction_median_ms;
  const ResponseKind* kind = find_kind(page.response);
  if (kind != nullptr && kind->simulate != nullptr) {
    kind->simulate(page, *this, answer);
    reaction_ms = draw_lognormal(stream_, reaction_ms, parameters_.reaction_sigma_log);
  }
  if (page.timeout_ms > 0.0 && reaction_ms > page.timeout_ms) {
    answer.timed_out = true;
    answer.device = "none";
    answer.choice = 0;
    answer.fields.assign(page.fields.size(), "");
    reaction_ms = page.timeout_ms;
  }
  clock_->advance_by(std::llround(reaction_ms * 1e6));
  answer.arrived_ns = clock_->now_ns();
  return answer;
}

}  // namespace impetus::inline observers
