// `impetus collect`: sessions that came back from a published study, into a study file.
// SPDX-License-Identifier: MIT
#include <cstdio>
#include <filesystem>
#include <string>

#include "experiments/commands/commands.hpp"
#include "experiments/provenance/build_name.hpp"
#include "experiments/settings/input_error.hpp"
#include "experiments/settings/json_document.hpp"
#include "experiments/site/returned_session.hpp"

namespace impetus::inline commands {
namespace {

/// What `impetus collect` was asked for.
struct CollectOptions {
  std::string folder;
  std::string site;
  std::string database;
};

PublishedStudy published_study(const std::filesystem::path& site) {
  const JsonDocument document = read_json(site / "study.json");
  try {
    return published_study_from(document.value);
  } catch (const std::exception& error) {
    throw InputError(document.name + ": " + error.what());
  }
}

void print_taken(const std::string& name, const TakenSession& taken) {
  const std::string what =
      taken.first_part == 0 ? "the whole download"
      : taken.first_part == taken.last_part
          ? "part " + std::to_string(taken.first_part)
          : "parts " + std::to_string(taken.first_part) + " to " + std::to_string(taken.last_part);
  std::printf("%s: %s, %zu records, %lld steps simulated again, 0 divergent%s\n", name.c_str(),
              what.c_str(), taken.records, static_cast<long long>(taken.steps),
              taken.finished ? "" : "; not finished");
}

/// Each session by itself: one that is refused keeps none of the others out.
int collect(const CollectOptions& options) {
  const PublishedStudy published = published_study(options.site);
  const Protocol protocol = make_protocol(parse_json("the protocol", published.protocol_json),
                                          parse_json("its scene", published.scene_json));
  const std::vector<ReturnedFiles> sessions = returned_files(options.folder);
  StudyFile study = StudyFile::open_for_writing(options.database, build_name());
  std::size_t taken = 0;
  for (const ReturnedFiles& files : sessions) {
    try {
      print_taken(files.name, take_session(files, published, protocol, study));
      ++taken;
    } catch (const InputError& refused) {
      std::fprintf(stderr, "refused: %s\n", refused.what());
    }
  }
  std::printf("%s: %zu of %zu sessions taken\n", options.database.c_str(), taken, sessions.size());
  return taken == sessions.size() ? kDone : kFound;
}

}  // namespace

void add_collect(CLI::App& app, Command& chosen) {
  const auto [command, options] = add_command<CollectOptions>(
      app, chosen, collect, "collect", "Take sessions of a published study into a study file");
  command->add_option("folder", options->folder, "Folder of what came back (.jsonl)")->required();
  command->add_option("--site", options->site, "Folder that `impetus publish` wrote")->required();
  command->add_option("--into", options->database, "Study file; made when it does not exist")
      ->required();
}

}  // namespace impetus::inline commands
