// A file that is written whole or not at all.
//
//   bytes ─> a temporary file beside it ─> on disk ─> renamed over the old one
//
// Whoever reads meanwhile sees the old file or the new one; of two writers the last one wins.
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string_view>

namespace impetus::inline models {

/// Throws std::runtime_error, in one sentence that names the file, when it cannot be written; then
/// nothing has changed.
void write_whole_file(const std::filesystem::path& file, std::string_view bytes);

/// Throws as write_whole_file() would where that can be known before the bytes are: no such folder,
/// one that is closed, a folder in the file's place. Nothing changes.
void require_writable(const std::filesystem::path& file);

}  // namespace impetus::inline models
