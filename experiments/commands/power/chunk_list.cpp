// SPDX-License-Identifier: MIT
#include "experiments/commands/power/chunk_list.hpp"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <vector>

#include "experiments/commands/commands.hpp"
#include "experiments/commands/new_file.hpp"
#include "experiments/commands/progress_line.hpp"
#include "experiments/commands/sentences.hpp"
#include "experiments/models/atomic_file.hpp"
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
struct KnownChunks {
  std::vector<ChunkReport> reports;
  double done_s{0.0};
  std::int64_t done{0};
};

/// A chunk that is there but cannot be used has failed.
void look_at_chunk(const Sweep& sweep, std::int64_t number, KnownChunks& known) {
  ChunkReport report = report_of_chunk(sweep.out, number);
  if (report.state == ChunkState::kDone) {
    try {
      known.done_s += sweep.read(number).took_s;
      ++known.done;
    } catch (const InputError& error) {
      report.state = ChunkState::kFailed;
      report.sentence = error.what();
    }
  }
  known.reports.push_back(report);
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

int list_chunks(const Sweep& sweep, const std::string& repeated) {
  KnownChunks known;
  for (std::int64_t number = 1; number <= sweep.chunks; ++number) {
    look_at_chunk(sweep, number, known);
    std::printf("%s --chunk %lld  # %s\n", repeated.c_str(), static_cast<long long>(number),
                state_words(known.reports.back()).c_str());
  }
  const double chunk_s = known.done == 0 ? 0.0 : known.done_s / static_cast<double>(known.done);
  const SweepSums sums = sums_of(known.reports, chunk_s);
  std::printf("# %s\n# once all are done, their page: %s\n", sums_words(sums, sweep.chunks).c_str(),
              repeated.c_str());
  return kDone;
}

void attempt_chunk(const Sweep& sweep, std::int64_t number, const ChunkWork& work) {
  ChunkMark mark(sweep.out, number);
  try {
    require_writable(chunk_file(sweep.out, number));
    work(mark);
  } catch (const std::exception& error) {
    mark.fail(error.what());
    throw;
  }
}

int compute_chunk(const Sweep& sweep, std::int64_t number, const ChunkWork& work) {
  const std::filesystem::path file = chunk_file(sweep.out, number);
  make_out_folder(chunk_folder(sweep.out));
  const bool is_there = std::filesystem::exists(file);
  if (is_there) {
    sweep.read(number);
  } else {
    attempt_chunk(sweep, number, work);
  }
  std::printf("%s: %s\n", file.c_str(), is_there ? "is there already" : "done");
  return kDone;
}

}  // namespace impetus::inline commands
