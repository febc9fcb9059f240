// A chunk of a power analysis: one file that any machine computes by itself and writes whole.
//
//   OUT/chunks/chunk-0007.json      done: the studies of chunk 7 with all their tests
//                    .running.json  somebody is at it, or was (chunk_mark.hpp)
//                    .failed.json   what its last attempt ended with
//
// Nothing is locked and nothing is shared, so that any network file system will do: a file appears
// under its name once all of it is on disk. It says what it answers and by which build, and holds
// a checksum of itself; whoever reads all of them refuses what does not belong together.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "experiments/power/power_question.hpp"
#include "experiments/power/power_study.hpp"

namespace impetus::inline power {

/// What a chunk's file holds.
struct PowerChunk {
  PowerQuestion question;
  PowerRequest request;  ///< with the chunk's own number
  std::string build;     ///< that computed it
  double took_s{0.0};    ///< from its first study to its last test
  std::vector<TestedStudy> studies;
};

/// Where the chunks of a power analysis are.
std::filesystem::path chunk_folder(const std::filesystem::path& out);

/// OUT/chunks/chunk-0007 and an ending: ".json".
std::filesystem::path chunk_file(const std::filesystem::path& out, std::int64_t number,
                                 const std::string& ending = ".json");

/// Throws std::runtime_error, in one sentence, when it cannot be written; then there is no file.
void write_chunk(const std::filesystem::path& out, const PowerChunk& chunk);

/// A chunk that is there, whole, and answers this question and this request's chunk. Throws
/// InputError, naming the file, when it does not; nothing is changed.
PowerChunk read_chunk(const std::filesystem::path& out, const PowerQuestion& question,
                      const PowerRequest& request);

/// Throws InputError when a chunk that is there is of another build.
void require_build(const std::filesystem::path& out, const PowerQuestion& question,
                   PowerRequest request, const std::string& build);

/// All chunks of the request, in their order. Throws InputError, naming a file, when some are
/// missing, one is refused by read_chunk(), or two are of different builds.
std::vector<PowerChunk> read_all_chunks(const std::filesystem::path& out,
                                        const PowerQuestion& question, PowerRequest request);

}  // namespace impetus::inline power
