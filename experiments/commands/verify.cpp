// `impetus verify`: whether a study file can be published, and if not, why.
// SPDX-License-Identifier: MIT
#include <cstdio>
#include <memory>
#include <string>

#include "experiments/commands/commands.hpp"
#include "experiments/commands/replays/replay_check.hpp"
#include "experiments/study/study_verification.hpp"
#include "experiments/study/verification.hpp"

namespace impetus::inline commands {
namespace {

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
  return verification.passed() ? kDone : kFound;
}

}  // namespace

void add_verify(CLI::App& app, Command& chosen) {
  auto options = std::make_shared<VerifyOptions>();
  CLI::App* command = app.add_subcommand(
      "verify", "Check that a study file is whole, complete and as recorded: can it be published?");
  command->add_option("study", options->study, "Study file; it is not changed")->required();
  command->add_flag("--replay", options->replay, "Simulate every trial again, too");
  command->add_flag("--json", options->json, "As JSON");
  command->callback([options, &chosen] { chosen = [options] { return verify(*options); }; });
}

}  // namespace impetus::inline commands
