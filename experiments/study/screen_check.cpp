// SPDX-License-Identifier: MIT
#include "experiments/study/screen_check.hpp"

#include <algorithm>
#include <map>

#include "experiments/record/lab_screen.hpp"
#include "experiments/store/screen_rows.hpp"

namespace impetus::inline study {
namespace {

/// "P01, causality, session 2: ".
std::string place_of(const SessionScreen& session) {
  return session.participant + ", " + session.protocol + ", session " +
         std::to_string(session.session_id) + ": ";
}

}  // namespace

Failures unsaid_screens(SQLite::Database& study) {
  Failures failures;
  const SessionScreen* before = nullptr;
  const std::vector<SessionScreen> sessions = session_screens(study);
  for (const SessionScreen& session : sessions) {
    if (!has_square_pixels(session.screen) && !session.said_not_square) {
      failures.push_back(place_of(session) + "each pixel was " + pixel_words(session.screen) +
                         " (" + screen_words(session.screen) +
                         "), and nobody said that they are not square");
    }
    const bool resumed = before != nullptr && before->enrolment_id == session.enrolment_id;
    if (resumed && !is_same_screen(before->screen, session.screen) && !session.said_changed) {
      failures.push_back(place_of(session) + "sat before " + screen_words(session.screen) +
                         ", in the session before " + screen_words(before->screen) +
                         ", and nobody said that the screen changed");
    }
    before = &session;
  }
  return failures;
}

std::vector<std::string> screen_remarks(SQLite::Database& study) {
  std::int64_t not_square = 0;
  std::map<std::string, std::vector<ScreenGeometry>> screens;  // of each participant
  for (const SessionScreen& session : session_screens(study)) {
    not_square += session.said_not_square ? 1 : 0;
    std::vector<ScreenGeometry>& known = screens[session.participant];
    if (std::none_of(known.begin(), known.end(), [&](const ScreenGeometry& screen) {
          return is_same_screen(screen, session.screen);
        })) {
      known.push_back(session.screen);
    }
  }
  std::vector<std::string> remarks;
  for (const auto& [participant, seen] : screens) {
    if (seen.size() > 1) {
      std::string words = participant + " sat before " + std::to_string(seen.size()) + " screens: ";
      for (const ScreenGeometry& screen : seen) {
        words += (&screen == &seen.front() ? "" : "; ") + screen_words(screen);
      }
      remarks.push_back(words);
    }
  }
  if (not_square > 0) {
    remarks.push_back(std::to_string(not_square) +
                      " sessions were before a screen whose pixels, as was said, are not square");
  }
  return remarks;
}

}  // namespace impetus::inline study
