// SPDX-License-Identifier: MIT
#include "experiments/session/session.hpp"

#include <optional>

#include "experiments/questions/session_pages.hpp"
#include "experiments/session/practice_part.hpp"
#include "experiments/session/trial_sequence.hpp"

namespace impetus::inline session {
namespace {

constexpr const char* kConsentId = "consent";

/// Every stage returns whether the session goes on; when it does not, `talk_` knows why.
class Session {
 public:
  Session(const Script& script, const Plan& plan, const SessionHistory& history, const Ports& ports,
          const Design& design)
      : script_(script),
        history_(history),
        ports_(ports),
        standing_(plan, history),
        talk_(ports.input, ports.recorder, standing_),
        sitting_{script, design, ports_, standing_, talk_, calibration_},
        trials_(sitting_, levels_after(history, plan, design)) {
    if (script.gaze && script.gaze->calibration && ports.gaze != nullptr && !plan.empty()) {
      calibration_.emplace(*script.gaze->calibration, plan.front().seed, ports_, talk_, standing_);
    }
  }

  SessionResult run() {
    const bool finished = welcome() && ask_consent() && ask_demographics() && instruct() &&
                          calibrate() && PracticePart(sitting_, trials_).run() &&
                          trials_.run_phase(TrialPhase::kMain, 0) && ask_questions() && thank();
    ports_.recorder.await_saved();
    return {finished ? SessionEnding::kFinished : talk_.ending(), standing_.completed_count(),
            standing_.progress().total, trials_.gaze_troubles()};
  }

 private:
  /// Who was interrupted before consenting has begun nothing to come back to.
  bool welcome() {
    const bool back = history_.resumed && history_.answered.contains(kConsentId);
    const Text& text = back ? welcome_back(standing_.completed_count()) : script_.welcome;
    return ask(text_page(text, progress())).has_value();
  }

  bool ask_consent() {
    if (history_.answered.contains(kConsentId)) {
      return true;
    }
    const Page page = consent_page(script_.consent, script_.consent_statement, progress());
    const auto answer = ask(page);
    if (!answer) {
      return false;
    }
    const bool agreed = answer->choice == 0;
    ports_.recorder.save(
        QuestionRecord{"consent", kConsentId, page.statement, agreed ? "agreed" : "declined"});
    return agreed || talk_.end(SessionEnding::kDeclined);
  }

  bool ask_demographics() {
    const std::vector<Field>& fields = script_.demographics;
    if (fields.empty() || history_.answered.contains(fields.front().id)) {
      return true;
    }
    const auto answer = ask(demographics_page(fields, progress()));
    for (std::size_t i = 0; answer && i < fields.size(); ++i) {
      ports_.recorder.save(
          QuestionRecord{"demographic", fields[i].id, fields[i].label, answer->fields[i]});
    }
    return answer.has_value();
  }

  bool instruct() {
    for (const Text& text : script_.instructions) {
      if (!ask(text_page(text, progress()))) {
        return false;
      }
    }
    return true;
  }

  /// In every session anew; nothing where no trial waits.
  bool calibrate() {
    const auto next = standing_.next_slot();
    return !calibration_ || !next || calibration_->calibrate(*next);
  }

  bool ask_questions() {
    for (const FreeQuestion& question : script_.questions) {
      if (history_.answered.contains(question.id)) {
        continue;
      }
      const auto answer = ask(question_page(question, progress()));
      if (!answer) {
        return false;
      }
      ports_.recorder.save(
          QuestionRecord{"question", question.id, question.text, answer->fields.front()});
    }
    return true;
  }

  bool thank() {
    // Saved before the words: closing the window on the last page loses nothing.
    ports_.recorder.mark_finished();
    ports_.recorder.await_saved();
    ports_.input.ask(thanks_page(script_.thanks, script_.part_follows, progress()));
    return true;
  }

  std::optional<Answer> ask(const Page& page) { return talk_.ask(page); }
  [[nodiscard]] SessionProgress progress() const { return standing_.progress(); }

  const Script& script_;
  const SessionHistory& history_;
  Ports ports_;  ///< with the present correction of the gaze
  SessionStanding standing_;
  Conversation talk_;
  std::optional<GazeCalibration> calibration_;
  Sitting sitting_;
  TrialSequence trials_;
};

}  // namespace

SessionResult run_session(const Script& script, const Plan& plan, const SessionHistory& history,
                          const Ports& ports, const Design& design) {
  return Session(script, plan, history, ports, design).run();
}

}  // namespace impetus::inline session
