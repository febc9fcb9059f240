// SPDX-License-Identifier: MIT
#include "experiments/store/study_writer.hpp"

#include <SQLiteCpp/Transaction.h>
#include <sqlite3.h>

#include "experiments/store/adaptive_rows.hpp"
#include "experiments/store/attempt_rows.hpp"
#include "experiments/store/rows.hpp"

namespace impetus::inline store {
namespace {

std::string trial_words(std::int64_t slot) { return "trial " + std::to_string(slot); }

}  // namespace

StudyWriter::StudyWriter(StudyFile& study, bool sync_overridden)
    : study_(study), sync_overridden_(sync_overridden), thread_([this] { run(); }) {}

StudyWriter::StudyWriter(StudyFile& study, const Enrolment& enrolment, const PageSession& session)
    : StudyWriter(study, session.sync_overridden) {
  set_enrolment(enrolment);
  session_id_ = session.id;
}

StudyWriter::StudyWriter(StudyFile& study, const Enrolment& enrolment, SessionFacts facts)
    : StudyWriter(study, facts.sync_overridden) {
  set_enrolment(enrolment);
  whole_ = facts.page ? &held_ : nullptr;
  begin(std::move(facts));
  whole_ = nullptr;
}

StudyWriter::StudyWriter(StudyFile& study, NewEnrolment fresh, SessionFacts facts)
    : StudyWriter(study, facts.sync_overridden) {
  whole_ = &held_;
  // The plan is the program's own: were it forbidden, the session would not be to blame.
  enqueue([this, fresh = std::move(fresh)](SQLite::Database& database) {
    set_enrolment(insert_enrolment(database, fresh));
  });
  begin(std::move(facts));
  whole_ = nullptr;
}

void StudyWriter::set_enrolment(const Enrolment& enrolment) {
  enrolment_id_ = enrolment.id;
  for (const StoredTrial& trial : enrolment.trials) {
    trial_ids_[trial.slot] = trial.id;
  }
}

void StudyWriter::begin(SessionFacts facts) {
  enqueue("the session", [this, facts = std::move(facts)](SQLite::Database& database) {
    session_id_ = insert_session(database, enrolment_id_, facts);
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

void StudyWriter::save_whole(const std::function<void()>& save_all) {
  std::vector<Task> tasks = std::exchange(held_, {});
  whole_ = &tasks;
  save_all();
  whole_ = nullptr;
  enqueue([tasks = std::move(tasks)](SQLite::Database& database) {
    for (const Task& task : tasks) {
      task(database);
    }
  });
}

void StudyWriter::count_part() {
  enqueue([this](SQLite::Database& database) {
    execute(database, "UPDATE session SET page_parts = page_parts + 1 WHERE id = ?", session_id_);
  });
}

void StudyWriter::save(AttemptRecord attempt) {
  const std::int64_t late = late_frames(attempt);
  frames_.timed += static_cast<std::int64_t>(attempt.frames.size());
  frames_.late += late;
  frames_.late_attempts += late > 0 ? 1 : 0;
  not_finite_attempts_ += has_not_finite(attempt) ? 1 : 0;
  const std::string place = trial_words(attempt.slot);
  enqueue(place, [this, attempt = std::move(attempt)](SQLite::Database& database) {
    insert_attempt(database, {trial_ids_.at(attempt.slot), session_id_, sync_overridden_}, attempt,
                   keeps_steps_);
    if (saved_) {
      saved_();
    }
  });
}

void StudyWriter::save(QuestionRecord answer) {
  const std::string place = "answer to " + answer.id;
  enqueue(place, [this, answer = std::move(answer)](SQLite::Database& database) {
    insert_row(database, "answer",
               {{"session_id", session_id_},
                {"kind", answer.kind},
                {"question", answer.id},
                {"words", answer.text},
                {"answer", text_or_null(answer.answer)}});
  });
}

void StudyWriter::save(NoteRecord note) {
  const std::string place = "note on " + note.kind;
  enqueue(place, [this, note = std::move(note)](SQLite::Database& database) {
    insert_row(database, "note",
               {{"session_id", session_id_},
                {"written_utc", Now()},
                {"kind", note.kind},
                {"text", note.text}});
  });
}

void StudyWriter::save(ChosenLevel chosen) {
  const std::string place = trial_words(chosen.slot) + ", its level";
  enqueue(place, [this, chosen = std::move(chosen)](SQLite::Database& database) {
    update_chosen_level(database, trial_ids_.at(chosen.slot), chosen);
  });
}

void StudyWriter::save(CalibrationRecord calibration) {
  enqueue("calibration", [this, calibration = std::move(calibration)](SQLite::Database& database) {
    insert_calibration(database, session_id_, calibration);
  });
}

void StudyWriter::mark_finished() {
  enqueue([this](SQLite::Database& database) {
    execute(database,
            "UPDATE enrolment SET finished_utc = strftime('%Y-%m-%dT%H:%M:%fZ') WHERE id = ?",
            enrolment_id_);
    execute(database, "UPDATE session SET page_key = NULL WHERE enrolment_id = ?", enrolment_id_);
  });
}

void StudyWriter::set_ending(const std::string& ending) {
  enqueue([this, ending](SQLite::Database& database) {
    execute(
        database,
        "UPDATE session SET ended_utc = strftime('%Y-%m-%dT%H:%M:%fZ'), ending = ? WHERE id = ?",
        ending, session_id_);
  });
}

void StudyWriter::end(const std::string& ending) {
  set_ending(ending);
  await_saved();
}

void StudyWriter::enqueue(Task task) {
  if (whole_ != nullptr) {
    whole_->push_back(std::move(task));
    return;
  }
  {
    const std::lock_guard lock(mutex_);
    tasks_.push_back(std::move(task));
  }
  changed_.notify_all();
}

/// What a table forbids is told apart from a disk that fails, by its place in the session.
void StudyWriter::enqueue(std::string place, Task task) {
  enqueue([this, place = std::move(place), task = std::move(task)](SQLite::Database& database) {
    try {
      task(database);
    } catch (const SQLite::Exception& error) {
      if (error.getErrorCode() != SQLITE_CONSTRAINT) {
        throw;
      }
      throw ForbiddenRecord(
          sentence_of(error),
          place + ": expected values that a study may hold, got others (" + error.what() + ")");
    }
  });
}

std::string StudyWriter::sentence_of(const std::exception& error) const {
  return study_.name() + ": could not be written (" + error.what() +
         "); everything up to the last completed trial is saved";
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
    failure_ = std::make_exception_ptr(StoreError(sentence_of(error)));
  }
}

}  // namespace impetus::inline store
