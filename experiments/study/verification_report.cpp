// SPDX-License-Identifier: MIT
#include "experiments/study/verification_report.hpp"

#include <nlohmann/json.hpp>

#include "experiments/tables/text_table.hpp"

namespace impetus::inline study {
namespace {

using nlohmann::json;

/// Of one check, so that the last line stays in sight; JSON has all.
constexpr std::size_t kMostToldFailures = 10;

std::size_t failure_count(const Verification& verification) {
  std::size_t count = 0;
  for (const VerificationCheck& check : verification.checks) {
    count += check.failures.size();
  }
  return count;
}

std::string first_failure(const Verification& verification) {
  for (const VerificationCheck& check : verification.checks) {
    if (!check.failures.empty()) {
      return check.failures.front();
    }
  }
  return "";
}

std::string number_of(std::int64_t count, const std::string& one) {
  return std::to_string(count) + " " + one + (count == 1 ? "" : "s");
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
  if (verification.passed() && !verification.obstacles.empty()) {
    const std::size_t more = verification.obstacles.size() - 1;
    return "cannot be published: whole, but " + verification.obstacles.front() +
           (more > 0 ? " (and " + std::to_string(more) + " more)" : "");
  }
  if (verification.passed()) {
    return "can be published: " + number_of(verification.participants, "participant") + ", " +
           number_of(verification.completed_trials, "trial") + ", " +
           number_of(verification.sessions, "session");
  }
  const std::size_t more = failure_count(verification) - 1;
  return "cannot be published: " + first_failure(verification) +
         (more > 0 ? " (and " + std::to_string(more) + " more)" : "");
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
