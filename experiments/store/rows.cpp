// SPDX-License-Identifier: MIT
#include "experiments/store/rows.hpp"

namespace impetus::inline store {
namespace {

void bind(SQLite::Statement& statement, int index, const RowValue& value) {
  if (const auto* integer = std::get_if<std::int64_t>(&value)) {
    statement.bind(index, *integer);
  } else if (const auto* number = std::get_if<double>(&value)) {
    statement.bind(index, *number);
  } else if (const auto* text = std::get_if<std::string>(&value)) {
    statement.bind(index, *text);
  } else if (const auto* blob = std::get_if<Bytes>(&value)) {
    statement.bind(index, blob->bytes.data(), static_cast<int>(blob->bytes.size()));
  }
}

/// With a place for each value, but for moments, which SQLite tells itself.
std::string insertion(const std::string& table, std::initializer_list<Cell> cells) {
  std::string columns;
  std::string places;
  for (const Cell& cell : cells) {
    const bool is_now = std::holds_alternative<Now>(cell.value);
    columns += (columns.empty() ? "" : ", ") + std::string(cell.column);
    places +=
        (places.empty() ? "" : ", ") + std::string(is_now ? "strftime('%Y-%m-%dT%H:%M:%fZ')" : "?");
  }
  return "INSERT INTO " + table + " (" + columns + ") VALUES (" + places + ")";
}

}  // namespace

std::int64_t RowInsert::insert(std::initializer_list<Cell> cells) {
  if (!statement_) {
    statement_.emplace(database_, insertion(table_, cells));
  }
  statement_->reset();
  statement_->clearBindings();
  int index = 0;
  for (const Cell& cell : cells) {
    if (!std::holds_alternative<Now>(cell.value)) {
      bind(*statement_, ++index, cell.value);
    }
  }
  statement_->exec();
  return database_.getLastInsertRowid();
}

}  // namespace impetus::inline store
