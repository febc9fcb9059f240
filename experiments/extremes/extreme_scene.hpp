// A scene at an extreme, in terms that any engine of rigid bodies understands: balls and blocks,
// what they weigh, where they are and how they move.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "engine/trees/tree_settings.hpp"
#include "engine/world/world.hpp"

namespace impetus::inline extremes {

/// The solids there are; all dimensions in metres.
struct SolidBall {
  double radius_m{0.1};
};

/// A block about its centre.
struct SolidBlock {
  Vector3 edges_m{0.1, 0.1, 0.1};
};

using Solid = std::variant<SolidBall, SolidBlock>;

/// Where a body is and how it moves, in world.
struct MotionSeen {
  Pose pose{};
  Vector3 velocity_m_s{Vector3::Zero()};
  Vector3 spin_rad_s{Vector3::Zero()};
};

/// A body as it starts.
struct ExtremeBody {
  Solid solid{};
  double mass_kg{1.0};  ///< 0: nothing moves or turns it
  MotionSeen start{};
  /// Of a block's volume tree, three levels deep; none: one volume, which is the solid itself.
  std::optional<TreeKind> tree{};
};

/// `name` says what is extreme about it, such as "1e-06 m". Restitution, gravity, walls and the
/// order of work are those of `settings`.
struct ExtremeScene {
  std::string name;
  std::vector<ExtremeBody> bodies;
  WorldSettings settings{};
  double step_s{1.0 / 240.0};
  std::int64_t steps{240};
  std::int64_t work_per_step{kUnlimitedTests};
};

/// Principal moments about the centre of mass, kg m²; zero where nothing turns the body.
Vector3 inertia_of(const ExtremeBody& body);

/// The scene in this engine. Trees are built once for each solid and kind, and kept.
World world_of(const ExtremeScene& scene);

MotionSeen motion_of(const BodyModel& model, const BodyState& state);

}  // namespace impetus::inline extremes
