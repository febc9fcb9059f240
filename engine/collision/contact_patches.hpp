// Contacts gathered by the pair of surface groups that they lie on, each patch a weighted mean.
//
//   (group of a, group of b) --> patch, patch ...      Σ P, Σ P n, Σ P p, greatest depth
//
// A contact joins, of its groups' patches, the one whose mean of unit normals stays longest; where
// it would fall below kOneSurfaceCosine the patch would not be one surface, so the contact starts
// another. (Dingliana 2002, sec. 4.2.3 and eq. 4.11 and 4.12, corrected)
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "engine/volumes/sphere.hpp"

namespace impetus {

/// Length of the mean of unit normals below which they are not of one surface; normals 91° apart
/// are not.
inline constexpr double kOneSurfaceCosine = 0.7;

class ContactPatches {
 public:
  /// Adds a contact on group `group_a` of a and `group_b` of b, of weight P ≥ 0.
  void add(std::int32_t group_a, std::int32_t group_b, const TouchPoint& touch, double weight);

  /// One contact for each patch, in the order in which they began: normal ΣPn made unit, point
  /// ΣPp / ΣP, greatest depth. Weights that are all zero count as equal.
  [[nodiscard]] std::vector<TouchPoint> contacts() const;

 private:
  struct Patch {
    std::int32_t group_a;
    std::int32_t group_b;
    double count{0.0};
    Vector3 normals{Vector3::Zero()};
    Vector3 points{Vector3::Zero()};
    double weight{0.0};
    Vector3 weighted_normals{Vector3::Zero()};
    Vector3 weighted_points{Vector3::Zero()};
    double depth_m{0.0};
  };

  Patch& patch_for(std::int32_t group_a, std::int32_t group_b, const Vector3& normal);
  static TouchPoint contact_of(const Patch& patch);

  std::vector<Patch> patches_;
};

}  // namespace impetus
