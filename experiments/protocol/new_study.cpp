// SPDX-License-Identifier: MIT
#include "experiments/protocol/new_study.hpp"

#include <algorithm>
#include <optional>

#include "experiments/protocol/embedded_templates.hpp"
#include "experiments/protocol/new_design.hpp"
#include "experiments/settings/input_error.hpp"

namespace impetus::inline protocol {
namespace {

constexpr const char* kShared = "study";
constexpr std::string_view kTemplateFolder = "protocols/templates/";
constexpr std::string_view kSuffix = ".json";

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
  throw InputError("--template: expected one of " +
                   listed(study_templates(), &StudyTemplate::name) + ", got " + name);
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
OrderedJson asked_block(const OrderedJson& ask, const OrderedJson& factors,
                        const OrderedJson& natural, bool of_many, const std::string& question) {
  OrderedJson block = ask["block"];
  if (block.contains("question")) {
    block["question"] = question.empty() ? question_words(ask, of_many) : question;
  }
  if (ask["key"] == "two_interval") {
    block["standard"] = {{factors.front()["name"].get<std::string>(), natural}};
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

/// Whether what is asked is seen the more rarely, the higher the level is: what looks natural is
/// at the top, and the unnatural is asked about; or the other way round.
bool is_falling(const OrderedJson& ask, const OrderedJson& factor, const OrderedJson& natural) {
  const OrderedJson& levels = factor["levels"];
  const bool ordered = levels.front().is_number() || levels.front().is_boolean();
  const OrderedJson& top =
      ordered ? *std::max_element(levels.begin(), levels.end()) : levels.back();
  return (natural == top) != ask.contains("asks_natural");
}

/// Its function runs over the levels of the factor: half-way in their middle. `falling`: what is
/// asked is seen the more rarely, the higher the level is.
OrderedJson observer_of(const OrderedJson& factor, bool falling) {
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
          {"falling", falling},
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
  const OrderedJson scene = scene_of(shown);
  const OrderedJson natural = natural_level(factors.front(), scene);
  const OrderedJson block =
      asked_block(ask, factors, natural, shown.contains("of_many"), choices.question);
  OrderedJson protocol = shared["protocol"];
  protocol["name"] = choices.name;
  protocol["title"] = choices.name + ": " + block.value("question", ask["does"].get<std::string>());
  protocol["design"] = design_of(factors, {levels, ask["key"] == "two_interval", natural});
  protocol[ask["key"].get<std::string>()] = block;
  if (shown.contains("gaze")) {
    add_gaze(shared["gaze"], protocol);
  }
  replace_words(protocol, "THINGS", shown["things"]);
  replace_words(protocol, "SEES", shown["sees"]);
  if (ask.contains("advice")) {
    protocol["session"]["instructions"].back()["paragraphs"].back() = ask["advice"];
  }
  replace_words(protocol, "DOES", ask["does"]);
  if (choices.language != "en") {
    protocol["language"] = choices.language;
  }
  std::map<std::string, std::string> files{
      {"protocol.json", file_text(protocol)},
      {"scene.json", file_text(scene)},
      {"observer.json",
       file_text(observer_of(factors.front(), is_falling(ask, factors.front(), natural)))}};
  for (const auto& name : shown.value("files", std::vector<std::string>())) {
    files.emplace(name, name.ends_with(kSuffix) ? file_text(shipped_stimulus(name))
                                                : find_carried("stimuli/" + name).value());
  }
  return files;
}

}  // namespace impetus::inline protocol
