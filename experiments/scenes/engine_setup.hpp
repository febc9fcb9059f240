// From what a scene says of the engine to what the engine is given: settings of the world,
// schedule, region, budget and trees. Precondition of all: engine_checks.hpp finds nothing.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "experiments/scenes/scene.hpp"

namespace impetus::inline scenes {

/// What `scene` says of the world's settings; holds, enclosure and schedule apart.
WorldSettings world_settings_of(const Scene& scene);

/// The number of a material by its name: those of the scene, in alphabetical order, from 1; 0 for
/// "", which none has.
int material_number(const Scene& scene, const std::string& name);

WorkBudget budget_of(const EngineSettings& engine);

/// One list to the finest level, or to `level`, when the scene asks for none.
Schedule schedule_of(const EngineSettings& engine, double metres_per_degree,
                     std::size_t bodies = 2);

/// Of several of limited_list_rule_names() that a schedule says, the last; of none, the first.
std::string limits_key(const ScheduleSettings& schedule);

/// The deepest level to which any pair can be refined: of `level` or the lists, or the last of the
/// trees.
int deepest_level_of(const EngineSettings& engine);

/// What the scheduler's metric needs beside its name.
MetricOptions metric_options_of(const EngineSettings& engine, double metres_per_degree,
                                std::size_t bodies = 2);

/// The region of high priority; kNone when the scheduler is another.
RegionRule region_of(const EngineSettings& engine, double metres_per_degree);

/// Whether the gaze decides the detail of collisions.
bool depends_on_gaze(const EngineSettings& engine);

/// An octree of the root alone when the scene says nothing; not built beyond `deepest_level`.
TreeSettings tree_settings_of(const EngineSettings& engine, int deepest_level = kGreatestTreeDepth);

/// A place that a scene names in degrees, on the screen.
ScreenPoint screen_point_of(const ScreenPlace& place_deg, double metres_per_degree);

/// A time in steps of the engine; expected to be whole.
double steps_of(double duration_ms, const EngineSettings& engine);

/// Whether a number of steps is whole but for rounding.
bool is_whole(double steps);

}  // namespace impetus::inline scenes
