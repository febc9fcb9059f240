// What a chunk of a power analysis keeps (chunk_file.hpp): its studies with all their tests.
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiments/power/chunk_file.hpp"
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

/// All chunks of the request, whichever its own is. One is complete when it has all studies of it.
Sweep power_sweep(const std::filesystem::path& out, const PowerQuestion& question,
                  const PowerRequest& request);

/// The studies of a chunk of such a sweep, in the order of its cells.
std::vector<TestedStudy> tested_studies(const SweptChunk& chunk);

}  // namespace impetus::inline power
