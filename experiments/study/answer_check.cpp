// SPDX-License-Identifier: MIT
#include "experiments/study/answer_check.hpp"

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "experiments/questions/level_value.hpp"
#include "experiments/questions/rating.hpp"
#include "experiments/questions/response_kinds.hpp"
#include "experiments/questions/two_interval.hpp"
#include "experiments/store/rows.hpp"
#include "experiments/study/embedded_places.hpp"

namespace impetus::inline study {
namespace {

using nlohmann::json;

/// A completed attempt and the answers that stand beside it.
struct AnsweredAttempt {
  std::int64_t protocol_id{0};
  std::string place;
  TrialPhase phase{TrialPhase::kMain};
  std::string condition;  ///< JSON
  std::uint64_t seed{0};
  std::optional<RatingScale> rated_on{};  ///< no rating: none
  std::vector<ResponseRecord> responses;  ///< without their details
  std::vector<std::string> details;       ///< of each, JSON
  std::int64_t clicks{0};
  bool has_gaze{false};

  [[nodiscard]] bool is_asked() const { return phase != TrialPhase::kAdaptation; }
  [[nodiscard]] std::int64_t count(const std::string& kind) const {
    return std::count_if(responses.begin(), responses.end(),
                         [&](const ResponseRecord& response) { return response.kind == kind; });
  }
};

void load_responses(SQLite::Database& database, std::int64_t id, AnsweredAttempt& attempt) {
  SQLite::Statement query(database,
                          "SELECT kind, question, answer, positive, correct, timed_out, detail "
                          "FROM response WHERE attempt_id = ? ORDER BY number");
  query.bind(1, id);
  while (query.executeStep()) {
    ResponseRecord& response = attempt.responses.emplace_back();
    NextColumn(query) >> response.kind >> response.question >> response.answer >>
        response.positive >> response.correct >> response.timed_out >>
        attempt.details.emplace_back();
  }
}

std::vector<AnsweredAttempt> load_answered(SQLite::Database& database) {
  SQLite::Statement query(
      database,
      std::string(kPlacesSql) +
          "SELECT shown.id, protocol_id, shown.place, shown.phase, condition, trial.seed, "
          "(SELECT count(*) FROM click WHERE click.attempt_id = shown.id), "
          "EXISTS (SELECT 1 FROM gaze WHERE gaze.attempt_id = shown.id), "
          "rating IS NOT NULL, minimum, maximum, best, low_anchor, high_anchor "
          "FROM shown JOIN trial ON trial.id = trial_id "
          "JOIN enrolled ON enrolled.id = shown.enrolment_id "
          "LEFT JOIN rating ON rating.attempt_id = shown.id "
          "WHERE outcome <> 'interrupted' ORDER BY shown.id");
  std::vector<AnsweredAttempt> attempts;
  while (query.executeStep()) {
    AnsweredAttempt& attempt = attempts.emplace_back();
    std::int64_t id = 0;
    std::string phase;
    bool is_rated = false;
    RatingScale scale;
    NextColumn(query) >> id >> attempt.protocol_id >> attempt.place >> phase >> attempt.condition >>
        attempt.seed >> attempt.clicks >> attempt.has_gaze >> is_rated >> scale.minimum >>
        scale.maximum >> scale.best >> scale.low_anchor >> scale.high_anchor;
    attempt.phase = phase_named(phase);
    if (is_rated) {
      attempt.rated_on = scale;
    }
    load_responses(database, id, attempt);
  }
  return attempts;
}

/// Whether each question was answered once, what nobody asked was not, and each answer is one that
/// its question would have kept like that.
class AttemptCheck {
 public:
  AttemptCheck(const AnsweredAttempt& attempt, const Protocol& protocol, Failures& failures)
      : attempt_(attempt), protocol_(protocol), script_(protocol.script), failures_(failures) {}

  void make() {
    check_rating();
    check_counts();
    if (!takes_clicks(script_) && attempt_.clicks > 0) {
      fail("has clicks, which its protocol does not ask for");
    }
    if (!script_.gaze && attempt_.has_gaze) {
      fail("has gaze samples, though its protocol follows no gaze");
    }
    check_answers();
  }

 private:
  void fail(const std::string& what) { failures_.push_back(attempt_.place + ": " + what); }

  void check_rating() {
    const RatingScale* scale = attempt_.is_asked() ? find_scale(script_) : nullptr;
    const std::int64_t answers = (attempt_.rated_on ? 1 : 0) + attempt_.count("rating");
    if (scale != nullptr && answers == 0) {
      fail("completed without the rating that was asked for");
    } else if (scale == nullptr && answers > 0) {
      fail("has a rating, which its protocol does not ask for");
    } else if (answers > 1) {
      fail("has a rating, though the time for it was up");
    } else if (attempt_.rated_on && *attempt_.rated_on != *scale) {
      fail("rated on another scale than the protocol's");
    }
  }

  void check_counts() {
    for (const auto& question : script_.asked) {
      const std::string& kind = question->kind().name;
      if (attempt_.is_asked() && question->kind().table == "response" &&
          attempt_.count(kind) == 0) {
        fail("completed without the answer of kind " + kind + " that was asked for");
      }
    }
    std::map<std::string, std::int64_t> counts;
    for (const ResponseRecord& response : attempt_.responses) {
      ++counts[response.kind];
    }
    counts.erase("rating");
    for (const auto& [kind, count] : counts) {
      const bool is_asked = asked(kind) != nullptr;
      if (!is_asked || count != 1) {
        fail("has " + std::to_string(count) + " answers of kind " + kind +
             ", its protocol asks for " + (is_asked ? "one" : "none"));
      }
    }
  }

  /// The question of this kind; null: none is asked.
  [[nodiscard]] const Question* asked(const std::string& kind) const {
    for (const auto& question : script_.asked) {
      if (attempt_.is_asked() && question->kind().name == kind) {
        return question.get();
      }
    }
    return nullptr;
  }

  void check_answers() {
    try {
      for (std::size_t i = 0; i < attempt_.responses.size(); ++i) {
        const ResponseRecord& response = attempt_.responses[i];
        if (const Question* question = asked(response.kind)) {
          check_answer(*question, response, json::parse(attempt_.details[i]));
        }
      }
    } catch (const std::exception& error) {
      fail(std::string("its answers cannot be judged: ") + error.what());
    }
  }

  /// Names the first column in which the answer differs from what its question keeps of it.
  void check_answer(const Question& question, const ResponseRecord& stored, const json& detail) {
    const std::vector<ResponseRecord> possible = answers_like(question, stored);
    std::string difference;
    for (const ResponseRecord& again : possible) {
      difference = stored.question != again.question
                       ? "was asked in other words than its protocol's"
                   : stored.positive != again.positive ? kept_as("positive", stored, again.positive)
                   : stored.correct != again.correct   ? kept_as("correct", stored, again.correct)
                   : detail != to_json(again.detail)
                       ? "the answer " + stored.answer + " is kept with " + detail.dump() +
                             ", its protocol gives " + to_json(again.detail).dump()
                       : "";
      if (difference.empty()) {
        return;
      }
    }
    fail(possible.empty() ? "the answer " + stored.answer + " is none that can be given"
                          : difference);
  }

  static std::string kept_as(const std::string& column, const ResponseRecord& stored,
                             const std::optional<bool>& again) {
    return "the answer " + stored.answer + " is not kept with " + column + " " +
           (again ? std::to_string(static_cast<int>(*again)) : std::string("empty")) +
           ", as its protocol gives";
  }

  /// What the question keeps of all ways to answer it that read like this one. Whether bodies touch
  /// is a replay's to tell: either is possible.
  [[nodiscard]] std::vector<ResponseRecord> answers_like(const Question& question,
                                                         const ResponseRecord& stored) const {
    PlannedTrial trial;
    trial.phase = attempt_.phase;
    trial.seed = attempt_.seed;
    trial.condition = condition_from_json(json::parse(attempt_.condition), protocol_.design);
    SessionProgress progress;
    progress.language = script_.language;
    std::vector<ResponseRecord> like;
    for (const bool touch : {false, true}) {
      const AskedTrial asked{trial, progress, test_interval(script_, trial),
                             [touch](const auto& /*names*/) { return touch; }};
      const std::optional<Page> page = question.page(asked);
      for (std::size_t choice = 0; page && choice < page->choices.size(); ++choice) {
        AttemptRecord record;
        question.keep(asked, given(*page, choice, stored), record);
        for (ResponseRecord& response : record.responses) {
          if (response.answer == stored.answer) {
            like.push_back(std::move(response));
          }
        }
      }
    }
    return like;
  }

  static Answer given(const Page& page, std::size_t choice, const ResponseRecord& stored) {
    Answer answer;
    answer.choice = choice;
    answer.timed_out = stored.timed_out;
    for (const Field& field : page.fields) {
      const bool fits = !stored.timed_out && may_be_filled_in(field, stored.answer);
      answer.fields.push_back(fits ? stored.answer : "");
    }
    return answer;
  }

  /// A mark is a whole number on its line.
  static bool may_be_filled_in(const Field& field, const std::string& text) {
    if (field.kind != Field::Kind::kSlider) {
      return true;
    }
    const double mark = std::strtod(text.c_str(), nullptr);
    return text == to_text(LevelValue(mark)) && mark >= field.minimum && mark <= field.maximum;
  }

  const AnsweredAttempt& attempt_;
  const Protocol& protocol_;
  const Script& script_;
  Failures& failures_;
};

/// An enrolment of somebody who was shown a trial.
struct BegunEnrolment {
  std::int64_t id{0};
  std::int64_t protocol_id{0};
  std::string place;
  bool is_finished{false};
};

/// Those of the pages before the trials, and, of who has finished, of those after them.
std::vector<std::string> questions_of_pages(const Script& script, bool is_finished) {
  std::vector<std::string> ids;
  if (!script.consent_statement.empty()) {
    ids.emplace_back("consent");
  }
  for (const Field& field : script.demographics) {
    ids.push_back(field.id);
  }
  for (const FreeQuestion& question : script.questions) {
    if (is_finished) {
      ids.push_back(question.id);
    }
  }
  return ids;
}

/// Pages were asked of whoever was shown a trial; what was left empty has a row, too.
Failures missing_pages(SQLite::Database& database, const ProtocolShelf& shelf) {
  Failures failures;
  for (const BegunEnrolment& enrolment :
       load_as<BegunEnrolment, std::int64_t, std::int64_t, std::string, bool>(
           database,
           std::string(kPlacesSql) +
               "SELECT id, protocol_id, place, finished_utc IS NOT NULL FROM enrolled "
               "WHERE EXISTS (SELECT 1 FROM shown WHERE enrolment_id = enrolled.id) ORDER BY id")) {
    const Protocol* protocol = shelf.find(enrolment.protocol_id);
    if (protocol == nullptr) {
      continue;
    }
    const auto answered = load_column<std::string>(
        database,
        "SELECT question FROM answer JOIN session ON session.id = session_id "
        "WHERE enrolment_id = ? AND NOT (kind = 'consent' AND answer IS 'declined')",
        enrolment.id);
    for (const std::string& id : questions_of_pages(protocol->script, enrolment.is_finished)) {
      if (std::find(answered.begin(), answered.end(), id) == answered.end()) {
        failures.push_back(enrolment.place + ": was shown trials, but what was answered to " + id +
                           " is missing");
      }
    }
  }
  return failures;
}

}  // namespace

Failures wrong_answers(StudyFile& study, const ProtocolShelf& shelf) {
  Failures failures = missing_pages(study.database(), shelf);
  for (const AnsweredAttempt& attempt : load_answered(study.database())) {
    if (const Protocol* protocol = shelf.find(attempt.protocol_id)) {
      AttemptCheck(attempt, *protocol, failures).make();
    }
  }
  return failures;
}

}  // namespace impetus::inline study
