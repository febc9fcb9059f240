// Who took part in a study, how far they came, and how each sitting went.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "experiments/store/study_file.hpp"

namespace impetus::inline store {

/// Notes of one kind that a sitting left.
struct NoteSummary {
  std::string kind;  ///< "not finite", "gaze lost", "sync test failed", ...
  std::int64_t count{0};
  std::string first_text;
};

/// One session. Times are UTC, as ISO 8601; "" where there is none.
struct ListedSession {
  std::int64_t session{0};
  std::string started_utc;
  std::string ended_utc;
  std::string last_recorded_utc;  ///< of its trials, notes, start and end
  double length_s{0.0};           ///< from its start to its end, or to what was last recorded
  std::string ending;             ///< "finished", "quit", ...; "": none was written
  bool running{false};            ///< no ending yet, and another process has the file
  bool resumed{false};            ///< not the enrolment's first
  std::string resumed_at;         ///< "trial", "block"; "": recorded before schema 5
  std::optional<double> resumed_after_s{};
  std::int64_t completed_trials{0};  ///< practice included, set aside or not
  std::int64_t sync_tries{0};        ///< of the test; 0: flips in virtual time need none
  bool sync_passed{false};
  bool sync_overridden{false};
  std::string gaze_source;  ///< "": not followed
  std::string browser;      ///< "": in a window
  std::vector<NoteSummary> notes;
};

/// One participant in one protocol.
struct Participation {
  std::string participant;
  bool simulated{false};
  std::string protocol;
  std::string protocol_hash;
  std::string merged_from;  ///< name of the file; "": recorded in this one
  std::string group;        ///< levels between participants, "keys f j"; "": there are none
  std::string planned_utc;
  std::string finished_utc;          ///< "": not finished
  std::int64_t planned_trials{0};    ///< of the main phase
  std::int64_t completed_trials{0};  ///< of the main phase
  std::int64_t practice_trials{0};   ///< completed
  std::int64_t interrupted_attempts{0};
  std::int64_t set_aside_attempts{0};
  std::int64_t timed_frames{0};  ///< of all attempts
  std::int64_t late_timed_frames{0};
  std::vector<ListedSession> sittings;
};

/// What the analysis leaves out.
struct LeftOut {
  std::string participant;
  std::optional<std::int64_t> trial{};  ///< its id; none: all of the participant's
  std::string reason;
  std::string decided_utc;
};

/// A study's participations, and what the analysis leaves out of them.
struct SessionList {
  std::string created_utc;
  std::string build;  ///< that made the file
  std::vector<Participation> participations;
  std::vector<LeftOut> left_out;
};

/// All of it, as of one moment. `in_use`: another process has the file, so that what lacks an
/// ending may still run. Throws SQLite::Exception.
SessionList load_session_list(StudyFile& study, bool in_use);

}  // namespace impetus::inline store
