// Which recorded trial each yoked trial of a plan follows, decided before the plan is stored.
//
//   plan   recorded, 10 bodies, repetition 2 ──> partner's  tracked, 10 bodies, repetition 2
//
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "experiments/design/plan.hpp"
#include "experiments/protocol/protocol_file.hpp"
#include "experiments/record/gaze.hpp"
#include "experiments/store/study_file.hpp"

namespace impetus::inline commands {

/// The plan with every trial whose region is recorded yoked to a trial of the partner that the
/// protocol names. Throws InputError when there is no such partner or trial, when its scene is
/// another or its recording has no valid gaze.
Plan yoked(Plan plan, StudyFile& study, const Protocol& protocol, const std::string& participant,
           bool simulated);

/// The recorded gaze of all trials that the plan's are yoked to.
GazePaths gaze_paths_of(const Plan& plan, StudyFile& study);

}  // namespace impetus::inline commands
