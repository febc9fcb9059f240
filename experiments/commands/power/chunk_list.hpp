// A sweep in chunks as commands: the options by which one is asked for, and the list of all, with
// how far each is.
// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

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

/// A sweep in chunks, as `--list` tells of it.
struct ListedSweep {
  std::filesystem::path out;
  std::int64_t chunks{1};
  std::string repeated;  ///< the command as it was given, but for --chunk and --list
  /// What a chunk that is there took; throws InputError where it cannot be used.
  std::function<double(std::int64_t number)> took_s;
};

/// Prints a command for each chunk, with its state as a shell's comment, and the sums. Writes
/// nothing.
int list_chunks(const ListedSweep& sweep);

}  // namespace impetus::inline commands
