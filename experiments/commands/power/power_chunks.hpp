// A power analysis in chunks, as any scheduler runs them: the work as commands, one chunk computed,
// all of them read together.
//
//   --chunks 50 --list ─> 50 commands, and how far each is
//   --chunks 50 --chunk 7 ─> a ledger on this machine's own disk ─> OUT/chunks/chunk-0007.json
//   --chunks 50 ─> all 50 files ─> OUT/power.sqlite ─> the page
//
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "experiments/commands/power/power_options.hpp"

namespace impetus::inline commands {

/// Prints a command for each chunk, with its state as a shell's comment, and the sums. Writes
/// nothing.
int list_chunks(const PowerOptions& options, const PowerTask& task);

/// Computes the chunk that was asked for, unless it is there. Throws what keeps it from it, in one
/// sentence that --list repeats; then the chunk is as it was.
int do_chunk(const PowerOptions& options, const PowerTask& task);

/// Puts the studies of all chunks into the ledger, all or none. Throws InputError when a chunk is
/// missing, broken or another question's.
void gather_chunks(const PowerOptions& options, const PowerTask& task,
                   const std::filesystem::path& ledger);

}  // namespace impetus::inline commands
