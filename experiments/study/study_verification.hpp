// Whether a study file can be published: whole, as this program makes them, complete, and saying of
// everything where it comes from.
//
//   file ─> schema ─> values ─> protocols ─> plans ─> order ─> recordings ─> answers ─> provenance
//   ─> screens (─> replay)
//
// A damaged file is looked at no further.
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>

#include "experiments/store/study_file.hpp"
#include "experiments/study/verification_report.hpp"

namespace impetus::inline study {

/// A further check, made once the others can be: a replay.
using FurtherCheck = std::function<VerificationCheck(StudyFile&)>;

/// Reads the study as of one moment and changes nothing. Throws InputError when the file is no
/// study of a schema that is known.
Verification verify_study(const std::filesystem::path& path, const FurtherCheck& further = {});

}  // namespace impetus::inline study
