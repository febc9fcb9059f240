// SPDX-License-Identifier: MIT
#include "experiments/store/merging/study_merge.hpp"

#include <SQLiteCpp/Transaction.h>

#include <algorithm>
#include <deque>
#include <map>

#include "experiments/settings/input_error.hpp"
#include "experiments/store/merging/merge_part.hpp"
#include "experiments/store/read_only_file.hpp"
#include "experiments/store/rows.hpp"
#include "experiments/store/study_integrity.hpp"

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
  for (const auto& [theirs, hash] :
       load_rows<std::int64_t, std::string>(source, "SELECT id, hash FROM protocol")) {
    if (const auto ours =
            load_value<std::int64_t>(destination, "SELECT id FROM protocol WHERE hash = ?", hash)) {
      present[theirs] = *ours;
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
    const int bytes = value.getBytes();  // of none there is no address, and NULL would be bound
    insert.bind(index, bytes > 0 ? value.getBlob() : "", bytes);
  }
}

/// Puts all rows of one study into another, with ids of their own there.
///
///   id in the source ──+ largest id there before──> id in the destination; references go along
///   a protocol that is there already ─────────────> that one's id
///
/// It knows tables by the schema alone: ids are columns called `id`, references are declared. Both
/// studies are of the present schema.
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

  /// Copies every row but that of the table study; of a protocol only what the destination lacks.
  /// References may be broken until the end of the destination's transaction, which must be open.
  void copy() {
    destination_.exec("PRAGMA defer_foreign_keys = ON");
    for (const std::string& table : tables_) {
      copy_table(table);
    }
  }

  /// The largest id of a participant that was there before: those beyond it are the source's.
  [[nodiscard]] std::int64_t participants_before() const { return ids_.at("participant").offset; }

 private:
  void copy_table(const std::string& table) {
    const std::vector<std::string> columns = column_names(destination_, table);
    const std::vector<const NewIds*> changed = changed_columns(table, columns);
    const std::string names = joined(columns, "\"");
    SQLite::Statement select(source_, "SELECT " + names + " FROM \"" + table + "\"" +
                                          (has_id(columns) ? " ORDER BY id" : ""));
    const std::string places = joined(std::vector<std::string>(columns.size(), "?"), "");
    SQLite::Statement insert(
        destination_, "INSERT INTO \"" + table + "\" (" + names + ") VALUES (" + places + ")");
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

  SQLite::Database& source_;
  SQLite::Database& destination_;
  std::vector<std::string> tables_;
  std::map<std::string, NewIds> ids_;  ///< by table, of those that have ids
};

void require_not_a_source(const std::vector<std::filesystem::path>& sources,
                          const std::filesystem::path& into) {
  for (const std::filesystem::path& source : sources) {
    if (holds_anything(into) && holds_anything(source) &&
        std::filesystem::equivalent(source, into)) {
      throw InputError("--into " + into.string() +
                       ": expected a study other than those that are merged");
    }
  }
}

/// The sources; before them the destination, unless it is new, for as long as they are compared.
std::deque<MergePart> comparable_parts(const std::vector<std::filesystem::path>& sources,
                                       const std::filesystem::path& into, bool is_new) {
  std::deque<MergePart> parts;
  if (!is_new) {
    parts.push_back(open_merge_part(into));
  }
  for (const std::filesystem::path& source : sources) {
    parts.push_back(open_merge_part(source));
  }
  require_one_study(parts);
  return parts;
}

/// Participants that came straight from the file's own sessions are the file's; others keep the
/// file that they came from before.
void add_part(MergePart& part, SQLite::Database& destination) {
  RowCopy copy(part.study.database(), destination);
  copy.copy();
  const auto [created_utc, build] = load_row<std::string, std::string>(
      part.study.database(), "SELECT created_utc, build FROM study");
  const std::int64_t file =
      insert_row(destination, "merged_file",
                 {{"name", std::filesystem::path(part.study.name()).filename().string()},
                  {"hash", part.hash},
                  {"created_utc", created_utc},
                  {"build", build},
                  {"merged_utc", Now()}});
  execute(destination,
          "UPDATE participant SET merged_file_id = ? WHERE id > ? AND merged_file_id IS NULL", file,
          copy.participants_before());
}

MergeResult add_parts(std::deque<MergePart>& parts, StudyFile& study) {
  SQLite::Database& database = study.database();
  const std::int64_t before = count_rows(database, "participant");
  SQLite::Transaction transaction(database);
  for (MergePart& part : parts) {
    add_part(part, database);
  }
  MergeResult result;
  result.participants = count_rows(database, "participant");
  result.participants_added = result.participants - before;
  result.completed_trials = count_rows(database, "attempt WHERE outcome = 'completed'");
  transaction.commit();
  return result;
}

/// A study that was made for a merge which then failed is none.
void remove_study(const std::filesystem::path& path) {
  std::error_code ignored;
  for (const char* ending : {"", "-wal", "-shm"}) {
    std::filesystem::remove(path.string() + ending, ignored);
  }
}

}  // namespace

MergeResult merge_studies(const std::vector<std::filesystem::path>& sources,
                          const std::filesystem::path& into, const std::string& build) {
  require_not_a_source(sources, into);
  const bool is_new = !holds_anything(into);
  std::deque<MergePart> parts = comparable_parts(sources, into, is_new);
  StudyIdentity compared;
  if (!is_new) {
    compared = parts.front().identity;
    parts.pop_front();  // its lock goes too: it is opened for writing
  }
  bool is_ours = false;
  try {
    StudyFile study = StudyFile::open_for_writing(into, build);
    if (identity_of(study) != compared) {
      throw InputError(into.string() +
                       ": another process changed it while the studies were compared; nothing was "
                       "merged");
    }
    is_ours = is_new;
    return add_parts(parts, study);
  } catch (const SQLite::Exception& error) {
    if (is_ours) {
      remove_study(into);
    }
    throw StoreError(into.string() + ": could not be written (" + error.what() +
                     "); nothing was merged");
  }
}

}  // namespace impetus::inline store
