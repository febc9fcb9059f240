// What `impetus publish` and `impetus serve` make of a protocol.
// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>

#include "experiments/site/site_folder.hpp"

namespace impetus::inline commands {

/// Which study becomes a page, and how it is to be used.
struct PublishOptions {
  std::string protocol;
  std::string program;  ///< folder of what runs in a page; "": where it was built
  SiteOptions site;
};

/// A study that is ready to be written as a site.
struct Publication {
  Protocol protocol;
  PublishedStudy study;
  std::filesystem::path program;
};

/// The options that both have.
void add_publish_options(CLI::App& command, PublishOptions& options);

/// Throws InputError where the protocol cannot be run in a page.
Publication publication_of(const PublishOptions& options);

}  // namespace impetus::inline commands
