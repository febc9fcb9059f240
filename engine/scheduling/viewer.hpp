// The viewer: where the eye is, the screen it looks at, and how fast it sees things move.
//
// The world is life-size: the screen lies in the plane through the world's origin that faces the
// eye, so a metre in that plane is a metre on the glass.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "engine/numerics/vector.hpp"
#include "engine/volumes/view_frustum.hpp"

namespace impetus::inline scheduling {

/// The screen as the viewer meets it: size in metres and pixels, eye to screen in metres.
struct ScreenGeometry {
  double width_m{0.0};
  double height_m{0.0};
  int width_px{0};
  int height_px{0};
  double viewing_distance_m{0.0};
};

/// The eye (metres, world) and the two unit directions that span the screen.
struct Viewer {
  ScreenGeometry screen;
  Vector3 eye{Vector3::UnitZ()};
  Vector3 right{Vector3::UnitX()};
  Vector3 up{Vector3::UnitY()};
  Vector3 velocity{Vector3::Zero()};  ///< of the eye (m/s)
  Vector3 turning{Vector3::Zero()};   ///< angular velocity of the view (rad/s)
};

/// An eye at the viewing distance, turned about the vertical by `azimuth_deg` from the z axis: the
/// angle between the world's x axis and the image plane. It is raised by `elevation_deg` (from 0 to
/// below 90) above the horizontal plane through the world's origin, and looks down at the origin.
Viewer viewer_at(const ScreenGeometry& screen, double azimuth_deg, double elevation_deg = 0.0);

/// What the viewer sees through the screen from `front_m` before it to `back_m` behind it.
ViewFrustum view_frustum(const Viewer& viewer, double front_m, double back_m);

/// A point of the screen: metres right of and above its centre.
struct ScreenPoint {
  double x_m{0.0};
  double y_m{0.0};

  friend bool operator==(const ScreenPoint&, const ScreenPoint&) = default;
};

/// Where the viewer looks, when that is known.
using Fixation = std::optional<ScreenPoint>;

/// A disc about a point of the screen, as the eye sees it.
struct GazeRegion {
  ScreenPoint centre;
  double radius_deg{0.0};
};

/// Where a point of the screen is in the world.
Vector3 on_screen(const Viewer& viewer, const ScreenPoint& point);

/// Where a point of the world appears on the screen; none when it is not before the eye.
std::optional<ScreenPoint> projected(const Viewer& viewer, const Vector3& point);

/// The angle at the eye between two points of the world (degrees).
double visual_angle_deg(const Viewer& viewer, const Vector3& p, const Vector3& q);

/// The velocity, as the viewer's moving frame has it, of what is at `place` and moves at
/// `velocity` (m/s, world).
///
///   V = v − v_cam − ω_cam × X     X from the eye
///
/// A body that moves and turns with the eye is seen standing still. An eye at rest changes no bit.
/// (Dingliana 2002, eq. 5.1, corrected: the camera's terms are taken off, in one frame and unit)
Vector3 seen_velocity(const Viewer& viewer, const Vector3& place, const Vector3& velocity);

/// The speed at which its direction from the eye changes (degrees per second): ‖X × V‖ / ‖X‖².
double angular_speed_deg_s(const Viewer& viewer, const Vector3& place, const Vector3& velocity);

}  // namespace impetus::inline scheduling
