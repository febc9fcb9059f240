// A participant's enrolment in one protocol of a run: found again, or planned and stored.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "experiments/commands/running/run_part.hpp"
#include "experiments/design/plan.hpp"
#include "experiments/protocol/protocol_file.hpp"
#include "experiments/record/gaze.hpp"
#include "experiments/store/enrolment.hpp"
#include "experiments/store/study_file.hpp"
#include "experiments/store/study_writer.hpp"

namespace impetus::inline commands {

/// The stored enrolment, to be resumed, if there is one. Throws InputError when it is finished, or
/// another seed is asked for than its own.
std::optional<Enrolment> find_to_resume(StudyFile& study, const RunPart& part,
                                        const RunOptions& options);

/// In words, how `screen` differs from the one of the enrolment's last session; "": it does not.
/// Throws InputError where it does and `options` do not say so.
std::string change_of_screen(StudyFile& study, const RunOptions& options,
                             const Enrolment& enrolment, const ScreenGeometry& screen);

/// The plan of a new enrolment, with the part's solved values, and yoked where regions follow
/// another's gaze. Throws InputError where it cannot be.
Plan new_plan(StudyFile& study, const RunPart& part, const RunOptions& options);

/// A new enrolment with its whole plan.
Enrolment enrol_anew(StudyFile& study, const RunPart& part, const RunOptions& options,
                     const Plan& plan);

/// The plan with every trial whose region is recorded yoked to a trial of the partner that the
/// protocol names, decided before the plan is stored:
///
///   plan   recorded, 10 bodies, repetition 2 ──> partner's  tracked, 10 bodies, repetition 2
///
/// Throws InputError when there is no such partner or trial, when its scene is another or its
/// recording has no valid gaze.
Plan yoked(Plan plan, StudyFile& study, const Protocol& protocol, const std::string& participant,
           bool simulated);

/// The recorded gaze of all trials that the plan's are yoked to.
GazePaths gaze_paths_of(const Plan& plan, StudyFile& study);

}  // namespace impetus::inline commands
