// SPDX-License-Identifier: MIT
#include "engine/world/world_settings.hpp"

namespace impetus::inline world {
namespace {

std::string of_world(const std::string& problem) {
  return problem.empty() ? "" : "world: " + problem;
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
  if (settings.most_response_passes < 1) {
    return "world: the response needs one pass or more, got " +
           std::to_string(settings.most_response_passes);
  }
  const bool imposes = settings.imposed_hold_s > 0.0 || settings.imposed_spin;
  if (!settings.figures.empty() && imposes) {
    return "world: expected no imposed hold or spin where there are figures";
  }
  if (!settings.figures.empty() && settings.response == ResponseMethod::kTogether) {
    return "world: expected impulses in turn where there are figures, got together";
  }
  for (const std::string& problem :
       {of_world(problem_of(settings.materials)),
        of_world(settings.enclosure ? problem_of(*settings.enclosure) : ""),
        problem_of(settings.schedule), of_world(problem_of(settings.costs))}) {
    if (!problem.empty()) {
      return problem;
    }
  }
  return "";
}

}  // namespace impetus::inline world
