// SPDX-License-Identifier: MIT
#include "experiments/store/merging/row_copy.hpp"

#include <SQLiteCpp/Statement.h>

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "experiments/store/study_schema.hpp"

namespace impetus::inline store {
namespace {

/// What the ids of one table's rows become.
struct NewIds {
  std::int64_t offset{0};
  std::map<std::int64_t, std::int64_t> present{};  ///< rows that the destination has already

  [[nodiscard]] std::int64_t of(std::int64_t id) const {
    const auto found = present.find(id);
    return found == present.end() ? id + offset : found->second;
  }
};

constexpr const char* kId = "id";

bool has_id(const std::vector<std::string>& columns) {
  return std::find(columns.begin(), columns.end(), kId) != columns.end();
}

std::int64_t largest_id(SQLite::Database& database, const std::string& table) {
  return database.execAndGet("SELECT coalesce(max(id), 0) FROM \"" + table + "\"").getInt64();
}

std::map<std::int64_t, std::int64_t> protocols_present(SQLite::Database& source,
                                                       SQLite::Database& destination) {
  std::map<std::int64_t, std::int64_t> present;
  SQLite::Statement theirs(source, "SELECT id, hash FROM protocol");
  while (theirs.executeStep()) {
    SQLite::Statement ours(destination, "SELECT id FROM protocol WHERE hash = ?");
    ours.bind(1, theirs.getColumn(1).getString());
    if (ours.executeStep()) {
      present[theirs.getColumn(0).getInt64()] = ours.getColumn(0).getInt64();
    }
  }
  return present;
}

std::string joined(const std::vector<std::string>& names, const std::string& quote) {
  std::string text;
  for (const std::string& name : names) {
    text += (text.empty() ? "" : ", ") + quote + name + quote;
  }
  return text;
}

void bind(SQLite::Statement& insert, int index, const SQLite::Column& value) {
  if (value.isInteger()) {
    insert.bind(index, value.getInt64());
  } else if (value.isFloat()) {
    insert.bind(index, value.getDouble());
  } else if (value.isText()) {
    insert.bind(index, value.getString());
  } else if (value.isBlob()) {
    insert.bind(index, value.getBlob(), value.getBytes());
  }
}

class RowCopy {
 public:
  RowCopy(SQLite::Database& source, SQLite::Database& destination)
      : source_(source), destination_(destination), tables_(table_names(destination)) {
    std::erase(tables_, "study");
    for (const std::string& table : tables_) {
      if (has_id(column_names(destination, table))) {
        ids_[table].offset = largest_id(destination, table);
      }
    }
    ids_["protocol"].present = protocols_present(source, destination);
  }

  void copy() {
    destination_.exec("PRAGMA defer_foreign_keys = ON");
    for (const std::string& table : tables_) {
      copy_table(table);
    }
  }

  [[nodiscard]] std::int64_t participants_before() const { return ids_.at("participant").offset; }

 private:
  void copy_table(const std::string& table) {
    const std::vector<std::string> columns = column_names(destination_, table);
    const std::vector<const NewIds*> changed = changed_columns(table, columns);
    const std::string names = joined(columns, "\"");
    SQLite::Statement select(source_, "SELECT " + names + " FROM \"" + table + "\"" +
                                          (has_id(columns) ? " ORDER BY id" : ""));
    SQLite::Statement insert(destination_, "INSERT INTO \"" + table + "\" (" + names +
                                               ") VALUES (" + placeholders(columns.size()) + ")");
    while (select.executeStep()) {
      if (!is_present(table, columns, select)) {
        bind_row(select, insert, changed);
        insert.exec();
        insert.reset();
        insert.clearBindings();
      }
    }
  }

  /// For each column, how its ids change; null where it holds none.
  std::vector<const NewIds*> changed_columns(const std::string& table,
                                             const std::vector<std::string>& columns) {
    std::vector<const NewIds*> changed(columns.size(), nullptr);
    const auto place = [&](const std::string& column) {
      return static_cast<std::size_t>(std::find(columns.begin(), columns.end(), column) -
                                      columns.begin());
    };
    if (has_id(columns)) {
      changed[place(kId)] = &ids_.at(table);
    }
    for (const Reference& reference : references_of(destination_, table)) {
      changed[place(reference.column)] = &ids_.at(reference.table);
    }
    return changed;
  }

  bool is_present(const std::string& table, const std::vector<std::string>& columns,
                  const SQLite::Statement& row) const {
    const auto ids = ids_.find(table);
    if (ids == ids_.end() || ids->second.present.empty()) {
      return false;
    }
    const auto id = std::find(columns.begin(), columns.end(), kId) - columns.begin();
    return ids->second.present.contains(row.getColumn(static_cast<int>(id)).getInt64());
  }

  static void bind_row(const SQLite::Statement& row, SQLite::Statement& insert,
                       const std::vector<const NewIds*>& changed) {
    for (std::size_t column = 0; column < changed.size(); ++column) {
      const SQLite::Column value = row.getColumn(static_cast<int>(column));
      const int index = static_cast<int>(column) + 1;
      if (changed[column] != nullptr && !value.isNull()) {
        insert.bind(index, changed[column]->of(value.getInt64()));
      } else {
        bind(insert, index, value);
      }
    }
  }

  static std::string placeholders(std::size_t count) {
    return joined(std::vector<std::string>(count, "?"), "");
  }

  SQLite::Database& source_;
  SQLite::Database& destination_;
  std::vector<std::string> tables_;
  std::map<std::string, NewIds> ids_;  ///< by table, of those that have ids
};

}  // namespace

std::int64_t copy_rows(SQLite::Database& source, SQLite::Database& destination) {
  RowCopy copy(source, destination);
  copy.copy();
  return copy.participants_before();
}

}  // namespace impetus::inline store
