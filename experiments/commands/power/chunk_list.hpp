// A sweep in chunks as commands: the options by which one is asked for, the list of all, with how
// far each is, and the command that computes one.
// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <functional>
#include <string>

#include "experiments/power/chunk_file.hpp"
#include "experiments/power/chunk_mark.hpp"

namespace impetus::inline commands {

/// Which chunks of a sweep a command was asked for.
struct ChunkOptions {
  std::int64_t chunks{0};  ///< 0: nothing was said
  std::int64_t chunk{0};   ///< the one to be computed; 0: none by itself
  bool list{false};
  std::string repeated;  ///< the command as it was given, but for `chunk` and `list`
};

/// `in_pieces` says what --chunks does alone.
void add_chunk_options(CLI::App& command, ChunkOptions& options, const std::string& in_pieces);

/// Throws InputError unless each of `chunks` has a study at least, of `studies`, and the one that
/// was asked for is among them. `one` says what it is that there are so many of.
void require_chunks(const ChunkOptions& options, std::int64_t chunks, std::int64_t studies,
                    const std::string& one = "study");

/// Prints a command for each chunk, `repeated` with its number, its state as a shell's comment, and
/// the sums. Writes nothing.
int list_chunks(const Sweep& sweep, const std::string& repeated);

/// Computes a chunk and writes its file.
using ChunkWork = std::function<void(ChunkMark& mark)>;

/// Does the work, with a mark at the chunk. Throws what keeps it from it, in one sentence that
/// --list repeats; then there is no file.
void attempt_chunk(const Sweep& sweep, std::int64_t number, const ChunkWork& work);

/// The same for a chunk that was asked for by itself, unless it is there; says which. Throws
/// InputError, too, when the one that is there does not belong to the sweep.
int compute_chunk(const Sweep& sweep, std::int64_t number, const ChunkWork& work);

}  // namespace impetus::inline commands
