// `impetus verify`: whether a study file can be published, and if not, why.
// SPDX-License-Identifier: MIT
#include <cstdio>
#include <exception>
#include <string>
#include <utility>
#include <vector>

#include "experiments/commands/commands.hpp"
#include "experiments/commands/replays/replay_levels.hpp"
#include "experiments/store/study_file.hpp"
#include "experiments/study/replay_comparison.hpp"
#include "experiments/study/study_verification.hpp"
#include "experiments/study/verification_report.hpp"

namespace impetus::inline commands {
namespace {

std::string place_of(const StoredAttempt& attempt, const std::string& protocol) {
  return attempt.participant + ", " + protocol + ", slot " + std::to_string(attempt.trial.slot) +
         ", attempt " + std::to_string(attempt.number);
}

std::string problem_of(ReplayComparison& comparison, ReplayLibrary& library,
                       const StoredAttempt& attempt) {
  try {
    const std::string problem = comparison.problem_of(attempt);
    return problem.empty()
               ? ""
               : place_of(attempt, library.protocol(attempt.protocol_id).name) + ": " + problem;
  } catch (const std::exception& error) {
    return "trial " + std::to_string(attempt.trial_id) + " cannot be simulated: " + error.what();
  }
}

void check_levels(StudyFile& study, ReplayLibrary& library, Failures& failures) {
  try {
    for (const LevelDivergence& divergence : divergent_levels(study, library)) {
      failures.push_back("trial " + std::to_string(divergence.trial_id) + ": " + divergence.words);
    }
  } catch (const std::exception& error) {
    failures.push_back(std::string("adaptive levels cannot be chosen anew: ") + error.what());
  }
}

/// Compares each step of every attempt bit for bit, what was recorded of its collisions, and every
/// adaptive level with what its track chooses anew.
VerificationCheck check_replay(StudyFile& study) {
  VerificationCheck check{"replay", "", {}};
  ReplayLibrary library(study);
  const std::vector<StoredAttempt> attempts = load_attempts(study);
  ReplayComparison comparison(study, library);
  for (const StoredAttempt& attempt : attempts) {
    if (std::string problem = problem_of(comparison, library, attempt); !problem.empty()) {
      check.failures.push_back(std::move(problem));
    }
  }
  check_levels(study, library, check.failures);
  check.found = std::to_string(attempts.size()) + " trials again, " +
                std::to_string(comparison.steps()) + " steps, each bit as it was";
  return check;
}

/// What `impetus verify` was asked for.
struct VerifyOptions {
  std::string study;
  bool replay{false};
  bool json{false};
};

int verify(const VerifyOptions& options) {
  const Verification verification =
      verify_study(options.study, options.replay ? check_replay : FurtherCheck());
  const std::string text = options.json ? verification_json(options.study, verification)
                                        : verification_words(options.study, verification);
  std::fputs(text.c_str(), stdout);
  return verification.publishable() ? kDone : kFound;
}

}  // namespace

void add_verify(CLI::App& app, Command& chosen) {
  const auto [command, options] = add_command<VerifyOptions>(
      app, chosen, verify, "verify",
      "Check that a study file is whole, complete and as recorded: can it be published?");
  command->add_option("study", options->study, "Study file; it is not changed")->required();
  command->add_flag("--replay", options->replay, "Simulate every trial again, too");
  command->add_flag("--json", options->json, "As JSON");
}

}  // namespace impetus::inline commands
