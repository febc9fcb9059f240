// SPDX-License-Identifier: MIT
#include "experiments/protocol/spin_limits.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "engine/numerics/elementary_functions.hpp"
#include "engine/numerics/random_stream.hpp"
#include "experiments/protocol/screen_file.hpp"
#include "experiments/questions/level_value.hpp"
#include "experiments/run/scene_run.hpp"
#include "experiments/scenes/random_places.hpp"
#include "experiments/scenes/scene_bodies.hpp"
#include "experiments/scenes/scene_file.hpp"

namespace impetus::inline protocol {
namespace {

constexpr std::size_t kBodies = 2;
/// From the start to the collision, and after its last contact.
constexpr int kLeadSteps = 4;
constexpr int kClearSteps = 30;
constexpr int kMostSteps = 2000;

/// The scene with accurate collisions that begin soon, nothing imposed, and nobody looking on.
Scene accurate_scene(const SolveTask& task) {
  Scene scene = task.scene;
  scene.engine.level = task.entry.accurate_level;
  scene.imposed->random_spin->on = false;
  scene.imposed->contact_hold_ms = 0.0;
  scene.meeting->lead_s = kLeadSteps / scene.engine.step_hz;
  scene.distractors.reset();
  return scene;
}

void jitter(const SolveEntry& entry, double size_deg, RandomStream& stream, Scene& scene) {
  for (std::size_t body = 0; body < kBodies; ++body) {
    Quaternion& orientation = (*scene.bodies)[body].orientation;
    for (int axis = 0; axis < 3; ++axis) {
      orientation = turn_about(axis, entry.turn_deg * draw_symmetric(stream)) * orientation;
    }
  }
  auto offset_deg = scene.meeting->offset_deg.value_or(std::array<double, 2>{});
  for (double& component : offset_deg) {
    component += entry.size_share * size_deg * draw_symmetric(stream);
  }
  scene.meeting->offset_deg = offset_deg;
}

/// How the collision changed both angular velocities, over all its contacts; none without one.
std::optional<ImposedSpin> spin_change(StagedScene scene) {
  SceneRun run(std::move(scene));
  const World& world = run.world();
  std::array<Quaternion, kBodies> at_contact;
  std::array<Vector3, kBodies> momentum{world.states()[0].angular_momentum,
                                        world.states()[1].angular_momentum};
  int last_contact = -1;
  for (int step = 0; step < kMostSteps; ++step) {
    if (last_contact >= 0 ? step - last_contact > kClearSteps : step > 2 * kLeadSteps) {
      break;
    }
    if (!run.step_whole().collisions.empty()) {
      for (std::size_t body = 0; body < kBodies && last_contact < 0; ++body) {
        at_contact[body] = world.states()[body].pose.orientation;
      }
      last_contact = step;
    }
  }
  if (last_contact < 0) {
    return std::nullopt;
  }
  const auto change = [&](std::size_t body) {
    BodyState turned = world.states()[body];
    turned.pose.orientation = at_contact[body];
    turned.angular_momentum -= momentum[body];
    return angular_velocity(world.models()[body], turned);
  };
  return ImposedSpin{change(0), change(1)};
}

/// Both bodies' components, in the order of the limits.
using Components = std::array<std::vector<double>, 3 * kBodies>;

Components changes_of(const SolveTask& task, ShapeLibrary& shapes, const Progress& progress) {
  const Scene base = accurate_scene(task);
  const ScreenGeometry screen = assumed_screen();
  const double m_per_deg = metres_per_degree(screen.viewing_distance_m);
  const double size_deg = 2.0 * bodies_of(base, m_per_deg, shapes).shapes[0]->radius_m / m_per_deg;
  const std::size_t runs = task.entry.runs;
  RandomStream stream(1, "random spin limits");
  Components components;
  for (std::size_t start = 0; start < 2 * runs && components[0].size() < runs; ++start) {
    Scene scene = base;
    jitter(task.entry, size_deg, stream, scene);
    const auto change = spin_change(build_scene(scene, screen, 0.0, shapes));
    for (std::size_t i = 0; change && i < components.size(); ++i) {
      const Vector3& spin = i < 3 ? change->a : change->b;
      components[i].push_back(spin[static_cast<Eigen::Index>(i % 3)]);
    }
    progress(static_cast<double>(components[0].size()) / static_cast<double>(runs));
  }
  if (components[0].size() < runs) {
    refuse(*task.document, task.place + "/runs",
           "expected " + std::to_string(runs) + " accurate collisions, but of " +
               std::to_string(2 * runs) + " starts under " + to_json(task.condition).dump() +
               " only " + std::to_string(components[0].size()) + " led to one");
  }
  return components;
}

}  // namespace

RowList<SolveEntry> spin_limits_rows() {
  using E = SolveEntry;
  return {row("accurate_level", &E::accurate_level, whole<int>({0, 6}),
              "The level of accurate collisions."),
          row("runs", &E::runs, whole<std::size_t>({20, 100000})),
          row("turn_deg", &E::turn_deg, number({0, 180}),
              "Each start is turned about each axis by up to so much."),
          row("size_share", &E::size_share, number({0, 1}),
              "And shifted up or down, and to and fro, by up to this share of a body's size."),
          row("percentiles", &E::percentiles, several<2>(number({0, 100})),
              "The lower limit and the upper.")};
}

double percentile(std::vector<double> values, double percent) {
  std::sort(values.begin(), values.end());
  const double place = percent / 100.0 * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(std::floor(place));
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return values[below] + (place - std::floor(place)) * (values[above] - values[below]);
}

std::vector<SolvedValue> solve_spin_limits(const SolveTask& task, ShapeLibrary& shapes,
                                           const Progress& progress) {
  const Components components = changes_of(task, shapes, progress);
  const auto& [low, high] = task.entry.percentiles;
  std::vector<SolvedValue> values;
  for (std::size_t i = 0; i < components.size(); ++i) {
    const std::string body = task.entry.pointer + (i < 3 ? "/a/" : "/b/");
    const std::string component = "/" + std::to_string(i % 3);
    values.push_back({body + "least_rad_s" + component, percentile(components[i], low)});
    values.push_back({body + "most_rad_s" + component, percentile(components[i], high)});
  }
  return values;
}

}  // namespace impetus::inline protocol
