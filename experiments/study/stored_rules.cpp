// SPDX-License-Identifier: MIT
#include "experiments/study/stored_rules.hpp"

#include <algorithm>
#include <map>

#include "engine/world/world.hpp"
#include "experiments/record/lab_screen.hpp"
#include "experiments/store/rows.hpp"
#include "experiments/store/session_rows.hpp"
#include "experiments/study/embedded_order_rules.hpp"
#include "experiments/study/embedded_places.hpp"
#include "experiments/study/embedded_provenance_rules.hpp"
#include "experiments/study/embedded_recording_rules.hpp"
#include "experiments/study/embedded_remarks.hpp"

namespace impetus::inline study {
namespace {

/// The rule with the numbers that this build puts into it.
std::string with_formats(std::string rule) {
  const std::pair<const char*, int> values[] = {{"{oldest format}", kOldestRecordingFormat},
                                                {"{format}", kRecordingFormat}};
  for (const auto& [name, value] : values) {
    const std::size_t at = rule.find(name);
    if (at != std::string::npos) {
      rule.replace(at, std::string(name).size(), std::to_string(value));
    }
  }
  return rule;
}

/// What the queries of a text yield, each of which ends with a semicolon at the end of a line.
std::vector<std::string> sentences(SQLite::Database& study, const std::string& before,
                                   const std::string& queries) {
  std::vector<std::string> found;
  for (std::size_t begin = 0, end = 0; (end = queries.find(";\n", begin)) != std::string::npos;
       begin = end + 2) {
    const std::string query = with_formats(queries.substr(begin, end - begin));
    for (std::string& sentence : load_column<std::string>(study, before + query)) {
      found.push_back(std::move(sentence));
    }
  }
  return found;
}

/// "P01, causality, session 2: ".
std::string place_of(const SessionScreen& session) {
  return session.participant + ", " + session.protocol + ", session " +
         std::to_string(session.session_id) + ": ";
}

}  // namespace

Failures broken_order(SQLite::Database& study) {
  return sentences(study, kPlacesSql, kOrderRulesSql);
}

Failures broken_recordings(SQLite::Database& study) {
  return sentences(study, kPlacesSql, kRecordingRulesSql);
}

Failures broken_provenance(SQLite::Database& study) {
  return sentences(study, kPlacesSql, kProvenanceRulesSql);
}

std::vector<std::string> remarks_on(SQLite::Database& study) {
  return sentences(study, "", kRemarksSql);
}

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
