// Folders that `impetus export` wrote: they alone are replaced, and only while they hold nothing
// else.
//
//   CSV:  the tables that codebook.json explains, the codebook, protocols/ID-NAME-HASH.*.json
//   BIDS: the files that dataset_description.json lists; where it is from before it listed them,
//         whatever has a name that such an export gives
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace impetus::inline exports {

/// Throws InputError, naming what it is of, unless `folder` is an earlier export and all below it
/// is the export's own.
void require_earlier_export(const std::filesystem::path& folder);

}  // namespace impetus::inline exports
