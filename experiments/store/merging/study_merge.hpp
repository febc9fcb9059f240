// Files of several stations of one study, joined into one.
//
//   sources ──each whole, unused, of the same protocols, with other participants──> one transaction
//
// What a source says comes whole; ids are new, so that nothing but names and hashes identifies
// across files. Sources are never changed.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace impetus::inline store {

/// What a merge added, and what the study holds since.
struct MergeResult {
  std::int64_t participants_added{0};
  std::int64_t participants{0};
  std::int64_t completed_trials{0};
};

/// Puts all of `sources` into the study `into`, which is made when there is none; all or nothing.
/// `build` goes into a new one. Throws InputError, before anything is written, when a file is no
/// study, in use, damaged or changed by hand; is given twice or was merged before; holds other
/// protocols or versions of them than the rest, or a participant that another holds. Throws
/// StoreError when it cannot be written; then nothing was added.
MergeResult merge_studies(const std::vector<std::filesystem::path>& sources,
                          const std::filesystem::path& into, const std::string& build);

}  // namespace impetus::inline store
