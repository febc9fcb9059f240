// Whether a file lies within a folder.
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace impetus::inline models {

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
