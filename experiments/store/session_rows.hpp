// A session as rows: what it says of itself when it begins, its calibrations, how it takes up an
// enrolment that was left, and before which screen the participant sat.
// SPDX-License-Identifier: MIT
#pragma once

#include <SQLiteCpp/Database.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/scheduling/viewer.hpp"
#include "engine/world/world_settings.hpp"
#include "experiments/record/lab_screen.hpp"
#include "experiments/record/record.hpp"
#include "experiments/session/resumption.hpp"
#include "experiments/session/timing_check.hpp"

namespace impetus::inline store {

/// How a session goes on with what an earlier one left.
struct ResumedSession {
  ResumeRule::At at{ResumeRule::At::kTrial};
  /// By the wall clock, since anything was last recorded; < 0: it was set back; none: unknown.
  std::optional<double> after_s{};
  Resumption resumption{};
};

/// The web page that a session runs in.
struct SessionPage {
  std::string name;   ///< by which the parts go that it hands over
  std::string key{};  ///< whoever knows it may go on with the session; "": nobody
};

/// What a session says of itself before it begins.
struct SessionFacts {
  int recording_format{kRecordingFormat};
  std::string build;
  std::string machine;
  std::string display;
  bool simulated{false};
  std::string observer;  ///< JSON; "" for a person
  ScreenGeometry screen;
  bool screen_measured{false};
  std::optional<ScreenLight> screen_light{};  ///< none: not measured
  double refresh_hz{0.0};
  bool rounding_allowed{false};
  SyncTest sync;
  bool sync_overridden{false};
  std::string series{};  ///< of protocols, which this one is part of; "": none
  std::int64_t series_place{1};
  std::string photodiode_patch{};           ///< its corner; "": none
  std::string gaze_source{};                ///< "mouse", ...; "": gaze is not followed
  std::optional<ResumedSession> resumed{};  ///< none: the enrolment's first session
  std::optional<SessionPage> page{};        ///< none: in a window
};

/// Begins a session of the enrolment, and sets aside what it shows again; returns its id. Throws
/// SQLite::Exception, as all here.
std::int64_t insert_session(SQLite::Database& database, std::int64_t enrolment_id,
                            const SessionFacts& facts);

/// A run through the points of a calibration.
void insert_calibration(SQLite::Database& database, std::int64_t session_id,
                        const CalibrationRecord& record);

/// Seconds by the wall clock since anything of the enrolment was last recorded: a trial, a note, a
/// session's start or end. Negative when that clock was set back since; none: there was no session.
std::optional<double> seconds_since_recorded(SQLite::Database& database, std::int64_t enrolment_id);

/// Kinds of notes on markers for another recorder, and on sounds.
inline constexpr const char* kMarkersNote = "markers";           ///< where they go
inline constexpr const char* kSoundNote = "sound";               ///< by which device, or by none
inline constexpr const char* kSoundLostNote = "sound lost";      ///< since when nothing was heard
inline constexpr const char* kMarkersLostNote = "markers lost";  ///< how many of how many

/// Kinds of notes of a session: that it resumed on another screen than the one before, and that its
/// pixels really are not square. Both were said by whoever started it.
inline constexpr const char* kScreenChangedNote = "screen changed";
inline constexpr const char* kPixelsNotSquareNote = "pixels not square";

/// At a session's start and end: how the eye tracker's clock stands to this machine's.
inline constexpr const char* kGazeTrackerNote = "gaze tracker";

/// The screen of the enrolment's last session; none: there was no session.
std::optional<ScreenGeometry> last_screen(SQLite::Database& database, std::int64_t enrolment_id);

/// A session's screen, and what was said of it.
struct SessionScreen {
  std::int64_t session_id{0};
  std::int64_t enrolment_id{0};
  std::string participant;
  std::string protocol;
  ScreenGeometry screen;
  bool said_changed{false};
  bool said_not_square{false};
};

/// A session that a page began, as far as it is kept.
struct PageSession {
  std::int64_t id{0};
  std::int64_t enrolment_id{0};
  std::string participant;
  std::uint64_t seed{0};
  ScreenGeometry screen;
  bool sync_overridden{false};
  std::int64_t parts{0};  ///< of its record that are kept
  std::string key;        ///< with which it goes on; "": it does not
  bool is_last{false};    ///< of its enrolment
};

/// The one that goes by this name; none: there is none.
std::optional<PageSession> find_page_session(SQLite::Database& database, const std::string& name);

/// Whether the enrolment's last session ran in a page and goes on for whoever has this key.
bool goes_on_by(SQLite::Database& database, std::int64_t enrolment_id, const std::string& key);

/// By enrolment, and in the order of time.
std::vector<SessionScreen> session_screens(SQLite::Database& database);

}  // namespace impetus::inline store
