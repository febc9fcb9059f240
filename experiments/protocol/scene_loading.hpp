// A scene file as read and checked, for whoever stages it: a protocol, or a scene by itself.
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "experiments/protocol/json_document.hpp"

namespace impetus {

/// The scene in the file, valid by its schema and its own rules. Throws InputError with one
/// sentence, "file:/pointer: expected ..., got ...".
JsonDocument load_scene(const std::filesystem::path& path);

/// Throws InputError unless the scene is valid by its schema and its own rules.
void require_scene(const JsonDocument& scene);

}  // namespace impetus
