// A query of a study whose columns tell where they come from.
// SPDX-License-Identifier: MIT
#pragma once

#include <SQLiteCpp/Database.h>
#include <sqlite3.h>

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace impetus::inline exports {

/// The table's column that a query's column is, unchanged.
struct ColumnOrigin {
  std::string table;
  std::string column;
};

/// Rows of a query, one after another, whose values keep their types.
class RowQuery {
 public:
  /// `parameters` are the texts ?1, ?2, ... Throws StoreError, here and in step(), with what the
  /// database says.
  RowQuery(SQLite::Database& database, const std::string& sql,
           const std::vector<std::string>& parameters = {});

  /// Whether there is another row, which is then the present one.
  bool step();

  [[nodiscard]] int columns() const;
  [[nodiscard]] std::string name(int column) const;
  [[nodiscard]] ColumnOrigin origin(int column) const;  ///< empty when it is computed

  /// Of the present row: SQLITE_NULL, _INTEGER, _FLOAT, _TEXT or _BLOB.
  [[nodiscard]] int type(int column) const;
  [[nodiscard]] bool is_null(int column) const { return type(column) == SQLITE_NULL; }
  [[nodiscard]] std::int64_t integer(int column) const;
  [[nodiscard]] double number(int column) const;
  [[nodiscard]] std::string_view bytes(int column) const;  ///< text or bytes, until the next step()
  [[nodiscard]] std::string text(int column) const { return std::string(bytes(column)); }

 private:
  /// Lets go of a statement.
  struct Finalise {
    void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
  };

  [[noreturn]] void fail() const;

  sqlite3* database_;
  std::unique_ptr<sqlite3_stmt, Finalise> statement_;
};

}  // namespace impetus::inline exports
