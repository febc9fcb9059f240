// SPDX-License-Identifier: MIT
#include <algorithm>

#include "experiments/power/recovery.hpp"
#include "experiments/tables/csv_line.hpp"
#include "experiments/tables/number_text.hpp"
#include "experiments/tables/plain_text.hpp"

namespace impetus::inline power {
namespace {

constexpr double kNominal = 0.95;

std::string percent(double share) { return printed("%.1f", 100.0 * share); }

/// "94.5 (90.4 to 96.9)", and a star where what was promised lies outside.
std::string coverage_words(const ParameterRecovery& one) {
  if (one.fitted == 0) {
    return "–";
  }
  const ShareInterval interval = wilson_interval(one.covered, one.fitted);
  const bool is_as_promised = interval.low <= kNominal && kNominal <= interval.high;
  return percent(static_cast<double>(one.covered) / static_cast<double>(one.fitted)) + " (" +
         percent(interval.low) + " to " + percent(interval.high) + ")" +
         (is_as_promised ? "" : " *");
}

std::string row_of(const ParameterRecovery& one, std::int64_t studies) {
  const auto number = [&](double value) {
    return one.fitted == 0 ? std::string("–") : rounded_number(value, 4);
  };
  return "| " + markdown_text(one.name) + " | " + rounded_number(one.planted, 6) + " | " +
         number(one.mean) + " | " + number(one.mean - one.planted) + " | " + number(one.sd) +
         " | " + coverage_words(one) + " | " + number(one.median_width) + " | " +
         std::to_string(one.fitted) + " of " + std::to_string(studies) + " |\n";
}

}  // namespace

std::string recovery_page(const RecoveryQuestion& question,
                          const std::vector<RecoveredStudy>& studies) {
  const auto failed = std::count_if(studies.begin(), studies.end(),
                                    [](const RecoveredStudy& one) { return !one.remark.empty(); });
  const std::int64_t fitted = std::ssize(studies) - failed;
  std::string page =
      "# Does the study give back what was planted?\n\n" + std::to_string(studies.size()) +
      " simulated studies of " + std::to_string(question.participants) + " participants each in " +
      markdown_text(question.protocol) + " (" + question.protocol_hash.substr(0, 12) +
      "), answered by " + markdown_text(question.observer_name) +
      ", each fitted as `impetus fit` fits people's answers (seed " +
      std::to_string(question.seed) + ").\n\n";
  if (failed > 0) {
    page += std::to_string(failed) + " could not be fitted and are in no row below:\n\n";
    for (const RecoveredStudy& study : studies) {
      page += study.remark.empty() ? ""
                                   : "- study " + std::to_string(study.number) + ": " +
                                         markdown_text(study.remark) + "\n";
    }
    page += "\n";
  }
  page +=
      "| parameter | planted | mean found | bias | SD over studies | 95 % intervals that hold it, "
      "% "
      "| median width | fitted in |\n|---|---|---|---|---|---|---|---|\n";
  for (const ParameterRecovery& one : recovery_of(studies)) {
    page += row_of(one, fitted);
  }
  page +=
      "\nOf the intervals that hold what was planted there should be 95 %; in brackets, what "
      "chance "
      "leaves open (Wilson 1927), and a star where 95 % is outside. In the other studies a "
      "parameter was held at what was planted, since no answer depends on it or the study does not "
      "identify it; the rest was then fitted given that. What is fitted in few studies is not "
      "asked by this design: more levels, more people or a simpler observer would tell it.\n";
  return page;
}

std::string recovery_csv(const std::vector<RecoveredStudy>& studies) {
  std::string text = csv_line(
      {"study", "seed", "parameter", "planted", "value", "low", "high", "covered", "held_because"});
  for (const RecoveredStudy& study : studies) {
    for (const RecoveredParameter& one : study.parameters) {
      const auto number = [&](double value) {
        return one.is_fitted() ? exact_number(value) : std::string();
      };
      text +=
          csv_line({std::to_string(study.number), std::to_string(study.seed), one.name,
                    exact_number(one.planted), number(one.value), number(one.low), number(one.high),
                    one.is_fitted() ? (one.is_covered() ? "1" : "0") : "", one.held_because});
    }
  }
  return text;
}

}  // namespace impetus::inline power
