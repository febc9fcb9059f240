// A response to 64 contacts: the same problem for our solvers and for those of peers.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "engine/collision/contact_model.hpp"
#include "engine/dynamics/body.hpp"
#include "tests/bench/crowd_starts.hpp"

namespace impetus {

inline constexpr int kContactsOfProblem = 64;

/// Two bodies and 64 contacts between them; most approach.
struct ContactProblem {
  std::vector<BodyModel> models;
  std::vector<BodyState> states;
  std::vector<Contact> contacts;
};

/// Bodies of the shape's mass and inertia, one above the other, that meet over a patch: points
/// within half a radius of the middle, normals up to about 30° off the line of the centres.
ContactProblem random_contact_problem(const CrowdShape& shape, RandomStream& random);

}  // namespace impetus
