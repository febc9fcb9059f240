// SPDX-License-Identifier: MIT
#include "experiments/store/session_rows.hpp"

#include "experiments/store/rows.hpp"

namespace impetus::inline store {
namespace {

/// What `get` finds in what may be missing.
template <typename T, typename Get>
auto if_any(const std::optional<T>& from, const Get& get) {
  return from ? std::optional(get(*from)) : std::nullopt;
}

/// The completed attempts at these slots are no longer: the session shows their trials again. All
/// that they recorded stays.
void set_aside(SQLite::Database& database, std::int64_t enrolment_id, std::int64_t session_id,
               const std::set<std::int64_t>& slots) {
  for (const std::int64_t slot : slots) {
    execute(database,
            "UPDATE attempt SET outcome = 'set aside', set_aside_in = ? "
            "WHERE outcome = 'completed' AND trial_id = "
            "(SELECT id FROM trial WHERE enrolment_id = ? AND slot = ?)",
            session_id, enrolment_id, slot);
  }
}

const char* name_of(CalibrationKind kind) {
  return kind == CalibrationKind::kCalibration  ? "calibration"
         : kind == CalibrationKind::kValidation ? "validation"
                                                : "drift check";
}

std::int64_t insert_run(SQLite::Database& database, std::int64_t session_id,
                        const CalibrationRecord& record) {
  const auto corrected_by = [&](double GazeCorrection::*member) {
    return if_any(record.correction, [&](const GazeCorrection& made) { return made.*member; });
  };
  return insert_row(database, "calibration",
                    {{"session_id", session_id},
                     {"kind", name_of(record.kind)},
                     {"number", record.number},
                     {"before_slot", record.before_slot},
                     {"gaze_source", record.gaze_source},
                     {"accuracy_deg", record.accuracy_deg},
                     {"worst_accuracy_deg", record.worst_accuracy_deg},
                     {"precision_rms_deg", record.precision_rms_deg},
                     {"precision_sd_deg", record.precision_sd_deg},
                     {"lost_share", record.lost_share},
                     {"sampling_hz", record.sampling_hz},
                     {"accuracy_limit_deg", record.accuracy_limit_deg},
                     {"passed", record.passed},
                     {"began_ns", record.began_ns},
                     {"correction_x0_m", corrected_by(&GazeCorrection::x0_m)},
                     {"correction_xx", corrected_by(&GazeCorrection::xx)},
                     {"correction_xy", corrected_by(&GazeCorrection::xy)},
                     {"correction_y0_m", corrected_by(&GazeCorrection::y0_m)},
                     {"correction_yx", corrected_by(&GazeCorrection::yx)},
                     {"correction_yy", corrected_by(&GazeCorrection::yy)}});
}

}  // namespace

std::int64_t insert_session(SQLite::Database& database, std::int64_t enrolment_id,
                            const SessionFacts& facts) {
  const bool in_series = !facts.series.empty();
  const auto at_block = [](const ResumedSession& resumed) {
    return std::string(resumed.at == ResumeRule::At::kBlock ? "block" : "trial");
  };
  const auto measured = [&](double interval_ns) {
    return facts.sync.valid_flips > 0 ? std::optional(interval_ns) : std::nullopt;
  };
  const std::int64_t id = insert_row(
      database, "session",
      {{"enrolment_id", enrolment_id},
       {"started_utc", Now()},
       {"recording_format", facts.recording_format},
       {"build", facts.build},
       {"machine", facts.machine},
       {"display", facts.display},
       {"simulated", facts.simulated},
       {"observer", text_or_null(facts.observer)},
       {"screen_width_m", facts.screen.width_m},
       {"screen_height_m", facts.screen.height_m},
       {"screen_width_px", facts.screen.width_px},
       {"screen_height_px", facts.screen.height_px},
       {"viewing_distance_m", facts.screen.viewing_distance_m},
       {"screen_measured", facts.screen_measured},
       {"screen_black_cd_m2", if_any(facts.screen_light, [](auto& it) { return it.black_cd_m2; })},
       {"screen_white_cd_m2", if_any(facts.screen_light, [](auto& it) { return it.white_cd_m2; })},
       {"screen_gamma", if_any(facts.screen_light, [](auto& it) { return it.gamma; })},
       {"refresh_hz", facts.refresh_hz},
       {"rounding_allowed", facts.rounding_allowed},
       {"sync_tries", facts.sync.tries},
       {"sync_valid_flips", facts.sync.valid_flips},
       {"sync_mean_interval_ns", measured(facts.sync.mean_interval_ns)},
       {"sync_sd_interval_ns", measured(facts.sync.sd_interval_ns)},
       {"sync_passed", facts.sync.passed},
       {"sync_overridden", facts.sync_overridden},
       {"series", text_or_null(facts.series)},
       {"series_place", in_series ? std::optional(facts.series_place) : std::nullopt},
       {"resumed_at", if_any(facts.resumed, at_block)},
       {"resumed_after_s", facts.resumed ? facts.resumed->after_s : std::nullopt},
       {"first_slot", facts.resumed ? facts.resumed->resumption.first_slot : std::nullopt},
       {"photodiode_patch", text_or_null(facts.photodiode_patch)},
       {"gaze_source", text_or_null(facts.gaze_source)},
       {"page_name", if_any(facts.page, [](auto& page) { return page.name; })},
       {"page_key", facts.page ? text_or_null(facts.page->key) : std::nullopt},
       {"page_parts", facts.page ? std::optional<std::int64_t>(0) : std::nullopt}});
  if (facts.resumed) {
    set_aside(database, enrolment_id, id, facts.resumed->resumption.set_aside);
  }
  return id;
}

void insert_calibration(SQLite::Database& database, std::int64_t session_id,
                        const CalibrationRecord& record) {
  const std::int64_t id = insert_run(database, session_id, record);
  RowInsert rows(database, "calibration_point");
  std::int64_t number = 0;
  for (const CalibrationPointRecord& point : record.points) {
    rows.insert({{"calibration_id", id},
                 {"point", ++number},
                 {"x_m", point.shown.x_m},
                 {"y_m", point.shown.y_m},
                 {"gaze_x_m", if_any(point.gaze, [](const auto& gaze) { return gaze.x_m; })},
                 {"gaze_y_m", if_any(point.gaze, [](const auto& gaze) { return gaze.y_m; })},
                 {"accuracy_deg", point.accuracy_deg},
                 {"precision_rms_deg", point.precision_rms_deg},
                 {"precision_sd_deg", point.precision_sd_deg},
                 {"samples", point.samples},
                 {"lost", point.lost}});
  }
}

std::optional<double> seconds_since_recorded(SQLite::Database& database,
                                             std::int64_t enrolment_id) {
  return *load_value<std::optional<double>>(
      database,
      "WITH sitting AS (SELECT * FROM session WHERE enrolment_id = ?), "
      "recorded (at_utc) AS ("
      "SELECT started_utc FROM sitting UNION ALL SELECT ended_utc FROM sitting UNION ALL "
      "SELECT written_utc FROM note WHERE session_id IN (SELECT id FROM sitting) UNION ALL "
      "SELECT saved_utc FROM attempt WHERE session_id IN (SELECT id FROM sitting)) "
      "SELECT (julianday('now') - julianday(max(at_utc))) * 86400 FROM recorded",
      enrolment_id);
}

std::optional<ScreenGeometry> last_screen(SQLite::Database& database, std::int64_t enrolment_id) {
  std::optional<ScreenGeometry> last;
  for (const SessionScreen& session : session_screens(database)) {
    if (session.enrolment_id == enrolment_id) {
      last = session.screen;
    }
  }
  return last;
}

std::vector<SessionScreen> session_screens(SQLite::Database& database) {
  using std::int64_t;
  using std::string;
  const auto rows =
      load_rows<int64_t, int64_t, string, string, double, double, int, int, double, bool, bool>(
          database,
          "SELECT session.id, enrolment_id, pseudonym, protocol.name, screen_width_m, "
          "screen_height_m, screen_width_px, screen_height_px, viewing_distance_m, "
          "EXISTS (SELECT 1 FROM note WHERE session_id = session.id AND kind = ?), "
          "EXISTS (SELECT 1 FROM note WHERE session_id = session.id AND kind = ?) "
          "FROM session JOIN enrolment ON enrolment.id = enrolment_id "
          "JOIN participant ON participant.id = participant_id "
          "JOIN protocol ON protocol.id = protocol_id ORDER BY enrolment_id, session.id",
          kScreenChangedNote, kPixelsNotSquareNote);
  std::vector<SessionScreen> sessions;
  for (const auto& [id, enrolment, participant, protocol, width_m, height_m, width_px, height_px,
                    distance_m, changed, not_square] : rows) {
    sessions.push_back({id,
                        enrolment,
                        participant,
                        protocol,
                        {width_m, height_m, width_px, height_px, distance_m},
                        changed,
                        not_square});
  }
  return sessions;
}

std::optional<PageSession> find_page_session(SQLite::Database& database, const std::string& name) {
  using std::int64_t;
  for (const auto& [id, enrolment, participant, seed, width_m, height_m, width_px, height_px,
                    distance_m, overridden, parts, key, last] :
       load_rows<int64_t, int64_t, std::string, std::uint64_t, double, double, int, int, double,
                 bool, int64_t, std::string, bool>(
           database,
           "SELECT session.id, enrolment_id, pseudonym, seed, screen_width_m, screen_height_m, "
           "screen_width_px, screen_height_px, viewing_distance_m, sync_overridden, page_parts, "
           "ifnull(page_key, ''), "
           "session.id = (SELECT max(id) FROM session AS other "
           "WHERE other.enrolment_id = session.enrolment_id) "
           "FROM session JOIN enrolment ON enrolment.id = enrolment_id "
           "JOIN participant ON participant.id = participant_id WHERE page_name = ?",
           name)) {
    return PageSession{id,
                       enrolment,
                       participant,
                       seed,
                       {width_m, height_m, width_px, height_px, distance_m},
                       overridden,
                       parts,
                       key,
                       last};
  }
  return std::nullopt;
}

bool goes_on_by(SQLite::Database& database, std::int64_t enrolment_id, const std::string& key) {
  return load_value<bool>(database,
                          "SELECT ifnull(page_key = ?, 0) FROM session WHERE enrolment_id = ? "
                          "ORDER BY id DESC LIMIT 1",
                          key, enrolment_id)
      .value_or(false);
}

}  // namespace impetus::inline store
