// The program's commands. Each adds itself to the command line and runs when it was called.
//
// A command returns the exit status: 0 done, 1 found what it looks for (a divergence, an invalid
// file), 2 could not run. It throws InputError or StoreError with the sentence to print.
// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <cmath>
#include <functional>
#include <string>

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

/// Each adds a subcommand to `app`; parsing that subcommand puts its action into `chosen`.
void add_run(CLI::App& app, Command& chosen);
void add_check(CLI::App& app, Command& chosen);
void add_collect(CLI::App& app, Command& chosen);
void add_exclude(CLI::App& app, Command& chosen);
void add_export(CLI::App& app, Command& chosen);
void add_extremes(CLI::App& app, Command& chosen);
void add_film(CLI::App& app, Command& chosen);
void add_fit(CLI::App& app, Command& chosen);
void add_merge(CLI::App& app, Command& chosen);
void add_new(CLI::App& app, Command& chosen);
void add_observers(CLI::App& app, Command& chosen);
void add_power(CLI::App& app, Command& chosen);
void add_predict(CLI::App& app, Command& chosen);
void add_preview(CLI::App& app, Command& chosen);
void add_publish(CLI::App& app, Command& chosen);
void add_recover(CLI::App& app, Command& chosen);
void add_replay(CLI::App& app, Command& chosen);
void add_report(CLI::App& app, Command& chosen);
void add_screen(CLI::App& app, Command& chosen);
void add_serve(CLI::App& app, Command& chosen);
void add_sessions(CLI::App& app, Command& chosen);
void add_mesh(CLI::App& app, Command& chosen);
void add_tree(CLI::App& app, Command& chosen);
void add_timing(CLI::App& app, Command& chosen);
void add_trade(CLI::App& app, Command& chosen);
void add_verify(CLI::App& app, Command& chosen);

/// The parts of `impetus tree`.
void add_tree_build(CLI::App& tree, Command& chosen);
void add_tree_show(CLI::App& tree, Command& chosen);

}  // namespace impetus::inline commands
