// Whether a participant's plan is the one that protocol, code and seed give.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/store/study_file.hpp"
#include "experiments/study/protocol_shelf.hpp"
#include "experiments/study/verification.hpp"

namespace impetus::inline study {

/// Plans every enrolment anew; of each the first difference is told. The level of an adaptive trial
/// is left to a replay, solved values are taken as they were stored. Enrolments whose protocol
/// cannot be read are passed over. Throws SQLite::Exception.
Failures changed_plans(StudyFile& study, const ProtocolShelf& shelf);

}  // namespace impetus::inline study
