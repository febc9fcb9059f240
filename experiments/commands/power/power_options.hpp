// What `impetus power` is asked: its options, and the question that they come to.
//
//   options ─> protocol, observers ─> question, request
//
// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "experiments/commands/power/chunk_list.hpp"
#include "experiments/commands/running/run_part.hpp"
#include "experiments/power/power_question.hpp"
#include "experiments/protocol/observer_file.hpp"

namespace impetus::inline commands {

/// What `impetus power` was asked for.
struct PowerOptions : ChunkOptions {
  std::string protocol;
  std::string observer;
  std::string null_observer;
  bool no_null{false};
  std::vector<std::int64_t> sizes;
  std::int64_t studies{1000};
  std::string model{"means"};
  std::string response;
  std::vector<std::string> factors;
  std::string compared;
  std::int64_t seed{1};
  std::int64_t jobs{0};
  bool allow_rounding{false};
  std::string screen_file;
  std::string out{"power"};
};

/// A screen as questions name it: JSON.
std::string screen_json(const ScreenGeometry& screen);

/// How whole studies are simulated. Throws InputError where nobody takes part in the protocol.
RunOptions simulated_run(const std::string& protocol, const std::string& observer,
                         bool allow_rounding);

void add_options(CLI::App& command, PowerOptions& options);

/// The options as the protocol and the observers understand them.
struct PowerTask {
  RunPart planted;                      ///< of every session, with the effect
  RunOptions run;                       ///< the same
  std::optional<ObserverFile> without;  ///< of those without the effect; none: none is known
  PowerQuestion question;
  PowerRequest request;
};

/// Throws InputError, naming the option or the file, when they do not go together.
PowerTask task_of(const PowerOptions& options);

}  // namespace impetus::inline commands
