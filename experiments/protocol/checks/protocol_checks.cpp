// SPDX-License-Identifier: MIT
#include "experiments/protocol/checks/protocol_checks.hpp"

#include <algorithm>
#include <cstdio>
#include <set>

#include "experiments/design/adaptive_levels.hpp"
#include "experiments/design/blocks.hpp"
#include "experiments/protocol/checks/adaptive_checks.hpp"
#include "experiments/protocol/checks/protocol_scene_checks.hpp"
#include "experiments/protocol/design_reading.hpp"
#include "experiments/questions/response_kinds.hpp"

namespace impetus::inline protocol {
namespace {

using nlohmann::json;

constexpr double kMostTrials = 10'000;

std::string count_text(double count) {
  char text[32];
  std::snprintf(text, sizeof text, "%.15g", count);
  return text;
}

bool has_level(const json& factor, const json& level) {
  const json& levels = factor["levels"];
  return std::find(levels.begin(), levels.end(), level) != levels.end();
}

/// Refuses a design that nobody could sit through before its cells fill the memory.
void check_size(const JsonDocument& protocol) {
  const json& design = protocol.value["design"];
  auto trials = design["repetitions"].get<double>();
  for (const json& factor : design["factors"]) {
    trials *= static_cast<double>(factor["levels"].size());
  }
  if (trials > kMostTrials) {
    refuse(protocol, "/design",
           "expected at most 10000 trials, got " + count_text(trials) +
               " (levels of all factors × repetitions)");
  }
}

/// The same of the trials that are planned, blocks and tracks and catch trials counted.
void check_planned_size(const JsonDocument& protocol) {
  const Design design = design_from(protocol.value["design"]);
  double trials =
      static_cast<double>(design.repetitions) * static_cast<double>(cells(design).size());
  if (design.adaptive) {
    trials = static_cast<double>(design.adaptive->trials_per_track) *
             static_cast<double>(adaptive_tracks(design).size());
  }
  for (const CatchTrials& kind : design.catch_trials) {
    trials += static_cast<double>(kind.count) *
              static_cast<double>(block_order(design, {"", "P01", 0}).size());
  }
  if (trials > kMostTrials) {
    refuse(protocol, "/design",
           "expected at most 10000 trials, got " + count_text(trials) +
               " (all tracks and catch trials counted)");
  }
}

void check_factors(const JsonDocument& protocol, const JsonDocument& scene) {
  const json& factors = protocol.value["design"]["factors"];
  std::set<std::string> names;
  std::set<std::string> pointers;
  for (std::size_t i = 0; i < factors.size(); ++i) {
    const std::string place = item("/design/factors", i);
    const auto pointer = factors[i]["pointer"].get<std::string>();
    if (!names.insert(factors[i]["name"].get<std::string>()).second) {
      refuse(protocol, place + "/name",
             "expected a name of its own, got " + factors[i]["name"].dump() + " again");
    }
    if (!pointers.insert(pointer).second) {
      refuse(protocol, place + "/pointer",
             "expected a value that no other factor overrides, got \"" + pointer + "\" again");
    }
    if (!names_single_value(scene.value, pointer)) {
      refuse(protocol, place + "/pointer",
             "expected a pointer to a single value of " + scene.name + ", got \"" + pointer + "\"");
    }
  }
}

void check_runs(const JsonDocument& protocol) {
  const json& design = protocol.value["design"];
  const json rules = design.value("longest_runs", json::array());
  for (std::size_t i = 0; i < rules.size(); ++i) {
    if (!has_factor(design, rules[i]["factor"].get<std::string>())) {
      refuse(protocol, item("/design/longest_runs", i) + "/factor",
             "expected the name of a factor, got " + rules[i]["factor"].dump());
    }
  }
}

void check_questions(const JsonDocument& protocol) {
  const json session = protocol.value.value("session", json::object());
  std::set<std::string> ids{"consent"};
  for (const char* list : {"demographics", "questions"}) {
    const json entries = session.value(list, json::array());
    for (std::size_t i = 0; i < entries.size(); ++i) {
      const std::string place = item(std::string("/session/") + list, i);
      if (!ids.insert(entries[i]["id"].get<std::string>()).second) {
        refuse(protocol, place + "/id",
               "expected an id of its own, got " + entries[i]["id"].dump() + " again");
      }
      if (entries[i].value("kind", "") == "choice" && !entries[i].contains("options")) {
        refuse(protocol, place, "expected the key \"options\" for a choice, which is missing");
      }
      if (entries[i].contains("minimum") && entries[i].contains("maximum") &&
          entries[i]["minimum"] >= entries[i]["maximum"]) {
        refuse(protocol, place + "/maximum",
               "expected more than the minimum " + entries[i]["minimum"].dump() + ", got " +
                   entries[i]["maximum"].dump());
      }
    }
  }
}

/// Blocks are made of factors of the design.
void check_blocks(const JsonDocument& protocol) {
  const json& design = protocol.value["design"];
  if (!design.contains("blocks")) {
    return;
  }
  const json& names = design["blocks"]["factors"];
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string place = "/design/blocks/factors/" + std::to_string(i);
    const auto name = names[i].get<std::string>();
    if (!has_factor(design, name)) {
      refuse(protocol, place, "expected the name of a factor, got " + names[i].dump());
    }
    if (design.contains("adaptive") && design["adaptive"]["factor"].get<std::string>() == name) {
      refuse(protocol, place,
             "expected a factor whose levels are known beforehand, got " + names[i].dump() +
                 ", which is adaptive");
    }
  }
}

/// Only a design that has blocks, and whose levels do not follow from answers that would be set
/// aside, is resumed at a block's start.
void check_resume(const JsonDocument& protocol) {
  const json session = protocol.value.value("session", json::object());
  if (!session.contains("resume") || session["resume"]["at"].get<std::string>() != "block") {
    return;
  }
  const json& design = protocol.value["design"];
  if (!design.contains("blocks")) {
    refuse(protocol, "/session/resume/at",
           "expected \"trial\" where /design has no blocks, got \"block\"");
  }
  if (design.contains("adaptive")) {
    refuse(protocol, "/session/resume/at",
           "expected \"trial\" where levels are adaptive (they followed from the answers that "
           "would be set aside), got \"block\"");
  }
}

/// As many right answers fit into the trials that are looked at as train_until asks for, and these
/// into the most that there are.
void check_training_criterion(const JsonDocument& protocol) {
  const json& design = protocol.value["design"];
  if (!design.contains("train_until")) {
    return;
  }
  const std::string place = "/design/train_until";
  const json& rule = design["train_until"];
  if (rule["right"].get<std::int64_t>() > rule["of"].get<std::int64_t>()) {
    refuse(protocol, place + "/right",
           "expected at most the " + rule["of"].dump() + " trials that are looked at, got " +
               rule["right"].dump());
  }
  if (rule["of"].get<std::int64_t>() > rule["most_trials"].get<std::int64_t>()) {
    refuse(protocol, place + "/of",
           "expected at most the " + rule["most_trials"].dump() +
               " trials that there are (most_trials), got " + rule["of"].dump());
  }
}

const char* words_of_type(const json& value) {
  return value.is_string() ? "a text" : value.is_boolean() ? "a boolean" : "a number";
}

bool is_alike(const json& a, const json& b) {
  return a.is_number() ? b.is_number() : a.type() == b.type();
}

void check_catch_condition(const JsonDocument& protocol, const std::string& place,
                           const json& condition) {
  const json& design = protocol.value["design"];
  for (const json& factor : design["factors"]) {
    const auto name = factor["name"].get<std::string>();
    if (!condition.contains(name)) {
      refuse(protocol, place, "expected a level for every factor, but \"" + name + "\" has none");
    }
    const json& own = factor["levels"].front();
    if (!is_alike(own, condition[name])) {
      refuse(protocol, place + "/" + name,
             std::string("expected ") + words_of_type(own) +
                 ", as the factor's own levels are, got " + condition[name].dump());
    }
  }
  for (auto level = condition.begin(); level != condition.end(); ++level) {
    if (!has_factor(design, level.key())) {
      refuse(protocol, place,
             "expected only factors of the design, got " + json(level.key()).dump());
    }
  }
}

/// Every catch trial has a level for every factor, of the same type as the factor's own, and no two
/// kinds are alike.
void check_catch_trials(const JsonDocument& protocol) {
  const json kinds = protocol.value["design"].value("catch_trials", json::array());
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    const json& condition = kinds[i]["condition"];
    check_catch_condition(protocol, item("/design/catch_trials", i) + "/condition", condition);
    for (std::size_t before = 0; before < i; ++before) {
      if (kinds[before]["condition"] == condition) {
        refuse(protocol, item("/design/catch_trials", i) + "/condition",
               "expected a condition of its own, got " + condition.dump() + " again");
      }
    }
  }
}

}  // namespace

void check_design(const JsonDocument& protocol, const JsonDocument& scene) {
  check_size(protocol);
  check_factors(protocol, scene);
  check_runs(protocol);
  check_blocks(protocol);
  check_catch_trials(protocol);
  check_adaptive(protocol);
  check_thresholds(protocol);
  check_planned_size(protocol);
  check_training_criterion(protocol);
  check_resume(protocol);
  check_question_blocks(protocol);
  check_questions(protocol);
}

void check_practice(const JsonDocument& protocol) {
  const json& design = protocol.value["design"];
  const json practice = design.value("practice", json::array());
  for (std::size_t i = 0; i < practice.size(); ++i) {
    const std::string place = item("/design/practice", i);
    for (const json& factor : design["factors"]) {
      const auto name = factor["name"].get<std::string>();
      if (!practice[i].contains(name)) {
        refuse(protocol, place, "expected a level for every factor, but \"" + name + "\" has none");
      }
      if (!has_level(factor, practice[i][name])) {
        refuse(protocol, place + "/" + name,
               "expected one of the factor's levels " + factor["levels"].dump() + ", got " +
                   practice[i][name].dump());
      }
    }
    for (const auto& [name, unused] : practice[i].items()) {
      if (!has_factor(design, name)) {
        refuse(protocol, place, "expected only factors of the design, got " + json(name).dump());
      }
    }
  }
}

void check_practice_rule(const JsonDocument& protocol) {
  const json& design = protocol.value["design"];
  if (!design.contains("practice_until")) {
    return;
  }
  const json& rule = design["practice_until"];
  const auto factor = rule["factor"].get<std::string>();
  if (!has_factor(design, factor)) {
    refuse(protocol, "/design/practice_until/factor",
           "expected the name of a factor, got " + json(factor).dump());
  }
  const json practice = design.value("practice", json::array());
  for (const char* end : {"best", "worst"}) {
    const bool practised = std::any_of(practice.begin(), practice.end(), [&](const json& trial) {
      return trial.contains(factor) && trial[factor] == rule[end];
    });
    if (!practised) {
      refuse(protocol, std::string("/design/practice_until/") + end,
             "expected a level of " + factor + " that is practised, got " + rule[end].dump());
    }
  }
}

Plan plan_for(const Protocol& protocol, const std::string& participant, std::uint64_t seed) {
  try {
    return make_plan(protocol.design, {protocol.name, participant, seed});
  } catch (const InputError&) {
    throw;  // of the participant's code
  } catch (const std::runtime_error&) {
    refuse(protocol.document, "/design/longest_runs",
           "expected rules that some order of the trials keeps to, but none was found");
  }
}

}  // namespace impetus::inline protocol
