// A command line as it was given, to be given again.
// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <set>
#include <string>

namespace impetus::inline commands {

/// A word as a shell reads it: quoted where it must be.
std::string shell_word(const std::string& word);

/// This program, the command and what it was given, but for the options named in `without`; for a
/// shell, in the folder in which the command was given.
std::string given_words(const CLI::App& command, const std::set<std::string>& without);

}  // namespace impetus::inline commands
