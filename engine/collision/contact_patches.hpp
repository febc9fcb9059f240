// Contacts gathered by the pair of surface groups that they lie on, each patch a weighted mean.
//
//   (group of a, group of b) --> patch, patch ...      Σ P, Σ P n, Σ P p, greatest depth
//
// A contact joins, of its groups' patches, the one whose mean of unit normals stays longest. Where
// it would fall below kOneSurfaceCosine the patch would not be one surface, so the contact starts
// another. Nodes without a group, inside the solid, are of no one surface: they join what is near.
// At last patches of different groups that face the same way within that cosine, and are
// no further apart than neighbouring nodes, are one again: groups cut curved surfaces into pieces
// and a corner lies on several, which would make many contacts of one.
// (Dingliana 2002, sec. 4.2.3 and eq. 4.11 and 4.12, corrected)
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "engine/collision/contact_reduction.hpp"

namespace impetus::inline collision {

/// Length of the mean of unit normals below which they are not of one surface, and cosine between
/// patches that are not: two normals 120° apart, two patches 60° apart. Normals between nodes of a
/// grid scatter by as much as 45° about that of a plane.
inline constexpr double kOneSurfaceCosine = 0.5;

/// The patches of the contacts that were added.
class ContactPatches {
 public:
  /// Adds a contact of weight P ≥ 0.
  void add(const NodeContact& contact, double weight);

  void clear();

  /// Adds one contact for each patch, in the order in which they began: normal ΣPn made unit, point
  /// ΣPp / ΣP, greatest depth. Weights that are all zero count as equal.
  void add_contacts_to(std::vector<TouchPoint>& contacts) const;

 private:
  /// What is summed over the contacts of one patch.
  struct Patch {
    std::int32_t group_a{kNoGroup};
    std::int32_t group_b{kNoGroup};
    double count{0.0};
    Vector3 normals{Vector3::Zero()};
    Vector3 points{Vector3::Zero()};
    Matrix3 scatter_m2{Matrix3::Zero()};  ///< sum of d dᵀ, d from the mean point
    double weight{0.0};
    Vector3 weighted_normals{Vector3::Zero()};
    Vector3 weighted_points{Vector3::Zero()};
    double depth_m{0.0};
    double node_m{0.0};  ///< the largest of its contacts'

    [[nodiscard]] TouchPoint contact() const;
    [[nodiscard]] Vector3 mean_point() const { return points / count; }
    [[nodiscard]] double half_length_m(const Vector3& direction) const;
    [[nodiscard]] bool is_near(const Patch& other) const;
    [[nodiscard]] bool faces_as(const Patch& other) const;
    void join(const Patch& other);
    /// As join() with the patch of one contact.
    void join_one(const NodeContact& contact, double weight_of_it);
  };

  /// The patches of one pair of groups, by their places, from first to last.
  struct OfGroups {
    std::uint64_t groups{0};  ///< both
    std::uint32_t round{0};   ///< of another round: of nobody
    std::int32_t first{0};
    std::int32_t last{0};
  };

  static Patch patch_of(const NodeContact& contact, double weight);
  Patch* patch_for(const NodeContact& contact, const OfGroups& of_groups);
  OfGroups& entry_of(std::uint64_t groups);
  void begin_patch(const NodeContact& contact, double weight, OfGroups& of_groups);
  void make_room();

  std::vector<Patch> patches_;
  std::vector<std::int32_t> next_;   ///< of the same groups, by patch; -1: none
  std::vector<OfGroups> by_groups_;  ///< a power of two, at least twice as many as patches
  std::uint32_t round_{1};
  mutable std::vector<Patch> whole_;  ///< memory for patches that are one again
};

/// What the sums of reductions by patches have in common: they leave a contact for each patch.
class PatchSums : public ContactSums {
 public:
  void begin(const Vector3& /*fallback*/) override { patches_.clear(); }
  void reduce_to(std::vector<TouchPoint>& contacts) const override {
    patches_.add_contacts_to(contacts);
  }

 protected:
  ContactPatches patches_;
};

// Pre-processed grouping: one mean for each pair of nearly plane pieces of surface that meet.
// (Dingliana 2002, sec. 4.2.3)

/// Sums of the reduction `groups`.
class GroupedContacts final : public PatchSums {
 public:
  static constexpr unsigned kTerms = kGroupTerm;

  void add(const NodeContact& contact) override { patches_.add(contact, /*weight=*/1.0); }
};

// Groups whose normals come from the density gradients of the two nodes.
//
// The outward normal of b points to a, that of a to b, so the pair's is (n_b − n_a) made unit.
// (Dingliana 2002, sec. 4.2.4, eq. 4.10, corrected)

/// Outward normals less than 90° apart, whose difference is shorter than this, are not of surfaces
/// that face each other: the geometric normal stands.
inline constexpr double kLeastOpposed = 1.4142135623730951;

/// The normal, unit and from b to a, that the densities of the two nodes give.
inline Vector3 density_contact_normal(const NodeContact& contact) {
  const Vector3 difference = contact.outward_b - contact.outward_a;
  const double length = difference.norm();
  return length >= kLeastOpposed ? Vector3(difference / length) : contact.touch.normal;
}

/// Sums of the reduction `density`.
class DensityContacts final : public PatchSums {
 public:
  static constexpr unsigned kTerms = kGroupTerm | kOutwardTerm;

  void add(const NodeContact& contact) override {
    NodeContact faced = contact;
    faced.touch.normal = density_contact_normal(contact);
    patches_.add(faced, /*weight=*/1.0);
  }
};

// Groups weighted by the probability that the solids meet, P = κ ρ_a ρ_b.
// (Dingliana 2002, sec. 4.2.5, eq. 4.6, 4.11 and 4.12, corrected)

/// Sums of the reduction `weighted`.
class WeightedContacts final : public PatchSums {
 public:
  static constexpr unsigned kTerms = kGroupTerm | kChanceTerm;

  void add(const NodeContact& contact) override {
    patches_.add(contact, collision_probability(contact));
  }
};

}  // namespace impetus::inline collision
