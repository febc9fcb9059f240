// SPDX-License-Identifier: MIT
#include "experiments/commands/running/simulated_group.hpp"

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <mutex>
#include <string>
#include <utility>

#include "experiments/commands/progress_line.hpp"
#include "experiments/commands/running/participant_run.hpp"
#include "experiments/design/between_participants.hpp"
#include "experiments/observers/side_by_side.hpp"
#include "experiments/store/enrolment.hpp"
#include "experiments/study/stored_plan.hpp"

namespace impetus::inline commands {
namespace {

/// What the threads share; each takes the next participant until there is none.
class SimulatedGroup {
 public:
  SimulatedGroup(const std::vector<RunPart>& parts, const RunOptions& options, StudyFile& study)
      : parts_(parts),
        options_(options),
        study_(study),
        line_("simulating " + std::to_string(options.participants) + " participants") {}

  void run() {
    run_workers(jobs(), stops_, [this](std::int64_t /*any*/) {
      while (take_next()) {
      }
    });
  }

  [[nodiscard]] std::int64_t finished_before() const { return finished_before_; }

 private:
  [[nodiscard]] std::int64_t jobs() const {
    // Who follows another's gaze must find the same others finished, and who joins a group in a
    // later part the same others planned for, however many cores there are.
    const bool in_order = std::any_of(parts_.begin(), parts_.end(), [&](const RunPart& part) {
      const auto& gaze = part.protocol.script.gaze;
      return (gaze && gaze->yoked_to) ||
             (parts_.size() > 1 && groups(part.protocol.design).size() > 1);
    });
    const std::int64_t wanted = in_order ? 1 : options_.jobs > 0 ? options_.jobs : core_count();
    return std::clamp<std::int64_t>(wanted, 1, options_.participants);
  }

  /// Whether there was one to take.
  bool take_next() {
    std::unique_lock turn(turn_);
    if (next_ > options_.participants || stops_) {
      return false;
    }
    RunOptions own = options_;
    own.participant = simulated_name(next_++, options_.participants);
    run_parts(own, std::move(turn));
    return true;
  }

  /// The next participant's turn comes when this one is enrolled: so it is in the file, too.
  void run_parts(const RunOptions& own, std::unique_lock<std::mutex> turn) {
    for (const RunPart& part : parts_) {
      if (finished(part, own.participant)) {
        continue;
      }
      ParticipantRun participant(part, own, study_, nullptr);
      if (turn.owns_lock()) {
        turn.unlock();
      }
      participant.run([&] { tell_saved(participant.planned_trials()); });
    }
    if (turn.owns_lock()) {  // else another has the turn, and may count itself now
      ++finished_before_;
    }
  }

  bool finished(const RunPart& part, const std::string& participant) {
    const std::lock_guard lock(study_.transactions());
    return has_finished(study_, participant, true, texts_of(part.protocol));
  }

  void tell_saved(std::size_t planned) {
    const std::lock_guard lock(mutex_);
    done_ += 1.0 / static_cast<double>(planned * parts_.size());
    line_.tell(done_ / static_cast<double>(options_.participants));
  }

  const std::vector<RunPart>& parts_;
  const RunOptions& options_;
  StudyFile& study_;
  std::atomic<bool> stops_{false};  ///< one has failed
  std::mutex turn_;                 ///< to take the next participant
  std::int64_t next_{1};
  std::int64_t finished_before_{0};  ///< changed by who has the turn
  std::mutex mutex_;                 ///< of what follows
  ProgressLine line_;
  double done_{0.0};  ///< participants, the parts of one being fractions
};

}  // namespace

std::string simulated_name(std::int64_t number, std::int64_t count) {
  const auto digits = std::max<std::size_t>(2, std::to_string(count).size());
  const std::string text = std::to_string(number);
  return "S" + std::string(digits - text.size(), '0') + text;
}

std::string group_words(std::int64_t count) {
  const std::string first = simulated_name(1, count);
  return count == 1 ? "participant " + first
                    : "participants " + first + " to " + simulated_name(count, count);
}

void run_simulated_group(const std::vector<RunPart>& parts, const RunOptions& options,
                         StudyFile& study) {
  std::int64_t before = 0;
  {
    SimulatedGroup group(parts, options, study);
    group.run();
    before = group.finished_before();
  }
  const auto count = static_cast<long long>(options.participants);
  std::fprintf(stderr, "simulated participant %lld of %lld\n", count, count);
  if (before > 0) {
    std::fprintf(stderr, "note: %lld of them had finished before\n",
                 static_cast<long long>(before));
  }
}

}  // namespace impetus::inline commands
