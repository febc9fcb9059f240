// SPDX-License-Identifier: MIT
#include "experiments/scenes/scene_region.hpp"

#include <cmath>
#include <map>

#include "experiments/scenes/scene_schedule.hpp"

namespace impetus::inline scenes {
namespace {

using nlohmann::json;

constexpr double kDefaultRenewal_ms = 250.0;

RegionKind region_kind(const std::string& name) {
  static const std::map<std::string, RegionKind> kKinds{
      {"all-good", RegionKind::kAllGood}, {"all-bad", RegionKind::kAllBad},
      {"tracked", RegionKind::kTracked},  {"random", RegionKind::kRandom},
      {"fixed", RegionKind::kFixed},      {"recorded", RegionKind::kRecorded}};
  return kKinds.at(name);
}

double renewal_steps(const json& engine) {
  return steps_of(engine["region"].value("renewal_ms", kDefaultRenewal_ms), engine);
}

void add_kind_problems(const json& engine, std::vector<SceneProblem>& problems) {
  const double steps = renewal_steps(engine);
  if (steps < 1.0 || !is_whole(steps)) {
    problems.push_back({"/engine/region/renewal_ms",
                        "expected a whole number of steps of 1/" + engine["step_hz"].dump() +
                            " s, got " +
                            engine["region"].value("renewal_ms", json(kDefaultRenewal_ms)).dump()});
  }
  const json& region = engine["region"];
  const bool is_fixed = region_kind(region["kind"].get<std::string>()) == RegionKind::kFixed;
  if (is_fixed && !region.contains("point_deg")) {
    problems.push_back(
        {"/engine/region", "expected the key \"point_deg\" for kind fixed, which is missing"});
  }
  if (!is_fixed && region.contains("point_deg")) {
    problems.push_back({"/engine/region/point_deg", "expected none for kind " +
                                                        region["kind"].get<std::string>() +
                                                        ", got " + region["point_deg"].dump()});
  }
}

}  // namespace

RegionRule region_of(const json& engine, double metres_per_degree) {
  if (scheduler_of(engine) != kRegionScheduler) {
    return {};
  }
  const json& region = engine["region"];
  RegionRule rule;
  rule.kind = region_kind(region["kind"].get<std::string>());
  rule.radius_deg = region["radius_deg"].get<double>();
  rule.renewal_steps = std::llround(renewal_steps(engine));
  if (rule.kind == RegionKind::kFixed) {
    rule.point = screen_point_of(region["point_deg"], metres_per_degree);
  }
  return rule;
}

void add_region_problems(const json& engine, std::vector<SceneProblem>& problems) {
  const bool by_region = scheduler_of(engine) == kRegionScheduler;
  if (by_region && !engine.contains("region")) {
    problems.push_back(
        {"/engine", "expected the key \"region\" for the scheduler region, which is missing"});
  }
  if (!by_region && engine.contains("region")) {
    problems.push_back(
        {"/engine/region", "expected the scheduler region with it, got " +
                               (engine.contains("schedule") ? engine["schedule"]["scheduler"].dump()
                                                            : std::string("no schedule"))});
  }
  if (by_region && engine.contains("region")) {
    add_kind_problems(engine, problems);
  }
}

}  // namespace impetus::inline scenes
