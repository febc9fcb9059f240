// How a design is told to its reader: blocks, tracks, catch trials and the rules for the order.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/protocol/protocol_file.hpp"

namespace impetus {

/// Prints how the main trials are ordered, one line for each rule.
void print_order(const Design& design);

}  // namespace impetus
