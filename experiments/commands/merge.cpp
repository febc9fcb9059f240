// `impetus merge`: files of several stations of one study, joined into one.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "experiments/commands/commands.hpp"
#include "experiments/provenance/build_name.hpp"
#include "experiments/settings/input_error.hpp"
#include "experiments/store/merging/study_merge.hpp"
#include "experiments/store/rows.hpp"
#include "experiments/store/study_reader.hpp"
#include "experiments/study/stored_plan.hpp"

namespace impetus::inline commands {
namespace {

/// What `impetus merge` was asked for.
struct MergeOptions {
  std::vector<std::string> sources;
  std::string into;
};

/// The first protocol of the study that does not have the hash that it is kept under; none of what
/// is no study, or has a protocol that this build cannot read: merge_studies() judges that.
std::optional<std::string> changed_protocol(const std::filesystem::path& path) {
  try {
    StudyFile study = StudyFile::open_for_reading(path);
    for (const std::int64_t id :
         load_column<std::int64_t>(study.database(), "SELECT id FROM protocol ORDER BY id")) {
      const ProtocolTexts texts = load_protocol_texts(study, id);
      if (hash_of(texts.protocol_json, texts.scene_json) != texts.hash) {
        return texts.name;
      }
    }
  } catch (const std::exception&) {
  }
  return std::nullopt;
}

/// Studies are one by the hashes of their protocols: one that was changed by hand would pass for
/// another, or give itself to trials that never had it. Throws InputError.
void require_protocols_as_hashed(const std::filesystem::path& path) {
  if (const auto name = changed_protocol(path)) {
    throw InputError(path.string() + ": its protocol " + *name +
                     " was changed by hand, its hash tells");
  }
}

int merge(const MergeOptions& options) {
  const std::vector<std::filesystem::path> sources(options.sources.begin(), options.sources.end());
  std::for_each(sources.begin(), sources.end(), require_protocols_as_hashed);
  require_protocols_as_hashed(options.into);
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
