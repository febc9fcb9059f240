// SPDX-License-Identifier: MIT
#include "experiments/commands/trading/parting_chunks.hpp"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <string>
#include <utility>

#include "experiments/commands/commands.hpp"
#include "experiments/commands/new_file.hpp"
#include "experiments/commands/power/power_studies.hpp"
#include "experiments/commands/progress_line.hpp"
#include "experiments/models/atomic_file.hpp"
#include "experiments/power/chunk_file.hpp"
#include "experiments/power/chunk_mark.hpp"
#include "experiments/provenance/build_name.hpp"
#include "experiments/settings/input_error.hpp"

namespace impetus::inline commands {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr SweepKind kPartings{"trade", 1, "whole trials of a trade"};

/// A time that was not reached is null.
json json_of(const PartedTrial& trial) {
  const auto time = [](double time_s) { return std::isfinite(time_s) ? json(time_s) : json(); };
  return {time(trial.first_s), time(trial.half_s), trial.share_together};
}

PartedTrial parted_trial(const json& value) {
  const auto time = [](const json& time_s) {
    return time_s.is_null() ? kNeverParted_s : time_s.get<double>();
  };
  return {time(value.at(0)), time(value.at(1)), value.at(2).get<double>()};
}

/// The starts of one chunk.
PartingRequest request_of(const PartingWork& work, const ChunkNumber& chunk) {
  PartingRequest request = work.request;
  const std::vector<std::int64_t> numbers = numbers_of(chunk, request.starts);
  request.first_start = numbers.front();
  request.starts = std::ssize(numbers);
  return request;
}

/// All that a chunk's trials follow from.
json question_of(const PartingWork& work, const ChunkNumber& chunk) {
  json question = work.question;
  question["number of chunks"] = chunk.of;
  return question;
}

/// Says which part of the question a chunk answers otherwise.
void require_question(const fs::path& file, const json& there, const json& wanted) {
  for (const auto& [words, value] : wanted.items()) {
    if (there.at(words) != value) {
      throw InputError(file.string() +
                       ": expected a chunk of the same question, got one of another " + words +
                       "; give another --out");
    }
  }
}

/// What a chunk's file holds, once it is known to belong here.
struct PartingChunk {
  std::string build;
  double took_s{0.0};
  std::vector<std::vector<PartedTrial>> trials;  ///< of each setting, by start
};

PartingChunk read_parting_chunk(const fs::path& out, const PartingWork& work,
                                const ChunkNumber& chunk) {
  const fs::path file = chunk_file(out, chunk.number);
  const json value = read_chunk_value(file, kPartings);
  try {
    require_question(file, value.at("question"), question_of(work, chunk));
    if (value.at("chunk") != chunk.number) {
      refuse_chunk(file, "chunk " + std::to_string(chunk.number), "another");
    }
    PartingChunk read{value.at("build").get<std::string>(), value.at("took_s").get<double>(), {}};
    const auto starts = static_cast<std::size_t>(request_of(work, chunk).starts);
    for (const json& setting : value.at("trials")) {
      read.trials.emplace_back();
      for (const json& trial : setting) {
        read.trials.back().push_back(parted_trial(trial));
      }
      if (read.trials.back().size() != starts) {
        refuse_chunk(file, "all starts of its chunk", "others");
      }
    }
    if (read.trials.size() != work.request.settings.size()) {
      refuse_chunk(file, "all settings", "others");
    }
    return read;
  } catch (const json::exception&) {
    refuse_chunk(file, "a whole chunk", "one that lacks a part");
  }
}

json computed_chunk(const PartingWork& work, const ChunkNumber& chunk, const StartOf& start,
                    ChunkMark& mark) {
  ProgressLine line("whole trials of chunk " + std::to_string(chunk.number));
  const auto begin = std::chrono::steady_clock::now();
  json trials = json::array();
  for (const PartedTrials& of_setting : partings(start, request_of(work, chunk), [&](double share) {
         mark.tell(share);
         line.tell(share);
       })) {
    json& all = trials.emplace_back(json::array());
    for (const PartedTrial& trial : of_setting.trials) {
      all.push_back(json_of(trial));
    }
  }
  return {{"build", build_name()},
          {"question", question_of(work, chunk)},
          {"chunk", chunk.number},
          {"took_s", seconds_since(begin)},
          {"trials", trials}};
}

/// Two builds are never mixed: the first chunk that is there is asked.
void require_this_build(const fs::path& out, const PartingWork& work, std::int64_t chunks) {
  for (std::int64_t number = 1; number <= chunks; ++number) {
    const fs::path file = chunk_file(out, number);
    if (fs::exists(file)) {
      require_same_build(file, read_parting_chunk(out, work, {number, chunks}).build, build_name());
      return;
    }
  }
}

}  // namespace

int list_partings(const fs::path& out, const ChunkOptions& options, const PartingWork& work) {
  return list_chunks({out, options.chunks, options.repeated, [&](std::int64_t number) {
                        return read_parting_chunk(out, work, {number, options.chunks}).took_s;
                      }});
}

int do_parting_chunk(const fs::path& out, const ChunkOptions& options, const PartingWork& work,
                     const StartOf& start) {
  const ChunkNumber chunk{options.chunk, options.chunks};
  const fs::path file = chunk_file(out, chunk.number);
  make_out_folder(chunk_folder(out));
  require_this_build(out, work, chunk.of);
  if (fs::exists(file)) {
    read_parting_chunk(out, work, chunk);
    std::printf("%s: is there already\n", file.c_str());
    return kDone;
  }
  ChunkMark mark(out, chunk.number);
  try {
    require_writable(file);
    write_chunk_value(file, kPartings, computed_chunk(work, chunk, start, mark));
  } catch (const std::exception& error) {
    mark.fail(error.what());
    throw;
  }
  std::printf("%s: done\n", file.c_str());
  return kDone;
}

std::vector<PartedTrials> gathered_partings(const fs::path& out, std::int64_t chunks,
                                            const PartingWork& work) {
  require_all_chunks(out, chunks);
  std::vector<PartedTrials> all;
  for (const PartingSetting& setting : work.request.settings) {
    all.push_back({setting, {}});
  }
  for (std::int64_t number = 1; number <= chunks; ++number) {
    PartingChunk chunk = read_parting_chunk(out, work, {number, chunks});
    require_same_build(chunk_file(out, number), chunk.build, build_name());
    for (std::size_t i = 0; i < all.size(); ++i) {
      std::move(chunk.trials[i].begin(), chunk.trials[i].end(), std::back_inserter(all[i].trials));
    }
  }
  return all;
}

}  // namespace impetus::inline commands
