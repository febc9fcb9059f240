// SPDX-License-Identifier: MIT
#include "engine/volumes/volume.hpp"

#include <algorithm>
#include <iterator>

#include "engine/volumes/core_contact.hpp"
#include "engine/volumes/core_distance.hpp"

namespace impetus::inline volumes {
namespace {

/// What answers the questions of a pair of kinds.
struct PairProcedures {
  bool (*overlap)(const Volume& a, const Volume& b);
  TouchPoint (*touch)(const Volume& a, const Volume& b, const Vector3& fallback);
};

bool spheres_overlap(const Volume& a, const Volume& b) {
  return overlap(*std::get_if<Sphere>(&a), *std::get_if<Sphere>(&b));
}

TouchPoint touch_of_spheres(const Volume& a, const Volume& b, const Vector3& fallback) {
  return touch(*std::get_if<Sphere>(&a), *std::get_if<Sphere>(&b), fallback);
}

bool swept_overlap(const Volume& a, const Volume& b) {
  const CoredVolume of_a = cored(a);
  const CoredVolume of_b = cored(b);
  const double reach_m = of_a.radius_m + of_b.radius_m;
  return comes_after(of_a, of_b) ? come_within(of_b.core, of_a.core, reach_m)
                                 : come_within(of_a.core, of_b.core, reach_m);
}

TouchPoint touch_of_cores(const Volume& a, const Volume& b, const Vector3& fallback) {
  return core_contact(cored(a), cored(b), fallback);
}

bool boxes_overlap(const Volume& a, const Volume& b) {
  const CoredVolume of_a = cored(a);
  const CoredVolume of_b = cored(b);
  return comes_after(of_a, of_b) ? !are_separated(of_b.core, of_a.core, 0.0)
                                 : !are_separated(of_a.core, of_b.core, 0.0);
}

TouchPoint touch_of_circumscribed(const Volume& a, const Volume& b, const Vector3& fallback) {
  return touch(bounding_sphere(a), bounding_sphere(b), fallback);
}

constexpr PairProcedures kSpheres{spheres_overlap, touch_of_spheres};
constexpr PairProcedures kSwept{swept_overlap, touch_of_cores};
constexpr PairProcedures kBoxes{boxes_overlap, touch_of_cores};
constexpr PairProcedures kCubes{boxes_overlap, touch_of_circumscribed};
constexpr PairProcedures kMirrored{};  // the row of the other kind has the pair

// In the order of Volume's kinds.
// clang-format off
constexpr PairProcedures kTable[][std::variant_size_v<Volume>] = {
    //                     Sphere     LineSwept  RectangleSwept  Box        Cube
    /* Sphere         */ { kSpheres,  kSwept,    kSwept,         kSwept,    kSwept },
    /* LineSwept      */ { kMirrored, kSwept,    kSwept,         kSwept,    kSwept },
    /* RectangleSwept */ { kMirrored, kMirrored, kSwept,         kSwept,    kSwept },
    /* Box            */ { kMirrored, kMirrored, kMirrored,      kBoxes,    kBoxes },
    /* Cube           */ { kMirrored, kMirrored, kMirrored,      kMirrored, kCubes },
};
// clang-format on
static_assert(std::size(kTable) == std::variant_size_v<Volume>);

double share_of(double width_m, double depth_m) {
  if (!(width_m > 0.0)) {
    return depth_m >= 0.0 ? 1.0 : 0.0;
  }
  return std::clamp(depth_m / width_m, 0.0, 1.0);
}

}  // namespace

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

bool overlap(const Volume& a, const Volume& b) {
  const bool in_order = a.index() <= b.index();
  const Volume& first = in_order ? a : b;
  const Volume& second = in_order ? b : a;
  return kTable[first.index()][second.index()].overlap(first, second);
}

TouchPoint touch(const Volume& a, const Volume& b, const Vector3& fallback) {
  if (a.index() <= b.index()) {
    return kTable[a.index()][b.index()].touch(a, b, fallback);
  }
  TouchPoint contact = kTable[b.index()][a.index()].touch(b, a, -fallback);
  contact.normal = -contact.normal;
  return contact;
}

double width_along(const Volume& volume, const Vector3& direction) {
  const CoredVolume whole = cored(volume);
  return 2.0 * (reach_along(whole.core, direction) + whole.radius_m);
}

double interpenetration(const Volume& a, const Volume& b, const TouchPoint& contact) {
  const bool cubes = std::holds_alternative<Cube>(a) && std::holds_alternative<Cube>(b);
  const auto width_m = [&](const Volume& volume) {
    return cubes ? 2.0 * bounding_sphere(volume).radius_m : width_along(volume, contact.normal);
  };
  return share_of(std::min(width_m(a), width_m(b)), contact.depth_m);
}

double wall_interpenetration(const Volume& volume, const TouchPoint& contact) {
  return share_of(width_along(volume, contact.normal), contact.depth_m);
}

}  // namespace impetus::inline volumes
