// SPDX-License-Identifier: MIT
#include "experiments/protocol/new_study.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string_view>
#include <utility>

#include "experiments/protocol/embedded_templates.hpp"
#include "experiments/settings/input_error.hpp"

namespace impetus::inline protocol {
namespace {

constexpr const char* kShared = "study";
constexpr std::string_view kTemplateFolder = "protocols/templates/";
constexpr std::string_view kSuffix = ".json";
constexpr double kTrials = 60.0;  ///< of a study, about
constexpr int kTrialsPerTrack = 40;
constexpr std::size_t kLeastChosenFrom = 4;

OrderedJson number_of(double number) {
  const bool whole = std::floor(number) == number && std::abs(number) < 1e15;
  return whole ? OrderedJson(static_cast<std::int64_t>(number)) : OrderedJson(number);
}

/// A number to the millionth, whole where it is.
OrderedJson short_number(double number) { return number_of(std::round(number * 1e6) / 1e6); }

/// "a, b, c" of an object's keys.
std::string key_list(const OrderedJson& object) {
  std::vector<std::string> keys;
  for (const auto& each : object.items()) {
    keys.push_back(each.key());
  }
  return listed(keys);
}

// ---------------------------------------------------------------- the design
//
// Factors come from what somebody chose to vary. Their levels are shown equally often, or those of
// the first factor are chosen trial by trial.

/// How the levels of the first factor are chosen.
enum class LevelChoice {
  kAll,        ///< each is shown equally often
  kStaircase,  ///< up and down by what was answered (Levitt 1971)
  kQuest       ///< where an answer tells most (Watson 2017)
};

/// "all", "staircase" or "quest". Throws InputError.
LevelChoice level_choice(const std::string& name) {
  for (const auto& [known, choice] : {std::pair("all", LevelChoice::kAll),
                                      {"staircase", LevelChoice::kStaircase},
                                      {"quest", LevelChoice::kQuest}}) {
    if (name == known) {
      return choice;
    }
  }
  throw InputError("--levels: expected all, staircase or quest, got " + name);
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
  return number_of(number);
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
OrderedJson factor_from(const std::string& vary, const OrderedJson& offered, bool fine) {
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
  if (fine && factor.contains("fine_levels")) {
    factor["levels"] = factor["fine_levels"];
  }
  factor.erase("fine_levels");
  if (equals < vary.size()) {
    factor["levels"] = levels_from(vary.substr(equals + 1));
  }
  if (!factor.contains("levels") || factor["levels"].size() < 2) {
    throw InputError("--vary: expected " + name + "= and two levels or more, got " + vary);
  }
  const OrderedJson& levels = factor["levels"];
  if (std::any_of(levels.begin(), levels.end(), [&](const OrderedJson& level) {
        return level == "" || level.is_number() != levels.front().is_number();
      })) {
    throw InputError("--vary: expected levels of " + name +
                     " that are all numbers or all words, got " + vary);
  }
  return factor;
}

/// The factors of the design, one for each of `vary` ("restitution=0.2,0.8"); the first that is
/// offered where that is empty. A name alone has the levels that `offered` gives it, finer ones
/// where the first factor's are chosen trial by trial. Throws InputError.
OrderedJson factors_from(const std::vector<std::string>& vary, const OrderedJson& offered,
                         LevelChoice choice) {
  OrderedJson factors = OrderedJson::array();
  const std::vector<std::string> first{offered.begin().key()};
  for (const std::string& each : vary.empty() ? first : vary) {
    factors.push_back(factor_from(each, offered, choice != LevelChoice::kAll && factors.empty()));
  }
  return factors;
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

/// Refuses levels that are no scale from hard to easy.
void require_scale(const OrderedJson& factor) {
  const OrderedJson& levels = factor["levels"];
  const bool numbers = std::all_of(levels.begin(), levels.end(),
                                   [](const OrderedJson& level) { return level.is_number(); });
  if (levels.size() < kLeastChosenFrom || !numbers ||
      !std::is_sorted(levels.begin(), levels.end())) {
    throw InputError("--levels: to choose from, expected four numbers or more of " +
                     factor["name"].get<std::string>() + ", rising from hard to easy, got " +
                     levels.dump());
  }
}

OrderedJson staircase_of(const OrderedJson& levels, bool two_intervals) {
  return {{"up", 1},
          {"down", two_intervals ? 3 : 2},
          {"steps", {2, 1}},
          {"starts", {levels.back(), levels[levels.size() / 2]}}};
}

OrderedJson quest_plus_of(const OrderedJson& levels, bool two_intervals) {
  constexpr int kThresholds = 25;
  const auto least = levels.front().get<double>();
  const double range = levels.back().get<double>() - least;
  OrderedJson thresholds = OrderedJson::array();
  for (int step = 0; step < kThresholds; ++step) {
    thresholds.push_back(short_number(least + range * step / (kThresholds - 1)));
  }
  OrderedJson slopes = OrderedJson::array();
  for (const double share : {0.0625, 0.125, 0.25}) {
    slopes.push_back(short_number(range * share));
  }
  const OrderedJson guesses = two_intervals ? OrderedJson{0.5} : OrderedJson{0.02, 0.1};
  return {{"function", "normal"},     {"scale", "linear"},
          {"thresholds", thresholds}, {"slopes", slopes},
          {"guess_rates", guesses},   {"lapse_rates", OrderedJson::array({0.02})}};
}

OrderedJson adaptive_of(const OrderedJson& factor, LevelChoice choice, bool two_intervals) {
  require_scale(factor);
  OrderedJson adaptive{{"factor", factor["name"]}, {"trials_per_track", kTrialsPerTrack}};
  if (choice == LevelChoice::kStaircase) {
    adaptive["staircase"] = staircase_of(factor["levels"], two_intervals);
  } else {
    adaptive["quest_plus"] = quest_plus_of(factor["levels"], two_intervals);
  }
  return adaptive;
}

/// The design of about sixty trials, or of a track for each condition. `two_intervals`: half of
/// all answers are right by chance. Throws InputError where levels cannot be chosen from.
OrderedJson design_of(const OrderedJson& factors, LevelChoice choice, bool two_intervals) {
  double cells = 1.0;
  for (const OrderedJson& factor : factors) {
    cells *= static_cast<double>(factor["levels"].size());
  }
  const auto repetitions =
      choice == LevelChoice::kAll ? std::max<std::int64_t>(2, std::llround(kTrials / cells)) : 1;
  OrderedJson design{{"factors", factors},
                     {"repetitions", repetitions},
                     {"practice", {end_condition(factors, false), end_condition(factors, true)}}};
  if (choice != LevelChoice::kAll) {
    design["adaptive"] = adaptive_of(factors.front(), choice, two_intervals);
  }
  return design;
}

// ---------------------------------------------------------------- what templates say

/// The text of a file that the program carries, by its place below the project's folder.
std::optional<std::string> find_carried(const std::string& path) {
  for (const EmbeddedFile& file : kTemplates) {
    if (file.name == path) {
      return file.text;
    }
  }
  return std::nullopt;
}

/// With what it says beside another template, where it is like one.
std::optional<OrderedJson> find_template_file(const std::string& name) {
  const auto text = find_carried(std::string(kTemplateFolder) + name + std::string(kSuffix));
  if (!text) {
    return std::nullopt;
  }
  OrderedJson content = OrderedJson::parse(*text);
  if (!content.contains("like")) {
    return content;
  }
  OrderedJson whole = find_template_file(content["like"].get<std::string>()).value();
  whole.merge_patch(content);
  return whole;
}

std::string file_text(const OrderedJson& content) { return content.dump(2) + "\n"; }

/// A shipped scene or figure, for a file of the study's own, which has no schema beside it.
OrderedJson shipped_stimulus(const std::string& file_name) {
  OrderedJson content = OrderedJson::parse(find_carried("stimuli/" + file_name).value());
  content.erase("$schema");
  return content;
}

OrderedJson scene_of(const OrderedJson& shown) {
  const OrderedJson& scene = shown["scene"];
  OrderedJson own = scene.is_string() ? shipped_stimulus(scene.get<std::string>()) : scene;
  if (shown.contains("changes")) {
    own.merge_patch(shown["changes"]);
  }
  return own;
}

/// A template with its words in the language of `shared`.
OrderedJson template_file(const std::string& name, const OrderedJson& shared) {
  auto found = find_template_file(name);
  if (found && !name.starts_with(kShared)) {
    const std::string named = found->value("like", name);
    if (shared.contains("templates")) {
      found->merge_patch(shared["templates"][named]);
    }
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

/// "": no page asks it. `of_many`: more than one collision is shown.
std::string question_words(const OrderedJson& ask, bool of_many) {
  return of_many && ask.contains("of_many") ? ask["of_many"].get<std::string>()
                                            : ask["block"].value("question", std::string());
}

/// `block` with the question's words, and what else the kind needs.
OrderedJson asked_block(const OrderedJson& ask, const OrderedJson& factors, bool of_many,
                        const std::string& question) {
  OrderedJson block = ask["block"];
  if (block.contains("question")) {
    block["question"] = question.empty() ? question_words(ask, of_many) : question;
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
  return {{"value", short_number(value)},
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

const OrderedJson& ask_named(const std::string& name, const OrderedJson& asks) {
  if (!asks.contains(name)) {
    throw InputError("--ask: expected one of " + key_list(asks) + ", got " + name);
  }
  return asks[name];
}

/// Levels are chosen from hard to easy: what is asked must be whether something was seen.
void require_detection(const OrderedJson& ask, const StudyChoices& choices) {
  if (choices.levels != "all" && !ask.contains("detects")) {
    throw InputError("--levels " + choices.levels +
                     ": expected --ask detection or two-interval, whose answers become right as "
                     "levels rise, got " +
                     choices.ask);
  }
}

/// The gaze is followed, and participants know it.
void add_gaze(const OrderedJson& gaze, OrderedJson& protocol) {
  protocol["gaze"] = gaze["task"];
  OrderedJson& session = protocol["session"];
  OrderedJson& consent = session["consent"]["paragraphs"];
  consent.insert(consent.begin() + 1, gaze["consent"]);
  OrderedJson& does = session["instructions"].back()["paragraphs"];
  does.insert(does.begin(), gaze["instruction"]);
}

}  // namespace

std::vector<StudyTemplate> study_templates() {
  std::vector<StudyTemplate> all;
  for (const EmbeddedFile& file : kTemplates) {
    std::string name = file.name;
    if (!name.starts_with(kTemplateFolder)) {
      continue;
    }
    name =
        name.substr(kTemplateFolder.size(), name.size() - kTemplateFolder.size() - kSuffix.size());
    if (name.starts_with(kShared)) {
      continue;
    }
    const OrderedJson content = find_template_file(name).value();
    StudyTemplate each{name, content["words"].get<std::string>(), {}};
    for (const auto& factor : content["vary"].items()) {
      each.offered.push_back(factor.key());
    }
    all.push_back(std::move(each));
  }
  return all;
}

std::vector<OfferedQuestion> offered_questions(const std::string& study_template,
                                               const std::string& language) {
  std::vector<OfferedQuestion> all;
  const OrderedJson shared = shared_parts(language);
  const bool of_many = template_file(study_template, shared).contains("of_many");
  for (const auto& ask : shared["asks"].items()) {
    all.push_back(
        {ask.key(), question_words(ask.value(), of_many), ask.value().contains("detects")});
  }
  return all;
}

std::map<std::string, std::string> make_study(const StudyChoices& choices) {
  const OrderedJson shared = shared_parts(choices.language);
  const OrderedJson shown = template_file(choices.study_template, shared);
  const OrderedJson& ask = ask_named(choices.ask, shared["asks"]);
  const LevelChoice levels = level_choice(choices.levels);
  require_detection(ask, choices);
  const OrderedJson factors = factors_from(choices.vary, shown["vary"], levels);
  const OrderedJson block = asked_block(ask, factors, shown.contains("of_many"), choices.question);
  OrderedJson protocol = shared["protocol"];
  protocol["name"] = choices.name;
  protocol["title"] = choices.name + ": " + block.value("question", ask["does"].get<std::string>());
  protocol["design"] = design_of(factors, levels, ask["key"] == "two_interval");
  protocol[ask["key"].get<std::string>()] = block;
  if (shown.contains("gaze")) {
    add_gaze(shared["gaze"], protocol);
  }
  replace_words(protocol, "THINGS", shown["things"]);
  replace_words(protocol, "SEES", shown["sees"]);
  replace_words(protocol, "DOES", ask["does"]);
  if (choices.language != "en") {
    protocol["language"] = choices.language;
  }
  std::map<std::string, std::string> files{
      {"protocol.json", file_text(protocol)},
      {"scene.json", file_text(scene_of(shown))},
      {"observer.json", file_text(observer_of(factors.front()))}};
  for (const auto& name : shown.value("files", std::vector<std::string>())) {
    files.emplace(name, name.ends_with(kSuffix) ? file_text(shipped_stimulus(name))
                                                : find_carried("stimuli/" + name).value());
  }
  return files;
}

}  // namespace impetus::inline protocol
