// SPDX-License-Identifier: MIT
#include "experiments/study/protocol_check.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "experiments/protocol/checks/protocol_checks.hpp"
#include "experiments/protocol/checks/yoke_checks.hpp"
#include "experiments/questions/rating.hpp"
#include "experiments/questions/response_kinds.hpp"
#include "experiments/questions/two_interval.hpp"
#include "experiments/store/enrolment.hpp"
#include "experiments/store/rows.hpp"
#include "experiments/store/study_reader.hpp"
#include "experiments/study/stored_plan.hpp"

namespace impetus::inline study {
namespace {

/// A completed attempt and the answers that stand beside it.
struct AnsweredAttempt {
  std::int64_t protocol_id{0};
  std::string place;
  bool is_asked{true};                          ///< no trial of adaptation
  std::optional<RatingScale> rated_on{};        ///< no rating: none
  std::int64_t rating_timeouts{0};              ///< responses of kind rating
  std::map<std::string, std::int64_t> answers;  ///< other responses, by kind
  std::int64_t clicks{0};
  bool has_gaze{false};
};

std::vector<AnsweredAttempt> load_answered(SQLite::Database& database) {
  SQLite::Statement query(
      database,
      "SELECT attempt.id, protocol_id, pseudonym || ', ' || name || ', slot ' || slot || "
      "', attempt ' || number, phase <> 'adaptation', "
      "(SELECT count(*) FROM click WHERE click.attempt_id = attempt.id), "
      "EXISTS (SELECT 1 FROM gaze WHERE gaze.attempt_id = attempt.id), "
      "rating IS NOT NULL, minimum, maximum, best, low_anchor, high_anchor "
      "FROM attempt JOIN trial ON trial.id = trial_id "
      "JOIN enrolment ON enrolment.id = enrolment_id "
      "JOIN participant ON participant.id = participant_id "
      "JOIN protocol ON protocol.id = protocol_id "
      "LEFT JOIN rating ON rating.attempt_id = attempt.id "
      "WHERE outcome <> 'interrupted' ORDER BY attempt.id");
  std::vector<AnsweredAttempt> attempts;
  while (query.executeStep()) {
    AnsweredAttempt& attempt = attempts.emplace_back();
    std::int64_t id = 0;
    bool is_rated = false;
    RatingScale scale;
    NextColumn(query) >> id >> attempt.protocol_id >> attempt.place >> attempt.is_asked >>
        attempt.clicks >> attempt.has_gaze >> is_rated >> scale.minimum >> scale.maximum >>
        scale.best >> scale.low_anchor >> scale.high_anchor;
    if (is_rated) {
      attempt.rated_on = scale;
    }
    for (const auto& [kind, count] : load_rows<std::string, std::int64_t>(
             database, "SELECT kind, count(*) FROM response WHERE attempt_id = ? GROUP BY kind",
             id)) {
      (kind == "rating" ? attempt.rating_timeouts : attempt.answers[kind]) = count;
    }
  }
  return attempts;
}

void check_rating(const AnsweredAttempt& attempt, const Script& script, Failures& failures) {
  const RatingScale* scale = attempt.is_asked ? find_scale(script) : nullptr;
  const std::int64_t answers = (attempt.rated_on ? 1 : 0) + attempt.rating_timeouts;
  if (scale != nullptr && answers == 0) {
    failures.push_back(attempt.place + ": completed without the rating that was asked for");
  } else if (scale == nullptr && answers > 0) {
    failures.push_back(attempt.place + ": has a rating, which its protocol does not ask for");
  } else if (answers > 1) {
    failures.push_back(attempt.place + ": has a rating, though the time for it was up");
  } else if (attempt.rated_on && *attempt.rated_on != *scale) {
    failures.push_back(attempt.place + ": rated on another scale than the protocol's");
  }
}

void check_responses(const AnsweredAttempt& attempt, const Script& script, Failures& failures) {
  std::map<std::string, std::int64_t> expected;
  for (const auto& question : script.asked) {
    if (attempt.is_asked && question->kind().table == "response") {
      expected[question->kind().name] = 1;
    }
  }
  for (const auto& [kind, count] : expected) {
    if (!attempt.answers.contains(kind)) {
      failures.push_back(attempt.place + ": completed without the answer of kind " + kind +
                         " that was asked for");
    }
  }
  for (const auto& [kind, count] : attempt.answers) {
    if (!expected.contains(kind) || count != expected.at(kind)) {
      failures.push_back(attempt.place + ": has " + std::to_string(count) + " answers of kind " +
                         kind + ", its protocol asks for " +
                         (expected.contains(kind) ? "one" : "none"));
    }
  }
}

void check_attempt(const AnsweredAttempt& attempt, const Script& script, Failures& failures) {
  check_rating(attempt, script, failures);
  check_responses(attempt, script, failures);
  if (!takes_clicks(script) && attempt.clicks > 0) {
    failures.push_back(attempt.place + ": has clicks, which its protocol does not ask for");
  }
  if (!script.gaze && attempt.has_gaze) {
    failures.push_back(attempt.place + ": has gaze samples, though its protocol follows no gaze");
  }
}

/// One stimulus of a completed attempt, as far as it was shown and simulated.
struct ShownInterval {
  std::int64_t protocol_id{0};
  std::string place;
  PlannedTrial trial;
  std::int64_t interval{1};
  double last_time_s{0.0};
  std::int64_t last_step{0};
};

/// Steps a second under a condition.
double step_hz(const Protocol& protocol, const Condition& condition) {
  return scene_under(protocol, condition)
      .at(nlohmann::json::json_pointer("/engine/step_hz"))
      .get<double>();
}

/// As LiveRun steps: to the step that the last frame falls on, or the next.
double last_step_needed(const ShownInterval& shown, const Protocol& protocol) {
  constexpr double kOfAStep = 1e-9;
  const std::vector<PlannedTrial> stimuli = stimuli_of(protocol.script, shown.trial);
  const Condition& condition = stimuli.at(static_cast<std::size_t>(shown.interval - 1)).condition;
  return std::ceil(shown.last_time_s * step_hz(protocol, condition) - kOfAStep);
}

/// What is wrong with an interval's length; "": nothing. A condition that is none of the protocol's
/// is wrong, too.
std::string length_problem(ShownInterval shown, const std::string& condition,
                           const Protocol& protocol) {
  try {
    shown.trial.condition = condition_from_json(nlohmann::json::parse(condition), protocol.design);
    const double needed = last_step_needed(shown, protocol);
    if (static_cast<double>(shown.last_step) == needed) {
      return "";
    }
    return "its last frame shows step " + to_text(LevelValue(needed)) + ", the last one there is " +
           std::to_string(shown.last_step);
  } catch (const std::exception& error) {
    return std::string("how long it is cannot be told: ") + error.what();
  }
}

using nlohmann::json;

/// Who was planned for, and by which seed.
struct StoredEnrolment {
  std::int64_t id{0};
  std::int64_t protocol_id{0};
  std::string participant;
  std::uint64_t seed{0};
};

/// The condition as it was planned: an adaptive level came later.
std::string planned_condition(const StoredTrial& trial, const Design& design) {
  json condition = json::parse(trial.condition);
  if (trial.track && design.adaptive) {
    condition.erase(design.adaptive->factor);
  }
  return condition.dump();
}

std::string words(const StoredTrial& trial, const std::string& condition) {
  return std::string(trial.phase == TrialPhase::kPractice ? "practice" : "main") + " trial under " +
         condition + ", repetition " + std::to_string(trial.repetition) + ", block " +
         std::to_string(trial.block) +
         (trial.track ? ", track " + std::to_string(*trial.track) : "") +
         (trial.catch_trial ? ", catch" : "") + ", seed " + std::to_string(trial.seed);
}

/// Whether the trial follows a recorded gaze where it must, and only there.
std::optional<std::string> yoke_problem(const StoredTrial& trial, const PlannedTrial& planned,
                                        const Protocol& protocol) {
  const bool follows = followed_condition(protocol, planned.condition).has_value();
  if (follows == trial.yoked_trial_id.has_value()) {
    return std::nullopt;
  }
  return std::string(follows ? "follows nobody's gaze, though its condition asks for one"
                             : "follows another's gaze, though its condition asks for none");
}

std::optional<std::string> first_difference(const std::vector<StoredTrial>& kept, const Plan& plan,
                                            const Protocol& protocol) {
  const std::vector<StoredTrial> anew = stored(plan);
  for (std::size_t i = 0; i < std::min(kept.size(), anew.size()); ++i) {
    const std::string slot = "slot " + std::to_string(anew[i].slot);
    if (kept[i].slot != anew[i].slot) {
      return slot + " is missing from the plan";
    }
    const std::string was = words(kept[i], planned_condition(kept[i], protocol.design));
    const std::string is = words(anew[i], json::parse(anew[i].condition).dump());
    if (was != is) {
      return slot + ": the plan has a " + was + "; planned anew it is a " + is;
    }
    if (const auto problem = yoke_problem(kept[i], plan[i], protocol)) {
      return slot + ": " + *problem;
    }
  }
  if (kept.size() != anew.size()) {
    return "the plan has " + std::to_string(kept.size()) + " trials; planned anew it has " +
           std::to_string(anew.size());
  }
  return std::nullopt;
}

std::optional<std::string> plan_problem(SQLite::Database& database,
                                        const StoredEnrolment& enrolment,
                                        const Protocol& protocol) {
  try {
    const std::vector<StoredTrial> kept = load_trials(database, enrolment.id);
    const Condition group = stored_group(kept, protocol.design);
    return first_difference(kept, plan_for(protocol, enrolment.participant, enrolment.seed, group),
                            protocol);
  } catch (const SQLite::Exception&) {
    throw;
  } catch (const std::exception& error) {
    return std::string("cannot be planned anew: ") + error.what();
  }
}

}  // namespace

ProtocolShelf::ProtocolShelf(StudyFile& study) {
  for (const std::int64_t id :
       load_column<std::int64_t>(study.database(), "SELECT id FROM protocol ORDER BY id")) {
    const ProtocolTexts texts = load_protocol_texts(study, id);
    const std::string place = "protocol " + texts.name;
    try {
      Protocol protocol = make_protocol(parse_json(place, texts.protocol_json),
                                        parse_json(place + ", scene", texts.scene_json));
      if (protocol.name != texts.name) {
        failures_.push_back(place + ": calls itself " + protocol.name);
      }
      if (protocol.hash != texts.hash) {
        failures_.push_back(place + ": its hash is " + texts.hash + ", computed anew it is " +
                            protocol.hash);
      }
      protocols_.emplace(id, std::move(protocol));
    } catch (const std::exception& error) {
      failures_.emplace_back(error.what());
      ++unreadable_;
    }
  }
}

const Protocol* ProtocolShelf::find(std::int64_t id) const {
  const auto found = protocols_.find(id);
  return found == protocols_.end() ? nullptr : &found->second;
}

Failures wrong_answers(StudyFile& study, const ProtocolShelf& shelf) {
  Failures failures;
  for (const AnsweredAttempt& attempt : load_answered(study.database())) {
    if (const Protocol* protocol = shelf.find(attempt.protocol_id)) {
      check_attempt(attempt, protocol->script, failures);
    }
  }
  return failures;
}

Failures wrong_lengths(StudyFile& study, const ProtocolShelf& shelf) {
  SQLite::Statement query(
      study.database(),
      "SELECT protocol_id, pseudonym || ', ' || name || ', slot ' || slot || ', attempt ' || "
      "number, frame.interval, max(shown_time_s), coalesce((SELECT max(step) FROM step "
      "WHERE step.attempt_id = attempt.id AND step.interval = frame.interval), -1), "
      "condition, trial.seed FROM frame JOIN attempt ON attempt.id = attempt_id "
      "JOIN trial ON trial.id = trial_id JOIN enrolment ON enrolment.id = enrolment_id "
      "JOIN participant ON participant.id = participant_id "
      "JOIN protocol ON protocol.id = protocol_id "
      "WHERE outcome <> 'interrupted' AND frame.phase = 'stimulus' "
      "GROUP BY attempt.id, frame.interval");
  Failures failures;
  while (query.executeStep()) {
    ShownInterval shown;
    std::string condition;
    NextColumn(query) >> shown.protocol_id >> shown.place >> shown.interval >> shown.last_time_s >>
        shown.last_step >> condition >> shown.trial.seed;
    const Protocol* protocol = shelf.find(shown.protocol_id);
    const std::string problem =
        protocol == nullptr ? "" : length_problem(shown, condition, *protocol);
    if (!problem.empty()) {
      failures.push_back(shown.place + ": " + problem);
    }
  }
  return failures;
}

Failures changed_plans(StudyFile& study, const ProtocolShelf& shelf) {
  Failures failures;
  for (const StoredEnrolment& enrolment :
       load_as<StoredEnrolment, std::int64_t, std::int64_t, std::string, std::uint64_t>(
           study.database(),
           "SELECT enrolment.id, protocol_id, pseudonym, seed FROM enrolment "
           "JOIN participant ON participant.id = participant_id ORDER BY enrolment.id")) {
    const Protocol* protocol = shelf.find(enrolment.protocol_id);
    if (protocol == nullptr) {
      continue;
    }
    if (const auto problem = plan_problem(study.database(), enrolment, *protocol)) {
      failures.push_back(enrolment.participant + ", " + protocol->name + ": " + *problem);
    }
  }
  return failures;
}

}  // namespace impetus::inline study
