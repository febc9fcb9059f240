// From overlapping nodes to the contact that the response needs.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "engine/collision/pair_refinement.hpp"
#include "engine/scheduling/priority.hpp"

namespace impetus {

/// One contact between two bodies, or of a body and a wall: `normal` unit, from b towards a, in
/// world.
struct Contact {
  BodyPair bodies;
  TouchPoint touch;
};

/// Directions to fall back on, in order, when the geometry leaves the normal open (coincident
/// centres, opposed normals). All from b towards a; zero vectors are passed over, and the x axis
/// is the last resort.
struct NormalFallbacks {
  Vector3 between_centres_of_mass{Vector3::Zero()};
  Vector3 approach{Vector3::Zero()};  ///< −(v_a − v_b)

  [[nodiscard]] Vector3 first_usable() const;
};

/// The average of the contacts of all overlapping node pairs: mean point, mean normal made unit,
/// greatest depth. Precondition: the pair overlaps. (Dingliana 2002, eq. 3.7, 3.8 and 4.5,
/// corrected)
Contact average_contact(BodyPair bodies, const PairRefinement& pair, PlacedTree& a, PlacedTree& b,
                        const NormalFallbacks& fallbacks);

/// One contact for each wall that nodes of body `body` reach: the average over those nodes.
/// `bodies` of each is {body, wall_index(wall)}, by rising wall.
std::vector<Contact> wall_contacts(std::int32_t body, const PairRefinement& pair, PlacedTree& tree,
                                   const Enclosure& walls);

}  // namespace impetus
