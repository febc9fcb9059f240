// SPDX-License-Identifier: MIT
#include "experiments/commands/publishing/publication.hpp"

#include <cstdio>

#include "experiments/commands/progress_line.hpp"
#include "experiments/commands/shipped_file.hpp"
#include "experiments/files/protocol_files.hpp"
#include "experiments/provenance/build_name.hpp"
#include "experiments/study/stored_plan.hpp"

namespace impetus::inline commands {
namespace {

namespace fs = std::filesystem;

/// Where the program that runs in a page lies: beside the data that came with this one, or where
/// the browser's build put it.
fs::path page_program(const std::string& given) {
  if (!given.empty()) {
    return given;
  }
  const fs::path installed = fs::path(shipped_file("browser/impetus.wasm")).parent_path();
  return fs::exists(installed / "impetus.wasm")
             ? installed
             : fs::path(shipped_file("build-browser/impetus.wasm")).parent_path();
}

}  // namespace

void add_publish_options(CLI::App& command, PublishOptions& options) {
  command
      .add_option("protocol", options.protocol, "Protocol file, such as protocols/causality.json")
      ->required()
      ->transform([](const std::string& name) { return shipped_file(name); });
  command.add_option("--completion", options.site.completion,
                     "Link that participants are led to at the end");
  command.add_flag("--assume-screen", options.site.assume_screen,
                   "Do not ask for the size and distance of the screen; they are assumed");
  command.add_flag("--in-window", options.site.in_window, "Do not fill the screen");
  command.add_flag("--allow-failed-sync", options.site.allow_failed_sync,
                   "Go on when the sync test fails; every trial is marked");
  command.add_flag("--phones", options.site.phones,
                   "Do not refuse what has neither keyboard nor mouse");
  command.add_option("--program", options.program,
                     "Folder of impetus.js and impetus.wasm (default: where they were built)");
}

Publication publication_of(const PublishOptions& options) {
  const BuildingLine told;
  Protocol protocol = load_protocol(options.protocol);
  require_publishable(protocol);
  if (protocol.script.markers) {
    std::fprintf(stderr, "note: a page sends no markers\n");
  }
  const ProtocolTexts texts = texts_of(protocol);
  ProgressLine line("solving what the plan needs");
  PublishedStudy study{
      texts.protocol_json, texts.scene_json,
      solve(protocol, *protocol.shapes, [&line](double share) { line.tell(share); }), build_name()};
  return {std::move(protocol), std::move(study), page_program(options.program)};
}

}  // namespace impetus::inline commands
