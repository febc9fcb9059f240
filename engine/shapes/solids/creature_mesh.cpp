// SPDX-License-Identifier: MIT
#include "engine/shapes/solids/creature_mesh.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "engine/shapes/solids/level_set_mesh.hpp"

namespace impetus::inline shapes {
namespace {

/// A straight piece of the animal, thick about one end and thin about the other, in lengths of it.
struct Bone {
  std::array<double, 3> from;
  std::array<double, 3> to;
  double from_radius;
  double to_radius;
};

/// Limbs differ from one another and head and tail turn aside: no symmetry to be mistaken about.
constexpr std::array kBones{
    Bone{{-0.17, 0.00, 0.00}, {0.14, 0.02, 0.00}, 0.110, 0.125},  // trunk
    Bone{{0.17, 0.06, 0.00}, {0.28, 0.23, 0.02}, 0.090, 0.065},   // neck
    Bone{{0.29, 0.25, 0.02}, {0.43, 0.21, 0.07}, 0.085, 0.055},   // head
    Bone{{0.27, 0.30, 0.06}, {0.20, 0.40, 0.11}, 0.046, 0.042},   // horns
    Bone{{0.27, 0.30, -0.03}, {0.21, 0.40, -0.09}, 0.046, 0.042},
    Bone{{0.14, -0.03, 0.09}, {0.21, -0.16, 0.13}, 0.064, 0.054},  // right fore leg
    Bone{{0.21, -0.16, 0.13}, {0.28, -0.32, 0.13}, 0.054, 0.050},
    Bone{{0.28, -0.32, 0.13}, {0.33, -0.32, 0.13}, 0.050, 0.046},
    Bone{{0.13, -0.03, -0.09}, {0.11, -0.17, -0.13}, 0.064, 0.054},  // left fore leg
    Bone{{0.11, -0.17, -0.13}, {0.05, -0.32, -0.13}, 0.054, 0.050},
    Bone{{0.05, -0.32, -0.13}, {0.10, -0.32, -0.13}, 0.050, 0.046},
    Bone{{-0.17, -0.02, 0.08}, {-0.23, -0.15, 0.12}, 0.076, 0.056},  // right hind leg
    Bone{{-0.23, -0.15, 0.12}, {-0.34, -0.31, 0.12}, 0.056, 0.050},
    Bone{{-0.34, -0.31, 0.12}, {-0.29, -0.32, 0.12}, 0.050, 0.046},
    Bone{{-0.17, -0.02, -0.08}, {-0.12, -0.17, -0.12}, 0.076, 0.056},  // left hind leg
    Bone{{-0.12, -0.17, -0.12}, {-0.14, -0.32, -0.12}, 0.056, 0.050},
    Bone{{-0.14, -0.32, -0.12}, {-0.09, -0.32, -0.12}, 0.050, 0.046},
    Bone{{-0.22, 0.03, 0.00}, {-0.36, 0.06, -0.03}, 0.078, 0.060},  // tail
    Bone{{-0.36, 0.06, -0.03}, {-0.45, 0.16, -0.10}, 0.060, 0.048},
    Bone{{-0.45, 0.16, -0.10}, {-0.43, 0.28, -0.18}, 0.048, 0.044}};

/// How near two surfaces must come to flow together.
constexpr double kBlend = 0.035;

/// Signed distance to a round cone, near enough for a level set.
double distance_to(const Bone& bone, const Vector3& point) {
  const Vector3 from(bone.from[0], bone.from[1], bone.from[2]);
  const Vector3 along = Vector3(bone.to[0], bone.to[1], bone.to[2]) - from;
  const double share = std::clamp((point - from).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (point - from - share * along).norm() -
         (bone.from_radius + share * (bone.to_radius - bone.from_radius));
}

/// The lesser of two, with the crease between them filled. (Quilez 2013, polynomial smooth minimum)
double blended(double a, double b) {
  const double overlap = std::max(kBlend - std::fabs(a - b), 0.0);
  return std::min(a, b) - overlap * overlap / (4.0 * kBlend);
}

double distance_to_creature(const Vector3& point) {
  double distance = distance_to(kBones.front(), point);
  for (std::size_t bone = 1; bone < kBones.size(); ++bone) {
    distance = blended(distance, distance_to(kBones[bone], point));
  }
  return distance;
}

/// Scaled so that x runs over `length_m` exactly, whatever the grid cut off.
void stretch(TriangleMesh& mesh, double length_m) {
  double least = mesh.vertices.front().x();
  double most = least;
  for (const Vector3& vertex : mesh.vertices) {
    least = std::min(least, vertex.x());
    most = std::max(most, vertex.x());
  }
  for (Vector3& vertex : mesh.vertices) {
    vertex *= length_m / (most - least);
  }
}

}  // namespace

TriangleMesh creature_mesh(double length_m, int cells) {
  assert(length_m > 0.0 && cells >= 8 && cells <= 48 && cells % 4 == 0);
  const double cell = 1.0 / cells;
  const Vector3 least(-0.52, -0.39, -0.25);
  const Vector3 most(0.52, 0.47, 0.20);
  SampleGrid grid{least - Vector3::Constant(cell), cell, {}};
  for (int axis = 0; axis < 3; ++axis) {
    grid.cells[static_cast<std::size_t>(axis)] =
        static_cast<int>((most[axis] - least[axis]) * cells) + 3;
  }
  TriangleMesh mesh = level_set_mesh(distance_to_creature, grid);
  stretch(mesh, length_m);
  return mesh;
}

}  // namespace impetus::inline shapes
