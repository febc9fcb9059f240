// What a scene says of the engine ("/engine"), as structs: read once from JSON, then passed on.
//
// Each member is a row of engine_settings.cpp (see settings/setting_rows.hpp); where the engine has
// the setting by itself, the row goes by its member. What a file may leave out, and what is asked
// whether it was said, is optional.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "engine/scheduling/metrics.hpp"
#include "engine/trees/tree_settings.hpp"
#include "engine/world/world_settings.hpp"
#include "experiments/record/staged_scene.hpp"
#include "experiments/settings/setting_rows.hpp"

namespace impetus::inline scenes {

/// The scheduler whose lists follow a region.
inline constexpr const char* kRegionScheduler = "region";

/// Right of the screen's centre and above it, degrees.
using ScreenPlace = std::array<double, 2>;

/// How few contacts the response gets.
struct ContactSettings {
  std::string reduction;  ///< one of reduction_names(); "": the average
  int most_per_pair{ContactModel{}.most_per_pair};
};

/// Who notices gaps, whose threshold rises by a share for each body beyond two.
struct WhoNotices : Noticing {
  double crowding_per_body{0.0};

  [[nodiscard]] Noticing among(std::size_t bodies) const {
    Noticing noticing = *this;
    const double others = bodies > 2 ? static_cast<double>(bodies - 2) : 0.0;
    noticing.threshold_arcmin *= 1.0 + crowding_per_body * others;
    return noticing;
  }
};

/// Which collisions are refined first, and how deep.
struct ScheduleSettings {
  std::string scheduler;  ///< a metric's name, or "region"
  std::optional<ScreenPlace> point_deg;
  std::optional<std::vector<WeightedTerm>> terms;
  std::optional<WhoNotices> noticing;
  std::optional<std::string> traversal;  ///< one of traversal_names()
  double persistence_ms{0.0};
  std::vector<PriorityList> lists;
  /// What lists are parted by, by the name of the list rule that it is for.
  std::map<std::string, std::vector<double>> limits;
};

/// Where collisions are of high priority.
struct RegionSettings {
  RegionKind kind{RegionKind::kAllGood};
  std::optional<ScreenPlace> point_deg;
  double radius_deg{0.0};
  double renewal_ms{250.0};
};

/// How much a step may do; exactly one of the two limits.
struct BudgetSettings {
  WorkCosts counts{};
  std::optional<std::int64_t> tests_per_step;
  std::optional<double> ms_per_step;
};

/// The restitution of contacts between two materials, in either order.
struct MaterialPair {
  std::array<std::string, 2> pair;
  double restitution{1.0};
};

/// How a scene's world is stepped, as its file says.
struct EngineSettings {
  EngineSettings() = default;
  /// Precondition: valid by the scene's schema.
  EngineSettings(const nlohmann::json& valid);  // NOLINT(google-explicit-constructor)

  /// Restitution, tunnelling, response, rotation and their limits; the rest is not said here.
  WorldSettings world;
  double step_hz{240.0};
  std::optional<std::vector<MaterialPair>> materials;
  ContactSettings contacts;
  std::optional<Vector3> gravity_m_s2;
  std::optional<int> tree_depth;
  std::optional<TreeSettings> tree;
  std::optional<int> level;
  std::optional<ScheduleSettings> schedule;
  std::optional<RegionSettings> region;
  std::optional<BudgetSettings> budget;

  /// The deepest level of the trees.
  [[nodiscard]] int finest_level() const { return tree_depth.value_or(0); }
  /// What decides a pair's list: a metric's name, "region", or "" without a schedule.
  [[nodiscard]] std::string scheduler() const { return schedule ? schedule->scheduler : ""; }
};

/// The rows of all these.
const Kind<EngineSettings>& engine_kind();

/// Kinds that other parts of a scene have, too.
Kind<int> level_kind();
Kind<std::string> material_kind();
Kind<ScreenPlace> screen_place_kind(const std::string& sentence);
Kind<TreeKind> kind_of_trees();

/// The words for kinds of region.
const Names<RegionKind>& region_names();

}  // namespace impetus::inline scenes
