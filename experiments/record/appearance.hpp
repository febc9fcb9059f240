// How a scene's bodies and what is about them are painted, beyond shapes and colours.
//
// All of it is drawing: no step of the world looks at it. A picture follows from it, the bodies'
// poses and the viewer alone, so a replay shows what the session showed.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "engine/numerics/vector.hpp"

namespace impetus::inline record {

using Colour = std::array<float, 3>;  ///< sRGB, 0–1

/// What the ground shows: nothing at all, one colour, or fields in turn.
enum class GroundPattern { kNone, kPlain, kChecks };

/// What the surface of a body shows beside its colour; each is solid, and turns with the body.
enum class SurfaceTexture { kNone, kWood, kMarble, kSpeckles };

/// A light that is so far away that it shines from one direction.
struct DistantLight {
  Vector3 towards{Vector3::UnitY()};  ///< unit, world
  double strength{1.0};               ///< 1: as bright as the one of a scene that names none
};

inline constexpr std::size_t kMostLights = 4;

/// Where the one light of a scene that names none shines from, as its viewer sees it: right, up and
/// towards the viewer (kLightingShader of gl_parts.hpp has the same).
inline Vector3 usual_light() { return Vector3(-0.55, 0.75, 0.60).normalized(); }

/// The share of a light that a surface reflects where it shines, before there was a choice.
inline constexpr double kUsualGloss = 0.1;

/// Faces of a body that meet at a smaller angle are shaded as one round surface.
inline constexpr double kUsualSmoothing_deg = 30.0;

/// What a painter needs to know beside bodies, walls and viewer.
struct Appearance {
  GroundPattern ground{GroundPattern::kNone};
  Colour ground_colour{};
  double check_m{0.0};              ///< of the ground's fields, along one side
  std::optional<double> floor_m{};  ///< how high the ground, or a cube's floor, lies in the world
  std::vector<DistantLight> lights{};
  double cast_shadows{0.0};     ///< the share of a light that a body in its way takes
  double contact_shadows{0.0};  ///< the share of all light that a body on the floor takes
  double contact_reach_m{0.0};  ///< how high above the floor a body still takes some
  double shadow_reach_m{0.0};   ///< how far about the world's origin shadows are cast and fall
  SurfaceTexture texture{SurfaceTexture::kNone};  ///< of bodies that have none of their own
  double gloss{kUsualGloss};
  double smooth_below_deg{kUsualSmoothing_deg};
};

}  // namespace impetus::inline record
