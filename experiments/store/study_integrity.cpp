// SPDX-License-Identifier: MIT
#include "experiments/store/study_integrity.hpp"

#include <sqlite3.h>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <map>
#include <set>

#include "experiments/store/migration.hpp"
#include "experiments/store/read_only_file.hpp"
#include "experiments/store/rows.hpp"
#include "experiments/tables/number_text.hpp"

namespace impetus::inline store {
namespace {

/// Of one table, view or index: what it consists of.
using Parts = std::set<std::string>;

/// Where the comment or quotation that begins at `start` ends; `start` where none does.
std::size_t end_of_words(const std::string& sql, std::size_t start) {
  if (sql.compare(start, 2, "--") == 0) {
    return std::min(sql.find('\n', start), sql.size());
  }
  if (sql[start] == '\'' || sql[start] == '"') {
    const std::size_t end = sql.find(sql[start], start + 1);
    return end == std::string::npos ? sql.size() : end + 1;
  }
  return start;
}

/// Without comments, and with single spaces where there was any white space.
std::string plain(const std::string& sql) {
  std::string text;
  for (std::size_t at = 0; at < sql.size();) {
    const std::size_t end = end_of_words(sql, at);
    if (end > at) {
      text += sql[at] == '-' ? "" : sql.substr(at, end - at);
      at = end;
    } else if (std::isspace(static_cast<unsigned char>(sql[at])) != 0) {
      text += text.empty() || text.back() == ' ' ? "" : " ";
      ++at;
    } else {
      text += sql[at++];
    }
  }
  return text;
}

/// Where the bracket that opens at `start` is closed.
std::size_t closing_bracket(const std::string& sql, std::size_t start) {
  int depth = 0;
  for (std::size_t at = start; at < sql.size();) {
    const std::size_t end = end_of_words(sql, at);
    if (end > at) {
      at = end;
      continue;
    }
    depth += sql[at] == '(' ? 1 : sql[at] == ')' ? -1 : 0;
    if (depth == 0) {
      return at;
    }
    ++at;
  }
  return sql.size();
}

/// The checks of a table as it was declared.
void add_checks(const std::string& table_sql, Parts& parts) {
  const std::string sql = plain(table_sql);
  for (std::size_t at = sql.find("CHECK ("); at != std::string::npos;
       at = sql.find("CHECK (", at + 1)) {
    parts.insert(sql.substr(at, closing_bracket(sql, at + 6) + 1 - at));
  }
}

Parts parts_of_table(SQLite::Database& database, const std::string& name, const std::string& sql) {
  Parts parts;
  const auto add = [&](const std::string& query) {
    for (const std::string& part : load_column<std::string>(database, query, name)) {
      parts.insert(part);
    }
  };
  add("SELECT 'the column ' || name || ' ' || type || iif(\"notnull\", ' NOT NULL', '') || "
      "coalesce(' DEFAULT ' || dflt_value, '') || iif(pk, ' PRIMARY KEY ' || pk, '') "
      "FROM pragma_table_xinfo(?)");
  add("SELECT 'the reference of ' || \"from\" || ' to ' || \"table\" || ' ' || on_update || ' ' || "
      "on_delete FROM pragma_foreign_key_list(?)");
  add("SELECT 'the ' || iif(strict, 'STRICT ', '') || iif(wr, 'WITHOUT ROWID ', '') || 'kind' "
      "FROM pragma_table_list(?) WHERE schema = 'main'");
  add("SELECT 'the uniqueness of ' || (SELECT group_concat(name, ', ') FROM "
      "pragma_index_info(list.name)) FROM pragma_index_list(?) AS list WHERE \"unique\"");
  add_checks(sql, parts);
  return parts;
}

/// By "table rating", "view rated_trial", ...
std::map<std::string, Parts> objects_of(SQLite::Database& database) {
  std::map<std::string, Parts> objects;
  for (const auto& [type, name, sql] : load_rows<std::string, std::string, std::string>(
           database,
           "SELECT type, name, sql FROM sqlite_master "
           "WHERE name NOT LIKE 'sqlite\\_%' ESCAPE '\\'")) {
    objects[type + " " + name] =
        type == "table" ? parts_of_table(database, name, sql) : Parts{plain(sql)};
  }
  return objects;
}

void compare_parts(const std::string& object, const Parts& expected, const Parts& found,
                   std::vector<std::string>& differences) {
  if (object.compare(0, 6, "table ") != 0) {
    if (expected != found) {
      differences.push_back("the " + object + " is not as this build makes it");
    }
    return;
  }
  const auto add_missing = [&](const Parts& from, const Parts& in, const std::string& verb) {
    std::vector<std::string> missing;
    std::set_difference(from.begin(), from.end(), in.begin(), in.end(),
                        std::back_inserter(missing));
    for (const std::string& part : missing) {
      differences.push_back("the " + object + verb + part);
    }
  };
  add_missing(expected, found, " lacks ");
  add_missing(found, expected, " has, beyond what this build makes, ");
}

/// What a check is true of may be unknown, too; then the row is allowed.
std::int64_t rows_against(SQLite::Database& study, const std::string& table,
                          const std::string& check) {
  const std::string condition = check.substr(std::string("CHECK ").size());
  return study.execAndGet("SELECT count(*) FROM \"" + table + "\" WHERE NOT " + condition)
      .getInt64();
}

void add_damaged_pages_and_values(SQLite::Database& database, std::vector<std::string>& damage) {
  for (const std::string& found : load_column<std::string>(database, "PRAGMA integrity_check")) {
    if (found != "ok") {
      damage.push_back("SQLite's check of its integrity: " + found);
    }
  }
}

void add_broken_references(SQLite::Database& database, std::vector<std::string>& damage) {
  for (const auto& [table, parent, rows] : load_rows<std::string, std::string, std::int64_t>(
           database,
           "SELECT \"table\", parent, count(*) FROM pragma_foreign_key_check "
           "GROUP BY \"table\", parent, fkid")) {
    damage.push_back(count_of(rows, "row") + " of " + table + (rows == 1 ? " refers" : " refer") +
                     " to a row of " + parent + " that is missing");
  }
}

}  // namespace

std::vector<std::string> forbidden_rows(SQLite::Database& study) {
  std::vector<std::string> broken;
  for (const auto& [table, sql] : load_rows<std::string, std::string>(
           study, "SELECT name, sql FROM sqlite_master WHERE type = 'table'")) {
    Parts checks;
    add_checks(sql, checks);
    for (const std::string& check : checks) {
      if (const std::int64_t rows = rows_against(study, table, check); rows > 0) {
        broken.push_back(count_of(rows, "row") + " of " + table +
                         (rows == 1 ? " breaks " : " break ") + check);
      }
    }
  }
  return broken;
}

std::vector<std::string> schema_differences(SQLite::Database& study) {
  SQLite::Database reference(":memory:", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
  create_tables_and_views(reference);
  const auto expected = objects_of(reference);
  const auto found = objects_of(study);
  std::vector<std::string> differences;
  for (const auto& [object, parts] : expected) {
    const auto there = found.find(object);
    if (there == found.end()) {
      differences.push_back("the " + object + kIsMissing);
    } else {
      compare_parts(object, parts, there->second, differences);
    }
  }
  for (const auto& [object, parts] : found) {
    if (!expected.contains(object)) {
      differences.push_back("the " + object + " is none of a study's");
    }
  }
  return differences;
}

std::vector<std::string> table_names(SQLite::Database& database) {
  return load_column<std::string>(database,
                                  "SELECT name FROM sqlite_master WHERE type = 'table' "
                                  "AND name NOT LIKE 'sqlite\\_%' ESCAPE '\\' ORDER BY name");
}

std::vector<std::string> column_names(SQLite::Database& database, const std::string& table) {
  return load_column<std::string>(database, "SELECT name FROM pragma_table_info(?) ORDER BY cid",
                                  table);
}

std::vector<Reference> references_of(SQLite::Database& database, const std::string& table) {
  return load_as<Reference, std::string, std::string>(
      database, "SELECT \"from\", \"table\" FROM pragma_foreign_key_list(?) ORDER BY \"from\"",
      table);
}

std::vector<std::string> damage_in(SQLite::Database& database) {
  std::vector<std::string> damage;
  try {
    add_damaged_pages_and_values(database, damage);
    add_broken_references(database, damage);
  } catch (const SQLite::Exception& error) {
    if (error.getErrorCode() != SQLITE_NOTADB) {
      damage.push_back(std::string("it cannot be read whole: ") + error.what());
    }
  }
  return damage;
}

std::vector<std::string> damage_in(const std::filesystem::path& path) {
  try {
    return damage_in(*open_read_only(path));
  } catch (const SQLite::Exception& error) {
    return {std::string("it cannot be read: ") + error.what()};
  }
}

}  // namespace impetus::inline store
