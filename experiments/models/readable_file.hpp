// The bytes of a file that somebody names, which may be anything.
//
// Only regular files are opened: a named pipe would be waited for, a device may never end. All
// readers go through here, but SQLite and assimp, which are given only what is readable.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace impetus::inline models {

/// Enough for the largest meshes and trees.
inline constexpr std::uintmax_t kMostBytes = 1'000'000'000;

/// Why the file cannot be read, in words ("there is no such file", "it is a named pipe, not a
/// file"); "" when nothing speaks against it. Opens nothing, throws nothing.
std::string reading_problem(const std::filesystem::path& file,
                            std::uintmax_t most_bytes = kMostBytes);

/// The whole file. Throws std::runtime_error with the words of reading_problem() alone.
std::string file_bytes(const std::filesystem::path& file, std::uintmax_t most_bytes = kMostBytes);

}  // namespace impetus::inline models
