// From the contacts of overlapping nodes to the few that the response needs.
//
//   none      every one of them
//   first     the one that was entered first
//   average   their mean
//   groups    a mean for each pair of surface groups
//   density   as groups, with normals from the density gradients
//   weighted  as groups, weighted by interpenetration and occupancy
//
//   nodes --one by one--> ContactSums --reduce_to()--> few --those that span the torque--> response
//
// A reduction is a class of sums and a line of the table in the source; those that gather patches
// are in contact_patches.hpp.
// (Dingliana 2002, sec. 4.2)
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "engine/trees/volume_tree.hpp"
#include "engine/volumes/sphere.hpp"

namespace impetus::inline collision {

/// Of a node of a and a node of b, or a node of a and a wall, which is one group and solid.
struct NodeContact {
  TouchPoint touch;
  double approach_m_s{0.0};      ///< of the bodies' points there along the normal; < 0: they part
  double since_entry_s{0.0};     ///< see time_since_entry_s()
  double node_m{0.0};            ///< radius that bounds the smaller of the two nodes
  double interpenetration{1.0};  ///< κ, from 0, touching, to 1, nested (eq. 4.3, corrected)
  double occupancy_a{1.0};       ///< share of the node that is solid
  double occupancy_b{1.0};
  std::int32_t group_a{kNoGroup};
  std::int32_t group_b{kNoGroup};
  Vector3 outward_a{Vector3::Zero()};  ///< density normal in world; zero where there is none
  Vector3 outward_b{Vector3::Zero()};
};

/// How likely it is that the solids meet where the nodes do: κ ρ_a ρ_b. (Dingliana 2002, eq. 4.6)
inline double collision_probability(const NodeContact& contact) {
  return contact.interpenetration * contact.occupancy_a * contact.occupancy_b;
}

/// How long ago two nodes of `reach_m` (sum of their half widths along the normal) began to overlap
/// when they moved at `speed_m_s`, of which `approach_m_s` along the normal: exact for spheres,
///   |(reach − depth) n − v t| = reach,
/// and depth over approach, the form of Dingliana 2002, sec. 4.2.1, corrected, where depth is
/// small. That form has no bound for nodes that slide past each other, which this has. Zero when
/// nothing moves.
double time_since_entry_s(double reach_m, double depth_m, double approach_m_s, double speed_m_s);

/// What a reduction can look at of a node contact beside where it touches.
inline constexpr unsigned kEntryTerm = 1;    ///< approach_m_s and since_entry_s
inline constexpr unsigned kGroupTerm = 2;    ///< node_m and the groups
inline constexpr unsigned kChanceTerm = 4;   ///< interpenetration and the occupancies
inline constexpr unsigned kOutwardTerm = 8;  ///< the density normals
inline constexpr unsigned kAllTerms = kEntryTerm | kGroupTerm | kChanceTerm | kOutwardTerm;

/// What a reduction keeps of the node contacts of one pair, or of a body and a wall, as they come.
class ContactSums {
 public:
  /// The most contacts that it leaves; a reduction that knows a bound states its own.
  static constexpr std::int64_t kMost = std::numeric_limits<std::int64_t>::max();
  /// What it looks at of a node contact beside where it touches; the others cost no time, and may
  /// be as a NodeContact begins.
  static constexpr unsigned kTerms = kAllTerms;

  virtual ~ContactSums() = default;

  /// Forgets what was added. `fallback` (unit, from b to a) is the normal of contacts whose own
  /// cancel.
  virtual void begin(const Vector3& fallback) = 0;

  virtual void add(const NodeContact& contact) = 0;

  /// Adds contacts of which where they touch is all that the reduction looks at.
  virtual void add_touches(std::span<const TouchPoint> touches) {
    for (const TouchPoint& touch : touches) {
      NodeContact contact;
      contact.touch = touch;
      add(contact);
    }
  }

  /// Adds to `contacts` those that are left: one or more when any was added, each normal unit and
  /// from b to a.
  virtual void reduce_to(std::vector<TouchPoint>& contacts) const = 0;
};

/// A way of reducing contacts: it makes the sums of as many pairs as there are.
class ContactReduction {
 public:
  virtual ~ContactReduction() = default;

  [[nodiscard]] virtual std::unique_ptr<ContactSums> make_sums() const = 0;
  [[nodiscard]] virtual std::int64_t most() const = 0;  ///< see ContactSums::kMost
  [[nodiscard]] virtual unsigned terms() const = 0;     ///< see ContactSums::kTerms
};

/// The reduction by a class of sums.
template <class Sums>
class ReductionBy final : public ContactReduction {
 public:
  [[nodiscard]] std::unique_ptr<ContactSums> make_sums() const override {
    return std::make_unique<Sums>();
  }
  [[nodiscard]] std::int64_t most() const override { return Sums::kMost; }
  [[nodiscard]] unsigned terms() const override { return Sums::kTerms; }
};

/// The reduction called `name`. Throws std::invalid_argument that lists the names there are.
std::shared_ptr<const ContactReduction> make_reduction(std::string_view name);

/// The names make_reduction() takes, in the order of the list above.
std::vector<std::string_view> reduction_names();

/// How a pair's contacts are reduced.
struct ContactModel {
  std::shared_ptr<const ContactReduction> reduction;  ///< none: average
  int most_per_pair{4};  ///< of what the reduction leaves, those that span most torque; 1 or more
};

/// The model's reduction, or the average when it names none.
const ContactReduction& reduction_of(const ContactModel& model);

/// The most contacts that the response can get for one pair, or for a body and one wall, of which
/// `node_contacts` nodes overlap; 0 of none.
std::int64_t most_contacts(const ContactModel& model, std::int64_t node_contacts);

}  // namespace impetus::inline collision
