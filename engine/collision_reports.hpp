// What a step reports of its collisions: one report for each pair of bodies, or body and wall, and
// behind it a run of contacts.
//
//   collisions   [ 0-1        | 0-wall 2 | 3-7 ]     by bodies
//   contacts     [ c0 c1 c2   | c3       | c4 c5 ]   first_contact and contact_count say which
//
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "engine/dynamics/impulse.hpp"
#include "engine/step.hpp"

namespace impetus {

struct ModelledCollision {
  CollisionReport report;
  std::vector<Contact> contacts;  ///< one or more, all of its bodies
};

/// Adds a collision for each run of `contacts` of the same bodies, in all else like `like`.
void add_by_bodies(const CollisionReport& like, const std::vector<Contact>& contacts,
                   std::vector<ModelledCollision>& modelled);

/// Reports the collisions by their bodies, whoever was refined first, and their contacts behind
/// them; `contact` of each is its deepest, of equals the first.
void report_in_order(std::vector<ModelledCollision> modelled, StepReport& report);

/// The contacts that the response gets, in the order of StepReport::contacts.
std::vector<Contact> contacts_to_respond_to(const StepReport& report);

/// Adds what the response to those contacts did: to each, and in all to each collision.
void report_response(const ResponseResult& result, StepReport& report);

}  // namespace impetus
