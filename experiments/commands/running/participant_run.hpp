// One participant's session of one protocol: enrolled or found again, then run as far as it comes.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "experiments/commands/running/run_part.hpp"
#include "experiments/design/plan.hpp"
#include "experiments/markers/marker_line.hpp"
#include "experiments/record/gaze.hpp"
#include "experiments/session/session.hpp"
#include "experiments/store/enrolment.hpp"
#include "experiments/store/study_writer.hpp"

namespace impetus::inline commands {

/// "participant P01, session 3", or several of them.
std::string sitting_words(const std::string& participant,
                          const std::vector<std::int64_t>& sessions);

/// One participant's session of one protocol, from enrolling to the last word.
class ParticipantRun {
 public:
  /// Finds the participant of `options` to resume or, once the laboratory is open, stores the plan.
  /// All but `laboratory` (none: the part's own is opened) must outlive this. Throws InputError
  /// when the participant has finished, or nothing can be opened; StoreError.
  ParticipantRun(const RunPart& part, const RunOptions& options, StudyFile& study,
                 std::shared_ptr<Laboratory> laboratory);

  /// Runs the session, says on standard output how it ended unless it was finished, and returns
  /// that. `saved` is called, on another thread, as each attempt is written. Throws
  /// InputError when the sync test failed or the window was closed; what the recorder throws.
  SessionEnding run(const std::function<void()>& saved);

  [[nodiscard]] const std::shared_ptr<Laboratory>& laboratory() const { return laboratory_; }
  /// In the study, after run().
  [[nodiscard]] std::int64_t session_id() const { return session_id_; }
  [[nodiscard]] std::size_t planned_trials() const { return enrolment_.trials.size(); }

 private:
  /// Where the region is said to follow somebody; null when nothing tells.
  [[nodiscard]] Gaze* gaze() const { return eye_ ? eye_.get() : laboratory_->gaze(); }

  const RunPart& part_;
  RunOptions options_;
  StudyFile& study_;
  std::shared_ptr<Laboratory> laboratory_;
  std::unique_ptr<MarkerLine> markers_;  ///< none: nothing is marked
  std::unique_ptr<Gaze> eye_;            ///< a recording's or a tracker's; none: the laboratory's
  Plan plan_;
  GazePaths gaze_paths_;  ///< that regions of the plan follow
  SyncTest sync_;
  Enrolment enrolment_;
  std::optional<ResumedSession> resumed_;  ///< none: the enrolment's first session
  std::string screen_change_;              ///< since the session before; "": none
  std::int64_t session_id_{0};
};

}  // namespace impetus::inline commands
