// SPDX-License-Identifier: MIT
#include "experiments/protocol/script_reading.hpp"

#include "experiments/protocol/design_reading.hpp"
#include "experiments/questions/response_kinds.hpp"

namespace impetus::inline protocol {
namespace {

using nlohmann::json;

Text text_from(const json& object) {
  return {object["title"].get<std::string>(), object["paragraphs"].get<std::vector<std::string>>()};
}

Field field_from(const json& object) {
  const auto kind = object["kind"].get<std::string>();
  Field field;
  field.id = object["id"].get<std::string>();
  field.label = object["label"].get<std::string>();
  field.kind = kind == "number"   ? Field::Kind::kNumber
               : kind == "choice" ? Field::Kind::kChoice
                                  : Field::Kind::kText;
  field.options = object.value("options", std::vector<std::string>{});
  field.minimum = object.value("minimum", -1e9);
  field.maximum = object.value("maximum", 1e9);
  return field;
}

CalibrationTask calibration_from(const json& object) {
  CalibrationTask task;
  task.accuracy_limit_deg = object["accuracy_limit_deg"].get<double>();
  task.most_tries = object.value("most_tries", task.most_tries);
  task.drift_limit_deg = object.value("drift_limit_deg", task.drift_limit_deg);
  task.point_ms = object.value("point_ms", task.point_ms);
  return task;
}

GazeLossRule loss_rule_from(const json& object) {
  const auto policy = object["then"].get<std::string>();
  GazeLossRule rule;
  rule.most_lost_share = object["most_lost_share"].get<double>();
  rule.policy = policy == "keep"   ? GazeLossRule::Policy::kKeep
                : policy == "mark" ? GazeLossRule::Policy::kMark
                                   : GazeLossRule::Policy::kRepeat;
  rule.most_repeats = object.value("most_repeats", rule.most_repeats);
  return rule;
}

GazeTask gaze_from(const json& object) {
  GazeTask task;
  task.extra_latency_ms = object["extra_latency_ms"].get<double>();
  if (object.contains("calibration")) {
    task.calibration = calibration_from(object["calibration"]);
  }
  task.loss = object.contains("when_lost") ? loss_rule_from(object["when_lost"]) : GazeLossRule{};
  if (object.contains("yoked_to")) {
    const json& rule = object["yoked_to"];
    task.yoked_to =
        YokeRule{rule["participant"].get<std::string>(), rule.value("protocol", std::string())};
  }
  return task;
}

ResumeRule resume_rule_from(const json& object) {
  ResumeRule rule;
  if (object["at"].get<std::string>() == "block") {
    rule.at = ResumeRule::At::kBlock;
  }
  rule.refuse_after_h = object.value("refuse_after_h", rule.refuse_after_h);
  return rule;
}

}  // namespace

Script script_from(const json& document) {
  Script script;
  script.title = document["title"].get<std::string>();
  if (!document.contains("session")) {
    return script;
  }
  const json& session = document["session"];
  script.welcome = text_from(session["welcome"]);
  script.consent = text_from(session["consent"]);
  script.consent_statement = session["consent"]["statement"].get<std::string>();
  for (const json& field : session.value("demographics", json::array())) {
    script.demographics.push_back(field_from(field));
  }
  for (const json& page : session["instructions"]) {
    script.instructions.push_back(text_from(page));
  }
  if (session.contains("breaks")) {
    script.break_text = text_from(session["breaks"]);
    script.break_every = session["breaks"]["every"].get<std::int64_t>();
  }
  if (session.contains("resume")) {
    script.resume = resume_rule_from(session["resume"]);
  }
  for (const json& question : session.value("questions", json::array())) {
    script.questions.push_back(
        {question["id"].get<std::string>(), question["text"].get<std::string>()});
  }
  script.thanks = text_from(session["thanks"]);
  for (const json& entry : session.value("demonstrations", json::array())) {
    script.demonstrations.push_back({entry["id"].get<std::string>(), text_from(entry)});
  }
  script.asked = read_questions(document);
  script.timing = {document["timing"]["fixation_ms"].get<double>(),
                   document["timing"]["interval_ms"].get<double>()};
  if (document.contains("gaze")) {
    script.gaze = gaze_from(document["gaze"]);
  }
  script.practice_rule = practice_rule_from(document["design"]);
  script.training_rule = training_rule_from(document["design"]);
  return script;
}

}  // namespace impetus::inline protocol
