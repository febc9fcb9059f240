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

void create(SQLite::Database& database, const PowerQuestion& question) {
  database.exec(kLedgerSql);
  database.exec("PRAGMA application_id = " + std::to_string(kApplicationId));
  std::string names = "id, created_utc, seed";
  std::string marks = "1, strftime('%Y-%m-%dT%H:%M:%fZ'), :seed";
  for (const QuestionText& column : question_texts()) {
    names += std::string(", ") + column.name;
    marks += std::string(", :") + column.name;
  }
  SQLite::Statement insert(database, "INSERT INTO question (" + names + ") VALUES (" + marks + ")");
  insert.bind(":seed", question.seed);
  for (const QuestionText& column : question_texts()) {
    insert.bind(std::string(":") + column.name, question.*column.place);
  }
  insert.exec();
}

void require_same(SQLite::Database& database, const PowerQuestion& question,
                  const std::string& name) {
  SQLite::Statement row(database, "SELECT * FROM question");
  if (!row.executeStep()) {
    throw InputError(name + ": expected a ledger of a power analysis, got one without a question");
  }
  PowerQuestion kept;
  kept.seed = row.getColumn("seed").getInt64();
  for (const QuestionText& column : question_texts()) {
    kept.*column.place = row.getColumn(column.name).getString();
  }
  if (const std::string words = difference(kept, question); !words.empty()) {
    throw InputError(name + ": expected a ledger of the same question, got one of another " +
                     words + "; give another --out");
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

template <typename Visit>
void visit_missing(const PowerRequest& request, const DoneStudies& done, const Visit& visit) {
  for (PowerCell& cell : cells_of(request)) {
    std::erase_if(cell.sizes, [&](std::int64_t size) {
      return done.count({cell.number, size, cell.effect}) > 0;
    });
    if (!cell.sizes.empty() && !visit(cell)) {
      return;
    }
  }
}

TestedStudy study_in(const SQLite::Statement& row) {
  return {row.getColumn("effect").getInt() == 1,
          row.getColumn("number").getInt64(),
          row.getColumn("participants").getInt64(),
          row.getColumn("seed").getInt64(),
          row.getColumn("build").getString(),
          row.getColumn("simulated_s").getDouble(),
          {}};
}

StudyTest test_in(const SQLite::Statement& row) {
  const SQLite::Column p = row.getColumn("p");
  return {row.getColumn("factor").getString(),
          p.isNull() ? std::nullopt : std::optional(p.getDouble()),
          row.getColumn("method").getString(), row.getColumn("remark").getString()};
}

void bind_key(SQLite::Statement& row, const TestedStudy& study) {
  row.bind(1, study.effect ? 1 : 0);
  row.bind(2, study.number);
  row.bind(3, study.participants);
}

/// False when it is there already.
bool insert_study(SQLite::Database& database, const TestedStudy& study) {
  SQLite::Statement row(database, "INSERT OR IGNORE INTO study VALUES (?, ?, ?, ?, ?, ?)");
  bind_key(row, study);
  row.bind(4, study.seed);
  row.bind(5, study.build);
  row.bind(6, study.simulated_s);
  return row.exec() == 1;
}

void insert_tests(SQLite::Database& database, const TestedStudy& study) {
  SQLite::Statement row(database, "INSERT INTO test VALUES (?, ?, ?, ?, ?, ?, ?)");
  for (const StudyTest& test : study.tests) {
    bind_key(row, study);
    row.bind(4, test.factor);
    test.p ? row.bind(5, *test.p) : row.bind(5);
    row.bind(6, test.method);
    row.bind(7, test.remark);
    row.exec();
    row.reset();
  }
}

void require_one_build(SQLite::Database& database, const std::string& build,
                       const std::string& name) {
  SQLite::Statement other(database, "SELECT build FROM study WHERE build <> ? LIMIT 1");
  other.bind(1, build);
  if (other.executeStep()) {
    throw InputError(name + ": expected studies of the build of the chunks, " + build +
                     ", got some of " + other.getColumn(0).getString() + "; give another --out");
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

std::vector<TestedStudy> PowerLedger::studies() {
  const std::lock_guard lock(mutex_);
  const SQLite::Transaction transaction(database_);
  std::vector<TestedStudy> studies;
  SQLite::Statement row(database_,
                        "SELECT * FROM study ORDER BY number, effect DESC, participants");
  SQLite::Statement test(database_,
                         "SELECT * FROM test WHERE effect = ? AND number = ? AND participants = ? "
                         "ORDER BY factor");
  while (row.executeStep()) {
    studies.push_back(study_in(row));
    bind_key(test, studies.back());
    while (test.executeStep()) {
      studies.back().tests.push_back(test_in(test));
    }
    test.reset();
  }
  return studies;
}

void PowerLedger::add(const std::vector<TestedStudy>& studies) {
  const std::lock_guard lock(mutex_);
  SQLite::Transaction transaction(database_, SQLite::TransactionBehavior::IMMEDIATE);
  for (const TestedStudy& study : studies) {
    if (insert_study(database_, study)) {
      insert_tests(database_, study);
    }
  }
  if (!studies.empty()) {
    require_one_build(database_, studies.front().build, name_);
  }
  transaction.commit();
}

}  // namespace impetus::inline power
