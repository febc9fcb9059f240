// From the question of a power analysis to its tested studies, in a ledger.
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>

#include "experiments/commands/power/power_options.hpp"

namespace impetus::inline commands {

/// How the folders of what is thrown away begin.
inline constexpr const char* kScratchBegin = "simulating-";

/// What is simulated, and where.
struct PowerSimulation {
  const PowerOptions& options;
  const PowerTask& task;
  std::filesystem::path scratch;     ///< a folder for what is thrown away
  std::filesystem::path ledger;      ///< may not be there yet
  std::function<void(double)> told;  ///< the share that is done; may be empty
};

/// Simulates and tests all that the ledger lacks of the request's chunk. False when R lacks a
/// package, which R has said. Throws InputError when there is no R or the ledger is another's, and
/// the first error of a study.
[[nodiscard]] bool simulate_studies(const PowerSimulation& simulation);

}  // namespace impetus::inline commands
