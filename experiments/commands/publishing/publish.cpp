// `impetus publish`: a study as a folder that any web server serves.
// SPDX-License-Identifier: MIT
#include <cstdio>
#include <memory>
#include <string>

#include "experiments/commands/commands.hpp"
#include "experiments/commands/publishing/publication.hpp"

namespace impetus::inline commands {
namespace {

int publish(const PublishOptions& options, const std::string& out) {
  require_links(options.site);
  const Publication made = publication_of(options);
  write_site(made.study, made.protocol, options.site, made.program, out);
  std::printf("%s: %s, for a web server to serve; %s\n", out.c_str(), made.protocol.name.c_str(),
              options.site.drop_url.empty()
                  ? "each participant's session is offered to them as a download"
                  : ("trials are sent to " + options.site.drop_url).c_str());
  return kDone;
}

}  // namespace

void add_publish(CLI::App& app, Command& chosen) {
  auto options = std::make_shared<PublishOptions>();
  auto out = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("publish", "Write a study as a web page");
  add_publish_options(*command, *options);
  command
      ->add_option("--out", *out,
                   "Folder for the site: new or empty, unless --force replaces a site")
      ->required();
  command->add_option("--drop", options->site.drop_url,
                      "Link that takes trials in the form of DataPipe (left out: a download)");
  command->add_option("--experiment", options->site.experiment, "The study's id at the drop");
  command->add_flag("--force", options->site.replace, "Replace an earlier site");
  command->callback([options, out, &chosen] { chosen = [=] { return publish(*options, *out); }; });
}

}  // namespace impetus::inline commands
