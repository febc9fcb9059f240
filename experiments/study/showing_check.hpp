// Whether completed attempts have the steps that they were shown, and the frames that showed them.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/store/study_file.hpp"
#include "experiments/study/protocol_check.hpp"
#include "experiments/study/verification_report.hpp"

namespace impetus::inline study {

/// Intervals whose last step is not the last that their last frame needs, and such as name another
/// frame than the first that shows a step or a collision. Attempts whose protocol cannot be read
/// are passed over. Throws SQLite::Exception.
Failures wrong_showings(StudyFile& study, const ProtocolShelf& shelf);

}  // namespace impetus::inline study
