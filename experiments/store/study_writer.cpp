// SPDX-License-Identifier: MIT
#include "experiments/store/study_writer.hpp"

#include <SQLiteCpp/Statement.h>
#include <SQLiteCpp/Transaction.h>
#include <SQLiteCpp/VariadicBind.h>

#include <utility>

#include "experiments/store/adaptive_rows.hpp"
#include "experiments/store/attempt_rows.hpp"
#include "experiments/store/calibration_rows.hpp"
#include "experiments/store/not_finite_notes.hpp"
#include "experiments/store/resumption_rows.hpp"

namespace impetus::inline store {
namespace {

void bind_resumed(SQLite::Statement& insert, int first,
                  const std::optional<ResumedSession>& resumed) {
  if (!resumed) {
    return;
  }
  insert.bind(first, resumed->at == ResumeRule::At::kBlock ? "block" : "trial");
  insert.bind(first + 1, resumed->after_s);
  if (resumed->resumption.first_slot) {
    insert.bind(first + 2, *resumed->resumption.first_slot);
  }
}

}  // namespace

StudyWriter::StudyWriter(StudyFile& study, const Enrolment& enrolment, SessionFacts facts)
    : study_(study),
      enrolment_id_(enrolment.id),
      sync_overridden_(facts.sync_overridden),
      thread_([this] { run(); }) {
  for (const StoredTrial& trial : enrolment.trials) {
    trial_ids_[trial.slot] = trial.id;
  }
  enqueue([this, facts = std::move(facts)](SQLite::Database& database) {
    begin_session(database, facts);
  });
}

StudyWriter::~StudyWriter() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void StudyWriter::begin_session(SQLite::Database& database, const SessionFacts& facts) {
  SQLite::Statement insert(
      database,
      "INSERT INTO session (enrolment_id, started_utc, recording_format, build, machine, display, "
      "simulated, observer, screen_width_m, screen_height_m, screen_width_px, screen_height_px, "
      "viewing_distance_m, screen_measured, refresh_hz, rounding_allowed, sync_tries, "
      "sync_valid_flips, sync_mean_interval_ns, sync_sd_interval_ns, sync_passed, sync_overridden, "
      "series, series_place, resumed_at, resumed_after_s, first_slot, photodiode_patch, "
      "gaze_source) "
      "VALUES (?, strftime('%Y-%m-%dT%H:%M:%fZ'), ?, ?, ?, ?, ?, nullif(?, ''), ?, ?, ?, ?, ?, ?, "
      "?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, nullif(?, ''), nullif(?, ''))");
  SQLite::bind(insert, enrolment_id_, kRecordingFormat, facts.build, facts.machine, facts.display,
               facts.simulated ? 1 : 0, facts.observer, facts.screen.width_m, facts.screen.height_m,
               facts.screen.width_px, facts.screen.height_px, facts.screen.viewing_distance_m,
               facts.screen_measured ? 1 : 0, facts.refresh_hz, facts.rounding_allowed ? 1 : 0,
               facts.sync.tries, facts.sync.valid_flips, facts.sync.mean_interval_ns,
               facts.sync.sd_interval_ns, facts.sync.passed ? 1 : 0, facts.sync_overridden ? 1 : 0);
  if (!facts.series.empty()) {
    insert.bind(22, facts.series);
    insert.bind(23, facts.series_place);
  }
  bind_resumed(insert, 24, facts.resumed);
  insert.bind(27, facts.photodiode_patch);
  insert.bind(28, facts.gaze_source);
  insert.exec();
  session_id_ = database.getLastInsertRowid();
  if (facts.resumed) {
    set_aside(database, enrolment_id_, session_id_, facts.resumed->resumption.set_aside);
  }
}

void StudyWriter::save(AttemptRecord attempt) {
  const std::int64_t late = late_frames(attempt);
  frames_.timed += static_cast<std::int64_t>(attempt.frames.size());
  frames_.late += late;
  frames_.late_attempts += late > 0 ? 1 : 0;
  not_finite_attempts_ += has_not_finite(attempt) ? 1 : 0;
  enqueue([this, attempt = std::move(attempt)](SQLite::Database& database) {
    insert_attempt(database, {trial_ids_.at(attempt.slot), session_id_, sync_overridden_}, attempt);
    insert_not_finite_notes(database, session_id_, attempt);
    if (saved_) {
      saved_();
    }
  });
}

void StudyWriter::save(QuestionRecord answer) {
  enqueue([this, answer = std::move(answer)](SQLite::Database& database) {
    SQLite::Statement insert(database,
                             "INSERT INTO answer (session_id, kind, question, words, answer) "
                             "VALUES (?, ?, ?, ?, nullif(?, ''))");
    SQLite::bind(insert, session_id_, answer.kind, answer.id, answer.text, answer.answer);
    insert.exec();
  });
}

void StudyWriter::save(NoteRecord note) {
  enqueue([this, note = std::move(note)](SQLite::Database& database) {
    SQLite::Statement insert(database,
                             "INSERT INTO note (session_id, written_utc, kind, text) "
                             "VALUES (?, strftime('%Y-%m-%dT%H:%M:%fZ'), ?, ?)");
    SQLite::bind(insert, session_id_, note.kind, note.text);
    insert.exec();
  });
}

void StudyWriter::save(ChosenLevel chosen) {
  enqueue([this, chosen = std::move(chosen)](SQLite::Database& database) {
    update_chosen_level(database, trial_ids_.at(chosen.slot), chosen);
  });
}

void StudyWriter::save(CalibrationRecord calibration) {
  enqueue([this, calibration = std::move(calibration)](SQLite::Database& database) {
    insert_calibration(database, session_id_, calibration);
  });
}

void StudyWriter::mark_finished() {
  enqueue([this](SQLite::Database& database) {
    SQLite::Statement update(database,
                             "UPDATE enrolment SET finished_utc = strftime('%Y-%m-%dT%H:%M:%fZ') "
                             "WHERE id = ?");
    update.bind(1, enrolment_id_);
    update.exec();
  });
}

void StudyWriter::end(const std::string& ending) {
  enqueue([this, ending](SQLite::Database& database) {
    SQLite::Statement update(database,
                             "UPDATE session SET ended_utc = strftime('%Y-%m-%dT%H:%M:%fZ'), "
                             "ending = ? WHERE id = ?");
    SQLite::bind(update, ending, session_id_);
    update.exec();
  });
  await_saved();
}

void StudyWriter::enqueue(Task task) {
  {
    const std::lock_guard lock(mutex_);
    tasks_.push_back(std::move(task));
  }
  changed_.notify_all();
}

void StudyWriter::await_saved() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return tasks_.empty() && !busy_; });
  if (failure_) {
    std::rethrow_exception(failure_);
  }
}

void StudyWriter::run() {
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return !tasks_.empty() || stopping_; });
    if (tasks_.empty()) {
      return;
    }
    const Task task = std::move(tasks_.front());
    tasks_.pop_front();
    busy_ = true;
    lock.unlock();
    perform(task);
    lock.lock();
    busy_ = false;
    changed_.notify_all();
  }
}

void StudyWriter::perform(const Task& task) {
  if (failure_) {
    return;  // After a failure nothing later may stand in the file as if nothing were missing.
  }
  const std::lock_guard turn(study_.transactions());
  try {
    SQLite::Transaction transaction(study_.database());
    task(study_.database());
    transaction.commit();
    study_.require_present();
  } catch (const StoreError&) {
    const std::lock_guard lock(mutex_);
    failure_ = std::current_exception();
  } catch (const std::exception& error) {
    const std::lock_guard lock(mutex_);
    failure_ = std::make_exception_ptr(
        StoreError(study_.name() + ": could not be written (" + error.what() +
                   "); everything up to the last completed trial is saved"));
  }
}

}  // namespace impetus::inline store
