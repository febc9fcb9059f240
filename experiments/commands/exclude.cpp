// `impetus exclude`: what the analysis is to leave out, and why.
// SPDX-License-Identifier: MIT
#include <cstdio>
#include <string>

#include "experiments/commands/commands.hpp"
#include "experiments/provenance/build_name.hpp"
#include "experiments/store/exclusion.hpp"

namespace impetus::inline commands {
namespace {

/// What `impetus exclude` was asked for.
struct ExcludeOptions {
  std::string database;
  Exclusion exclusion;
  bool take_back{false};
};

int run_exclude(const ExcludeOptions& options) {
  Exclusion exclusion = options.exclusion;
  exclusion.excluded = !options.take_back;
  {  // what is refused leaves the file as it is
    StudyFile as_it_is = StudyFile::open_for_reading(options.database);
    require_excludable(as_it_is, exclusion);
  }
  StudyFile study = StudyFile::open_for_writing(options.database, build_name());
  exclude(study, exclusion);
  const std::string trial =
      exclusion.trial_id ? ", trial " + std::to_string(*exclusion.trial_id) : "";
  std::printf(
      "%s%s: %s\n", exclusion.participant.c_str(), trial.c_str(),
      exclusion.excluded
          ? "excluded. Nothing was deleted; --take-back undoes it."
          : "in again. Nothing was deleted: the study keeps each decision with its reason.");
  return kDone;
}

}  // namespace

void add_exclude(CLI::App& app, Command& chosen) {
  const auto [command, options] = add_command<ExcludeOptions>(
      app, chosen, run_exclude, "exclude", "Leave a participant or a trial out of the analysis");
  command->add_option("study", options->database, "Study file")->required();
  command->add_option("--participant", options->exclusion.participant, "Code of the participant")
      ->required();
  command->add_option("--trial", options->exclusion.trial_id,
                      "Id of one trial, as the views have it (default: all trials)");
  command->add_option("--reason", options->exclusion.reason, "Why; it stands in every report")
      ->required()
      ->check([](const std::string& reason) {
        return reason.find_first_not_of(" \t\n") == std::string::npos
                   ? std::string("expected a reason, got none")
                   : std::string();
      });
  command->add_flag("--take-back", options->take_back, "In again; the rows stay");
}

}  // namespace impetus::inline commands
