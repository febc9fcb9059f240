// A study as a folder that any web server serves: page, program, and all that it shows.
//
//   site/  index.html  session_page.css  *.js                 what is seen
//          impetus.js  impetus.wasm                          the session, as in the lab
//          study.json                                        protocol and scene
//          trees/                                            those that take long
//          site.json                                         how the page is to be used
//
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "experiments/lines/published_study.hpp"

namespace impetus::inline site {

/// How a page is to be used.
struct SiteOptions {
  std::string drop_url;    ///< to which each trial is posted; "": it is offered as a download
  std::string experiment;  ///< "experimentID", as the drop knows the study
  std::string completion;  ///< a link that participants are led to at the end; "": none
  bool served{false};  ///< by the program itself, which takes each trial and knows who was there
  bool assume_screen{false};      ///< its size and distance are not measured
  bool in_window{false};          ///< the page does not fill the screen
  bool allow_failed_sync{false};  ///< goes on where frames do not follow the refresh
  bool phones{false};             ///< may be used without keyboard and mouse
  bool replace{false};            ///< an earlier site in this folder
};

/// Throws InputError where the protocol cannot be run in a page: nobody takes part, or regions
/// follow the gaze of others, whom a page does not know.
void require_publishable(const Protocol& protocol);

/// Throws InputError unless the options' links can be used by a page.
void require_links(const SiteOptions& options);

/// Writes the folder, whole or not at all. `program` holds impetus.js and impetus.wasm. Throws
/// InputError when the folder is in the way or the program is missing, StoreError when something
/// cannot be written.
void write_site(const PublishedStudy& study, const Protocol& protocol, const SiteOptions& options,
                const std::filesystem::path& program, const std::filesystem::path& folder);

}  // namespace impetus::inline site
