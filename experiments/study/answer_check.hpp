// Whether what participants answered is what their protocols ask for.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/store/study_file.hpp"
#include "experiments/study/protocol_check.hpp"
#include "experiments/study/verification_report.hpp"

namespace impetus::inline study {

/// Answers that are missing, doubled, on another scale or never asked for, and such as their
/// questions would not keep like that. Attempts whose protocol cannot be read are passed over.
/// Throws SQLite::Exception.
Failures wrong_answers(StudyFile& study, const ProtocolShelf& shelf);

}  // namespace impetus::inline study
