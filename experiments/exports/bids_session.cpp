// SPDX-License-Identifier: MIT
#include "experiments/exports/bids_session.hpp"

#include <cctype>

#include "experiments/exports/row_query.hpp"
#include "experiments/tables/plain_text.hpp"

namespace impetus::inline exports {
namespace {

constexpr std::size_t kLongestLabel = 64;

bool is_ascii_word(char letter) {
  return static_cast<unsigned char>(letter) < 0x80 &&
         std::isalnum(static_cast<unsigned char>(letter)) != 0;
}

std::string in_small_letters(std::string text) {
  for (char& letter : text) {
    letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  }
  return text;
}

std::map<std::int64_t, std::string> labels_of(SQLite::Database& database, const std::string& sql) {
  std::map<std::int64_t, std::string> labels;
  BidsLabels given;
  RowQuery query(database, sql);
  while (query.step()) {
    labels[query.integer(0)] = given.label_for(query.bytes(1));
  }
  return labels;
}

using nlohmann::ordered_json;

constexpr const char* kSessions =
    "SELECT session.id, enrolment.participant_id, enrolment.protocol_id, protocol.name, "
    "session.screen_width_m, session.screen_height_m, session.screen_width_px, "
    "session.screen_height_px, session.viewing_distance_m, session.refresh_hz, session.build, "
    "session.machine, session.display, coalesce(session.gaze_source, (SELECT max(gaze_source) "
    "FROM attempt WHERE session_id = session.id), ''), session.screen_measured FROM session "
    "JOIN enrolment ON enrolment.id = session.enrolment_id "
    "JOIN protocol ON protocol.id = enrolment.protocol_id "
    "ORDER BY enrolment.participant_id, session.id";

/// The first instant of a session; NULL: nothing has one.
constexpr const char* kZero =
    "SELECT min(at) FROM (SELECT onset_ns AS at FROM attempt WHERE session_id = ?1 AND onset_ns > "
    "0 "
    "UNION ALL SELECT flipped_ns FROM frame JOIN attempt ON attempt.id = attempt_id "
    "WHERE session_id = ?1 AND onset_ns > 0 "
    "UNION ALL SELECT taken_ns FROM gaze JOIN attempt ON attempt.id = attempt_id "
    "WHERE session_id = ?1 AND onset_ns > 0 "
    "UNION ALL SELECT began_ns FROM calibration WHERE session_id = ?1)";

std::string two_digits(int number) { return (number < 10 ? "0" : "") + std::to_string(number); }

ordered_json presentation_of(const RowQuery& query) {
  return {{"ScreenDistance", query.number(8)},
          {"ScreenOrigin", {"top", "left"}},
          {"ScreenSize", {query.number(4), query.number(5)}},
          {"ScreenResolution", {query.integer(6), query.integer(7)}},
          {"ScreenRefreshRate", query.number(9)},
          {"ScreenMeasured", query.integer(14) != 0},
          {"SoftwareName", "Impetus"},
          {"SoftwareVersion", as_utf8(query.bytes(10))},
          {"OperatingSystem", as_utf8(query.bytes(11))},
          {"Display", as_utf8(query.bytes(12))}};
}

void read_zero(SQLite::Database& database, BidsSession& session) {
  RowQuery query(database, kZero, {std::to_string(session.id)});
  session.has_clock = query.step() && !query.is_null(0);
  session.zero_ns = session.has_clock ? query.integer(0) : 0;
}

}  // namespace

std::string BidsLabels::label_for(std::string_view name) {
  std::string letters;
  for (const char letter : name) {
    if (is_ascii_word(letter) && letters.size() < kLongestLabel) {
      letters += letter;
    }
  }
  std::string label = letters;
  for (int number = 2; label.empty() || !given_.insert(in_small_letters(label)).second; ++number) {
    label = (letters.empty() ? "X" : letters + "X") + std::to_string(number);
  }
  return label;
}

BidsNames bids_names(SQLite::Database& database) {
  return {labels_of(database, "SELECT id, pseudonym FROM participant ORDER BY id"),
          labels_of(database, "SELECT id, name FROM protocol ORDER BY id")};
}

std::vector<BidsSession> bids_sessions(SQLite::Database& database, const BidsNames& names) {
  std::vector<BidsSession> sessions;
  std::map<std::int64_t, int> sittings;
  RowQuery query(database, kSessions);
  while (query.step()) {
    const std::string subject = "sub-" + names.participants.at(query.integer(1));
    const std::string sitting = "ses-" + two_digits(++sittings[query.integer(1)]);
    const std::string& task = names.tasks.at(query.integer(2));
    BidsSession session;
    session.id = query.integer(0);
    session.protocol_id = query.integer(2);
    session.folder = subject + "/" + sitting + "/beh/";
    session.stem = subject + "_" + sitting + "_task-" + task;
    session.task_name = task;
    session.stimulus = bids_scene_file(task);
    session.gaze_source = as_utf8(query.bytes(13));
    session.screen_width_m = query.number(4);
    session.screen_height_m = query.number(5);
    session.screen_width_px = query.integer(6);
    session.screen_height_px = query.integer(7);
    session.presentation = presentation_of(query);
    read_zero(database, session);
    sessions.push_back(session);
  }
  return sessions;
}

std::string bids_scene_file(const std::string& task) { return task + "_scene.json"; }

}  // namespace impetus::inline exports
