// SPDX-License-Identifier: MIT
#include "experiments/viewing/orbit_camera.hpp"

#include <algorithm>
#include <cmath>

#include "engine/numerics/elementary_functions.hpp"

namespace impetus::inline viewing {
namespace {

constexpr double kMostUp_deg = 89.0;
constexpr double kLeastMagnification = 0.25;
constexpr double kMostMagnification = 8.0;
constexpr double kPerNotch = 1.15;

/// `vector` turned about the unit `axis`. (Rodrigues)
Vector3 turned(const Vector3& vector, const Vector3& axis, double angle_deg) {
  const SineCosine angle = sine_cosine_deg(angle_deg);
  return angle.cosine * vector + angle.sine * axis.cross(vector) +
         (1.0 - angle.cosine) * axis.dot(vector) * axis;
}

}  // namespace

void OrbitCamera::turn(double right_deg, double up_deg) {
  right_deg_ = std::remainder(right_deg_ + right_deg, 360.0);
  up_deg_ = std::clamp(up_deg_ + up_deg, -kMostUp_deg, kMostUp_deg);
}

void OrbitCamera::zoom(double notches) {
  magnification_ = std::clamp(magnification_ * std::pow(kPerNotch, notches), kLeastMagnification,
                              kMostMagnification);
  constexpr double kAlmostOne = 1e-6;
  if (std::abs(magnification_ - 1.0) < kAlmostOne) {
    magnification_ = 1.0;  // as many notches back
  }
}

bool OrbitCamera::is_participants() const {
  return right_deg_ == 0.0 && up_deg_ == 0.0 && magnification_ == 1.0;
}

Viewer OrbitCamera::seen_from(const Viewer& own) const {
  if (is_participants()) {
    return own;
  }
  Viewer viewer = own;
  const Vector3 vertical = Vector3::UnitY();
  viewer.right = turned(own.right, vertical, right_deg_);
  const auto moved = [&](const Vector3& vector) {
    return turned(turned(vector, vertical, right_deg_), viewer.right, -up_deg_);
  };
  viewer.eye = moved(own.eye);
  viewer.up = moved(own.up);
  viewer.screen.width_m /= magnification_;
  viewer.screen.height_m /= magnification_;
  return viewer;
}

}  // namespace impetus::inline viewing
