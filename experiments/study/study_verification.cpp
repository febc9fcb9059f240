// SPDX-License-Identifier: MIT
#include "experiments/study/study_verification.hpp"

#include <SQLiteCpp/Transaction.h>

#include <string>
#include <utility>

#include "experiments/settings/input_error.hpp"
#include "experiments/store/migration.hpp"
#include "experiments/store/read_only_file.hpp"
#include "experiments/store/study_integrity.hpp"
#include "experiments/study/protocol_check.hpp"
#include "experiments/study/stored_rules.hpp"

namespace impetus::inline study {
namespace {

std::int64_t count(SQLite::Database& database, const std::string& what) {
  return database.execAndGet("SELECT count(*) FROM " + what).getInt64();
}

/// "1 plan", "12 plans".
std::string count_of(std::int64_t number, const std::string& one) {
  return std::to_string(number) + " " + one + (number == 1 ? "" : "s");
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
        count_of(count(database_, "session"), "session") +
            ": build, machine, display, screen, sync test",
        broken_provenance(database_));
    add("screens", "square pixels, and one screen for each participant, or it was said",
        unsaid_screens(database_));
    if (further) {
      verification_.checks.push_back(further(study_));
    }
    append(verification_.remarks, remarks_on(database_));
    append(verification_.remarks, screen_remarks(database_));
    verification_.participants = count(database_, "participant");
    verification_.completed_trials = count(database_, "attempt WHERE outcome = 'completed'");
    verification_.sessions = count(database_, "session");
  }

 private:
  void check_protocols_and_attempts() {
    const ProtocolShelf shelf(study_);
    add("protocols",
        count_of(static_cast<std::int64_t>(shelf.size()), "protocol") +
            ", each read and hashed anew",
        shelf.failures());
    check_plans(shelf);
    add("order", count_of(count(database_, "attempt"), "attempt") + ", in the planned order",
        broken_order(database_));
    Failures recordings = broken_recordings(database_);
    append(recordings, wrong_lengths(study_, shelf));
    add("recordings",
        count_of(count(database_, "step"), "step") + " and " +
            count_of(count(database_, "frame"), "frame") + ", none missing",
        std::move(recordings));
    add("answers",
        count_of(count(database_, "rating"), "rating") + ", " +
            count_of(count(database_, "response"), "answer") + ", " +
            count_of(count(database_, "click"), "click") + ", as asked for",
        wrong_answers(study_, shelf));
  }

  /// A plan follows from the code that was given at enrolment, which anonymising takes away.
  void check_plans(const ProtocolShelf& shelf) {
    const std::string plans = count_of(count(database_, "enrolment"), "plan");
    if (count(database_, "study WHERE anonymised_by IS NOT NULL") > 0) {
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
  StudyFile study = StudyFile::open_for_reading(path);
  try {
    const SQLite::Transaction one_moment(study.database());
    add_file_remarks(path, verification.remarks);
    StudyChecks(study, verification).make(further);
    return verification;
  } catch (const SQLite::Exception& error) {
    throw StoreError(study.name() + ": could not be read (" + error.what() + ")");
  }
}

}  // namespace impetus::inline study
