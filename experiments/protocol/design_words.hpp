// A design in words, for the page that explains a protocol and for `impetus check`.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "experiments/design/design.hpp"

namespace impetus::inline protocol {

/// "0, 100, 300"
std::string level_list(const Factor& factor);

/// "/bodies/0/mass", "keys of yes_no": what the factor changes.
std::string changed_by(const Factor& factor);

/// The text as it is.
inline std::string plain_text(std::string_view text) { return std::string(text); }

/// Cells, repetitions, blocks, order, catch trials, adaptive levels, practice: a sentence each.
/// `text_of` makes what the file's author wrote fit for where the lines will stand.
std::vector<std::string> design_lines(const Design& design,
                                      std::string (*text_of)(std::string_view) = plain_text);

}  // namespace impetus::inline protocol
