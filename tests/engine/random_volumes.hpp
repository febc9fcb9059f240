// Random volumes of every kind, thin and degenerate ones among them.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>

#include "engine/volumes/volume.hpp"
#include "tests/engine/builders.hpp"

namespace impetus {

inline constexpr int kKinds = static_cast<int>(std::variant_size_v<Volume>);
inline constexpr std::array<const char*, kKinds> kKindNames{"Sphere", "LineSwept", "RectangleSwept",
                                                            "Box", "Cube"};

/// One of the 24 turns that bring the axes onto each other, exactly.
inline Quaternion right_angled_turn(RandomStream& random) {
  const double half = std::sqrt(0.5);
  const std::array<Quaternion, 4> quarters{Quaternion::Identity(), Quaternion(half, half, 0, 0),
                                           Quaternion(half, 0, half, 0),
                                           Quaternion(half, 0, 0, half)};
  return quarters[random.below(4)] * quarters[random.below(4)];
}

/// Parallel to the axes one time in three.
inline Quaternion any_turn(RandomStream& random) {
  return random.below(3) == 0 ? right_angled_turn(random) : random_turn(random);
}

/// Up to one metre; now and then nothing.
inline double any_length(RandomStream& random) {
  return random.below(8) == 0 ? 0.0 : uniform_in(random, 0.01, 1.0);
}

/// About `centre`, with a radius of at least a centimetre where it has one.
inline Volume random_volume(RandomStream& random, int kind, const Vector3& centre) {
  const Quaternion turn = any_turn(random);
  const double radius_m = uniform_in(random, 0.01, 0.6);
  const Vector3 half(any_length(random), any_length(random), any_length(random));
  switch (kind) {
    case 0:
      return Sphere{centre, radius_m};
    case 1:
      return LineSwept{centre, turn * Vector3(half[0], 0.0, 0.0), radius_m};
    case 2:
      return RectangleSwept{centre, turn * Vector3(half[0], 0.0, 0.0),
                            turn * Vector3(0.0, half[1], 0.0), radius_m};
    case 3:
      return Box{centre, half, turn};
    default:
      return Cube{centre, half[0], turn};
  }
}

inline Volume moved(const Volume& volume, const Vector3& way) {
  return placed(volume, {way, Quaternion::Identity()});
}

/// Larger by `factor` in every direction, about the origin.
inline Volume scaled(const Volume& volume, double factor) {
  return std::visit(
      [factor](auto kind) {
        kind.centre *= factor;
        if constexpr (requires { kind.radius_m; }) {
          kind.radius_m *= factor;
        }
        if constexpr (requires { kind.half_axis; }) {
          kind.half_axis *= factor;
        }
        if constexpr (requires { kind.half_u; }) {
          kind.half_u *= factor;
          kind.half_v *= factor;
        }
        if constexpr (requires { kind.half_extents_m; }) {
          kind.half_extents_m *= factor;
        }
        if constexpr (requires { kind.half_edge_m; }) {
          kind.half_edge_m *= factor;
        }
        return Volume(kind);
      },
      volume);
}

/// A core as its corners and a radius, worked out apart from the engine's cores.
struct Corners {
  std::vector<Vector3> places;
  double radius_m{0.0};
};

inline Corners corners_of(const Volume& volume) {
  Vector3 centre;
  Matrix3 halves = Matrix3::Zero();
  double radius_m = 0.0;
  if (const auto* sphere = std::get_if<Sphere>(&volume)) {
    centre = sphere->centre;
    radius_m = sphere->radius_m;
  } else if (const auto* line = std::get_if<LineSwept>(&volume)) {
    centre = line->centre;
    halves.col(0) = line->half_axis;
    radius_m = line->radius_m;
  } else if (const auto* rectangle = std::get_if<RectangleSwept>(&volume)) {
    centre = rectangle->centre;
    halves.col(0) = rectangle->half_u;
    halves.col(1) = rectangle->half_v;
    radius_m = rectangle->radius_m;
  } else if (const auto* box = std::get_if<Box>(&volume)) {
    centre = box->centre;
    halves = box->orientation.toRotationMatrix() * box->half_extents_m.asDiagonal();
  } else {
    const auto& cube = std::get<Cube>(volume);
    centre = cube.centre;
    halves = cube.orientation.toRotationMatrix() * cube.half_edge_m;
  }
  Corners corners{{}, radius_m};
  for (int index = 0; index < 8; ++index) {
    const Vector3 sides(index & 1 ? 1.0 : -1.0, index & 2 ? 1.0 : -1.0, index & 4 ? 1.0 : -1.0);
    corners.places.push_back(centre + halves * sides);
  }
  return corners;
}

}  // namespace impetus
