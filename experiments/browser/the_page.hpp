// What the program asks of the page it runs in: three calls that wait, and a few that do not.
// Behind them is page/session_page.js; how the program waits (Asyncify) is nobody else's business.
//
//   next_frame   until the browser begins its next frame    (when that was)
//   ask          until somebody has answered a page          (what was answered)
//   await_saved  until all that was handed over is kept      (or the page says why not, and waits
//   on)
//
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>

namespace impetus::inline browser {

/// Waits for the browser's next frame; returns when that began (ns, of the steady clock).
std::int64_t next_frame();

/// Shows a page, as page_json() says it, until it is answered or left; returns what came of it.
nlohmann::json ask_of_participant(const nlohmann::json& page);

/// Waits until every line that was handed over is where it is to be kept; then the participant
/// stands here, and a page that is opened again goes on from it.
void await_kept(const nlohmann::json& standing);

/// Hands over one line of the record.
void hand_over(const std::string& line);

/// What happened since the last call: clicks, moves of the mouse, whether a pause was asked for.
nlohmann::json take_events();

/// How far the session has come, along the bottom edge.
void show_progress(const nlohmann::json& progress);

/// A point to look at over the picture, pixels from its upper left; off: none.
void show_target(bool on, double x_px, double y_px);

/// Whether the mouse pointer is seen over the picture, which is in front from now on.
void show_picture(bool with_pointer);

/// A sentence for the participant, where nothing can go on.
void tell(const std::string& sentence);

}  // namespace impetus::inline browser
