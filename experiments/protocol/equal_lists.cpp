// SPDX-License-Identifier: MIT
#include "experiments/protocol/equal_lists.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "engine/numerics/trigonometry.hpp"
#include "engine/scheduling/solved_thresholds.hpp"
#include "experiments/protocol/design_reading.hpp"
#include "experiments/protocol/screen_file.hpp"
#include "experiments/run/live_run.hpp"
#include "experiments/scenes/scene_file.hpp"
#include "experiments/scenes/scene_schedule.hpp"
#include "experiments/session/unattended.hpp"

namespace impetus::inline protocol {
namespace {

using nlohmann::json;

/// The pilot's collisions of two bodies.
struct Pilot {
  std::vector<double> measures;
  double share{0.0};  ///< of them in the first list
};

Pilot run_pilot(const json& scene, double pilot_s, ShapeLibrary& shapes, const Progress& progress) {
  LiveRun live(build_scene(scene, assumed_screen(), 0.0, shapes, "pilot"), 1);
  live.drop_digests();
  play_to(live, pilot_s, progress);
  Pilot pilot;
  for (const CollisionRecord& collision : live.take_collisions()) {
    if (!is_wall(collision.report.bodies.b) && collision.priority) {
      pilot.measures.push_back(*collision.priority);
      pilot.share += collision.report.list == 0 ? 1.0 : 0.0;
    }
  }
  pilot.share /= std::max(1.0, static_cast<double>(pilot.measures.size()));
  return pilot;
}

double threshold_of(const json& scene, double share, const std::vector<double>& measures) {
  const json& engine = scene["engine"];
  const double m_per_deg = metres_per_degree(assumed_screen().viewing_distance_m);
  const auto metric = make_metric(scheduler_of(engine), metric_options_of(engine, m_per_deg));
  return thresholds_for({share}, measures, *metric).front();
}

std::string percent(double share) {
  char text[32];
  std::snprintf(text, sizeof text, "%.0f", 100.0 * share);
  return text;
}

std::string parted(double share) { return percent(share) + " to " + percent(1.0 - share); }

}  // namespace

std::vector<SolvedValue> solve_equal_lists(const SolveTask& task, ShapeLibrary& shapes,
                                           const Progress& progress) {
  constexpr int kMostPilots = 6;
  const auto share = task.entry["share"].get<double>();
  const auto within = task.entry["within"].get<double>();
  const auto pilot_s = task.entry["pilot_s"].get<double>();
  const auto pointer = task.entry["pointer"].get<std::string>();
  json scene = task.scene;
  int number = 0;  // of pilots that are done
  const Progress tell_pilot = [&](double done) { progress((number + done) / kMostPilots); };
  Pilot pilot = run_pilot(scene, pilot_s, shapes, tell_pilot);
  for (number = 1; number < kMostPilots && !pilot.measures.empty(); ++number) {
    const double threshold = threshold_of(scene, share, pilot.measures);
    scene[json::json_pointer(pointer)] = threshold;
    pilot = run_pilot(scene, pilot_s, shapes, tell_pilot);
    if (!pilot.measures.empty() && std::abs(pilot.share - share) <= within) {
      return {{pointer, threshold}};
    }
  }
  refuse(*task.document, task.place,
         "expected a threshold that parts the pilot's collisions " + parted(share) + " within " +
             percent(within) + " %, but under " + to_json(task.condition).dump() +
             (pilot.measures.empty() ? " no two bodies collide in the pilot"
                                     : " the best found parts them " + parted(pilot.share)));
}

}  // namespace impetus::inline protocol
