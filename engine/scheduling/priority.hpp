// Which collisions are refined first.
//
// A metric gives each pair a number; larger means sooner. A new metric is one class here (or in a
// file of its own) and one name in the scene's schema. (Dingliana 2002, sec. 5.1.2 and 5.2)
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "engine/scheduling/viewer.hpp"
#include "engine/shapes/sphere.hpp"

namespace impetus {

/// Two bodies by their index in the world, a < b.
struct BodyPair {
  std::int32_t a{0};
  std::int32_t b{0};

  friend bool operator==(const BodyPair&, const BodyPair&) = default;
};

/// What a metric may look at: the bounding spheres of both bodies, in world.
struct PairBounds {
  BodyPair pair;
  Sphere a;
  Sphere b;
};

class PriorityMetric {
 public:
  virtual ~PriorityMetric() = default;
  [[nodiscard]] virtual double priority(const PairBounds& bounds, const Viewer& viewer) const = 0;
};

/// Near is high: minus the distance (metres) from the eye to the midpoint of the two centres.
class DistancePriority final : public PriorityMetric {
 public:
  [[nodiscard]] double priority(const PairBounds& bounds, const Viewer& viewer) const override;
};

/// The pairs by falling priority; equal priorities keep their order.
std::vector<BodyPair> prioritised(const std::vector<PairBounds>& bounds,
                                  const PriorityMetric& metric, const Viewer& viewer);

}  // namespace impetus
