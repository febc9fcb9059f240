// SPDX-License-Identifier: MIT
#include "engine/world/world_settings.hpp"

#include <cmath>

namespace impetus::inline world {
namespace {

std::string of_world(const std::string& problem) {
  return problem.empty() ? "" : "world: " + problem;
}

std::string problem_of(const ImposedRebound& rebound) {
  constexpr double kWholeTurnDeg = 360.0;
  if (!(std::abs(rebound.wider_deg) <= kWholeTurnDeg)) {
    return "an imposed rebound turns by 360 degrees at most";
  }
  if (!(std::abs(rebound.axis.norm() - 1.0) <= 1e-9)) {
    return "the axis of an imposed rebound must be a unit vector";
  }
  if (!(rebound.speed_ratio >= 0.0 && std::isfinite(rebound.speed_ratio))) {
    return "the speed ratio of an imposed rebound cannot be negative, and must be finite";
  }
  return "";
}

}  // namespace

std::string problem_of(const WorldSettings& settings) {
  if (!(settings.restitution >= 0.0 && settings.restitution <= 1.0)) {
    return "world: restitution must lie in [0, 1]";
  }
  if (!(settings.imposed_hold_s >= 0.0)) {
    return "world: an imposed hold cannot be negative";
  }
  if (settings.contacts.most_per_pair < 1) {
    return "world: a pair needs one contact or more";
  }
  if (settings.most_entry_tests < 0) {
    return "world: expected 0 or more tests of entry a step, got " +
           std::to_string(settings.most_entry_tests);
  }
  if (settings.imposed_spin &&
      !(settings.imposed_spin->spin.a.allFinite() && settings.imposed_spin->spin.b.allFinite())) {
    return "world: an imposed spin must be finite";
  }
  if (!settings.gravity_m_s2.allFinite()) {
    return "world: gravity must be finite";
  }
  if (!is_tried(settings.recording_format)) {
    return "world: expected the rules of recording format " +
           std::to_string(kOldestRecordingFormat) + " to " + std::to_string(kRecordingFormat) +
           ", got " + std::to_string(settings.recording_format);
  }
  if (settings.most_response_passes < 1) {
    return "world: the response needs one pass or more, got " +
           std::to_string(settings.most_response_passes);
  }
  const bool imposes =
      settings.imposed_hold_s > 0.0 || settings.imposed_spin || settings.imposed_rebound;
  if (!settings.figures.empty() && imposes) {
    return "world: expected no imposed hold, spin or rebound where there are figures";
  }
  if (!settings.figures.empty() && settings.response == ResponseMethod::kTogether) {
    return "world: expected impulses in turn where there are figures, got together";
  }
  for (const std::string& problem :
       {of_world(problem_of(settings.materials)),
        of_world(settings.enclosure ? problem_of(*settings.enclosure) : ""),
        of_world(settings.imposed_rebound ? problem_of(*settings.imposed_rebound) : ""),
        problem_of(settings.schedule), of_world(problem_of(settings.costs))}) {
    if (!problem.empty()) {
      return problem;
    }
  }
  return "";
}

}  // namespace impetus::inline world
