// One protocol of a run, from its files to what a session needs.
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "experiments/commands/running/run_options.hpp"

namespace impetus::inline commands {

/// Reads and checks the protocol and, unless "", the observer (a name or a file). Throws
/// InputError.
RunPart part_from(const std::filesystem::path& file, const std::string& observer,
                  const RunOptions& options);

/// Builds all bodies of the part, telling its progress.
void build_shapes(const RunPart& part);

/// Solves what the plan needs, telling its progress. Throws InputError where there is no solution.
void solve_what_is_asked(RunPart& part);

}  // namespace impetus::inline commands
