// SPDX-License-Identifier: MIT
#include "experiments/lines/published_study.hpp"

#include <stdexcept>
#include <utility>

#include "experiments/design/between_participants.hpp"
#include "experiments/protocol/checks/protocol_checks.hpp"
#include "experiments/questions/level_value.hpp"

namespace impetus::inline lines {
namespace {

using nlohmann::json;

constexpr int kFormat = 1;

json solved_json(const SolvedFor& solved) {
  return {{"condition", to_json(solved.condition)}, {"values", solved_values_json(solved.values)}};
}

SolvedFor solved_from(const json& solved) {
  return {condition_from_json(solved.at("condition")),
          solved_values_from_json(solved.at("values"))};
}

}  // namespace

json to_json(const PublishedStudy& study) {
  json solved = json::array();
  for (const SolvedFor& each : study.solved) {
    solved.push_back(solved_json(each));
  }
  return {{"format", kFormat},
          {"build", study.build},
          {"recording_format", study.recording_format},
          {"protocol", study.protocol_json},
          {"scene", study.scene_json},
          {"solved", solved}};
}

PublishedStudy published_study_from(const json& document) {
  if (!document.is_object() || document.value("format", 0) != kFormat) {
    throw std::runtime_error("expected a study that was published in format " +
                             std::to_string(kFormat));
  }
  PublishedStudy study;
  study.build = document.at("build").get<std::string>();
  constexpr int kUnsaid = 2;  // by those that did not say it
  study.recording_format = document.value("recording_format", kUnsaid);
  if (!is_tried(study.recording_format)) {
    throw std::runtime_error(
        "expected sessions of recording format " + std::to_string(kOldestRecordingFormat) + " to " +
        std::to_string(kRecordingFormat) + ", got " + std::to_string(study.recording_format) +
        ", published by " + study.build);
  }
  study.protocol_json = document.at("protocol").get<std::string>();
  study.scene_json = document.at("scene").get<std::string>();
  for (const json& each : document.at("solved")) {
    study.solved.push_back(solved_from(each));
  }
  return study;
}

Protocol protocol_of(const PublishedStudy& study, std::shared_ptr<ShapeLibrary> shapes) {
  Protocol protocol = trusted_protocol(parse_json("the protocol", study.protocol_json),
                                       parse_json("its scene", study.scene_json));
  protocol.shapes = std::move(shapes);
  return protocol;
}

Plan plan_of(const PublishedStudy& study, const Protocol& protocol, const std::string& participant,
             std::uint64_t seed) {
  const Condition group = draw_group(protocol.design, {protocol.name, participant, seed}, {});
  Plan plan = plan_for(protocol, participant, seed, group);
  put_solved(study.solved, plan);
  return plan;
}

}  // namespace impetus::inline lines
