// Whether a file lies within a folder.
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace impetus {

/// By its name alone; nothing is looked up. Both absolute.
bool is_named_within(const std::filesystem::path& file, const std::filesystem::path& folder);

/// Where links lead; what is not there, or cannot be looked up, is not within.
bool is_really_within(const std::filesystem::path& file, const std::filesystem::path& folder);

}  // namespace impetus
