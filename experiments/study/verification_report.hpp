// What was found of a study that is to be published: checks that all must pass, and remarks; in
// words for a terminal and as JSON for programs.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace impetus::inline study {

/// One sentence for each thing that is wrong; none when all is right.
using Failures = std::vector<std::string>;

/// One of the checks that a study must pass.
struct VerificationCheck {
  std::string name;   ///< one word: "file", "plans", ...
  std::string found;  ///< what was looked at, and how much of it
  Failures failures;
};

/// All that was found of a study.
struct Verification {
  std::vector<VerificationCheck> checks;  ///< in the order made; the first failure is the reason
  std::vector<std::string> obstacles;     ///< why a study is not published though its file is whole
  std::vector<std::string> remarks;       ///< what a reader should know, and forbids nothing
  std::int64_t participants{0};
  std::int64_t completed_trials{0};  ///< practice included
  std::int64_t sessions{0};

  /// Whether every check passed.
  [[nodiscard]] bool passed() const {
    return std::all_of(checks.begin(), checks.end(),
                       [](const VerificationCheck& check) { return check.failures.empty(); });
  }
  /// Whether the study can be published: it passed, and nothing stands against it.
  [[nodiscard]] bool publishable() const { return passed() && obstacles.empty(); }
};

/// A line for each check, each failure, each obstacle and each remark; the last line alone says
/// whether the study `name` can be published, and if not, the first reason.
std::string verification_words(const std::string& name, const Verification& verification);

/// The same as one JSON object.
std::string verification_json(const std::string& name, const Verification& verification);

}  // namespace impetus::inline study
