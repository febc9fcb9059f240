// What the analysis is to leave out: said with a reason, taken back with one, never deleted.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "experiments/store/study_file.hpp"

namespace impetus::inline store {

/// A decision to leave out a participant or one trial of theirs, or to take that back.
struct Exclusion {
  std::string participant;
  std::optional<std::int64_t> trial_id{};  ///< none: all of the participant's
  bool excluded{true};                     ///< false: taken back
  std::string reason;
};

/// The participant's id. Throws InputError when there is no such participant or trial of theirs,
/// when it is excluded already, or not, for taking back.
std::int64_t require_excludable(StudyFile& study, const Exclusion& exclusion);

/// Adds a row; the study was opened for writing. Throws what require_excludable() throws.
void exclude(StudyFile& study, const Exclusion& exclusion);

}  // namespace impetus::inline store
