// SPDX-License-Identifier: MIT
#include "experiments/study/study_verification.hpp"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Transaction.h>
#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "engine/world/world.hpp"
#include "experiments/record/lab_screen.hpp"
#include "experiments/settings/input_error.hpp"
#include "experiments/store/migration.hpp"
#include "experiments/store/read_only_file.hpp"
#include "experiments/store/rows.hpp"
#include "experiments/store/session_rows.hpp"
#include "experiments/store/study_integrity.hpp"
#include "experiments/study/answer_check.hpp"
#include "experiments/study/embedded_obstacles.hpp"
#include "experiments/study/embedded_order_rules.hpp"
#include "experiments/study/embedded_places.hpp"
#include "experiments/study/embedded_provenance_rules.hpp"
#include "experiments/study/embedded_recording_rules.hpp"
#include "experiments/study/embedded_remarks.hpp"
#include "experiments/study/protocol_check.hpp"
#include "experiments/study/showing_check.hpp"
#include "experiments/study/verification_report.hpp"
#include "experiments/tables/number_text.hpp"

namespace impetus::inline study {
namespace {

// What must hold between rows though no constraint of a table can say it, and what a reader should
// know. Each rule is a query that yields one sentence for every violation, so that a rule is read
// as it is checked: order_rules.sql, recording_rules.sql, provenance_rules.sql, obstacles.sql, and
// remarks.sql.

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

/// Plans are whole, and trials were completed in their order, none passed over. Throws
/// SQLite::Exception, as all here.
Failures broken_order(SQLite::Database& study) {
  return sentences(study, kPlacesSql, kOrderRulesSql);
}

/// Every completed attempt has its steps and frames, as many as were counted, without gaps.
Failures broken_recordings(SQLite::Database& study) {
  return sentences(study, kPlacesSql, kRecordingRulesSql);
}

/// Every session says what recorded it, on what, before which screen, and who took part.
Failures broken_provenance(SQLite::Database& study) {
  return sentences(study, kPlacesSql, kProvenanceRulesSql);
}

/// One sentence each: simulated participants, late frames, exclusions, words that participants
/// wrote,
/// ...
std::vector<std::string> remarks_on(SQLite::Database& study) {
  return sentences(study, "", kRemarksSql);
}

// Whether people saw what was measured: square pixels, and one screen from the first session to the
// last. What was not so, and said, stands against publishing; what nobody said is wrong.

/// Sessions whose pixels were not square, and resumed ones before another screen than the session
/// before, where nobody said so.
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

/// The sessions' screens but those of participants whom the analysis leaves out.
std::vector<SessionScreen> screens_of_analysed(SQLite::Database& study) {
  std::vector<SessionScreen> sessions = session_screens(study);
  const auto left_out =
      load_column<std::string>(study, "SELECT participant FROM excluded WHERE trial IS NULL");
  std::erase_if(sessions, [&](const SessionScreen& session) {
    return std::find(left_out.begin(), left_out.end(), session.participant) != left_out.end();
  });
  return sessions;
}

/// The same that was said; and who sat before several screens.
std::vector<std::string> screen_obstacles(SQLite::Database& study) {
  std::int64_t not_square = 0;
  std::map<std::string, std::vector<ScreenGeometry>> screens;  // of each participant
  for (const SessionScreen& session : screens_of_analysed(study)) {
    not_square += session.said_not_square ? 1 : 0;
    std::vector<ScreenGeometry>& known = screens[session.participant];
    if (std::none_of(known.begin(), known.end(), [&](const ScreenGeometry& screen) {
          return is_same_screen(screen, session.screen);
        })) {
      known.push_back(session.screen);
    }
  }
  std::vector<std::string> obstacles;
  for (const auto& [participant, seen] : screens) {
    if (seen.size() > 1) {
      std::string words = participant + " sat before " + std::to_string(seen.size()) + " screens: ";
      for (const ScreenGeometry& screen : seen) {
        words += (&screen == &seen.front() ? "" : "; ") + screen_words(screen);
      }
      obstacles.push_back(words);
    }
  }
  if (not_square > 0) {
    obstacles.push_back(count_of(not_square, "session") + (not_square == 1 ? " was" : " were") +
                        " before a screen whose pixels, as was said, are not square");
  }
  return obstacles;
}

void append(Failures& to, const Failures& from) { to.insert(to.end(), from.begin(), from.end()); }

/// Of the file as it is, before any copy of an older schema is made.
std::int64_t schema_version(const std::filesystem::path& path) {
  return open_read_only(path)->execAndGet("PRAGMA user_version").getInt64();
}

void add_file_remarks(const std::filesystem::path& path, std::vector<std::string>& remarks) {
  const std::int64_t version = schema_version(path);
  if (version < kSchemaVersion) {
    remarks.push_back("it is of schema " + std::to_string(version) +
                      "; the checks read a copy brought to schema " +
                      std::to_string(kSchemaVersion));
  }
  if (has_log(path)) {
    remarks.push_back("a part of it stands in " + log_beside(path).filename().string() +
                      " until a session or a merge closes the file properly; the two belong "
                      "together");
  }
}

/// Everything that can be checked of a file that is whole.
class StudyChecks {
 public:
  StudyChecks(StudyFile& study, Verification& verification)
      : study_(study), database_(study.database()), verification_(verification) {}

  void make(const FurtherCheck& further) {
    const auto tables = static_cast<std::int64_t>(table_names(database_).size());
    add("schema", count_of(tables, "table") + ", and views, as this build makes them",
        schema_differences(database_));
    if (!verification_.passed()) {
      return;  // queries may not even be possible
    }
    add("values", "every value is one that its table allows", forbidden_rows(database_));
    check_protocols_and_attempts();
    add("provenance",
        count_of(count_rows(database_, "session"), "session") +
            ": build, machine, display, screen, sync test",
        broken_provenance(database_));
    add("screens", "square pixels, and one screen for each participant, or it was said",
        unsaid_screens(database_));
    if (further) {
      verification_.checks.push_back(further(study_));
    }
    append(verification_.remarks, remarks_on(database_));
    verification_.obstacles = sentences(database_, "", kObstaclesSql);
    append(verification_.obstacles, screen_obstacles(database_));
    verification_.participants = count_rows(database_, "participant");
    verification_.completed_trials = count_rows(database_, "attempt WHERE outcome = 'completed'");
    verification_.sessions = count_rows(database_, "session");
  }

 private:
  void check_protocols_and_attempts() {
    const ProtocolShelf shelf(study_);
    add("protocols",
        count_of(static_cast<std::int64_t>(shelf.size()), "protocol") +
            ", each read and hashed anew",
        shelf.failures());
    check_plans(shelf);
    add("order", count_of(count_rows(database_, "attempt"), "attempt") + ", in the planned order",
        broken_order(database_));
    Failures recordings = broken_recordings(database_);
    append(recordings, wrong_showings(study_, shelf));
    add("recordings",
        count_of(count_rows(database_, "step"), "step") + " and " +
            count_of(count_rows(database_, "frame"), "frame") + ", none missing",
        std::move(recordings));
    add("answers",
        count_of(count_rows(database_, "rating"), "rating") + ", " +
            count_of(count_rows(database_, "response"), "answer") + ", " +
            count_of(count_rows(database_, "click"), "click") + ", as asked for",
        wrong_answers(study_, shelf));
  }

  /// A plan follows from the code that was given at enrolment, which anonymising takes away.
  void check_plans(const ProtocolShelf& shelf) {
    const std::string plans = count_of(count_rows(database_, "enrolment"), "plan");
    if (count_rows(database_, "study WHERE anonymised_by IS NOT NULL") > 0) {
      add("plans", plans + ", not made anew: the codes that they follow from were taken out", {});
    } else {
      add("plans", plans + ", as protocol, participant and seed give them anew",
          changed_plans(study_, shelf));
    }
  }

  void add(std::string name, std::string found, Failures failures) {
    verification_.checks.push_back({std::move(name), std::move(found), std::move(failures)});
  }

  StudyFile& study_;
  SQLite::Database& database_;
  Verification& verification_;
};

}  // namespace

Verification verify_study(const std::filesystem::path& path, const FurtherCheck& further) {
  Verification verification;
  require_files(path);
  if (std::error_code error; std::filesystem::exists(path, error)) {
    verification.checks.push_back({"file", "whole, no reference broken", damage_in(path)});
    if (!verification.passed()) {
      return verification;
    }
  }
  StudyFile study = StudyFile::open_as_it_is(path);
  while_reading(study, [&] {
    const SQLite::Transaction one_moment(study.database());
    add_file_remarks(path, verification.remarks);
    StudyChecks(study, verification).make(further);
  });
  return verification;
}

}  // namespace impetus::inline study
