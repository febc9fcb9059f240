// The ledger of a power analysis: which simulated studies are done, and who is at which.
//
//   take() ─> simulate ─> an R script tests, and writes `study` and `test` ─> give_back()
//
// Any number of processes of one machine may share a ledger: each takes what is neither done nor
// taken by one that still runs. The tables are those of ledger.sql.
// SPDX-License-Identifier: MIT
#pragma once

#include <SQLiteCpp/Database.h>

#include <cstdint>
#include <filesystem>
#include <mutex>
#include <string>
#include <vector>

namespace impetus::inline power {

/// What a ledger answers. Everything that changes a study's tests is in it.
struct PowerQuestion {
  std::string protocol;
  std::string protocol_hash;
  std::string observer;       ///< JSON
  std::string null_observer;  ///< JSON; "": none is known
  std::string screen;
  std::string response;  ///< "rating", "answer" or "clicks"
  std::string model;     ///< "means" or "mixed"
  std::string factors;   ///< JSON array
  std::string compared;  ///< JSON array
  std::int64_t seed{1};
};

/// How many studies of which sizes are wanted.
struct PowerRequest {
  std::vector<std::int64_t> sizes;  ///< numbers of participants, rising, each once
  std::int64_t studies{0};          ///< of each size with the effect
  std::int64_t null_studies{0};     ///< of each size without it
};

/// One number of a study, to be simulated with as many participants as its greatest size.
struct PowerCell {
  bool effect{true};
  std::int64_t number{1};
  std::vector<std::int64_t> sizes;  ///< that are not done, rising
};

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

 private:
  std::mutex mutex_;
  std::string name_;
  SQLite::Database database_;
  std::string process_;
};

}  // namespace impetus::inline power
