// A file that somebody names: its bytes, which may be anything, and whether it lies within a
// folder.
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

/// By its name alone; nothing is looked up. Both absolute.
bool is_named_within(const std::filesystem::path& file, const std::filesystem::path& folder);

/// Where links lead; what is not there, or cannot be looked up, is not within.
bool is_really_within(const std::filesystem::path& file, const std::filesystem::path& folder);

/// The path that a URI without a scheme is: "%20" is a space, '\\' a '/'.
std::string decoded_uri(const std::string& uri);

/// Whether links lead to something; one that leads round in a circle, or a name that is too long,
/// names nothing.
bool is_there(const std::filesystem::path& file);

/// What is wrong with the place of a file that a scene in `folder`, or `whose` it is, names, in
/// words; "" when nothing is: it lies within the folder, or is not there.
std::string problem_of_place(const std::string& file, const std::filesystem::path& folder,
                             const std::string& whose = "scene");

}  // namespace impetus::inline models
