// What a methods section says of a machine's timing, and what it has to add that nobody measured.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "experiments/timing/timing_report.hpp"

namespace impetus::inline timing {

/// One paragraph, bad results included. The report has at least the blank run.
std::string methods_paragraph(const TimingReport& report);

/// A sentence for everything that software cannot know of itself.
std::vector<std::string> what_is_not_known(const TimingReport& report);

}  // namespace impetus::inline timing
