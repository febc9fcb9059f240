// Protocol files, with the scene and the language that they name.
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "experiments/protocol/protocol_file.hpp"

namespace impetus::inline files {

/// Reads the protocol and the scene beside it. Throws InputError naming file, place, what was
/// expected and what was there.
Protocol load_protocol(const std::filesystem::path& path);

}  // namespace impetus::inline files
