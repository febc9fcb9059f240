// `impetus sessions`: who takes part in a study, how far they came, how each sitting went.
// SPDX-License-Identifier: MIT
#include <cstdio>
#include <memory>
#include <string>

#include "experiments/commands/commands.hpp"
#include "experiments/store/read_only_file.hpp"
#include "experiments/store/session_list.hpp"
#include "experiments/study/session_words.hpp"

namespace impetus::inline commands {
namespace {

/// What `impetus sessions` was asked for.
struct SessionsOptions {
  std::string study;
  bool json{false};
};

/// Asked and let go before the study is opened: a session may begin while it is read.
bool is_in_use(const std::string& path) { return !ReadingLock(path).held(); }

int list_sessions(const SessionsOptions& options) {
  const bool in_use = is_in_use(options.study);
  StudyFile study = StudyFile::open_for_reading(options.study);
  try {
    const SessionList list = load_session_list(study, in_use);
    const std::string text =
        options.json ? session_json(study.name(), list) : session_words(study.name(), list);
    std::fputs(text.c_str(), stdout);
    return kDone;
  } catch (const SQLite::Exception& error) {
    throw StoreError(study.name() + ": could not be read (" + error.what() + ")");
  }
}

}  // namespace

void add_sessions(CLI::App& app, Command& chosen) {
  auto options = std::make_shared<SessionsOptions>();
  CLI::App* command = app.add_subcommand(
      "sessions", "List a study's participants, their progress and their sessions");
  command->add_option("study", options->study, "Study file; a session may be running on it")
      ->required();
  command->add_flag("--json", options->json, "As JSON");
  command->callback([options, &chosen] { chosen = [options] { return list_sessions(*options); }; });
}

}  // namespace impetus::inline commands
