// SPDX-License-Identifier: MIT
#include "experiments/observers/observer_kinds.hpp"

#include <algorithm>
#include <cmath>

#include "experiments/settings/schema_sentences.hpp"

namespace impetus::inline observers {

using nlohmann::json;
using DeclaredObserver = const ObserverKind&();
DeclaredObserver adapting_observer, awaiting_observer, bouncing_observer, causality_observer,
    counterfactual_observer, foreseeing_observer, gap_observer, gap_thresholds_observer,
    gaze_observer, launching_observer, psychometric_observer, rebound_observer, response_observer;

const std::vector<std::reference_wrapper<const ObserverKind>>& observer_kinds() {
  static const std::vector<std::reference_wrapper<const ObserverKind>> kinds{
      adapting_observer(),  awaiting_observer(),       bouncing_observer(),
      causality_observer(), counterfactual_observer(), foreseeing_observer(),
      gap_observer(),       gap_thresholds_observer(), gaze_observer(),
      launching_observer(), psychometric_observer(),   rebound_observer(),
      response_observer()};
  return kinds;
}

namespace {

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

OrderedJson number_schema(double minimum, double maximum, const std::string& words) {
  OrderedJson schema = words.empty() ? OrderedJson::object() : OrderedJson{{"description", words}};
  using E = ParameterEntry;
  const RowList<E> rows{unread<E>("value", number({minimum, maximum})).in_every_file(),
                        unread<E>("unit", any_text()).in_every_file(),
                        unread<E>("source", text()).in_every_file(), unread<E>("note", any_text())};
  schema.update(rows.form("").schema);
  return schema;
}

constexpr const char* kCutWords =
    "The boundary between two neighbouring points of the rating scale, from its good end on; each "
    "is more than the one before.";

/// `cuts`: those of a file; a list of all files has a pattern.
OrderedJson parameters_schema(const std::vector<ParameterEntry>& entries,
                              const std::vector<std::string>& cuts) {
  OrderedJson schema{{"type", "object"}, {"additionalProperties", false}};
  schema["required"] = OrderedJson::array();
  for (const ParameterEntry& entry : entries) {
    if (!entry.optional) {
      schema["required"].push_back(entry.name);
    }
    schema["properties"][entry.name] = number_schema(entry.minimum, entry.maximum, entry.words);
  }
  for (const std::string& cut : cuts) {
    schema["required"].push_back(cut);
    schema["properties"][cut] = number_schema(-kAny, kAny, kCutWords);
  }
  return schema;
}

/// Of a file of one kind, which has `settings` beside its numbers.
OrderedJson file_of_kind(const OrderedJson& name, const OrderedJson& parameters,
                         const Form& settings) {
  OrderedJson schema{{"type", "object"},
                     {"additionalProperties", false},
                     {"required", {"schema_version", "observer", "parameters"}},
                     {"properties",
                      {{"$schema", {{"type", "string"}}},
                       {"schema_version", {{"const", 1}}},
                       {"observer", name},
                       {"note", {{"type", "string"}}}}}};
  if (settings.schema.contains("properties")) {
    schema["properties"].update(settings.schema["properties"]);
    for (const OrderedJson& key : settings.schema.value("required", OrderedJson::array())) {
      schema["required"].push_back(key);
    }
  }
  schema["properties"]["parameters"] = parameters;
  return schema;
}

/// Of any file of the kind.
OrderedJson schema_of(const ObserverKind& kind) {
  OrderedJson parameters = parameters_schema(kind.parameters, {});
  if (!kind.has_own_scale) {
    parameters["required"].push_back(cut_name(1));
    parameters["patternProperties"]["^cut_[1-8]_[2-9]$"] = number_schema(-kAny, kAny, kCutWords);
  }
  OrderedJson schema{{"description", kind.words}};
  schema.update(file_of_kind({{"const", kind.name}}, parameters, kind.settings));
  return schema;
}

}  // namespace

const ObserverKind* find_observer_kind(const std::string& name) {
  const auto found = std::find_if(observer_kinds().begin(), observer_kinds().end(),
                                  [&](const ObserverKind& kind) { return kind.name == name; });
  return found == observer_kinds().end() ? nullptr : &found->get();
}

const ObserverKind& named_kind(const JsonDocument& document) {
  json names = json::array();
  for (const ObserverKind& kind : observer_kinds()) {
    names.push_back(kind.name);
  }
  require_schema(document, {{"type", "object"},
                            {"required", {"observer"}},
                            {"properties", {{"observer", {{"enum", names}}}}}});
  return *find_observer_kind(document.value["observer"].get<std::string>());
}

OrderedJson observer_file_schema() {
  OrderedJson schema{{"$schema", "http://json-schema.org/draft-07/schema#"},
                     {"title", "Impetus simulated participant"},
                     {"description",
                      "What a simulated participant is made of. Every number has its unit and says "
                      "where it comes from."},
                     {"oneOf", OrderedJson::array()}};
  for (const ObserverKind& kind : observer_kinds()) {
    schema["oneOf"].push_back({{"$ref", "#/definitions/" + kind.name}});
    schema["definitions"][kind.name] = schema_of(kind);
  }
  return schema;
}

std::vector<ParameterEntry> with_rating_entries(RatingParameters& rating,
                                                std::vector<ParameterEntry> own) {
  own.insert(
      own.end(),
      {{"baseline", -kAny, kAny, &rating.baseline, "Of a rating's logit, where nothing was seen."},
       {"effect", -kAny, kAny, &rating.effect,
        "What a rating's logit gains where something was clearly seen."},
       {"effect_sd", 0.0, kAny, &rating.effect_sd, "Spread of the effect between participants."},
       {"intercept_sd", 0.0, kAny, &rating.intercept_sd,
        "Spread of the ratings' level between participants."},
       {"lapse_rate", 0.0, 1.0, &rating.lapse_rate,
        "Share of ratings and choices of an interval that are given blindly."},
       {"reaction_median_ms", 1.0, kAny, &rating.reaction_median_ms,
        "From the question to the answer; times are lognormal."},
       {"reaction_sigma_log", 0.0, kAny, &rating.reaction_sigma_log,
        "Standard deviation of the natural logarithm of these times."}});
  return own;
}

std::vector<ParameterEntry> with_answering_entries(RatingParameters& answering,
                                                   std::vector<ParameterEntry> own) {
  own.insert(own.end(), {{"lapse_rate", 0.0, 1.0, &answering.lapse_rate,
                          "The share of answers that are anything."},
                         {"reaction_median_ms", 0.0, kAny, &answering.reaction_median_ms,
                          "Median of the times from question to answer, which are lognormal."},
                         {"reaction_sigma_log", 0.0, kAny, &answering.reaction_sigma_log,
                          "Standard deviation of the natural logarithm of these times."}});
  return own;
}

void read_numbers(const JsonDocument& document, const std::vector<ParameterEntry>& entries,
                  const Form& settings, std::vector<double>* cuts) {
  const std::vector<std::string> names =
      cuts != nullptr ? cut_names(document.value) : std::vector<std::string>{};
  require_schema(document,
                 file_of_kind({{"type", "string"}}, parameters_schema(entries, names), settings));
  for (const ParameterEntry& entry : entries) {
    if (!entry.optional || document.value["parameters"].contains(entry.name)) {
      *entry.place = number_in(document, entry.name);
    }
  }
  for (const std::string& name : names) {
    const double value = number_in(document, name);
    if (!cuts->empty() && value <= cuts->back()) {
      refuse(document, "/parameters/" + name + "/value",
             "expected more than " + cut_name(cuts->size()) + ", got " +
                 document.value["parameters"][name]["value"].dump());
    }
    cuts->push_back(value);
  }
}

double number_in(const JsonDocument& document, const std::string& name) {
  return document.value["parameters"][name]["value"].get<double>();
}

// ---------------------------------------------------------------- how they answer

void RatingObserver::draw_traits() {
  traits_.intercept = normal();
  if (parameters_.effect_sd > 0.0) {
    traits_.slope = normal();
  }
}

std::vector<double> RatingObserver::probabilities(double seen) const {
  std::vector<double> probabilities(parameters_.points());
  for (std::size_t steps = 0; steps < probabilities.size(); ++steps) {
    probabilities[steps] =
        cumulative_rating(parameters_, traits_, seen, steps, probabilities.size());
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

double RatingObserver::yes_probability(double seen) const { return yes_chance(parameters_, seen); }

double RatingObserver::first_probability(double seen_first, double seen_second) const {
  return first_chance(parameters_, seen_first, seen_second);
}

ModelledObserver::ModelledObserver(const ObserverKind& kind, const RatingParameters& parameters,
                                   const Birth& birth)
    : RatingObserver(parameters, birth, kind.name),
      answers_(&kind.answers),
      parameters_(answers_->copy(parameters)) {
  const bool threshold_is_late = answers_->late_threshold_sd != nullptr;
  if (!threshold_is_late) {
    traits_.threshold = normal();
  }
  draw_traits();
  if (threshold_is_late && answers_->late_threshold_sd(*parameters_) > 0.0) {
    traits_.threshold = normal();
  }
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
