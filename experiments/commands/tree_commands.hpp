// The parts of `impetus tree`.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/commands/commands.hpp"

namespace impetus::inline commands {

void add_tree_build(CLI::App& tree, Command& chosen);
void add_tree_show(CLI::App& tree, Command& chosen);

}  // namespace impetus::inline commands
