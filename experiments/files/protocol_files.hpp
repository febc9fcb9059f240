// Protocol files, with the scene and the language that they name.
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>

#include "experiments/protocol/protocol_file.hpp"

namespace impetus::inline files {

/// Reads the protocol and the scene beside it. Throws InputError naming file, place, what was
/// expected and what was there.
Protocol load_protocol(const std::filesystem::path& path);

/// The same of a protocol that a program wrote, as if it lay at `path`; with a `scene` of its own,
/// as if that lay where the protocol names it, or with the file that it names.
Protocol protocol_from(JsonDocument document, const std::filesystem::path& path,
                       std::optional<JsonDocument> scene = {});

}  // namespace impetus::inline files
