// The report for people: one page of HTML that needs nothing but itself.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "experiments/timing/timing_report.hpp"

namespace impetus::inline timing {

/// Text as it has to stand in HTML, quotes included.
std::string html_text(const std::string& text);

std::string timing_page(const TimingReport& report);

}  // namespace impetus::inline timing
