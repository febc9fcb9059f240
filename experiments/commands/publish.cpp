// `impetus publish`: a study as a folder that any web server serves.
// SPDX-License-Identifier: MIT
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

#include "experiments/commands/build_name.hpp"
#include "experiments/commands/commands.hpp"
#include "experiments/commands/progress_line.hpp"
#include "experiments/commands/shipped_file.hpp"
#include "experiments/files/protocol_files.hpp"
#include "experiments/site/site_folder.hpp"
#include "experiments/study/stored_plan.hpp"

namespace impetus::inline commands {
namespace {

namespace fs = std::filesystem;

/// What `impetus publish` was asked for.
struct PublishOptions {
  std::string protocol;
  std::string out;
  std::string program;
  SiteOptions site;
};

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

int publish(const PublishOptions& options) {
  const BuildingLine told;
  const Protocol protocol = load_protocol(options.protocol);
  require_publishable(protocol);
  require_links(options.site);
  const ProtocolTexts texts = texts_of(protocol);
  ProgressLine line("solving what the plan needs");
  const PublishedStudy study{
      texts.protocol_json, texts.scene_json,
      solve(protocol, *protocol.shapes, [&line](double share) { line.tell(share); }), build_name()};
  write_site(study, protocol, options.site, page_program(options.program), options.out);
  std::printf("%s: %s, for a web server to serve; %s\n", options.out.c_str(), protocol.name.c_str(),
              options.site.drop_url.empty()
                  ? "each participant's session is offered to them as a download"
                  : ("trials are sent to " + options.site.drop_url).c_str());
  return kDone;
}

}  // namespace

void add_publish(CLI::App& app, Command& chosen) {
  auto options = std::make_shared<PublishOptions>();
  CLI::App* command = app.add_subcommand("publish", "Write a study as a web page");
  command
      ->add_option("protocol", options->protocol, "Protocol file, such as protocols/causality.json")
      ->required()
      ->transform([](const std::string& name) { return shipped_file(name); });
  command->add_option("--out", options->out, "Folder for the site; must not exist")->required();
  command->add_option("--drop", options->site.drop_url,
                      "Link that takes trials in the form of DataPipe (left out: a download)");
  command->add_option("--experiment", options->site.experiment, "The study's id at the drop");
  command->add_option("--completion", options->site.completion,
                      "Link that participants are led to at the end");
  command->add_flag("--phones", options->site.phones,
                    "Do not refuse what has neither keyboard nor mouse");
  command->add_option("--program", options->program,
                      "Folder of impetus.js and impetus.wasm (default: where they were built)");
  command->add_flag("--force", options->site.replace, "Replace an earlier site");
  command->callback([options, &chosen] { chosen = [options] { return publish(*options); }; });
}

}  // namespace impetus::inline commands
