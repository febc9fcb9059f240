// The program's commands. Each adds itself to the command line and runs when it was called.
//
// A command returns the exit status: 0 done, 1 found what it looks for (a divergence, an invalid
// file), 2 could not run. It throws InputError or StoreError with the sentence to print.
// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <utility>

namespace impetus::inline commands {

inline constexpr int kDone = 0;
inline constexpr int kFound = 1;
inline constexpr int kCouldNotRun = 2;

/// What main() calls once the command line is read.
using Command = std::function<int()>;

/// Numbers from `least` to `most`; CLI::Range takes what is no number, too.
inline CLI::Validator number_from(double least, double most) {
  const CLI::Range range(least, most);
  return CLI::Validator(
      [range, least](std::string& text) {
        double number = least;
        const bool no_number = CLI::detail::lexical_cast(text, number) && std::isnan(number);
        return no_number ? "expected a number, got " + text : range(text);
      },
      range.get_description());
}

/// Of 63 bits: what an SQLite integer holds without a sign, so a negative one is noticed.
inline constexpr std::uint64_t kLargestSeed = std::numeric_limits<std::int64_t>::max();

/// Adds a subcommand; parsing it puts into `chosen` that `action` is done on its options. Returns
/// the subcommand, and the options, which it keeps.
template <typename Options>
std::pair<CLI::App*, Options*> add_command(CLI::App& app, Command& chosen,
                                           int (*action)(const Options&), const char* name,
                                           const char* words) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand(name, words);
  command->callback(
      [options, action, &chosen] { chosen = [options, action] { return action(*options); }; });
  return {command, options.get()};
}

/// Adds a subcommand to `app`; parsing that subcommand puts its action into `chosen`.
using AddCommand = void(CLI::App& app, Command& chosen);

AddCommand add_run, add_check, add_collect, add_exclude, add_export, add_extremes, add_film,
    add_fit, add_merge, add_new, add_observers, add_power, add_predict, add_preview, add_publish,
    add_recover, add_replay, add_report, add_screen, add_serve, add_sessions, add_timing,
    add_verify, add_mesh, add_tree, add_trade;

/// The parts of `impetus tree`.
AddCommand add_tree_build, add_tree_show;

}  // namespace impetus::inline commands
