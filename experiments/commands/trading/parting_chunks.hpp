// The whole trials of `impetus trade` in chunks, as any scheduler runs them: each tries all
// settings from starts of its own. Nothing of them is a time, so that it does not matter which
// machine computes which; what is timed is left to the machine that reads them together.
//
//   --chunks 20 --list ─> 20 commands, and how far each is
//   --chunks 20 --chunk 7 ─> OUT/chunks/chunk-0007.json
//   --chunks 20 ─> all 20 files, and the other parts measured here ─> OUT/trade.csv
//
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <vector>

#include "experiments/commands/power/chunk_list.hpp"
#include "experiments/trade/parting.hpp"

namespace impetus::inline commands {

/// Whole trials to be tried.
struct PartingWork {
  PartingRequest request;   ///< of all starts
  nlohmann::json question;  ///< all that they follow from, by the words for it
};

/// Prints a command for each chunk, with its state. Writes nothing.
int list_partings(const std::filesystem::path& out, const ChunkOptions& options,
                  const PartingWork& work);

/// Computes the chunk that was asked for, unless it is there. Throws what keeps it from it, in one
/// sentence that --list repeats; then the chunk is as it was.
int do_parting_chunk(const std::filesystem::path& out, const ChunkOptions& options,
                     const PartingWork& work, const StartOf& start);

/// The trials of all chunks, as if they had been tried at once. Throws InputError when a chunk is
/// missing, broken, another question's or another build's.
std::vector<PartedTrials> gathered_partings(const std::filesystem::path& out, std::int64_t chunks,
                                            const PartingWork& work);

}  // namespace impetus::inline commands
