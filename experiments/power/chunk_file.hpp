// A sweep in chunks, whatever is swept: each chunk is one file that any machine computes by itself
// and writes whole. A file says what it answers and by which build; whoever reads it refuses what
// does not belong to the sweep.
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
#include <functional>
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

/// A part of what a sweep asks: its place in a chunk's file, and its words.
struct AskedPart {
  std::string place;  ///< "/question/seed"
  std::string words;  ///< "seed"
};

/// A chunk that was read and belongs to its sweep.
struct SweptChunk {
  std::string build;     ///< that computed it
  double took_s{0.0};    ///< to compute it
  nlohmann::json value;  ///< all that its file holds
};

/// All chunks of one sweep: where they are, what they answer and what each must hold.
struct Sweep {
  SweepKind kind;
  std::filesystem::path out;
  std::int64_t chunks{1};
  nlohmann::json asked;          ///< what is asked, as the file of each chunk says it
  std::vector<AskedPart> parts;  ///< that a chunk must say as `asked` does, compared in this order
  /// What a chunk that answers `asked` lacks: "all studies of its chunk"; "": nothing.
  std::function<std::string(const nlohmann::json& value)> lacks;

  /// The numbers of the chunks that are not there, rising.
  [[nodiscard]] std::vector<std::int64_t> missing() const;

  /// A chunk that is there, as it was written, complete, and of this sweep. Throws InputError,
  /// naming the file, when it is not; nothing is changed.
  SweptChunk read(std::int64_t number) const;

  /// Gives all chunks to `take`, in their order. Throws InputError, naming a file, when some are
  /// missing, one is refused by read(), or two are of different builds.
  void read_all(const std::function<void(const SweptChunk& chunk)>& take) const;

  /// Throws InputError when the first chunk that is there is of another build than `build`, or is
  /// refused by read().
  void require_build(const std::string& build) const;
};

}  // namespace impetus::inline power
