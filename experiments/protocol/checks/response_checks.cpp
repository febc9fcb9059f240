// SPDX-License-Identifier: MIT
#include "experiments/protocol/checks/response_checks.hpp"

#include <algorithm>

#include "experiments/protocol/checks/protocol_scene_checks.hpp"
#include "experiments/scenes/engine_setup.hpp"
#include "experiments/scenes/scene_file.hpp"
#include "experiments/session/intervals.hpp"

namespace impetus::inline protocol {
namespace {

using nlohmann::json;

/// The factor of this name; null when there is none.
const json* find_factor(const JsonDocument& protocol, const std::string& name) {
  for (const json& factor : protocol.value["design"]["factors"]) {
    if (factor["name"].get<std::string>() == name) {
      return &factor;
    }
  }
  return nullptr;
}

void check_something_is_asked(const JsonDocument& protocol) {
  const json& document = protocol.value;
  if (document.value("participants", std::string()) == "none") {
    return;
  }
  for (const char* kind : {"rating", "yes_no", "two_interval", "free_text", "clicks"}) {
    if (document.contains(kind)) {
      return;
    }
  }
  refuse(protocol, "",
         "expected something that participants answer, a key \"rating\", \"yes_no\", "
         "\"two_interval\", \"free_text\" or \"clicks\", but there is none");
}

void check_right_when(const JsonDocument& protocol) {
  if (!protocol.value.contains("yes_no") || !protocol.value["yes_no"].contains("right_when")) {
    return;
  }
  const auto name = protocol.value["yes_no"]["right_when"]["factor"].get<std::string>();
  const json* factor = find_factor(protocol, name);
  if (factor == nullptr) {
    refuse(protocol, "/yes_no/right_when/factor",
           "expected the name of a factor, got " + json(name).dump());
  }
  for (const json& level : (*factor)["levels"]) {
    if (!level.is_number()) {
      refuse(protocol, "/yes_no/right_when/factor",
             "expected a factor whose levels are numbers, got " + json(name).dump() +
                 ", which has " + level.dump());
    }
  }
}

void check_standard_names(const JsonDocument& protocol) {
  if (!protocol.value.contains("two_interval")) {
    return;
  }
  const json& standard = protocol.value["two_interval"]["standard"];
  if (standard.empty()) {
    refuse(protocol, "/two_interval/standard",
           "expected at least one level, or both intervals show the same, got {}");
  }
  for (auto level = standard.begin(); level != standard.end(); ++level) {
    if (find_factor(protocol, level.key()) == nullptr) {
      refuse(protocol, "/two_interval/standard",
             "expected only factors of the design, got " + json(level.key()).dump());
    }
  }
}

void check_practice_rating(const JsonDocument& protocol) {
  if (protocol.value["design"].contains("practice_until") && !protocol.value.contains("rating")) {
    refuse(protocol, "/design/practice_until",
           "expected the key \"rating\" in the protocol, because the best level must be rated "
           "better than the worst, but it is missing");
  }
}

bool has_right_answer(const json& document) {
  return document.contains("two_interval") ||
         (document.contains("yes_no") && document["yes_no"].contains("right_when"));
}

}  // namespace

void check_responses(const JsonDocument& protocol) {
  check_something_is_asked(protocol);
  check_right_when(protocol);
  check_standard_names(protocol);
  check_practice_rating(protocol);
}

void check_training(const JsonDocument& protocol) {
  const json& design = protocol.value["design"];
  if (!design.contains("train_until")) {
    return;
  }
  if (design.contains("practice_until")) {
    refuse(protocol, "/design/train_until",
           "expected either this or practice_until, but both are there");
  }
  if (!has_right_answer(protocol.value)) {
    refuse(protocol, "/design/train_until",
           "expected a question that has a right answer (yes_no with right_when, or two_interval), "
           "but there is none");
  }
  if (design.value("practice", json::array()).empty()) {
    refuse(protocol, "/design/train_until",
           "expected conditions to train with in /design/practice, but there are none");
  }
}

void check_standard(const Protocol& protocol) {
  if (!protocol.script.two_interval) {
    return;
  }
  const TwoIntervalQuestion& question = *protocol.script.two_interval;
  const std::string place = "/two_interval/standard";
  for (const FactorLevel& level : question.standard) {
    const std::string message = complaint(scene_under(protocol, {level}));
    if (!message.empty()) {
      refuse(protocol.document, place + "/" + level.factor, message);
    }
  }
  for (const Condition& cell : cells(protocol.design)) {
    const Condition standard = standard_of(cell, question);
    const json scene = scene_under(protocol, standard);
    const auto problems = scene_problems(scene);
    if (!problems.empty()) {
      refuse(protocol.document, place,
             problems.front().pointer + " of the scene under " + to_json(standard).dump() + ": " +
                 problems.front().message);
    }
    if (depends_on_gaze(scene["engine"]) && !protocol.script.gaze) {
      refuse(protocol.document, place,
             "expected the key \"gaze\" in the protocol, because the detail of collisions depends "
             "on the gaze under " +
                 to_json(standard).dump() + ", but it is missing");
    }
  }
}

}  // namespace impetus::inline protocol
