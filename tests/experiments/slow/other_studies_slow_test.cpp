// Whole studies: ten minutes of eighty bodies by seven schedulers, and the response study.
// SPDX-License-Identifier: MIT
#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "tests/experiments/program.hpp"

namespace impetus {
namespace {

const std::string kSource = IMPETUS_SOURCE_DIR;

/// Of a scheduler's collisions of two bodies, the share of high priority in equal parts of what
/// `column` spans between its 1st and 99th percentile.
class Distribution {
 public:
  Distribution(SQLite::Database& database, const std::string& scheduler, const std::string& column)
      : database_(database), scheduler_(scheduler), column_(column) {}

  [[nodiscard]] std::vector<double> shares(int parts) const {
    SQLite::Statement query(
        database_,
        "WITH ranked AS (SELECT list, ntile(" + std::to_string(parts) + ") OVER (ORDER BY " +
            column_ +
            ") AS part FROM collision JOIN attempt ON attempt.id = attempt_id "
            "JOIN trial ON trial.id = trial_id WHERE body_b NOT LIKE 'wall%' "
            "AND json_extract(condition, '$.scheduler') = ?) "
            "SELECT avg(list = 0) FROM ranked GROUP BY part ORDER BY part");
    query.bind(1, scheduler_);
    std::vector<double> shares;
    while (query.executeStep()) {
      shares.push_back(query.getColumn(0).getDouble());
    }
    return shares;
  }

 private:
  SQLite::Database& database_;
  std::string scheduler_;
  std::string column_;
};

}  // namespace
}  // namespace impetus
