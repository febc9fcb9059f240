// The ledger of a power analysis: which simulated studies are done, and who is at which.
//
//   take() ─> simulate ─> an R script tests, and writes `study` and `test` ─> give_back()
//
// Any number of processes of one machine may share a ledger: each takes what is neither done nor
// taken by one that still runs. Machines share none: each fills one of its own, whose rows travel
// as a chunk (power_chunk.hpp). The tables are those of ledger.sql.
// SPDX-License-Identifier: MIT
#pragma once

#include <SQLiteCpp/Database.h>

#include <cstdint>
#include <filesystem>
#include <mutex>
#include <string>
#include <vector>

#include "experiments/power/power_question.hpp"
#include "experiments/power/power_study.hpp"

namespace impetus::inline power {

/// The ledger, open and shared.
class PowerLedger {
 public:
  /// Opens the ledger or makes it. Throws InputError when it is that of another question or no
  /// ledger at all; StoreError when it cannot be written.
  PowerLedger(const std::filesystem::path& path, const PowerQuestion& question);
  ~PowerLedger();  ///< gives back all that this process has taken
  PowerLedger(const PowerLedger&) = delete;
  PowerLedger& operator=(const PowerLedger&) = delete;

  /// At most `most` cells that are not done and that nobody is at; from now on this process is.
  std::vector<PowerCell> take(const PowerRequest& request, std::size_t most);
  void give_back(const std::vector<PowerCell>& cells);

  /// How many studies of the request are not done, each size by itself.
  std::int64_t missing(const PowerRequest& request);

  /// All that is done, in the order of cells_of() and then of sizes, each with its tests.
  std::vector<TestedStudy> studies();

  /// Adds what was done elsewhere, all of it or nothing; what is there already stays. Throws
  /// InputError when the ledger holds studies of another build.
  void add(const std::vector<TestedStudy>& studies);

 private:
  std::mutex mutex_;
  std::string name_;
  SQLite::Database database_;
  std::string process_;
};

}  // namespace impetus::inline power
