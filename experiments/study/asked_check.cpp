// SPDX-License-Identifier: MIT
#include "experiments/study/asked_check.hpp"

#include <SQLiteCpp/Statement.h>

#include <cmath>
#include <cstdint>
#include <exception>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "experiments/questions/response_kinds.hpp"
#include "experiments/session/intervals.hpp"

namespace impetus::inline study {
namespace {

/// A completed attempt and the answers that stand beside it.
struct AnsweredAttempt {
  std::int64_t protocol_id{0};
  std::string place;
  std::optional<RatingScale> rated_on{};        ///< no rating: none
  std::int64_t rating_timeouts{0};              ///< responses of kind rating
  std::map<std::string, std::int64_t> answers;  ///< other responses, by kind
  std::int64_t clicks{0};
  std::int64_t gaze_samples{0};
};

/// "rating 1, yes_no 1" as the query groups them, by kind.
std::map<std::string, std::int64_t> responses_of(SQLite::Database& database, std::int64_t attempt) {
  SQLite::Statement query(database,
                          "SELECT kind, count(*) FROM response WHERE attempt_id = ? GROUP BY kind");
  query.bind(1, attempt);
  std::map<std::string, std::int64_t> counts;
  while (query.executeStep()) {
    counts[query.getColumn(0).getString()] = query.getColumn(1).getInt64();
  }
  return counts;
}

std::vector<AnsweredAttempt> load_answered(SQLite::Database& database) {
  SQLite::Statement query(
      database,
      "SELECT attempt.id, protocol_id, pseudonym || ', ' || name || ', slot ' || slot || "
      "', attempt ' || number, rating, minimum, maximum, best, low_anchor, high_anchor, "
      "(SELECT count(*) FROM click WHERE click.attempt_id = attempt.id), "
      "EXISTS (SELECT 1 FROM gaze WHERE gaze.attempt_id = attempt.id) "
      "FROM attempt JOIN trial ON trial.id = trial_id "
      "JOIN enrolment ON enrolment.id = enrolment_id "
      "JOIN participant ON participant.id = participant_id "
      "JOIN protocol ON protocol.id = protocol_id "
      "LEFT JOIN rating ON rating.attempt_id = attempt.id "
      "WHERE outcome <> 'interrupted' ORDER BY attempt.id");
  std::vector<AnsweredAttempt> attempts;
  while (query.executeStep()) {
    AnsweredAttempt attempt;
    attempt.protocol_id = query.getColumn(1).getInt64();
    attempt.place = query.getColumn(2).getString();
    if (!query.getColumn(3).isNull()) {
      attempt.rated_on = RatingScale{"",
                                     query.getColumn(4).getInt64(),
                                     query.getColumn(5).getInt64(),
                                     query.getColumn(6).getInt64(),
                                     query.getColumn(7).getString(),
                                     query.getColumn(8).getString()};
    }
    attempt.answers = responses_of(database, query.getColumn(0).getInt64());
    attempt.rating_timeouts = attempt.answers["rating"];
    attempt.answers.erase("rating");
    attempt.clicks = query.getColumn(9).getInt64();
    attempt.gaze_samples = query.getColumn(10).getInt64();
    attempts.push_back(std::move(attempt));
  }
  return attempts;
}

bool same_scale(const RatingScale& a, const RatingScale& b) {
  return a.minimum == b.minimum && a.maximum == b.maximum && a.best == b.best &&
         a.low_anchor == b.low_anchor && a.high_anchor == b.high_anchor;
}

void check_rating(const AnsweredAttempt& attempt, const Script& script, Failures& failures) {
  const std::int64_t answers = (attempt.rated_on ? 1 : 0) + attempt.rating_timeouts;
  if (script.scale && answers == 0) {
    failures.push_back(attempt.place + ": completed without the rating that was asked for");
  } else if (!script.scale && answers > 0) {
    failures.push_back(attempt.place + ": has a rating, which its protocol does not ask for");
  } else if (answers > 1) {
    failures.push_back(attempt.place + ": has a rating, though the time for it was up");
  } else if (attempt.rated_on && !same_scale(*attempt.rated_on, *script.scale)) {
    failures.push_back(attempt.place + ": rated on another scale than the protocol's");
  }
}

void check_responses(const AnsweredAttempt& attempt, const Script& script, Failures& failures) {
  std::map<std::string, std::int64_t> expected;
  for (const ResponseKind& kind : response_kinds()) {
    if (kind.is_asked(script) && kind.keep != nullptr && kind.table == "response") {
      expected[kind.name] = 1;
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
  if (!script.clicks && attempt.clicks > 0) {
    failures.push_back(attempt.place + ": has clicks, which its protocol does not ask for");
  }
  if (!script.gaze && attempt.gaze_samples > 0) {
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
  constexpr const char* kPointer = "/engine/step_hz";
  for (const FactorLevel& level : condition) {
    if (protocol.pointers.at(level.factor) == kPointer) {
      return std::get<double>(level.value);
    }
  }
  return protocol.scene.value.at(nlohmann::json::json_pointer(kPointer)).get<double>();
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

}  // namespace

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
    const Protocol* protocol = shelf.find(query.getColumn(0).getInt64());
    if (protocol == nullptr) {
      continue;
    }
    ShownInterval shown;
    shown.place = query.getColumn(1).getString();
    shown.interval = query.getColumn(2).getInt64();
    shown.last_time_s = query.getColumn(3).getDouble();
    shown.last_step = query.getColumn(4).getInt64();
    shown.trial.seed = static_cast<std::uint64_t>(query.getColumn(6).getInt64());
    const std::string problem = length_problem(shown, query.getColumn(5).getString(), *protocol);
    if (!problem.empty()) {
      failures.push_back(shown.place + ": " + problem);
    }
  }
  return failures;
}

}  // namespace impetus::inline study
