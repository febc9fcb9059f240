// SPDX-License-Identifier: MIT
#include "experiments/commands/fitting/answered_study.hpp"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "experiments/protocol/design_words.hpp"
#include "experiments/questions/rating.hpp"
#include "experiments/questions/two_interval.hpp"
#include "experiments/run/live_run.hpp"
#include "experiments/run/replay.hpp"
#include "experiments/store/rows.hpp"

namespace impetus::inline commands {
namespace {

/// Trials that the analysis leaves out, and participants (trial 0).
std::set<std::pair<std::string, std::int64_t>> excluded(StudyFile& study) {
  std::set<std::pair<std::string, std::int64_t>> all;
  for (const auto& [participant, trial] : load_rows<std::string, std::optional<std::int64_t>>(
           study.database(), "SELECT participant, trial FROM excluded")) {
    all.insert({participant, trial.value_or(0)});
  }
  return all;
}

std::int64_t chosen_protocol(StudyFile& study, const std::string& wanted) {
  std::vector<std::int64_t> fitting;
  std::vector<std::string> names;
  for (const auto& [id, name] : load_rows<std::int64_t, std::string>(
           study.database(), "SELECT id, name FROM protocol ORDER BY id")) {
    names.push_back(name);
    if (wanted.empty() || name == wanted) {
      fitting.push_back(id);
    }
  }
  if (fitting.size() == 1) {
    return fitting.front();
  }
  throw InputError(wanted.empty() ? study.name() + ": expected --protocol beside it, which of " +
                                        (names.empty() ? "none" : listed(names)) + " is meant"
                                  : "--protocol: expected one of " + study.name() + " (" +
                                        listed(names) + "), got " + wanted);
}

/// A stimulus as it was shown, as far as an observer looks at it.
struct ShownAgain {
  AttemptRecord record;
  StagedScene scene;  ///< at its end
};

[[noreturn]] void refuse_divergence(const StudyFile& study, const StoredAttempt& attempt,
                                    std::int64_t step) {
  throw InputError(study.name() +
                   ": expected trials that replay as they were recorded, but trial " +
                   std::to_string(attempt.trial_id) + " diverges at step " + std::to_string(step) +
                   why_divergent(attempt));
}

/// The one frame that observers ask for is the last: when the stimulus was over.
void add_last_frame(StudyFile& study, const StoredAttempt& attempt, std::int64_t interval,
                    AttemptRecord& record) {
  record.onset_ns = load_onset(study, attempt.id, interval).value_or(attempt.onset_ns);
  if (const auto last = load_last_frame(study, attempt.id, interval)) {
    FrameRecord& frame = record.frames.emplace_back();
    frame.flip.flipped_ns = last->flipped_ns;
    frame.interval = interval;
  }
}

/// Which frame first showed each collision is the session's knowledge, not a replay's.
void add_first_frames(StudyFile& study, const StoredAttempt& attempt, std::int64_t interval,
                      const std::vector<std::string>& names, AttemptRecord& record) {
  for (const StoredCollision& stored : load_collisions(study, attempt.id, names, interval)) {
    for (CollisionRecord& collision : record.collisions) {
      if (collision.step == stored.step && collision.report.bodies.a == stored.bodies.a &&
          collision.report.bodies.b == stored.bodies.b) {
        collision.first_frame_shown = stored.first_frame.value_or(-1);
      }
    }
  }
}

ShownAgain show_again(StudyFile& study, ReplayLibrary& library, const StoredAttempt& attempt,
                      std::int64_t interval) {
  const std::vector<StepRecord> steps = library.steps(attempt, interval);
  RunningReplay replay(library.stage(attempt, interval), steps);
  AttemptRecord record;
  const std::vector<std::string> names = body_names(replay.scene().world);
  for (std::size_t i = 0; !replay.done(); ++i) {
    const StepReport& report = replay.next();
    for (const CollisionReport& collision : report.collisions) {
      if (collision.began) {
        record.collisions.push_back(record_collision(replay.scene_run(), steps[i].gaze, collision));
      }
    }
  }
  if (replay.result().divergence) {
    refuse_divergence(study, attempt, replay.result().divergence->step);
  }
  record.body_names = names;
  add_last_frame(study, attempt, interval, record);
  add_first_frames(study, attempt, interval, names, record);
  return {std::move(record), replay.scene()};
}

bool has_any(const AnsweredTrial& trial) {
  return trial.rating_steps || trial.yes || trial.first || trial.mark || trial.clicks_s;
}

/// Where the mark is between the ends of its scale, 0 and 1; of a scale with two sides, −1 and 1.
/// It is a whole number of the scale.
Mark mark_on_line(const StoredResponse& response) {
  const json detail = json::parse(response.detail);
  const double value = detail["value"];
  const double least = detail["minimum"];
  const double most = detail["maximum"];
  const double side = least < 0.0 ? -1.0 : 0.0;
  const double unit = (1.0 - side) / (most - least);
  return {side + unit * (value - least), side, 1.0, unit};
}

/// What an observer goes by in a trial, and what happened in it; none: it marks no two-sided line.
struct Perceived {
  Percept percept;
  std::optional<double> happened{};
};

/// None: nothing tells what a mark on a line with two sides comes from.
std::optional<Mark> in_terms_of_seen(const Mark& mark, const Perceived& perceived) {
  if (mark.least == 0.0) {
    return mark;
  }
  if (!perceived.happened) {
    return std::nullopt;
  }
  const double happened = *perceived.happened;
  return Mark{happened - mark.value, happened - mark.most, happened - mark.least, mark.grain};
}

/// What an observer goes by in trials: found once for scenes that begin alike, where that is all it
/// goes by.
class Perception {
 public:
  explicit Perception(const ObserverFile& observer) : observer_(observer) {}

  const Perceived& of(const ShownAgain& again, const std::string& condition) {
    const AnswerModel& model = observer_.kind->answers;
    Perceived* place = &last_;
    bool is_new = true;
    if (model.is_of_scene) {
      const auto known =
          known_.try_emplace(std::pair(condition, hash_state(again.scene.start).hash));
      place = &known.first->second;
      is_new = known.second;
    }
    if (is_new) {
      place->percept = model.percept(*observer_.parameters, again.record, again.scene);
      if (model.happened != nullptr) {
        place->happened = model.happened(again.scene);
      }
    }
    return *place;
  }

 private:
  const ObserverFile& observer_;
  std::map<std::pair<std::string, std::uint64_t>, Perceived> known_;
  Perceived last_;
};

/// The answers alone; none when there is no answer that counts.
std::optional<AnsweredTrial> answers_of(StudyFile& study, const Protocol& protocol,
                                        const StoredAttempt& attempt) {
  AnsweredTrial trial;
  if (const RatingScale* scale = find_scale(protocol.script); scale != nullptr && attempt.rating) {
    trial.rating_steps = static_cast<std::size_t>(std::llabs(*attempt.rating - scale->best));
    trial.rating_points = static_cast<std::size_t>(scale->points());
  }
  for (const StoredResponse& response : load_responses(study, attempt.id)) {
    if (!response.timed_out && response.kind == "yes_no") {
      trial.yes = response.positive;
    }
    if (!response.timed_out && response.kind == "two_interval") {
      trial.first = response.answer == "first";
    }
    if (!response.timed_out && response.kind == "slider") {
      trial.mark = mark_on_line(response);
    }
  }
  if (takes_clicks(protocol.script)) {
    trial.clicks_s.emplace();
    for (const std::int64_t arrived_ns : load_clicks(study, attempt.id)) {
      trial.clicks_s->push_back(static_cast<double>(arrived_ns - attempt.onset_ns) / 1e9);
    }
  }
  return has_any(trial) ? std::optional(trial) : std::nullopt;
}

/// Clicks and marks count for a kind that explains them; one that does not needs another answer.
bool counts_for(const ObserverFile& observer, AnsweredTrial& trial) {
  if (observer.kind->answers.outcomes == nullptr) {
    trial.clicks_s.reset();
  }
  if (observer.kind->answers.mark == nullptr) {
    trial.mark.reset();
  }
  return has_any(trial);
}

/// As soon as people took part, nobody who is simulated counts.
void leave_out_simulated(StudyFile& study, AnsweredStudy& answered) {
  const auto codes = load_column<std::string>(study.database(),
                                              "SELECT pseudonym FROM participant WHERE simulated");
  const std::set<std::string> all(codes.begin(), codes.end());
  std::set<std::string> here;
  for (const StoredAttempt& attempt : answered.attempts) {
    here.insert(attempt.participant);
  }
  const auto simulated = static_cast<std::size_t>(std::count_if(
      here.begin(), here.end(), [&](const auto& code) { return all.contains(code); }));
  answered.all_simulated = simulated == here.size();
  if (!answered.all_simulated) {
    answered.simulated_left_out = simulated;
    std::erase_if(answered.attempts,
                  [&](const StoredAttempt& attempt) { return all.contains(attempt.participant); });
  }
}

}  // namespace

AnsweredStudy choose_answers(StudyFile& study, const AnswerChoice& choice) {
  AnsweredStudy answered;
  answered.protocol_id = chosen_protocol(study, choice.protocol);
  const auto left_out = excluded(study);
  answered.attempts = load_attempts(study);
  std::erase_if(answered.attempts, [&](const StoredAttempt& attempt) {
    return !attempt.completed || attempt.trial.phase != TrialPhase::kMain ||
           attempt.protocol_id != answered.protocol_id ||
           (!choice.code.empty() && attempt.participant != choice.code) ||
           left_out.contains({attempt.participant, 0}) ||
           left_out.contains({attempt.participant, attempt.trial_id});
  });
  if (answered.attempts.empty()) {
    throw InputError(study.name() + ": expected completed main trials" +
                     (choice.code.empty() ? "" : " of " + choice.code) +
                     " that are not excluded, got none");
  }
  leave_out_simulated(study, answered);
  return answered;
}

std::vector<std::vector<AnsweringPerson>> answering_people(
    StudyFile& study, ReplayLibrary& library, const AnsweredStudy& answered,
    const std::vector<ObserverFile>& observers, const Progress& told) {
  std::vector<std::vector<AnsweringPerson>> people(observers.size());
  std::vector<Perception> perceptions(observers.begin(), observers.end());
  double done = 0.0;
  for (const StoredAttempt& attempt : answered.attempts) {
    told(done++ / static_cast<double>(answered.attempts.size()));
    const Protocol& protocol = library.protocol(attempt.protocol_id);
    const std::optional<AnsweredTrial> answers = answers_of(study, protocol, attempt);
    if (!answers) {
      continue;
    }
    std::vector<AnsweredTrial> trials(observers.size(), *answers);
    for (std::int64_t interval = 1; interval <= library.intervals(attempt); ++interval) {
      const ShownAgain again = show_again(study, library, attempt, interval);
      for (std::size_t i = 0; i < observers.size(); ++i) {
        const Perceived& seen = perceptions[i].of(again, attempt.trial.condition);
        trials[i].percepts.push_back(seen.percept);
        trials[i].mark = answers->mark ? in_terms_of_seen(*answers->mark, seen) : std::nullopt;
      }
    }
    for (std::size_t i = 0; i < observers.size(); ++i) {
      if (counts_for(observers[i], trials[i])) {
        auto own = std::find_if(
            people[i].begin(), people[i].end(),
            [&](const AnsweringPerson& person) { return person.code == attempt.participant; });
        if (own == people[i].end()) {
          people[i].push_back({attempt.participant, {}});
          own = people[i].end() - 1;
        }
        own->trials.push_back(std::move(trials[i]));
      }
    }
  }
  for (std::vector<AnsweringPerson>& of_one : people) {
    std::sort(of_one.begin(), of_one.end(),
              [](const auto& a, const auto& b) { return a.code < b.code; });
  }
  return people;
}

}  // namespace impetus::inline commands
