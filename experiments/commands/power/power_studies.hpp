// The simulated studies of a power analysis: those that its ledger lacks, on several threads.
//
//   ledger.take() ─> every participant's session, headless ─> a study file that is thrown away
//        ^                                                       │
//        └── ledger.give_back() <── the ledger's rows <── power-fits.R, as it tests real studies
//
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

#include "experiments/commands/running/run_part.hpp"
#include "experiments/power/power_ledger.hpp"
#include "experiments/store/study_file.hpp"

namespace impetus::inline commands {

/// What tests studies.
struct PowerTools {
  std::filesystem::path script;  ///< power-fits.R
  std::string build;             ///< of this program, with the versions of R and its packages
};

/// All that simulating the studies of a power analysis needs.
struct PowerWork {
  RunPart planted;  ///< with the observer
  RunPart without;  ///< with the observer without the effect
  RunOptions run;   ///< of every session; participant and seed are set for each
  PowerRequest request;
  std::int64_t seed{1};
  std::int64_t jobs{1};
  PowerTools tools;
  std::filesystem::path scratch;  ///< a folder for what is thrown away
  std::filesystem::path ledger;
  std::function<void(double)> told;  ///< the share that is done; may be empty
};

double seconds_since(std::chrono::steady_clock::time_point begin);

/// The seed of a study: `impetus run --participants N --seed SEED` simulates it again.
std::uint64_t seed_of_study(std::int64_t seed, std::int64_t number);

/// `wanted` studies at a time, or as many as there are cores (0).
std::int64_t jobs_of(std::int64_t wanted);

/// The sessions of participants 1 to `participants`, one after the other, as whoever is yoked to
/// another needs, until `stops`. Nothing is synchronised with the disk: what is lost is simulated
/// again.
void simulate_people(const RunPart& part, const RunOptions& run, std::int64_t participants,
                     StudyFile& study, const std::function<bool()>& stops);

/// Simulates and tests what is missing, until nothing is, whoever did it; says how long it will
/// take, and how far it is, on standard error. Throws the first error once the other threads have
/// stopped; what they had begun is begun again next time.
void do_power_studies(const PowerWork& work, PowerLedger& ledger);

}  // namespace impetus::inline commands
