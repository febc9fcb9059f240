// SPDX-License-Identifier: MIT
#include "experiments/power/power_ledger.hpp"

#include <SQLiteCpp/Statement.h>
#include <SQLiteCpp/Transaction.h>

#include <algorithm>
#include <set>
#include <tuple>

#include "experiments/power/embedded_ledger.hpp"
#include "experiments/power/process_mark.hpp"
#include "experiments/settings/input_error.hpp"

namespace impetus::inline power {
namespace {

constexpr int kApplicationId = 0x494d5057;  // "IMPW"
constexpr int kPatience_ms = 60000;         // for another process that writes

/// Number, participants, with the effect or without.
using DoneStudies = std::set<std::tuple<std::int64_t, std::int64_t, bool>>;

/// A column of the ledger's question, what it is in words, and where it stands in the struct.
struct Column {
  const char* name;
  const char* words;
  std::string PowerQuestion::*place;
};

const std::vector<Column>& columns() {
  using Q = PowerQuestion;
  static const std::vector<Column> columns{
      {"protocol", "protocol", &Q::protocol},
      {"protocol_hash", "version of the protocol", &Q::protocol_hash},
      {"observer", "observer", &Q::observer},
      {"null_observer", "observer without the effect", &Q::null_observer},
      {"screen", "screen", &Q::screen},
      {"response", "response", &Q::response},
      {"model", "model", &Q::model},
      {"factors", "choice of factors", &Q::factors},
      {"compared", "pair of levels", &Q::compared}};
  return columns;
}

void create(SQLite::Database& database, const PowerQuestion& question) {
  database.exec(kLedgerSql);
  database.exec("PRAGMA application_id = " + std::to_string(kApplicationId));
  std::string names = "id, created_utc, seed";
  std::string marks = "1, strftime('%Y-%m-%dT%H:%M:%fZ'), :seed";
  for (const Column& column : columns()) {
    names += std::string(", ") + column.name;
    marks += std::string(", :") + column.name;
  }
  SQLite::Statement insert(database, "INSERT INTO question (" + names + ") VALUES (" + marks + ")");
  insert.bind(":seed", question.seed);
  for (const Column& column : columns()) {
    insert.bind(std::string(":") + column.name, question.*column.place);
  }
  insert.exec();
}

void require_same(SQLite::Database& database, const PowerQuestion& question,
                  const std::string& name) {
  const auto refuse = [&](const std::string& words) {
    throw InputError(name + ": expected a ledger of the same question, got one of another " +
                     words + "; give another --out");
  };
  SQLite::Statement kept(database, "SELECT * FROM question");
  if (!kept.executeStep()) {
    throw InputError(name + ": expected a ledger of a power analysis, got one without a question");
  }
  for (const Column& column : columns()) {
    if (kept.getColumn(column.name).getString() != question.*column.place) {
      refuse(column.words);
    }
  }
  if (kept.getColumn("seed").getInt64() != question.seed) {
    refuse("seed");
  }
}

/// Makes the tables where there are none, in one transaction whoever else does.
void create_or_check(SQLite::Database& database, const PowerQuestion& question,
                     const std::string& name) {
  SQLite::Transaction transaction(database, SQLite::TransactionBehavior::IMMEDIATE);
  const bool empty = database.execAndGet("SELECT count(*) FROM sqlite_master").getInt() == 0;
  if (empty) {
    create(database, question);
  } else if (database.execAndGet("PRAGMA application_id").getInt() != kApplicationId) {
    throw InputError(name + ": expected a ledger of a power analysis, got another database");
  } else {
    require_same(database, question, name);
  }
  transaction.commit();
}

DoneStudies done_studies(SQLite::Database& database) {
  DoneStudies done;
  SQLite::Statement row(database, "SELECT number, participants, effect FROM study");
  while (row.executeStep()) {
    done.emplace(row.getColumn(0).getInt64(), row.getColumn(1).getInt64(),
                 row.getColumn(2).getInt() == 1);
  }
  return done;
}

/// What others are at; forgets those who have ended.
DoneStudies taken_cells(SQLite::Database& database) {
  std::set<std::string> ended;
  DoneStudies taken;
  SQLite::Statement row(database, "SELECT number, effect, process FROM taken");
  while (row.executeStep()) {
    const std::string process = row.getColumn(2).getString();
    if (still_runs(process)) {
      taken.emplace(row.getColumn(0).getInt64(), 0, row.getColumn(1).getInt() == 1);
    } else {
      ended.insert(process);
    }
  }
  row.reset();
  for (const std::string& process : ended) {
    SQLite::Statement forget(database, "DELETE FROM taken WHERE process = ?");
    forget.bind(1, process);
    forget.exec();
  }
  return taken;
}

/// Numbers rise, each with the effect and then without: what is done first tells of both.
template <typename Visit>
void visit_missing(const PowerRequest& request, const DoneStudies& done, const Visit& visit) {
  const std::int64_t most = std::max(request.studies, request.null_studies);
  for (std::int64_t number = 1; number <= most; ++number) {
    for (const bool effect : {true, false}) {
      if (number > (effect ? request.studies : request.null_studies)) {
        continue;
      }
      PowerCell cell{effect, number, {}};
      for (const std::int64_t size : request.sizes) {
        if (done.count({number, size, effect}) == 0) {
          cell.sizes.push_back(size);
        }
      }
      if (!cell.sizes.empty() && !visit(cell)) {
        return;
      }
    }
  }
}

}  // namespace

PowerLedger::PowerLedger(const std::filesystem::path& path, const PowerQuestion& question) try
    : name_(path.string()),
      database_(name_, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE, kPatience_ms),
      process_(mark_of_this_process()) {
  create_or_check(database_, question, name_);
} catch (const SQLite::Exception& error) {
  throw InputError(path.string() +
                   ": expected a ledger of a power analysis that can be written: " + error.what());
}

PowerLedger::~PowerLedger() {
  try {
    SQLite::Statement forget(database_, "DELETE FROM taken WHERE process = ?");
    forget.bind(1, process_);
    forget.exec();
  } catch (const SQLite::Exception&) {  // then the next process finds that this one has ended
  }
}

std::vector<PowerCell> PowerLedger::take(const PowerRequest& request, std::size_t most) {
  const std::lock_guard lock(mutex_);
  SQLite::Transaction transaction(database_, SQLite::TransactionBehavior::IMMEDIATE);
  const DoneStudies taken = taken_cells(database_);
  std::vector<PowerCell> cells;
  visit_missing(request, done_studies(database_), [&](const PowerCell& cell) {
    if (taken.count({cell.number, 0, cell.effect}) == 0) {
      cells.push_back(cell);
    }
    return cells.size() < most;
  });
  for (const PowerCell& cell : cells) {
    SQLite::Statement row(database_,
                          "INSERT INTO taken (effect, number, process) VALUES (?, ?, ?)");
    row.bind(1, cell.effect ? 1 : 0);
    row.bind(2, cell.number);
    row.bind(3, process_);
    row.exec();
  }
  transaction.commit();
  return cells;
}

void PowerLedger::give_back(const std::vector<PowerCell>& cells) {
  const std::lock_guard lock(mutex_);
  SQLite::Transaction transaction(database_, SQLite::TransactionBehavior::IMMEDIATE);
  for (const PowerCell& cell : cells) {
    SQLite::Statement row(database_, "DELETE FROM taken WHERE effect = ? AND number = ?");
    row.bind(1, cell.effect ? 1 : 0);
    row.bind(2, cell.number);
    row.exec();
  }
  transaction.commit();
}

std::int64_t PowerLedger::missing(const PowerRequest& request) {
  const std::lock_guard lock(mutex_);
  std::int64_t count = 0;
  visit_missing(request, done_studies(database_), [&](const PowerCell& cell) {
    count += static_cast<std::int64_t>(cell.sizes.size());
    return true;
  });
  return count;
}

}  // namespace impetus::inline power
