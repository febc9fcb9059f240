// SPDX-License-Identifier: MIT
#include "experiments/exports/row_query.hpp"

#include "experiments/store/study_file.hpp"

namespace impetus::inline exports {
namespace {

std::string text_or_none(const char* text) { return text == nullptr ? "" : text; }

}  // namespace

RowQuery::RowQuery(SQLite::Database& database, const std::string& sql,
                   const std::vector<std::string>& parameters)
    : database_(database.getHandle()) {
  sqlite3_stmt* statement = nullptr;
  if (sqlite3_prepare_v2(database_, sql.c_str(), -1, &statement, nullptr) != SQLITE_OK) {
    fail();
  }
  statement_.reset(statement);
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const auto size = static_cast<int>(parameters[i].size());
    if (sqlite3_bind_text(statement, static_cast<int>(i) + 1, parameters[i].c_str(), size,
                          SQLITE_TRANSIENT) != SQLITE_OK) {
      fail();
    }
  }
}

bool RowQuery::step() {
  const int result = sqlite3_step(statement_.get());
  if (result != SQLITE_ROW && result != SQLITE_DONE) {
    fail();
  }
  return result == SQLITE_ROW;
}

int RowQuery::columns() const { return sqlite3_column_count(statement_.get()); }

std::string RowQuery::name(int column) const {
  return text_or_none(sqlite3_column_name(statement_.get(), column));
}

ColumnOrigin RowQuery::origin(int column) const {
  return {text_or_none(sqlite3_column_table_name(statement_.get(), column)),
          text_or_none(sqlite3_column_origin_name(statement_.get(), column))};
}

int RowQuery::type(int column) const { return sqlite3_column_type(statement_.get(), column); }

std::int64_t RowQuery::integer(int column) const {
  return sqlite3_column_int64(statement_.get(), column);
}

double RowQuery::number(int column) const {
  return sqlite3_column_double(statement_.get(), column);
}

std::string_view RowQuery::bytes(int column) const {
  const void* start = sqlite3_column_blob(statement_.get(), column);
  const auto size = static_cast<std::size_t>(sqlite3_column_bytes(statement_.get(), column));
  return start == nullptr ? std::string_view()
                          : std::string_view(static_cast<const char*>(start), size);
}

void RowQuery::fail() const {
  throw StoreError("the study could not be read (" + std::string(sqlite3_errmsg(database_)) + ")");
}

}  // namespace impetus::inline exports
