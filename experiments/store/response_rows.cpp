// SPDX-License-Identifier: MIT
#include "experiments/store/response_rows.hpp"

#include <SQLiteCpp/Statement.h>
#include <SQLiteCpp/VariadicBind.h>

#include <cmath>
#include <optional>
#include <variant>

#include "experiments/store/optional_values.hpp"

namespace impetus::inline store {
namespace {

void bind_number(SQLite::Statement& statement, int index, double number) {
  if (std::floor(number) == number && std::abs(number) < 1e15) {
    statement.bind(index, static_cast<std::int64_t>(number));
  } else {
    statement.bind(index, number);
  }
}

void bind_level(SQLite::Statement& statement, int index, const LevelValue& value) {
  if (const auto* number = std::get_if<double>(&value)) {
    bind_number(statement, index, *number);
  } else if (const auto* text = std::get_if<std::string>(&value)) {
    statement.bind(index, *text);
  } else {
    statement.bind(index, std::get<bool>(value) ? "true" : "false");
  }
}

void insert_clicks(SQLite::Database& database, std::int64_t id,
                   const std::vector<ClickRecord>& clicks) {
  SQLite::Statement insert(database,
                           "INSERT INTO click (attempt_id, number, device, arrived_ns, "
                           "arrival_uncertainty_ns, interval) VALUES (?, ?, ?, ?, ?, ?)");
  std::int64_t number = 0;
  for (const ClickRecord& click : clicks) {
    SQLite::bind(insert, id, ++number, click.device, click.arrived_ns, click.arrival_uncertainty_ns,
                 click.interval);
    insert.exec();
    insert.reset();
  }
}

void insert_ratings(SQLite::Database& database, std::int64_t id,
                    const std::vector<RatingRecord>& ratings) {
  SQLite::Statement insert(database, "INSERT INTO rating VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
  for (const RatingRecord& rating : ratings) {
    SQLite::bind(insert, id, rating.rating, rating.minimum, rating.maximum, rating.best,
                 rating.low_anchor, rating.high_anchor, rating.device, rating.question_shown_ns,
                 rating.arrived_ns, rating.arrival_uncertainty_ns);
    insert.exec();
    insert.reset();
  }
}

void insert_responses(SQLite::Database& database, std::int64_t id,
                      const std::vector<ResponseRecord>& responses) {
  SQLite::Statement insert(database,
                           "INSERT INTO response (attempt_id, number, kind, question, answer, "
                           "detail, device, question_shown_ns, arrived_ns, arrival_uncertainty_ns, "
                           "timed_out, positive, correct) "
                           "VALUES (?, ?, ?, ?, nullif(?, ''), ?, ?, ?, ?, ?, ?, ?, ?)");
  std::int64_t number = 0;
  for (const ResponseRecord& response : responses) {
    SQLite::bind(insert, id, ++number, response.kind, response.question, response.answer,
                 json_object_of(database, response.detail), response.device,
                 response.question_shown_ns, response.arrived_ns, response.arrival_uncertainty_ns,
                 response.timed_out ? 1 : 0);
    bind_or_null(insert, 12, response.positive);
    bind_or_null(insert, 13, response.correct);
    insert.exec();
    insert.reset();
    insert.clearBindings();
  }
}

}  // namespace

std::string json_object_of(SQLite::Database& database, const std::vector<FactorLevel>& values) {
  std::string sql = "SELECT json_object(";
  for (const FactorLevel& value : values) {
    sql += sql.back() == '(' ? "?, " : ", ?, ";
    sql += std::holds_alternative<bool>(value.value) ? "json(?)" : "?";
  }
  SQLite::Statement query(database, sql + ")");
  int index = 0;
  for (const FactorLevel& value : values) {
    query.bind(++index, value.factor);
    bind_level(query, ++index, value.value);
  }
  query.executeStep();
  return query.getColumn(0).getString();
}

void insert_answers(SQLite::Database& database, std::int64_t attempt_id,
                    const AttemptRecord& attempt) {
  insert_clicks(database, attempt_id, attempt.clicks);
  insert_ratings(database, attempt_id, attempt.ratings);
  insert_responses(database, attempt_id, attempt.responses);
}

}  // namespace impetus::inline store
