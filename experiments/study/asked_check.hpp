// Whether each completed attempt holds what its protocol asks for, and no less of the simulation
// than was shown.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/store/study_file.hpp"
#include "experiments/study/protocol_shelf.hpp"
#include "experiments/study/verification.hpp"

namespace impetus::inline study {

/// Answers that are missing, doubled, on another scale or never asked for. Attempts whose protocol
/// cannot be read are passed over. Throws SQLite::Exception.
Failures wrong_answers(StudyFile& study, const ProtocolShelf& shelf);

/// Intervals whose last step is not the last that their last frame needs. Throws SQLite::Exception.
Failures wrong_lengths(StudyFile& study, const ProtocolShelf& shelf);

}  // namespace impetus::inline study
