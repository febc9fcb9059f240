// The recorder of a session: one transaction per trial, on a thread that never draws.
//
//   session thread:  save(attempt) --queue--> writer thread:  BEGIN … COMMIT (synchronised)
//                    await_saved()  <-------- all committed, or the first error
//
// SPDX-License-Identifier: MIT
#pragma once

#include <condition_variable>
#include <deque>
#include <exception>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "experiments/record/ports.hpp"
#include "experiments/store/enrolment.hpp"
#include "experiments/store/session_rows.hpp"

namespace impetus::inline store {

/// A record that a table of the study forbids: nothing failed, but what was to be saved is no
/// record of a session.
class ForbiddenRecord : public StoreError {
 public:
  ForbiddenRecord(const std::string& sentence, std::string refusal)
      : StoreError(sentence), refusal_(std::move(refusal)) {}

  /// "trial 5: expected values that a study may hold, got others (...)", without the file, which
  /// is whole.
  [[nodiscard]] const std::string& refusal() const { return refusal_; }

 private:
  std::string refusal_;
};

/// Timed frames of the attempts that were given to save.
struct FrameCount {
  std::int64_t timed{0};
  std::int64_t late{0};
  std::int64_t late_attempts{0};  ///< with any that was late
};

/// Keeps all that a session records.
class StudyWriter final : public Recorder {
 public:
  /// Begins a session row; that of a session in a page is kept with the first that is saved whole.
  /// `study` must outlive this. Several may write to one study at a time. Throws StoreError.
  StudyWriter(StudyFile& study, const Enrolment& enrolment, SessionFacts facts);

  /// The same for a participant who is new: enrolment and session are kept with the first that is
  /// saved whole, or not at all.
  StudyWriter(StudyFile& study, NewEnrolment fresh, SessionFacts facts);

  /// Goes on writing a session that a page began, whose writer is no more.
  StudyWriter(StudyFile& study, const Enrolment& enrolment, const PageSession& session);

  /// Waits for what is queued. The session keeps no ending unless end() was called.
  ~StudyWriter() override;
  StudyWriter(const StudyWriter&) = delete;
  StudyWriter& operator=(const StudyWriter&) = delete;

  /// From now on `saved` is called, on the writing thread, as each attempt is written.
  void tell(std::function<void()> saved) { saved_ = std::move(saved); }

  /// From now on attempts are kept without their steps: none of them can be replayed.
  void keep_no_steps() { keeps_steps_ = false; }

  /// All that `save_all` gives to save is kept as one, or nothing of it.
  void save_whole(const std::function<void()>& save_all);

  /// One more part of what the session's page hands over is kept.
  void count_part();

  void save(AttemptRecord attempt) override;
  void save(QuestionRecord answer) override;
  void save(NoteRecord note) override;
  void save(ChosenLevel chosen) override;
  void save(CalibrationRecord calibration) override;
  void mark_finished() override;

  /// Throws StoreError with the first thing that could not be saved; ForbiddenRecord where a table
  /// forbids it.
  void await_saved() override;

  /// Of those that were given to save: how many had a body taken out (attempt_rows.hpp).
  [[nodiscard]] std::int64_t not_finite_attempts() const { return not_finite_attempts_; }

  [[nodiscard]] const FrameCount& frames() const { return frames_; }

  /// Of the row that this began, once it is written: after await_saved() or end().
  [[nodiscard]] std::int64_t session_id() const { return session_id_; }

  /// Keeps how the session ended ("finished", "quit", "declined", "display closed", "failed").
  void set_ending(const std::string& ending);

  /// The same, and waits.
  void end(const std::string& ending);

 private:
  using Task = std::function<void(SQLite::Database&)>;

  StudyWriter(StudyFile& study, bool sync_overridden);
  void set_enrolment(const Enrolment& enrolment);
  void begin(SessionFacts facts);
  void enqueue(Task task);
  void enqueue(std::string place, Task task);
  [[nodiscard]] std::string sentence_of(const std::exception& error) const;
  void run();
  void perform(const Task& task);

  StudyFile& study_;
  std::int64_t enrolment_id_{0};
  std::map<std::int64_t, std::int64_t> trial_ids_;  ///< by slot
  bool sync_overridden_;
  std::int64_t session_id_{0};
  std::function<void()> saved_;
  bool keeps_steps_{true};
  std::vector<Task> held_;             ///< until something is saved as one
  std::vector<Task>* whole_{nullptr};  ///< while something is saved as one
  std::int64_t not_finite_attempts_{0};
  FrameCount frames_;

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Task> tasks_;
  bool busy_{false};
  bool stopping_{false};
  std::exception_ptr failure_;
  std::thread thread_;
};

}  // namespace impetus::inline store
