// `impetus publish`: a study as a folder that any web server serves.
// SPDX-License-Identifier: MIT
#include <cstdio>
#include <string>

#include "experiments/commands/commands.hpp"
#include "experiments/commands/publishing/publication.hpp"

namespace impetus::inline commands {
namespace {

/// What `impetus publish` was asked for.
struct PublishFolderOptions : PublishOptions {
  std::string out;
};

int publish(const PublishFolderOptions& options) {
  require_links(options.site);
  const Publication made = publication_of(options);
  write_site(made.study, made.protocol, options.site, made.program, options.out);
  std::printf(
      "%s: %s, for a web server to serve; %s\n", options.out.c_str(), made.protocol.name.c_str(),
      options.site.drop_url.empty() ? "each participant's session is offered to them as a download"
                                    : ("trials are sent to " + options.site.drop_url).c_str());
  return kDone;
}

}  // namespace

void add_publish(CLI::App& app, Command& chosen) {
  const auto [command, options] = add_command<PublishFolderOptions>(app, chosen, publish, "publish",
                                                                    "Write a study as a web page");
  add_publish_options(*command, *options);
  command
      ->add_option("--out", options->out,
                   "Folder for the site: new or empty, unless --force replaces a site")
      ->required();
  command->add_option("--drop", options->site.drop_url,
                      "Link that takes trials in the form of DataPipe (left out: a download)");
  command->add_option("--experiment", options->site.experiment, "The study's id at the drop");
  command->add_flag("--force", options->site.replace, "Replace an earlier site");
}

}  // namespace impetus::inline commands
