// SPDX-License-Identifier: MIT
#include "experiments/scenes/random_places.hpp"

#include <cmath>
#include <variant>

namespace impetus::inline scenes {

double draw_symmetric(RandomStream& stream) { return 2.0 * stream.uniform() - 1.0; }

// By rejection: no trigonometry.
Vector3 draw_direction(RandomStream& stream) {
  while (true) {
    const double x = draw_symmetric(stream);
    const double y = draw_symmetric(stream);
    const Vector3 point(x, y, draw_symmetric(stream));
    const double square = point.squaredNorm();
    if (square > 1e-4 && square <= 1.0) {
      return point / std::sqrt(square);
    }
  }
}

// A unit quaternion by rejection.
Quaternion draw_orientation(RandomStream& stream) {
  while (true) {
    const double w = draw_symmetric(stream);
    const double x = draw_symmetric(stream);
    const double y = draw_symmetric(stream);
    const double z = draw_symmetric(stream);
    const double square = w * w + x * x + y * y + z * z;
    if (square > 1e-4 && square <= 1.0) {
      const double scale = 1.0 / std::sqrt(square);
      return Quaternion(scale * w, scale * x, scale * y, scale * z);
    }
  }
}

Room room_within(const Enclosure& enclosure, double radius_m) {
  if (const auto* cube = std::get_if<ClosedCube>(&enclosure)) {
    return {Vector3::Zero(), Vector3::Constant(cube->half_edge_m - radius_m), nullptr};
  }
  constexpr int kCorners = 8;
  Eigen::AlignedBox3d box;
  for (int index = 0; index < kCorners; ++index) {
    box.extend(corner(enclosure, index));
  }
  return {box.center(), 0.5 * box.sizes(), &enclosure};
}

Vector3 draw_place(const Room& room, RandomStream& stream) {
  const double x = draw_symmetric(stream);
  const double y = draw_symmetric(stream);
  const Vector3 share(x, y, draw_symmetric(stream));
  return room.centre + room.half_extents_m.cwiseProduct(share);
}

}  // namespace impetus::inline scenes
