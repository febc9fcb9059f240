// From the question of a power analysis to its tested studies, in a ledger.
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "experiments/commands/power/power_options.hpp"
#include "experiments/commands/power/power_studies.hpp"

namespace impetus::inline commands {

/// How the folders of what is thrown away begin.
inline constexpr const char* kScratchBegin = "simulating-";

/// What tests studies of a model, written into a folder. None when R lacks a package, which R has
/// said. Throws InputError when there is no R.
std::optional<PowerTools> power_tools(const std::filesystem::path& folder,
                                      const std::string& model);

/// What is simulated, and where.
struct PowerSimulation {
  const PowerOptions& options;
  const PowerTask& task;
  PowerTools tools;
  std::filesystem::path scratch;     ///< a folder for what is thrown away
  std::filesystem::path ledger;      ///< may not be there yet
  std::function<void(double)> told;  ///< the share that is done; may be empty
};

/// Simulates and tests all that the ledger lacks of the request's chunk. Throws InputError when the
/// ledger is another's, and the first error of a study.
void simulate_studies(const PowerSimulation& simulation);

}  // namespace impetus::inline commands
