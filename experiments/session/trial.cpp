// SPDX-License-Identifier: MIT
#include "experiments/session/trial.hpp"

#include <algorithm>
#include <deque>
#include <utility>
#include <vector>

#include "experiments/gaze/gaze_latency.hpp"
#include "experiments/gaze/gaze_loss.hpp"
#include "experiments/questions/answer_keys.hpp"
#include "experiments/questions/question_order.hpp"
#include "experiments/questions/response_kinds.hpp"
#include "experiments/questions/two_interval.hpp"
#include "experiments/record/frame_grid.hpp"
#include "experiments/run/touching.hpp"
#include "experiments/session/stimulus.hpp"

namespace impetus::inline session {
namespace {

const char* name_of(Interruption interruption) {
  return interruption == Interruption::kPauseRequested  ? "pause"
         : interruption == Interruption::kDisplayClosed ? "display closed"
                                                        : kGazeLostNote;
}

/// Runs the phases of one attempt in order; a phase returns false when it was interrupted.
class Attempt {
 public:
  Attempt(const PlannedTrial& trial, std::int64_t number, const Script& script,
          const SessionProgress& progress, const Ports& ports, bool may_be_repeated)
      : script_(script),
        progress_(progress),
        asked_{trial, progress_, test_interval(script, trial),
               [this](const NamedPair& names) { return touch_by_the_end(own().scene(), names); }},
        ports_(ports),
        may_be_repeated_(may_be_repeated),
        follower_(script.gaze ? ports.gaze : nullptr, ports.clock, ports.gaze_correction) {
    std::int64_t interval = 0;
    for (const PlannedTrial& shown : stimuli_of(script, trial)) {
      stimuli_.emplace_back(shown, ++interval, script, progress_, ports, follower_);
    }
    result_.record.slot = trial.slot;
    result_.record.number = number;
    result_.record.wall_naming = wall_naming(own().scene().world.settings().enclosure);
    result_.record.intended_hold_s = own().scene().intended_hold_s;
    result_.record.realised_hold_s = own().scene().realised_hold_s;
    if (script.gaze && ports.gaze != nullptr) {
      result_.record.gaze_source = ports.gaze->source();
      result_.record.imposed_gaze_latency_s = own().imposed_gaze_latency_s();
    }
  }

  AttemptResult run() {
    const bool completed = show_interval() && show_stimuli() && gaze_suffices() && ask_questions();
    collect();
    if (completed) {
      result_.record.outcome = AttemptOutcome::kCompleted;
    } else {
      result_.record.interrupted_by = name_of(result_.interruption);
    }
    return std::move(result_);
  }

 private:
  bool show_interval() {
    ports_.display.restart_grid();
    Picture between_trials = stimuli_.front().blank();
    between_trials.progress = progress_;
    const TrialTiming& timing = script_.timing;
    if (!show_for(asked_.trial.is_asked() ? timing.interval_ms : timing.between_adaptors_ms,
                  between_trials)) {
      return false;
    }
    progress_.gaze_was_lost = false;  // the mark is gone when the trial begins
    ports_.recorder.await_saved();
    return true;
  }

  bool show_for(double duration_ms, const Picture& picture) {
    const std::int64_t frames = whole_frames(duration_ms / 1e3, ports_.display.refresh_hz());
    for (std::int64_t frame = 0; frame < frames; ++frame) {
      const Flip flip = ports_.display.show(picture);
      result_.record.late_untimed_frames += flip.late() ? 1 : 0;
      result_.interruption = ports_.input.interruption();
      if (result_.interruption != Interruption::kNone) {
        return false;
      }
    }
    return true;
  }

  bool show_stimuli() {
    ports_.display.restart_grid();
    for (std::size_t index = 0; index < stimuli_.size(); ++index) {
      if (index > 0) {
        if (!show_for(find_two_interval(script_)->between_ms(), stimuli_.front().blank())) {
          return false;
        }
        stimuli_[index - 1].take_clicks();  // a late one belongs to what was seen
      }
      result_.interruption = stimuli_[index].show();
      if (result_.interruption != Interruption::kNone) {
        return false;
      }
    }
    return true;
  }

  /// Whether the trial need not be shown again for want of a gaze.
  [[nodiscard]] bool gaze_suffices() const {
    return !may_be_repeated_ ||
           std::none_of(stimuli_.begin(), stimuli_.end(), [&](const Stimulus& stimulus) {
             return gaze_was_lost(gaze_loss_rule(script_), stimulus.gaze_lost_share());
           });
  }

  bool ask_questions() {
    if (stimuli_.size() > 1) {
      stimuli_.back().take_clicks();  // before the first is asked for its own
    }
    for (Stimulus& stimulus : stimuli_) {
      stimulus.be_witnessed();
    }
    if (!asked_.trial.is_asked()) {
      return true;
    }
    std::vector<std::optional<Answer>> answers(script_.asked.size());
    for (const std::size_t place : order_of_questions(script_, asked_.trial.seed)) {
      if (!ask(*script_.asked[place], answers[place])) {
        break;
      }
    }
    keep(answers);
    return result_.interruption == Interruption::kNone;
  }

  /// Asks by the question's page, if it has one; false when that was interrupted.
  bool ask(const Question& question, std::optional<Answer>& given) {
    std::optional<Page> page = question.page(asked_);
    if (!page) {
      return true;
    }
    const KeyedPage keyed = with_keys(std::move(*page), question, script_, asked_.trial.condition);
    Answer answer = ports_.input.ask(keyed.page);
    result_.record.late_untimed_frames += answer.late_frames;
    result_.interruption = answer.interruption;
    if (answer.interruption != Interruption::kNone) {
      return false;
    }
    if (ports_.markers != nullptr && !answer.timed_out) {
      ports_.markers->mark(MarkedEvent::kAnswer, answer.arrived_ns, asked_.test_interval);
    }
    answer.choice = keyed.answers.empty() ? answer.choice : keyed.answers.at(answer.choice);
    given = std::move(answer);
    return true;
  }

  /// Records are in the order in which kinds are listed, whatever was asked first.
  void keep(const std::vector<std::optional<Answer>>& answers) {
    for (std::size_t place = 0; place < answers.size(); ++place) {
      if (answers[place]) {
        script_.asked[place]->keep(asked_, *answers[place], result_.record);
      }
    }
  }

  void collect() {
    AttemptRecord& record = result_.record;
    record.region_covered_share = own().region_covered_share();
    bool depends_on_gaze = false;
    for (Stimulus& stimulus : stimuli_) {
      stimulus.append_to(record);
      depends_on_gaze = depends_on_gaze || stimulus.scene().depends_on_gaze;
      record.gaze_lost_share = std::max(record.gaze_lost_share, stimulus.gaze_lost_share());
    }
    if (ports_.markers != nullptr) {
      record.markers = ports_.markers->take();
    }
    if (depends_on_gaze) {
      record.gaze_latency_p95_ms = gaze_latency_p95_ms(record.steps, record.frames, record.gaze);
    }
  }

  /// The stimulus of the trial's own condition; the other is the standard.
  Stimulus& own() { return stimuli_[static_cast<std::size_t>(asked_.test_interval - 1)]; }

  const Script& script_;
  SessionProgress progress_;  ///< before what refers to it
  AskedTrial asked_;
  const Ports& ports_;
  bool may_be_repeated_;
  GazeFollower follower_;
  std::deque<Stimulus> stimuli_;
  AttemptResult result_;
};

}  // namespace

AttemptResult run_attempt(const PlannedTrial& trial, std::int64_t number, const Script& script,
                          const SessionProgress& progress, const Ports& ports,
                          bool may_be_repeated) {
  return Attempt(trial, number, script, progress, ports, may_be_repeated).run();
}

}  // namespace impetus::inline session
