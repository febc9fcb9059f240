// `impetus merge`: files of several stations of one study, joined into one.
// SPDX-License-Identifier: MIT
#include <cstdio>
#include <string>
#include <vector>

#include "experiments/commands/commands.hpp"
#include "experiments/provenance/build_name.hpp"
#include "experiments/store/merging/study_merge.hpp"

namespace impetus::inline commands {
namespace {

/// What `impetus merge` was asked for.
struct MergeOptions {
  std::vector<std::string> sources;
  std::string into;
};

int merge(const MergeOptions& options) {
  const std::vector<std::filesystem::path> sources(options.sources.begin(), options.sources.end());
  const MergeResult result = merge_studies(sources, options.into, build_name());
  std::printf(
      "%s: %lld participant%s added; it holds %lld, with %lld completed trials. The merged "
      "files are as they were.\n",
      options.into.c_str(), static_cast<long long>(result.participants_added),
      result.participants_added == 1 ? "" : "s", static_cast<long long>(result.participants),
      static_cast<long long>(result.completed_trials));
  return kDone;
}

}  // namespace

void add_merge(CLI::App& app, Command& chosen) {
  const auto [command, options] = add_command<MergeOptions>(
      app, chosen, merge, "merge", "Join the study files of several stations into one");
  command->add_option("studies", options->sources, "Study files; they are not changed")->required();
  command->add_option("--into", options->into, "Study file; made when it does not exist")
      ->required();
}

}  // namespace impetus::inline commands
