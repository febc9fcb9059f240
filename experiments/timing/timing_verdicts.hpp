// What the measured values are good for, a line each, with the rule that says so.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "experiments/timing/timing_report.hpp"

namespace impetus::inline timing {

/// From best to worst; what is not known is no better or worse than the rest.
enum class TimingGrade { kGood, kWithCare, kNotForTiming, kNotKnown };

/// "good", "with care", "not for timing studies", "not known".
const char* words_of(TimingGrade grade);

/// One line of the judgement.
struct TimingVerdict {
  std::string subject;   ///< "Late frames with 15 bodies"
  std::string measured;  ///< in words and numbers
  TimingGrade grade{TimingGrade::kNotKnown};
  std::string criterion;  ///< what is good, what needs care
};

/// In the order of the report.
std::vector<TimingVerdict> timing_verdicts(const TimingReport& report);

/// The worst of those that are known.
TimingGrade worst_of(const std::vector<TimingVerdict>& verdicts);

/// "0.123" to so many digits.
std::string decimal(double value, int digits);

/// "a blank picture", "1 body", "250 bodies".
std::string pictured(int bodies);

/// "key presses put into the window system".
std::string described(const InputDelay& input);

}  // namespace impetus::inline timing
