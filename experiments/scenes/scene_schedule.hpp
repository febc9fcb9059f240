// The schedule of a scene: what orders its collisions, and how a step's work is shared among them.
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "engine/scheduling/metrics.hpp"
#include "engine/scheduling/priority_lists.hpp"
#include "experiments/scenes/scene_checks.hpp"

namespace impetus::inline scenes {

/// What decides a pair's list in `engine`: a metric's name, "region", or "" without a schedule.
std::string scheduler_of(const nlohmann::json& engine);

/// The keys of a schedule that say what its lists are parted by, each the name of a list rule. Of
/// several that a schedule says, the last is its key; of none, the first.
std::vector<std::string> limits_keys();
std::string limits_key(const nlohmann::json& schedule);

/// The schedule that `engine` asks for: one list to the finest level, or to `level`, when it asks
/// for none. Precondition: schedule_problems() is empty.
Schedule schedule_of(const nlohmann::json& engine, double metres_per_degree);

/// The deepest level to which any pair can be refined: of `level` or the lists, or the last of the
/// trees. The same precondition.
int deepest_level_of(const nlohmann::json& engine);

/// What the scheduler's metric needs beside its name.
MetricOptions metric_options_of(const nlohmann::json& engine, double metres_per_degree);

/// A place that a scene names in degrees, on the screen.
ScreenPoint screen_point_of(const nlohmann::json& point_deg, double metres_per_degree);

/// Whether the gaze decides the detail of collisions.
bool depends_on_gaze(const nlohmann::json& engine);

/// A time in steps of the engine; expected to be whole.
double steps_of(double duration_ms, const nlohmann::json& engine);

/// Whether a number of steps is whole but for rounding.
bool is_whole(double steps);

/// What is wrong with level and schedule beyond the schema.
std::vector<SceneProblem> schedule_problems(const nlohmann::json& engine);

}  // namespace impetus::inline scenes
