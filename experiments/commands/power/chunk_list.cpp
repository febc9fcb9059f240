// SPDX-License-Identifier: MIT
#include "experiments/commands/power/chunk_list.hpp"

#include <algorithm>
#include <cstdio>
#include <vector>

#include "experiments/commands/commands.hpp"
#include "experiments/commands/progress_line.hpp"
#include "experiments/commands/sentences.hpp"
#include "experiments/power/chunk_mark.hpp"
#include "experiments/settings/input_error.hpp"

namespace impetus::inline commands {
namespace {

constexpr std::int64_t kMostChunks = 9999;  ///< four digits in a file's name

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
void look_at_chunk(const ListedSweep& listed, std::int64_t number, Sweep& sweep) {
  ChunkReport report = report_of_chunk(listed.out, number);
  if (report.state == ChunkState::kDone) {
    try {
      sweep.done_s += listed.took_s(number);
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

}  // namespace

void add_chunk_options(CLI::App& command, ChunkOptions& options, const std::string& in_pieces) {
  CLI::Option* chunks = command.add_option("--chunks", options.chunks, in_pieces)
                            ->check(CLI::Range(std::int64_t{1}, kMostChunks));
  CLI::Option* chunk = command.add_option("--chunk", options.chunk, "Compute this one, from 1")
                           ->check(CLI::Range(std::int64_t{1}, kMostChunks))
                           ->needs(chunks);
  command
      .add_flag("--list", options.list,
                "Print the command of each chunk and how far it is, and compute nothing")
      ->needs(chunks)
      ->excludes(chunk);
}

void require_chunks(const ChunkOptions& options, std::int64_t chunks, std::int64_t studies,
                    const std::string& one) {
  require(chunks <= studies, "--chunks: expected at most " + std::to_string(studies) + ", a " +
                                 one + " in each, got " + std::to_string(chunks));
  require(options.chunk <= chunks, "--chunk: expected from 1 to " + std::to_string(chunks) +
                                       ", got " + std::to_string(options.chunk));
}

int list_chunks(const ListedSweep& listed) {
  Sweep sweep;
  for (std::int64_t number = 1; number <= listed.chunks; ++number) {
    look_at_chunk(listed, number, sweep);
    std::printf("%s --chunk %lld  # %s\n", listed.repeated.c_str(), static_cast<long long>(number),
                state_words(sweep.reports.back()).c_str());
  }
  const double chunk_s = sweep.done == 0 ? 0.0 : sweep.done_s / static_cast<double>(sweep.done);
  const SweepSums sums = sums_of(sweep.reports, chunk_s);
  std::printf("# %s\n# once all are done, their page: %s\n",
              sums_words(sums, listed.chunks).c_str(), listed.repeated.c_str());
  return kDone;
}

}  // namespace impetus::inline commands
