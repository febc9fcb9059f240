// The protocols of a study and their scenes, as files again.
// SPDX-License-Identifier: MIT
#pragma once

#include <SQLiteCpp/Database.h>

#include <cstdint>
#include <filesystem>
#include <string>

namespace impetus::inline exports {

/// "protocols/NAME-HASH": what the files of a protocol are called in an export, before their
/// endings. Letters and digits alone, whatever name and hash hold; `id` keeps such names apart.
std::string protocol_stem(std::int64_t id, const std::string& name, const std::string& hash);

/// Writes STEM.protocol.json and STEM.scene.json of each, byte for byte; returns how many files.
/// Throws StoreError.
std::int64_t write_protocol_files(SQLite::Database& database, const std::filesystem::path& folder);

}  // namespace impetus::inline exports
