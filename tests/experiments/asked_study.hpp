// Small studies that ask given questions of two spheres that meet without a delay or with one.
// SPDX-License-Identifier: MIT
#pragma once

#include "tests/experiments/fakes.hpp"
#include "tests/experiments/refusals.hpp"

namespace impetus {

inline constexpr const char* kAskRating = R"({"rating": {"question": "How believable was it?",
  "minimum": 1, "maximum": 3, "best": 1, "low_anchor": "very", "high_anchor": "not at all",
  "timeout_ms": 5000}})";
inline constexpr const char* kAskYesNo = R"({"yes_no": {"question": "Was there a delay?",
  "right_when": {"factor": "delay_ms", "above": 0}, "timeout_ms": 5000}})";
inline constexpr const char* kAskTwoInterval =
    R"({"two_interval": {"question": "Which had a delay?",
  "standard": {"delay_ms": 0}, "timeout_ms": 5000}})";
inline constexpr const char* kAskChoice = R"({"choice": {"question": "What happened?",
  "options": ["a hit", "a late hit", "a miss"], "timeout_ms": 5000,
  "right_when": {"factor": "delay_ms", "options": {"0": "a hit", "300": "a late hit"}}}})";
inline constexpr const char* kAskSlider = R"({"slider": {"scales": [{"question": "How late was it?",
  "minimum": 0, "maximum": 100, "words": ["not at all", "very"]}], "timeout_ms": 5000}})";
inline constexpr const char* kAskFreeText = R"({"free_text": {"question": "What did you see?"}})";
inline constexpr const char* kAskClicks = R"({"clicks": {"merge_within_ms": 100}})";

/// A delay of 0 or 300 ms, each twice; two practice trials, 300 ms first.
inline json asked_protocol(const std::vector<std::string>& questions) {
  json protocol = json::parse(shipped(kProtocolName));
  protocol.erase("rating");
  protocol["session"].erase("breaks");
  json& design = protocol["design"];
  design["factors"] = json::array({design["factors"][0]});
  design["factors"][0]["levels"] = {0, 300};
  design["repetitions"] = 2;
  design["practice"] = json::parse(R"([{"delay_ms": 300}, {"delay_ms": 0}])");
  for (const std::string& question : questions) {
    protocol.merge_patch(json::parse(question));
  }
  return protocol;
}

/// The spheres meet after a tenth of a second.
inline json asked_scene() {
  json scene = json::parse(shipped(kSceneName));
  scene["meeting"]["lead_s"] = scene["meeting"]["follow_s"] = 0.1;
  return scene;
}

inline Protocol study_of(const json& protocol) {
  return make_protocol(parse_json("asked.json", protocol.dump()),
                       parse_json("spheres.json", asked_scene().dump()));
}

inline Protocol asked(const std::vector<std::string>& questions) {
  return study_of(asked_protocol(questions));
}

inline std::string asked_refusal(const json& protocol) {
  return refusal([&] { static_cast<void>(study_of(protocol)); });
}

inline PlannedTrial trial_with_delay(double delay_ms, std::uint64_t seed = 1) {
  PlannedTrial trial;
  trial.slot = 1;
  trial.condition = {{"delay_ms", delay_ms}};
  trial.seed = seed;
  return trial;
}

/// One trial of a study, answered by choosing `choice` on every page.
inline AttemptRecord answered_trial(TestLab& lab, const PlannedTrial& trial, std::size_t choice) {
  lab.input.on_page = [choice](const Page& page) {
    Answer answer;
    answer.choice = choice;
    answer.fields.assign(page.fields.size(), "7");
    return answer;
  };
  return run_attempt(trial, 1, lab.protocol.script, {}, lab.ports()).record;
}

}  // namespace impetus
