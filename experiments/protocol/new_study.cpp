// SPDX-License-Identifier: MIT
#include "experiments/protocol/new_study.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>

#include "experiments/protocol/embedded_templates.hpp"
#include "experiments/settings/input_error.hpp"

namespace impetus::inline protocol {
namespace {

constexpr const char* kShared = "study";
constexpr double kTrials = 60.0;  ///< of a study, about

std::optional<OrderedJson> find_template_file(const std::string& name) {
  for (const EmbeddedFile& file : kTemplates) {
    if (file.name == name + ".json") {
      return OrderedJson::parse(file.text);
    }
  }
  return std::nullopt;
}

OrderedJson template_file(const std::string& name) {
  const auto found = find_template_file(name);
  if (found && !name.starts_with(kShared)) {
    return *found;
  }
  std::vector<std::string> names;
  for (const StudyTemplate& each : study_templates()) {
    names.push_back(each.name);
  }
  throw InputError("--template: expected one of " + listed(names) + ", got " + name);
}

/// What all studies share, in the words of a language that comes with the program; in English for
/// others.
OrderedJson shared_parts(const std::string& language) {
  OrderedJson shared = find_template_file(kShared).value();
  if (const auto words = find_template_file(kShared + ("." + language))) {
    shared.merge_patch(*words);
  }
  return shared;
}

/// "a, b, c" of an object's keys.
std::string key_list(const OrderedJson& object) {
  std::vector<std::string> keys;
  for (const auto& each : object.items()) {
    keys.push_back(each.key());
  }
  return listed(keys);
}

/// A number, true, false, or a word.
OrderedJson level_from(const std::string& text) {
  if (text == "true" || text == "false") {
    return text == "true";
  }
  char* end = nullptr;
  const double number = std::strtod(text.c_str(), &end);
  if (end == text.c_str() || *end != '\0' || !std::isfinite(number)) {
    return text;
  }
  const bool whole = std::floor(number) == number && std::abs(number) < 1e15;
  return whole ? OrderedJson(static_cast<std::int64_t>(number)) : OrderedJson(number);
}

OrderedJson levels_from(const std::string& words) {
  OrderedJson levels = OrderedJson::array();
  for (std::size_t begin = 0; begin <= words.size();) {
    const std::size_t end = std::min(words.find(',', begin), words.size());
    levels.push_back(level_from(words.substr(begin, end - begin)));
    begin = end + 1;
  }
  return levels;
}

/// "/crowd/spin_deg_s" as spin_deg_s
std::string last_token(const std::string& pointer) {
  return pointer.substr(pointer.rfind('/') + 1);
}

/// A factor of the design, of one --vary.
OrderedJson factor_from(const std::string& vary, const OrderedJson& offered) {
  const std::size_t equals = std::min(vary.find('='), vary.size());
  const std::string name = vary.substr(0, equals);
  OrderedJson factor;
  if (name.rfind('/', 0) == 0) {
    factor = {{"name", last_token(name)}, {"label", last_token(name)}, {"pointer", name}};
  } else if (offered.contains(name)) {
    factor = {{"name", name}};
    factor.update(offered[name]);
  } else {
    throw InputError("--vary: expected one of " + key_list(offered) +
                     ", or a JSON Pointer into the scene, got " + name);
  }
  if (equals < vary.size()) {
    factor["levels"] = levels_from(vary.substr(equals + 1));
  }
  if (!factor.contains("levels") || factor["levels"].size() < 2) {
    throw InputError("--vary: expected " + name + "= and two levels or more, got " + vary);
  }
  return factor;
}

/// The condition in which every factor has its first level, or its last.
OrderedJson end_condition(const OrderedJson& factors, bool last) {
  OrderedJson condition = OrderedJson::object();
  for (const OrderedJson& factor : factors) {
    const OrderedJson& levels = factor["levels"];
    condition[factor["name"].get<std::string>()] = last ? levels.back() : levels.front();
  }
  return condition;
}

OrderedJson design_of(const OrderedJson& factors) {
  double cells = 1.0;
  for (const OrderedJson& factor : factors) {
    cells *= static_cast<double>(factor["levels"].size());
  }
  const auto repetitions = std::max<std::int64_t>(2, std::llround(kTrials / cells));
  return {{"factors", factors},
          {"repetitions", repetitions},
          {"practice", {end_condition(factors, false), end_condition(factors, true)}}};
}

/// `block` with the question's words, and what else the kind needs.
OrderedJson asked_block(const OrderedJson& ask, const OrderedJson& factors,
                        const std::string& question) {
  OrderedJson block = ask["block"];
  if (!question.empty() && block.contains("question")) {
    block["question"] = question;
  }
  if (ask["key"] == "two_interval") {
    const OrderedJson& first = factors.front();
    block["standard"] = {{first["name"].get<std::string>(), first["levels"].front()}};
  }
  return block;
}

void replace_words(OrderedJson& value, const std::string& from, const std::string& to) {
  if (value.is_string()) {
    auto text = value.get<std::string>();
    const std::size_t at = text.find(from);
    if (at != std::string::npos) {
      value = text.replace(at, from.size(), to);
    }
    return;
  }
  if (value.is_structured()) {
    for (OrderedJson& part : value) {
      replace_words(part, from, to);
    }
  }
}

OrderedJson number_entry(double value, const char* unit) {
  const double short_value = std::round(value * 1e6) / 1e6;
  return {{"value", level_from(OrderedJson(short_value).dump())},
          {"unit", unit},
          {"source", "assumed by `impetus new`; put your own"}};
}

/// Its function runs over the levels of the factor: half-way in their middle.
OrderedJson observer_of(const OrderedJson& factor) {
  const OrderedJson& levels = factor["levels"];
  OrderedJson of{{"factor", factor["name"]}};
  double least = 1.0;
  auto most = static_cast<double>(levels.size());
  if (levels.front().is_number()) {
    const auto [low, high] = std::minmax_element(levels.begin(), levels.end());
    least = low->get<double>();
    most = high->get<double>();
  } else if (levels.front().is_boolean()) {
    least = 0.0;
    most = 1.0;
  } else {
    of["levels"] = levels;
  }
  return {{"schema_version", 1},
          {"observer", "psychometric"},
          {"note",
           "Every number is an assumption: `impetus observers psychometric` says what each "
           "is. With \"falling\": true, yes becomes rarer as the level rises."},
          {"of", of},
          {"function", "normal"},
          {"falling", false},
          {"parameters",
           {{"threshold", number_entry((least + most) / 2.0, "as the factor's")},
            {"slope", number_entry((most - least) / 4.0, "as the factor's")},
            {"threshold_sd", number_entry((most - least) / 8.0, "as the factor's")},
            {"guess_rate", number_entry(0.05, "probability")},
            {"lapse_rate", number_entry(0.02, "probability")},
            {"reaction_median_ms", number_entry(900.0, "ms")}}}};
}

OrderedJson factors_from(const StudyChoices& choices, const OrderedJson& offered) {
  OrderedJson factors = OrderedJson::array();
  for (const std::string& vary : choices.vary) {
    factors.push_back(factor_from(vary, offered));
  }
  if (factors.empty()) {
    factors.push_back(factor_from(offered.begin().key(), offered));
  }
  return factors;
}

}  // namespace

std::vector<StudyTemplate> study_templates() {
  std::vector<StudyTemplate> all;
  for (const EmbeddedFile& file : kTemplates) {
    const std::string name = std::string(file.name).substr(0, std::string(file.name).rfind('.'));
    if (name.starts_with(kShared)) {
      continue;
    }
    const OrderedJson content = OrderedJson::parse(file.text);
    StudyTemplate each{name, content["words"].get<std::string>(), {}};
    for (const auto& factor : content["vary"].items()) {
      each.offered.push_back(factor.key());
    }
    all.push_back(std::move(each));
  }
  return all;
}

std::vector<std::pair<std::string, std::string>> offered_questions(const std::string& language) {
  std::vector<std::pair<std::string, std::string>> all;
  const OrderedJson shared = shared_parts(language);
  for (const auto& ask : shared["asks"].items()) {
    all.emplace_back(ask.key(), ask.value()["block"].value("question", std::string()));
  }
  return all;
}

std::map<std::string, OrderedJson> make_study(const StudyChoices& choices) {
  OrderedJson shown = template_file(choices.study_template);
  const OrderedJson shared = shared_parts(choices.language);
  if (shared.contains("templates")) {
    shown.merge_patch(shared["templates"][choices.study_template]);
  }
  if (!shared["asks"].contains(choices.ask)) {
    throw InputError("--ask: expected one of " + key_list(shared["asks"]) + ", got " + choices.ask);
  }
  const OrderedJson& ask = shared["asks"][choices.ask];
  const OrderedJson factors = factors_from(choices, shown["vary"]);
  const OrderedJson block = asked_block(ask, factors, choices.question);
  OrderedJson protocol = shared["protocol"];
  protocol["name"] = choices.name;
  protocol["title"] = choices.name + ": " + block.value("question", ask["does"].get<std::string>());
  protocol["design"] = design_of(factors);
  protocol[ask["key"].get<std::string>()] = block;
  replace_words(protocol, "THINGS", shown["things"]);
  replace_words(protocol, "SEES", shown["sees"]);
  replace_words(protocol, "DOES", ask["does"]);
  if (choices.language != "en") {
    protocol["language"] = choices.language;
  }
  return {{"protocol.json", protocol},
          {"scene.json", shown["scene"]},
          {"observer.json", observer_of(factors.front())}};
}

}  // namespace impetus::inline protocol
