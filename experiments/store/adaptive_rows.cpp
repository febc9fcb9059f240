// SPDX-License-Identifier: MIT
#include "experiments/store/adaptive_rows.hpp"

#include <SQLiteCpp/Statement.h>
#include <SQLiteCpp/VariadicBind.h>

#include <algorithm>
#include <cstdio>
#include <stdexcept>

#include "experiments/store/study_file.hpp"

namespace impetus::inline store {
namespace {

/// The answer of an attempt that counts: its first that is positive or negative.
constexpr const char* kCountedAnswerSql =
    "(SELECT positive FROM response WHERE response.attempt_id = attempt.id "
    "AND positive IS NOT NULL ORDER BY response.number LIMIT 1)";

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char letter : text) {
    if (letter == '"' || letter == '\\') {
      result += '\\';
    }
    if (static_cast<unsigned char>(letter) < 0x20) {
      char code[8];
      std::snprintf(code, sizeof code, "\\u%04x", static_cast<unsigned>(letter));
      result += code;
    } else {
      result += letter;
    }
  }
  return result + "\"";
}

std::string json_of(const LevelValue& value) {
  const auto* text = std::get_if<std::string>(&value);
  return text != nullptr ? quoted(*text) : to_text(value);
}

}  // namespace

std::string named_values_json(const std::vector<FactorLevel>& values) {
  std::vector<FactorLevel> sorted = values;
  std::sort(sorted.begin(), sorted.end(),
            [](const FactorLevel& a, const FactorLevel& b) { return a.factor < b.factor; });
  std::string text = "{";
  for (const FactorLevel& value : sorted) {
    text += (text.size() > 1 ? "," : "") + quoted(value.factor) + ":" + json_of(value.value);
  }
  return text + "}";
}

void update_chosen_level(SQLite::Database& database, std::int64_t trial_id,
                         const ChosenLevel& chosen) {
  SQLite::Statement update(database,
                           "UPDATE trial SET condition = ?, adaptive_state = ? "
                           "WHERE id = ? AND adaptive_state IS NULL");
  SQLite::bind(update, named_values_json(chosen.condition), named_values_json(chosen.state),
               trial_id);
  if (update.exec() != 1) {
    throw std::runtime_error("trial " + std::to_string(trial_id) + " has its level already");
  }
}

std::map<std::int64_t, bool> load_counted_answers(SQLite::Database& database,
                                                  std::int64_t enrolment) {
  SQLite::Statement query(database, std::string("SELECT slot, ") + kCountedAnswerSql +
                                        " AS counted FROM trial "
                                        "JOIN attempt ON attempt.trial_id = trial.id "
                                        "WHERE enrolment_id = ? AND track IS NOT NULL "
                                        "AND outcome = 'completed' AND counted IS NOT NULL");
  query.bind(1, enrolment);
  std::map<std::int64_t, bool> answers;
  while (query.executeStep()) {
    answers[query.getColumn(0).getInt64()] = query.getColumn(1).getInt() != 0;
  }
  return answers;
}

std::vector<StoredAdaptiveTrial> load_adaptive_trials(StudyFile& study) {
  SQLite::Statement query(
      study.database(),
      std::string("SELECT trial.id, pseudonym, protocol_id, enrolment_id, slot, track, condition, "
                  "adaptive_state, attempt.id IS NOT NULL, ") +
          kCountedAnswerSql +
          " FROM trial JOIN enrolment ON enrolment.id = enrolment_id "
          "JOIN participant ON participant.id = participant_id "
          "LEFT JOIN attempt ON attempt.trial_id = trial.id AND outcome = 'completed' "
          "WHERE track IS NOT NULL AND adaptive_state IS NOT NULL ORDER BY enrolment_id, slot");
  std::vector<StoredAdaptiveTrial> trials;
  while (query.executeStep()) {
    StoredAdaptiveTrial trial{query.getColumn(0).getInt64(),   query.getColumn(1).getString(),
                              query.getColumn(2).getInt64(),   query.getColumn(3).getInt64(),
                              query.getColumn(4).getInt64(),   query.getColumn(5).getInt64(),
                              query.getColumn(6).getString(),  query.getColumn(7).getString(),
                              query.getColumn(8).getInt() != 0};
    if (!query.getColumn(9).isNull()) {
      trial.counted_answer = query.getColumn(9).getInt() != 0;
    }
    trials.push_back(std::move(trial));
  }
  return trials;
}

}  // namespace impetus::inline store
