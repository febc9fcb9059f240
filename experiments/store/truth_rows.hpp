// The truth of recorded collisions, kept apart from the record: a replay fills it at any time.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "experiments/run/collision_truth.hpp"
#include "experiments/store/study_file.hpp"

namespace impetus::inline store {

/// A recorded collision; bodies by their index in the scene, b a wall where it is one.
struct StoredCollision {
  std::int64_t id{0};
  std::int64_t step{0};
  BodyPair bodies;
};

struct MeasuredCollision {
  std::int64_t collision_id{0};
  CollisionTruth truth;
};

/// The collisions of an attempt's interval between bodies of `names` and walls, in order; others
/// are left out.
std::vector<StoredCollision> load_collisions(StudyFile& study, std::int64_t attempt_id,
                                             const std::vector<std::string>& names,
                                             std::int64_t interval = 1);

/// Stores them in one transaction, in place of what was measured before. Throws StoreError.
void store_truths(StudyFile& study, const std::vector<MeasuredCollision>& collisions);

}  // namespace impetus::inline store
