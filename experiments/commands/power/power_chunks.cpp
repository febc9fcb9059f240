// SPDX-License-Identifier: MIT
#include "experiments/commands/power/power_chunks.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "experiments/commands/commands.hpp"
#include "experiments/commands/new_file.hpp"
#include "experiments/commands/power/power_simulation.hpp"
#include "experiments/commands/power/power_studies.hpp"
#include "experiments/commands/power/scratch_folder.hpp"
#include "experiments/commands/progress_line.hpp"
#include "experiments/models/atomic_file.hpp"
#include "experiments/power/chunk_mark.hpp"
#include "experiments/power/power_chunk.hpp"
#include "experiments/power/power_ledger.hpp"
#include "experiments/provenance/build_name.hpp"
#include "experiments/settings/input_error.hpp"

namespace impetus::inline commands {
namespace {

namespace fs = std::filesystem;

/// "running on node3 for 12 min, 40 %".
std::string state_words(const ChunkReport& report) {
  const std::string time = duration_words(report.since_s);
  switch (report.state) {
    case ChunkState::kWaiting:
      return "waiting";
    case ChunkState::kRunning:
      return "running on " + report.machine + " for " + time + ", " +
             std::to_string(static_cast<int>(report.share * 100.0)) + " %";
    case ChunkState::kSilent:
      return "silent on " + report.machine + " for " + time + ": probably killed, run it again";
    case ChunkState::kFailed:
      return "failed: " + report.sentence;
    case ChunkState::kDone:
      break;
  }
  return "done";
}

/// What is known of all chunks: their reports, and what those that are done took.
struct Sweep {
  std::vector<ChunkReport> reports;
  double done_s{0.0};
  std::int64_t done{0};
};

/// A chunk that is there but cannot be used has failed.
void look_at_chunk(const PowerOptions& options, const PowerTask& task, std::int64_t number,
                   Sweep& sweep) {
  ChunkReport report = report_of_chunk(options.out, number);
  if (report.state == ChunkState::kDone) {
    try {
      PowerRequest request = task.request;
      request.chunk.number = number;
      sweep.done_s += read_chunk(options.out, task.question, request).took_s;
      ++sweep.done;
    } catch (const InputError& error) {
      report.state = ChunkState::kFailed;
      report.sentence = error.what();
    }
  }
  sweep.reports.push_back(report);
}

std::string sums_words(const SweepSums& sums, std::int64_t chunks) {
  const auto count = [](std::int64_t number, const char* words) {
    return number == 0 ? "" : ", " + std::to_string(number) + words;
  };
  std::string words = std::to_string(sums.done) + " of " + std::to_string(chunks) + " done" +
                      count(sums.running, " running") + count(sums.silent, " silent") +
                      count(sums.failed, " failed") + count(sums.waiting, " waiting");
  if (sums.left_s > 0.0) {
    words += "; about " + duration_words(sums.left_s) + " left, " +
             std::to_string(std::max<std::int64_t>(sums.running, 1)) + " at a time";
  }
  return words;
}

/// A folder of this machine alone, for what is thrown away.
fs::path own_disk() {
  std::error_code error;
  fs::path folder = fs::temp_directory_path(error);
  if (error) {
    throw InputError("TMPDIR: expected a folder of this machine to simulate in, got none");
  }
  return folder;
}

/// The chunk's studies from a ledger of its own, which no other machine sees.
PowerChunk computed_chunk(const PowerOptions& options, const PowerTask& task, ChunkMark& mark) {
  const auto begin = std::chrono::steady_clock::now();
  const ScratchFolder scratch(own_disk(), std::string("impetus-") + kScratchBegin);
  const fs::path ledger = scratch.path() / "chunk.sqlite";
  const auto told = [&mark](double share) { mark.tell(share); };
  if (!simulate_studies({options, task, scratch.path(), ledger, told})) {
    throw std::runtime_error("a package of R is missing; R has said which");
  }
  PowerChunk chunk{task.question, task.request, build_name(), 0.0, {}};
  chunk.studies = PowerLedger(ledger, task.question).studies();
  chunk.took_s = seconds_since(begin);
  return chunk;
}

}  // namespace

int list_chunks(const PowerOptions& options, const PowerTask& task) {
  Sweep sweep;
  for (std::int64_t number = 1; number <= options.chunks; ++number) {
    look_at_chunk(options, task, number, sweep);
    std::printf("%s --chunk %lld  # %s\n", options.repeated.c_str(), static_cast<long long>(number),
                state_words(sweep.reports.back()).c_str());
  }
  const double chunk_s = sweep.done == 0 ? 0.0 : sweep.done_s / static_cast<double>(sweep.done);
  const SweepSums sums = sums_of(sweep.reports, chunk_s);
  std::printf("# %s\n# once all are done, their page: %s\n",
              sums_words(sums, options.chunks).c_str(), options.repeated.c_str());
  return kDone;
}

int do_chunk(const PowerOptions& options, const PowerTask& task) {
  const fs::path out = options.out;
  const fs::path file = chunk_file(out, options.chunk);
  make_out_folder(chunk_folder(out));
  require_build(out, task.question, task.request, build_name());
  if (fs::exists(file)) {
    read_chunk(out, task.question, task.request);
    std::printf("%s: is there already\n", file.c_str());
    return kDone;
  }
  ChunkMark mark(out, options.chunk);
  try {
    require_writable(file);
    write_chunk(out, computed_chunk(options, task, mark));
  } catch (const std::exception& error) {
    mark.fail(error.what());
    throw;
  }
  std::printf("%s: done\n", file.c_str());
  return kDone;
}

void gather_chunks(const PowerOptions& options, const PowerTask& task, const fs::path& ledger) {
  std::vector<TestedStudy> studies;
  for (PowerChunk& chunk : read_all_chunks(options.out, task.question, task.request)) {
    std::move(chunk.studies.begin(), chunk.studies.end(), std::back_inserter(studies));
  }
  PowerLedger(ledger, task.question).add(studies);
}

}  // namespace impetus::inline commands
