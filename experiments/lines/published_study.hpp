// A published study: all that a page needs to run its sessions, as one JSON document.
//
//   protocol, checked ──publish──> study.json, trees ──a page──> the same protocol, trusted
//
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "engine/world/world_settings.hpp"
#include "experiments/design/plan.hpp"
#include "experiments/protocol/protocol_file.hpp"
#include "experiments/protocol/solved_values.hpp"

namespace impetus::inline lines {

/// What is published.
struct PublishedStudy {
  std::string protocol_json;
  std::string scene_json;
  std::vector<SolvedFor> solved;           ///< for the plan of whoever comes
  std::string build;                       ///< of the program that published it
  int recording_format{kRecordingFormat};  ///< of its page, and so of the sessions
};

nlohmann::json to_json(const PublishedStudy& study);

/// Throws std::runtime_error, in words, for anything but what to_json() makes.
PublishedStudy published_study_from(const nlohmann::json& document);

/// Its protocol, whose shapes may be fetched from a cache. Nothing is checked again.
Protocol protocol_of(const PublishedStudy& study, std::shared_ptr<ShapeLibrary> shapes);

/// The plan of a participant of a published study: the same in the page and in the program.
Plan plan_of(const PublishedStudy& study, const Protocol& protocol, const std::string& participant,
             std::uint64_t seed);

}  // namespace impetus::inline lines
