// SPDX-License-Identifier: MIT
#include "experiments/protocol/script_reading.hpp"

#include "experiments/protocol/design_reading.hpp"

namespace impetus {
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

RatingScale scale_from(const json& object) {
  return {object["question"].get<std::string>(),   object["minimum"].get<std::int64_t>(),
          object["maximum"].get<std::int64_t>(),   object["best"].get<std::int64_t>(),
          object["low_anchor"].get<std::string>(), object["high_anchor"].get<std::string>()};
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
  for (const json& question : session.value("questions", json::array())) {
    script.questions.push_back(
        {question["id"].get<std::string>(), question["text"].get<std::string>()});
  }
  script.thanks = text_from(session["thanks"]);
  for (const json& entry : session.value("demonstrations", json::array())) {
    script.demonstrations.push_back({entry["id"].get<std::string>(), text_from(entry)});
  }
  script.scale = scale_from(document["rating"]);
  script.timing = {document["timing"]["fixation_ms"].get<double>(),
                   document["timing"]["interval_ms"].get<double>()};
  if (document.contains("clicks")) {
    script.clicks = ClickTask{document["clicks"]["merge_within_ms"].get<double>()};
  }
  if (document.contains("gaze")) {
    script.gaze = GazeTask{document["gaze"]["extra_latency_ms"].get<double>()};
  }
  script.practice_rule = practice_rule_from(document["design"]);
  return script;
}

}  // namespace impetus
