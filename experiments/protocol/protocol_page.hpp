// A protocol explained: one page in Markdown, generated from the file, for whoever runs or reviews
// the study.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "experiments/protocol/protocol_file.hpp"

namespace impetus::inline protocol {

/// What is varied, how trials are ordered, what happens in one, every word that is shown, what is
/// recorded, and how to run it. The same file gives the same page.
std::string protocol_page(const Protocol& protocol);

}  // namespace impetus::inline protocol
