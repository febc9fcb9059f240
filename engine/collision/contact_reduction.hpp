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
// A reduction is a class of sums in a file of its own and a line of the table in the source.
// (Dingliana 2002, sec. 4.2)
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "engine/collision/node_contact.hpp"

namespace impetus::inline collision {

/// What a reduction keeps of the node contacts of one pair, or of a body and a wall, as they come.
class ContactSums {
 public:
  /// The most contacts that it leaves; a reduction that knows a bound states its own.
  static constexpr std::int64_t kMost = std::numeric_limits<std::int64_t>::max();
  /// Whether it looks at more of a node contact than where it touches; the rest costs time.
  static constexpr bool kWeighs = true;

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

class ContactReduction {
 public:
  virtual ~ContactReduction() = default;

  [[nodiscard]] virtual std::unique_ptr<ContactSums> make_sums() const = 0;
  [[nodiscard]] virtual std::int64_t most() const = 0;  ///< see ContactSums::kMost
  [[nodiscard]] virtual bool weighs() const = 0;        ///< see ContactSums::kWeighs
};

/// The reduction by a class of sums.
template <class Sums>
class ReductionBy final : public ContactReduction {
 public:
  [[nodiscard]] std::unique_ptr<ContactSums> make_sums() const override {
    return std::make_unique<Sums>();
  }
  [[nodiscard]] std::int64_t most() const override { return Sums::kMost; }
  [[nodiscard]] bool weighs() const override { return Sums::kWeighs; }
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
