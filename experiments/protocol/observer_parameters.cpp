// SPDX-License-Identifier: MIT
#include "experiments/protocol/observer_parameters.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "experiments/settings/schema_check.hpp"

namespace impetus::inline protocol {
namespace {

using nlohmann::json;

constexpr double kAny = 1e9;
constexpr int kMostPoints = 9;  ///< of a protocol's scale

/// One number of the file and where it goes.
template <typename Parameters>
struct Entry {
  const char* name;
  double minimum;
  double maximum;
  double Parameters::*place;
  bool optional{false};  ///< left out, it stays what it is
};

template <typename Parameters>
using Entries = std::vector<Entry<Parameters>>;

template <typename Parameters>
void add_rating(Entries<Parameters>& entries) {
  using P = Parameters;
  const Entries<P> rating{{"baseline", -kAny, kAny, &P::baseline},
                          {"effect", -kAny, kAny, &P::effect},
                          {"effect_sd", 0.0, kAny, &P::effect_sd},
                          {"intercept_sd", 0.0, kAny, &P::intercept_sd},
                          {"lapse_rate", 0.0, 1.0, &P::lapse_rate},
                          {"reaction_median_ms", 1.0, kAny, &P::reaction_median_ms},
                          {"reaction_sigma_log", 0.0, kAny, &P::reaction_sigma_log}};
  entries.insert(entries.end(), rating.begin(), rating.end());
}

/// Of answers by yes or no, for kinds in which what was seen has no such rates of its own.
template <typename Parameters>
void add_yes_no(Entries<Parameters>& entries) {
  using P = Parameters;
  entries.push_back({"guess_rate", 0.0, 1.0, &P::yes_guess_rate, true});
  entries.push_back({"miss_rate", 0.0, 1.0, &P::yes_miss_rate, true});
}

Entries<CausalityParameters> entries_of(const CausalityParameters& /*kind*/) {
  using P = CausalityParameters;
  Entries<P> entries{{"threshold_mean_ms", -kAny, kAny, &P::threshold_mean_ms},
                     {"threshold_sd_ms", 0.0, kAny, &P::threshold_sd_ms},
                     {"threshold_width_ms", 1e-3, kAny, &P::threshold_width_ms}};
  add_yes_no(entries);
  return entries;
}

template <typename P>
Entries<P> gap_entries() {
  return {{"threshold_arcmin", 1e-3, kAny, &P::threshold_arcmin},
          {"width_log10", 1e-3, kAny, &P::width_log10},
          {"guess_rate", 0.0, 1.0, &P::guess_rate},
          {"miss_rate", 0.0, 1.0, &P::miss_rate}};
}

Entries<GapParameters> entries_of(const GapParameters& /*kind*/) {
  return gap_entries<GapParameters>();
}

Entries<GapThresholdParameters> entries_of(const GapThresholdParameters& /*kind*/) {
  using P = GapThresholdParameters;
  Entries<P> entries = gap_entries<P>();
  entries.push_back({"crowding_per_body", 0.0, kAny, &P::crowding_per_body});
  entries.push_back({"threshold_sd_log10", 0.0, kAny, &P::threshold_sd_log10});
  return entries;
}

Entries<ResponseParameters> entries_of(const ResponseParameters& /*kind*/) {
  using P = ResponseParameters;
  Entries<P> entries = gap_entries<P>();
  const Entries<P> own{{"spin_weight", 0.0, 1.0, &P::spin_weight},
                       {"spin_median_deg_s", 1e-3, kAny, &P::spin_median_deg_s},
                       {"spin_width_log10", 1e-3, kAny, &P::spin_width_log10},
                       {"speed_weight", 0.0, 1.0, &P::speed_weight},
                       {"speed_scale_deg_s", 1e-3, kAny, &P::speed_scale_deg_s}};
  entries.insert(entries.end(), own.begin(), own.end());
  return entries;
}

void add_eye(Entries<GazeObserverParameters>& entries) {
  using P = GazeObserverParameters;
  const Entries<P> eye{{"sampling_hz", 60.0, 1000.0, &P::sampling_hz},
                       {"latency_ms", 0.0, 1000.0, &P::latency_ms},
                       {"visual_delay_ms", 1.0, 1000.0, &P::visual_delay_ms},
                       {"fixation_min_ms", 1.0, kAny, &P::fixation_min_ms},
                       {"fixation_max_ms", 1.0, kAny, &P::fixation_max_ms},
                       {"saccade_base_ms", 1.0, kAny, &P::saccade_base_ms},
                       {"saccade_ms_per_deg", 0.0, kAny, &P::saccade_ms_per_deg},
                       {"pair_share", 0.0, 1.0, &P::pair_share},
                       {"pursuit_share", 0.0, 1.0, &P::pursuit_share},
                       {"pursuit_min_ms", 1.0, kAny, &P::pursuit_min_ms},
                       {"pursuit_max_ms", 1.0, kAny, &P::pursuit_max_ms},
                       {"pursuit_gain", 0.0, 1.0, &P::pursuit_gain},
                       {"pursuit_time_ms", 1.0, kAny, &P::pursuit_time_ms},
                       {"catch_up_deg", 0.5, kAny, &P::catch_up_deg},
                       {"fixational_sd_deg", 0.0, kAny, &P::fixational_sd_deg},
                       {"fixational_time_ms", 1e-3, kAny, &P::fixational_time_ms},
                       {"offset_sd_deg", 0.0, kAny, &P::offset_sd_deg},
                       {"blink_per_s", 0.0, 100.0, &P::blink_per_s},
                       {"blink_ms", 1.0, kAny, &P::blink_ms},
                       {"dropout_per_s", 0.0, 100.0, &P::dropout_per_s},
                       {"dropout_ms", 1.0, kAny, &P::dropout_ms}};
  entries.insert(entries.end(), eye.begin(), eye.end());
}

Entries<GazeObserverParameters> entries_of(const GazeObserverParameters& /*kind*/) {
  using P = GazeObserverParameters;
  Entries<P> entries{{"threshold_arcmin", 1e-3, kAny, &P::threshold_arcmin},
                     {"width_log10", 1e-3, kAny, &P::width_log10},
                     {"miss_rate", 0.0, 1.0, &P::miss_rate},
                     {"crowding_per_body", 0.0, kAny, &P::crowding_per_body},
                     {"merge_ms", 0.0, kAny, &P::merge_ms},
                     {"click_median_ms", 1.0, kAny, &P::click_median_ms},
                     {"click_sigma_log", 0.0, kAny, &P::click_sigma_log},
                     {"refractory_ms", 0.0, kAny, &P::refractory_ms},
                     {"false_clicks_per_s", 0.0, 100.0, &P::false_clicks_per_s},
                     {"events_per_s", 1e-3, kAny, &P::events_per_s}};
  add_eye(entries);
  return entries;
}

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

template <typename Parameters>
json observer_schema(const Entries<Parameters>& entries, const std::vector<std::string>& cuts) {
  json parameters{{"type", "object"}, {"additionalProperties", false}};
  const auto allow = [&](const std::string& name, double minimum, double maximum) {
    parameters["properties"][name] = number_schema(minimum, maximum);
  };
  const auto require = [&](const std::string& name, double minimum, double maximum) {
    parameters["required"].push_back(name);
    allow(name, minimum, maximum);
  };
  for (const auto& entry : entries) {
    if (entry.optional) {
      allow(entry.name, entry.minimum, entry.maximum);
    } else {
      require(entry.name, entry.minimum, entry.maximum);
    }
  }
  for (const std::string& cut : cuts) {
    require(cut, -kAny, kAny);
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

double value_of(const JsonDocument& document, const std::string& name) {
  return document.value["parameters"][name]["value"].get<double>();
}

void require_more(const JsonDocument& document, const std::string& greater,
                  const std::string& less) {
  if (value_of(document, greater) <= value_of(document, less)) {
    refuse(document, "/parameters/" + greater + "/value",
           "expected more than " + less + ", got " +
               document.value["parameters"][greater]["value"].dump());
  }
}

/// A range of durations: its end must not come before its beginning.
void require_range(const JsonDocument& document, const std::string& what) {
  if (value_of(document, what + "_max_ms") < value_of(document, what + "_min_ms")) {
    refuse(document, "/parameters/" + what + "_max_ms/value",
           "expected at least " + what + "_min_ms, got " +
               document.value["parameters"][what + "_max_ms"]["value"].dump());
  }
}

void check_ranges(const JsonDocument& /*document*/, const RatingParameters& /*any kind*/) {}

void check_ranges(const JsonDocument& document, const GazeObserverParameters& /*kind*/) {
  require_range(document, "fixation");
  require_range(document, "pursuit");
}

template <typename Parameters>
ObserverParameters read(const JsonDocument& document) {
  Parameters parameters;
  auto entries = entries_of(parameters);
  add_rating(entries);
  const std::vector<std::string> cuts = cut_names(document.value);
  require_schema(document, observer_schema(entries, cuts));
  for (const auto& entry : entries) {
    if (!entry.optional || document.value["parameters"].contains(entry.name)) {
      parameters.*entry.place = value_of(document, entry.name);
    }
  }
  for (const std::string& cut : cuts) {
    if (cut != cuts.front()) {
      require_more(document, cut, cut_name(parameters.cuts.size()));
    }
    parameters.cuts.push_back(value_of(document, cut));
  }
  check_ranges(document, parameters);
  return parameters;
}

/// What a file may call its observer, and how its numbers are read.
struct Kind {
  const char* name;
  ObserverParameters (*read)(const JsonDocument& document);
};

const std::vector<Kind>& kinds() {
  static const std::vector<Kind> kinds{{"causality", read<CausalityParameters>},
                                       {"gap", read<GapParameters>},
                                       {"gap-thresholds", read<GapThresholdParameters>},
                                       {"gaze-contingent", read<GazeObserverParameters>},
                                       {"response", read<ResponseParameters>}};
  return kinds;
}

json kind_schema() {
  json names = json::array();
  for (const Kind& kind : kinds()) {
    names.push_back(kind.name);
  }
  return {{"type", "object"},
          {"required", {"observer"}},
          {"properties", {{"observer", {{"enum", names}}}}}};
}

}  // namespace

ObserverParameters read_parameters(const JsonDocument& document) {
  require_schema(document, kind_schema());
  const auto name = document.value["observer"].get<std::string>();
  const auto kind = std::find_if(kinds().begin(), kinds().end(),
                                 [&](const Kind& one) { return name == one.name; });
  return kind->read(document);
}

}  // namespace impetus::inline protocol
