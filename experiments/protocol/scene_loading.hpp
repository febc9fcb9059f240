// A scene file as read and checked, for whoever stages it: a protocol, or a scene by itself.
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiments/protocol/json_document.hpp"

namespace impetus {

/// The scene in the file, valid by its schema and its own rules. Throws InputError with one
/// sentence, "file:/pointer: expected ..., got ...".
JsonDocument load_scene(const std::filesystem::path& path);

/// The scene in the file, valid by its schema alone, holding its meshes and those that `more_files`
/// name: what load_scene() goes on to check. Throws InputError.
JsonDocument read_scene(const std::filesystem::path& path,
                        const std::vector<std::string>& more_files = {});

/// Throws InputError unless the scene is valid by its schema and its own rules.
void require_scene(const JsonDocument& scene);

}  // namespace impetus
