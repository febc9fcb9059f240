// What a step reports of its collisions: one report for each pair of bodies, or body and wall, and
// behind it a run of contacts.
//
//   collisions   [ 0-1        | 0-wall 2 | 3-7 ]     by bodies
//   contacts     [ c0 c1 c2   | c3       | c4 c5 ]   first_contact and contact_count say which
//
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "engine/collision/list_refinement.hpp"
#include "engine/dynamics/impulse.hpp"
#include "engine/world/step.hpp"

namespace impetus::inline world {

/// Forgets what `report` said, and keeps its memory.
void restart(StepReport& report);

/// The collisions as they are modelled, whoever is refined first.
class ModelledCollisions {
 public:
  void clear();

  /// The contacts of one refined pair are added here, at the end ...
  [[nodiscard]] std::vector<Contact>& contacts() { return contacts_; }

  /// ... and then become collisions, one for each run of the same bodies, in all else like `like`.
  void add_contacts_as(const CollisionReport& like);

  /// Reports the collisions by their bodies, and their contacts behind them; `contact` of each is
  /// its deepest, of equals the first.
  void report_in_order(StepReport& report);

 private:
  std::vector<CollisionReport> collisions_;
  std::vector<Contact> contacts_;
  std::size_t taken_{0};  ///< contacts that are of a collision
};

/// What refinement did, to a report that knows the work before it as its floor.
void report_work(const WorkDone& work, StepReport& report);

/// The contacts that the response gets, in the order of StepReport::contacts, instead of what
/// `contacts` held.
void contacts_to_respond_to(const StepReport& report, std::vector<Contact>& contacts);

/// Adds what the response to those contacts did: to each, and in all to each collision.
void report_response(const ResponseResult& result, StepReport& report);

}  // namespace impetus::inline world
