// What a chunk of a power analysis keeps (chunk_file.hpp): its studies with all their tests. It
// says what it answers and by which build; whoever reads all of them refuses what does not belong
// together.
// SPDX-License-Identifier: MIT
#pragma once

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
