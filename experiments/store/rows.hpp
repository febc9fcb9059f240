// Rows of a study with their columns named: what is written stands beside its column, what is read
// comes as the types that are asked for.
// SPDX-License-Identifier: MIT
#pragma once

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>

#include <concepts>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace impetus::inline store {

/// As a value: the moment of writing by the wall clock, in UTC.
struct Now {};

/// As a value: bytes that are no text.
struct Bytes {
  std::string bytes;
};

/// What can stand in a row; the first is NULL.
using RowValue = std::variant<std::monostate, Now, std::int64_t, double, std::string, Bytes>;

/// A text, or NULL where it is empty.
inline std::optional<std::string> text_or_null(const std::string& text) {
  return text.empty() ? std::nullopt : std::optional(text);
}

/// A value of a row and the column that it goes into. What an optional lacks is NULL, a truth is 0
/// or 1, and of an unsigned number the 64 bits are kept.
struct Cell {
  template <typename T>
  Cell(const char* column_name, const T& content) : column(column_name), value(value_of(content)) {}

  const char* column;
  RowValue value;

 private:
  template <std::integral T>
  static RowValue value_of(T number) {
    return static_cast<std::int64_t>(number);
  }
  template <typename T>
  static RowValue value_of(const std::optional<T>& content) {
    return content ? value_of(*content) : RowValue{};
  }
  static RowValue value_of(double number) { return number; }
  static RowValue value_of(std::string text) { return text; }
  static RowValue value_of(Bytes bytes) { return bytes; }
  static RowValue value_of(Now now) { return now; }
};

/// Inserts rows into one table, all with the same columns in the same order.
class RowInsert {
 public:
  /// `table` outlives this, as `database` does.
  RowInsert(SQLite::Database& database, const char* table) : database_(database), table_(table) {}

  /// Returns the id of the new row. Throws SQLite::Exception.
  std::int64_t insert(std::initializer_list<Cell> cells);

 private:
  SQLite::Database& database_;
  const char* table_;
  std::optional<SQLite::Statement> statement_;  ///< made for the first row
};

/// The same for a single row.
inline std::int64_t insert_row(SQLite::Database& database, const char* table,
                               std::initializer_list<Cell> cells) {
  return RowInsert(database, table).insert(cells);
}

/// Runs a statement with its parameters; returns how many rows it changed. Throws
/// SQLite::Exception.
template <typename... Values>
int execute(SQLite::Database& database, const std::string& sql, const Values&... values) {
  SQLite::Statement statement(database, sql);
  [[maybe_unused]] int index = 0;
  (statement.bind(++index, values), ...);
  return statement.exec();
}

/// A column of the present row as a T. NULL is what an optional lacks, else "" or 0.
template <typename T>
T column_as(const SQLite::Column& column) {
  if constexpr (std::is_same_v<T, std::string>) {
    return column.isNull() ? "" : column.getString();
  } else if constexpr (std::is_same_v<T, bool>) {
    return column.getInt64() != 0;
  } else if constexpr (std::is_floating_point_v<T>) {
    return column.getDouble();
  } else if constexpr (std::is_integral_v<T>) {
    return static_cast<T>(column.getInt64());
  } else {
    return column.isNull() ? T() : T(column_as<typename T::value_type>(column));
  }
}

/// The columns of a query's present row one after another, each into a variable of its type.
class NextColumn {
 public:
  explicit NextColumn(SQLite::Statement& query) : query_(query) {}

  template <typename T>
  NextColumn& operator>>(T& variable) {
    variable = column_as<T>(query_.getColumn(next_++));
    return *this;
  }

 private:
  SQLite::Statement& query_;
  int next_{0};
};

/// All rows of a query with these parameters, by the types of their columns. Throws
/// SQLite::Exception.
template <typename... Columns, typename... Values>
std::vector<std::tuple<Columns...>> load_rows(SQLite::Database& database, const std::string& sql,
                                              const Values&... values) {
  SQLite::Statement query(database, sql);
  [[maybe_unused]] int index = 0;
  (query.bind(++index, values), ...);
  std::vector<std::tuple<Columns...>> rows;
  while (query.executeStep()) {
    [&]<std::size_t... kPlaces>(std::index_sequence<kPlaces...>) {
      rows.emplace_back(column_as<Columns>(query.getColumn(static_cast<int>(kPlaces)))...);
    }
    (std::index_sequence_for<Columns...>());
  }
  return rows;
}

/// The same as aggregates, whose first members the columns are.
template <typename Row, typename... Columns, typename... Values>
std::vector<Row> load_as(SQLite::Database& database, const std::string& sql,
                         const Values&... values) {
  std::vector<Row> rows;
  for (auto& columns : load_rows<Columns...>(database, sql, values...)) {
    rows.push_back(std::apply([](auto&... column) { return Row{std::move(column)...}; }, columns));
  }
  return rows;
}

/// The only row of a query; where there is none, that is a SQLite::Exception, too.
template <typename... Columns, typename... Values>
std::tuple<Columns...> load_row(SQLite::Database& database, const std::string& sql,
                                const Values&... values) {
  auto rows = load_rows<Columns...>(database, sql, values...);
  if (rows.empty()) {
    throw SQLite::Exception("No row to get a column from.");
  }
  return std::move(rows.front());
}

/// How many rows there are of what stands behind FROM.
inline std::int64_t count_rows(SQLite::Database& database, const std::string& from) {
  return std::get<0>(load_row<std::int64_t>(database, "SELECT count(*) FROM " + from));
}

/// The only column of all rows of a query.
template <typename Column, typename... Values>
std::vector<Column> load_column(SQLite::Database& database, const std::string& sql,
                                const Values&... values) {
  std::vector<Column> column;
  for (auto& [value] : load_rows<Column>(database, sql, values...)) {
    column.push_back(std::move(value));
  }
  return column;
}

/// The only column of the first row, if there is one.
template <typename Column, typename... Values>
std::optional<Column> load_value(SQLite::Database& database, const std::string& sql,
                                 const Values&... values) {
  const auto rows = load_rows<Column>(database, sql, values...);
  return rows.empty() ? std::nullopt : std::optional(std::get<0>(rows.front()));
}

}  // namespace impetus::inline store
