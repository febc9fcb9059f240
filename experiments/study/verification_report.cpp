// SPDX-License-Identifier: MIT
#include "experiments/study/verification_report.hpp"

#include <nlohmann/json.hpp>

#include "experiments/tables/number_text.hpp"
#include "experiments/tables/text_table.hpp"

namespace impetus::inline study {
namespace {

using nlohmann::json;

/// Of one check, so that the last line stays in sight; JSON has all.
constexpr std::size_t kMostToldFailures = 10;

std::vector<std::string> all_failures(const Verification& verification) {
  std::vector<std::string> all;
  for (const VerificationCheck& check : verification.checks) {
    all.insert(all.end(), check.failures.begin(), check.failures.end());
  }
  return all;
}

/// The first, and how many more.
std::string first_of(const std::vector<std::string>& sentences) {
  const std::size_t more = sentences.size() - 1;
  return sentences.front() + (more > 0 ? " (and " + std::to_string(more) + " more)" : "");
}

void add_rows(const VerificationCheck& check, std::vector<std::vector<std::string>>& rows) {
  if (check.failures.empty()) {
    rows.push_back({check.name, "ok", check.found});
  }
  for (std::size_t i = 0; i < check.failures.size() && i < kMostToldFailures; ++i) {
    rows.push_back({i == 0 ? check.name : "", "WRONG", check.failures[i]});
  }
  if (check.failures.size() > kMostToldFailures) {
    rows.push_back({"", "WRONG",
                    "and " + std::to_string(check.failures.size() - kMostToldFailures) + " more"});
  }
}

std::string verdict(const Verification& verification) {
  if (!verification.passed()) {
    return "cannot be published: " + first_of(all_failures(verification));
  }
  if (!verification.obstacles.empty()) {
    return "cannot be published: whole, but " + first_of(verification.obstacles);
  }
  return "can be published: " + count_of(verification.participants, "participant") + ", " +
         count_of(verification.completed_trials, "trial") + ", " +
         count_of(verification.sessions, "session");
}

}  // namespace

std::string verification_words(const std::string& name, const Verification& verification) {
  std::vector<std::vector<std::string>> rows;
  for (const VerificationCheck& check : verification.checks) {
    add_rows(check, rows);
  }
  for (const std::string& obstacle : verification.obstacles) {
    rows.push_back({"obstacle", "", obstacle});
  }
  for (const std::string& remark : verification.remarks) {
    rows.push_back({"remark", "", remark});
  }
  return text_table(rows) + printable(name + ": " + verdict(verification)) + "\n";
}

std::string verification_json(const std::string& name, const Verification& verification) {
  json checks = json::array();
  for (const VerificationCheck& check : verification.checks) {
    checks.push_back({{"name", check.name},
                      {"passed", check.failures.empty()},
                      {"found", check.found},
                      {"failures", check.failures}});
  }
  const json whole = {{"study", name},
                      {"publishable", verification.publishable()},
                      {"verdict", verdict(verification)},
                      {"participants", verification.participants},
                      {"completed_trials", verification.completed_trials},
                      {"sessions", verification.sessions},
                      {"checks", std::move(checks)},
                      {"obstacles", verification.obstacles},
                      {"remarks", verification.remarks}};
  return whole.dump(2, ' ', false, json::error_handler_t::replace) + "\n";
}

}  // namespace impetus::inline study
