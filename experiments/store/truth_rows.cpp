// SPDX-License-Identifier: MIT
#include "experiments/store/truth_rows.hpp"

#include <SQLiteCpp/Statement.h>
#include <SQLiteCpp/Transaction.h>
#include <SQLiteCpp/VariadicBind.h>

#include <algorithm>
#include <optional>

#include "experiments/record/wall_names.hpp"

namespace impetus::inline store {
namespace {

std::optional<std::int32_t> body_of(const std::string& name,
                                    const std::vector<std::string>& names) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) {
    return static_cast<std::int32_t>(found - names.begin());
  }
  return wall_named(name);
}

}  // namespace

std::vector<StoredCollision> load_collisions(StudyFile& study, std::int64_t attempt_id,
                                             const std::vector<std::string>& names,
                                             std::int64_t interval) {
  SQLite::Statement query(study.database(),
                          "SELECT id, step, body_a, body_b FROM collision WHERE attempt_id = ? "
                          "AND interval = ? ORDER BY id");
  query.bind(1, attempt_id);
  query.bind(2, interval);
  std::vector<StoredCollision> collisions;
  while (query.executeStep()) {
    const auto a = body_of(query.getColumn(2).getString(), names);
    const auto b = body_of(query.getColumn(3).getString(), names);
    if (a && b) {
      collisions.push_back(
          {query.getColumn(0).getInt64(), query.getColumn(1).getInt64(), {*a, *b}});
    }
  }
  return collisions;
}

void store_truths(StudyFile& study, const std::vector<MeasuredCollision>& collisions) {
  try {
    SQLite::Transaction transaction(study.database());
    SQLite::Statement insert(study.database(),
                             "INSERT OR REPLACE INTO collision_truth (collision_id, gap_m, gap_px, "
                             "gap_arcmin, hidden_share) VALUES (?, ?, ?, ?, ?)");
    for (const auto& [id, truth] : collisions) {
      SQLite::bind(insert, id, truth.gap_m, truth.gap_px, truth.gap_arcmin, truth.hidden_share);
      insert.exec();
      insert.reset();
    }
    transaction.commit();
  } catch (const SQLite::Exception& error) {
    throw StoreError(study.name() + ": the truth could not be saved: " + error.what());
  }
}

}  // namespace impetus::inline store
