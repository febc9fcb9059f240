// A design in words, for the page that explains a protocol and for `impetus check`.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "experiments/session/design.hpp"

namespace impetus {

/// "0, 100, 300"
std::string level_list(const Factor& factor);

/// "delay_ms 300, speed_deg_s 10"
std::string condition_words(const Condition& condition);

/// Cells, repetitions, blocks, order, catch trials, adaptive levels, practice: a sentence each.
std::vector<std::string> design_lines(const Design& design);

}  // namespace impetus
