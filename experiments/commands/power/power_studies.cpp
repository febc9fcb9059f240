// SPDX-License-Identifier: MIT
#include "experiments/commands/power/power_studies.hpp"

#include <SQLiteCpp/Database.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "experiments/commands/progress_line.hpp"
#include "experiments/commands/r_program.hpp"
#include "experiments/commands/running/participant_run.hpp"
#include "experiments/commands/running/simulated_group.hpp"
#include "experiments/observers/side_by_side.hpp"
#include "experiments/provenance/build_name.hpp"

namespace impetus::inline commands {
namespace {

namespace fs = std::filesystem;

constexpr double kBatch_s = 20.0;     ///< studies tested by one start of R: so much work
constexpr double kMostInABatch = 50;  ///< so that an interruption costs little

/// Threads that take studies from the ledger, simulate and test them, until none is missing.
class PowerStudies {
 public:
  PowerStudies(const PowerWork& work, PowerLedger& ledger)
      : work_(work), ledger_(ledger), line_("simulating studies") {
    missing_at_first_ = ledger_.missing(work_.request);
  }

  void run() {
    run_workers(work_.jobs, stops_, [this](std::int64_t job) {
      while (!stops_ && take_a_batch(job)) {
      }
    });
  }

 private:
  /// False when nothing is missing any more.
  bool take_a_batch(std::int64_t job) {
    const std::vector<PowerCell> cells = ledger_.take(work_.request, studies_in_a_batch());
    if (cells.empty()) {  // another thread or process is at what is missing; it may be stopped
      std::this_thread::sleep_for(std::chrono::milliseconds(200));
      return tell_progress() > 0;
    }
    const auto begin = std::chrono::steady_clock::now();
    do_batch(cells, work_.scratch / std::to_string(job));
    ledger_.give_back(cells);
    keep_time(seconds_since(begin) / static_cast<double>(cells.size()));
    return tell_progress() > 0;
  }

  void do_batch(const std::vector<PowerCell>& cells, const fs::path& folder) {
    fs::create_directories(folder);
    std::ofstream list(folder / "studies.tsv");
    list << "file\teffect\tnumber\tsizes\tseed\tsimulated_s\tbuild\n";
    for (const PowerCell& cell : cells) {
      const auto begin = std::chrono::steady_clock::now();
      const fs::path file = folder / (std::string(cell.effect ? "planted-" : "without-") +
                                      std::to_string(cell.number) + ".sqlite");
      simulate(cell, file);
      list << file.filename().string() << '\t' << (cell.effect ? 1 : 0) << '\t' << cell.number
           << '\t';
      for (const std::int64_t size : cell.sizes) {
        list << (size == cell.sizes.front() ? "" : ",") << size;
      }
      list << '\t' << seed_of_study(work_.seed, cell.number) << '\t' << seconds_since(begin) << '\t'
           << work_.tools.build << '\n';
    }
    list.close();
    test(folder);
    fs::remove_all(folder);
  }

  void simulate(const PowerCell& cell, const fs::path& file) {
    StudyFile study = StudyFile::open_for_writing(file, build_name());
    RunOptions own = work_.run;
    own.seed = seed_of_study(work_.seed, cell.number);
    own.keeps_steps = false;  // nothing that is tested is in them, and they take half of the time
    simulate_people(cell.effect ? work_.planted : work_.without, own, cell.sizes.back(), study,
                    [this] { return stops_.load(); });
  }

  void test(const fs::path& folder) {
    if (stops_) {
      return;
    }
    const int status = run_needed_r_script(
        {work_.tools.script.string(), work_.ledger.string(), (folder / "studies.tsv").string()});
    if (status != 0) {
      throw std::runtime_error("the tests of simulated studies ended with status " +
                               std::to_string(status) + "; what was tested before is kept");
    }
  }

  std::size_t studies_in_a_batch() {
    const std::lock_guard lock(mutex_);
    if (study_s_ <= 0.0) {
      return 1;  // how long one takes is not known yet
    }
    return static_cast<std::size_t>(std::clamp(kBatch_s / study_s_, 1.0, kMostInABatch));
  }

  /// Foretells the whole from the first.
  void keep_time(double study_s) {
    const std::lock_guard lock(mutex_);
    if (study_s_ <= 0.0) {
      const auto sizes = static_cast<double>(work_.request.sizes.size());
      const double left = static_cast<double>(ledger_.missing(work_.request)) / sizes;
      std::fprintf(
          stderr, "one study took %s; %.0f more, %lld at a time, take about %s.%s\n",
          duration_words(study_s).c_str(), left, static_cast<long long>(work_.jobs),
          duration_words(study_s * std::ceil(left / static_cast<double>(work_.jobs))).c_str(),
          work_.request.chunk.of == 1 ? " Interrupt it whenever you like: the same command goes on."
                                      : "");
    }
    study_s_ = study_s;
  }

  /// Returns how many are missing.
  std::int64_t tell_progress() {
    const std::int64_t missing = ledger_.missing(work_.request);
    const std::lock_guard lock(mutex_);
    const double share =
        1.0 - static_cast<double>(missing) /
                  static_cast<double>(std::max<std::int64_t>(missing_at_first_, 1));
    line_.tell(share);
    if (work_.told) {
      work_.told(share);
    }
    return missing;
  }

  const PowerWork& work_;
  PowerLedger& ledger_;
  std::atomic<bool> stops_{false};  ///< one has failed
  std::mutex mutex_;                ///< of what follows
  ProgressLine line_;
  std::int64_t missing_at_first_{0};
  double study_s_{0.0};  ///< what one took last; 0: not known yet
};

}  // namespace

double seconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

std::int64_t jobs_of(std::int64_t wanted) { return wanted > 0 ? wanted : core_count(); }

void simulate_people(const RunPart& part, const RunOptions& run, std::int64_t participants,
                     StudyFile& study, const std::function<bool()>& stops) {
  study.database().exec("PRAGMA synchronous = OFF");
  RunOptions own = run;
  for (std::int64_t number = 1; number <= participants && !stops(); ++number) {
    own.participant = simulated_name(number, number);
    ParticipantRun(part, own, study, nullptr).run({});
  }
}

std::uint64_t seed_of_study(std::int64_t seed, std::int64_t number) {
  constexpr std::uint64_t kStudies = 1'000'000;  // of one seed, so that no two share one
  return static_cast<std::uint64_t>(seed) * kStudies + static_cast<std::uint64_t>(number);
}

void do_power_studies(const PowerWork& work, PowerLedger& ledger) {
  PowerStudies(work, ledger).run();
}

}  // namespace impetus::inline commands
