// SPDX-License-Identifier: MIT
#include "engine/trees/builders/power_cells.hpp"

#include <cstddef>
#include <iterator>
#include <limits>
#include <utility>

namespace impetus::inline trees {
namespace {

/// Where the power distance to `a` is at most that to `b`.
HalfSpace nearer_to(const Sphere& a, const Sphere& b) {
  // |p − a|² − ra² ≤ |p − b|² − rb²  ⇔  (a − b)·p ≥ (|a|² − |b|² + rb² − ra²)/2
  const double offset = 0.5 * (a.centre.squaredNorm() - b.centre.squaredNorm() +
                               b.radius_m * b.radius_m - a.radius_m * a.radius_m);
  return {a.centre - b.centre, offset};
}

}  // namespace

std::vector<SurfacePart> power_cells(SurfacePart part, const std::vector<Sphere>& spheres) {
  std::vector<SurfacePart> cells;
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    SurfacePart left;  // what is nearer to a later sphere
    for (std::size_t j = i + 1; j < spheres.size(); ++j) {
      auto [nearer, farther] = cut(part, nearer_to(spheres[i], spheres[j]));
      left.insert(left.end(), std::make_move_iterator(farther.begin()),
                  std::make_move_iterator(farther.end()));
      part = std::move(nearer);
    }
    cells.push_back(std::move(part));
    part = std::move(left);
  }
  return cells;
}

std::size_t least_power(const std::vector<Sphere>& spheres, const Vector3& point) {
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    const double power =
        (point - spheres[i].centre).squaredNorm() - spheres[i].radius_m * spheres[i].radius_m;
    if (power < least) {
      least = power;
      best = i;
    }
  }
  return best;
}

}  // namespace impetus::inline trees
