// A plan as a study file keeps it, and back.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "experiments/design/plan.hpp"
#include "experiments/protocol/protocol_file.hpp"
#include "experiments/store/enrolment.hpp"

namespace impetus::inline study {

/// Conditions and solved values become JSON; ids are still to come.
std::vector<StoredTrial> stored(const Plan& plan);
Plan planned(const std::vector<StoredTrial>& trials, const Design& design);

/// The group, of the factors between participants, that a stored plan is of. Throws
/// std::runtime_error when that is none of the design's.
Condition stored_group(const std::vector<StoredTrial>& trials, const Design& design);

/// The protocol and its scene as they were read.
ProtocolTexts texts_of(const Protocol& protocol);

/// The hash of such texts, computed anew. Throws InputError where they are no protocol.
std::string hash_of(const std::string& protocol_json, const std::string& scene_json);

}  // namespace impetus::inline study
