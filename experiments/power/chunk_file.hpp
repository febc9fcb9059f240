// The file of a chunk of a sweep, whatever is swept: one file that any machine computes by itself
// and writes whole.
//
//   OUT/chunks/chunk-0007.json      done: what the sweep keeps of chunk 7, and a checksum of that
//                    .running.json  somebody is at it, or was (chunk_mark.hpp)
//                    .failed.json   what its last attempt ended with
//
// Nothing is locked and nothing is shared, so that any network file system will do: a file appears
// under its name once all of it is on disk.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace impetus::inline power {

/// Where the chunks of a sweep are.
std::filesystem::path chunk_folder(const std::filesystem::path& out);

/// OUT/chunks/chunk-0007 and an ending: ".json".
std::filesystem::path chunk_file(const std::filesystem::path& out, std::int64_t number,
                                 const std::string& ending = ".json");

/// One of so many chunks, as equal as can be.
struct ChunkNumber {
  std::int64_t number{1};  ///< from 1
  std::int64_t of{1};
};

/// Of the numbers from 1 to `all`, those of a chunk: all chunks together have each once, rising.
std::vector<std::int64_t> numbers_of(const ChunkNumber& chunk, std::int64_t all);

/// What is swept, as files name it, in which form, and in words.
struct SweepKind {
  const char* name;   ///< "power"
  int format;         ///< raised whenever older files may not be read
  const char* words;  ///< "a power analysis"
};

/// Writes the value with its kind, format and checksum. Throws std::runtime_error, in one sentence,
/// when it cannot be written; then there is no file.
void write_chunk_value(const std::filesystem::path& file, const SweepKind& kind,
                       nlohmann::json value);

/// What the file holds, once it is known to be as it was written, and of this kind and format.
/// Throws InputError.
nlohmann::json read_chunk_value(const std::filesystem::path& file, const SweepKind& kind);

/// "FILE: expected EXPECTED, got INSTEAD; remove it and compute it again". Throws InputError.
[[noreturn]] void refuse_chunk(const std::filesystem::path& file, const std::string& expected,
                               const std::string& instead);

/// Throws InputError that names those of the chunks that are not there.
void require_all_chunks(const std::filesystem::path& out, std::int64_t chunks);

/// Throws InputError where `there`, the build of a chunk, is not this one.
void require_same_build(const std::filesystem::path& file, const std::string& there,
                        const std::string& build);

}  // namespace impetus::inline power
