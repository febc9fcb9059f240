// SPDX-License-Identifier: MIT
#include "engine/volumes/volume.hpp"

namespace impetus::inline volumes {

Sphere bounding_sphere(const Volume& volume) {
  return std::visit([](const auto& kind) { return bounding_sphere(kind); }, volume);
}

CoredVolume cored(const Volume& volume) {
  return std::visit([](const auto& kind) { return cored(kind); }, volume);
}

Volume placed(const Volume& volume, const Pose& pose) {
  return std::visit([&](const auto& kind) { return Volume(placed(kind, pose)); }, volume);
}

bool holds(const Volume& volume, const Vector3& point) {
  return std::visit([&](const auto& kind) { return holds(kind, point); }, volume);
}

double content_m3(const Volume& volume) {
  return std::visit([](const auto& kind) { return content_m3(kind); }, volume);
}

}  // namespace impetus::inline volumes
