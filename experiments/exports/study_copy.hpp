// A study as another study file: whole or not at all, without what was deleted from it.
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "experiments/store/study_file.hpp"

namespace impetus::inline exports {

/// Refuses a target that exists; with `replace` it may be another study. Throws InputError.
void require_free_file(const StudyFile& study, const std::filesystem::path& target, bool replace);

/// Writes the study to `target`. Throws StoreError when it cannot be written; then nothing has
/// changed.
void write_study_copy(StudyFile& study, const std::filesystem::path& target);

}  // namespace impetus::inline exports
