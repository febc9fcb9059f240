// SPDX-License-Identifier: MIT
#include "experiments/commands/trading/parting_chunks.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>
#include <utility>

#include "experiments/commands/power/power_studies.hpp"
#include "experiments/commands/progress_line.hpp"
#include "experiments/provenance/build_name.hpp"

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

/// The trials that a chunk keeps: of each setting, by start.
std::vector<std::vector<PartedTrial>> kept_trials(const json& chunk) {
  std::vector<std::vector<PartedTrial>> trials;
  for (const json& setting : chunk.at("trials")) {
    std::vector<PartedTrial>& all = trials.emplace_back();
    for (const json& trial : setting) {
      all.push_back(parted_trial(trial));
    }
  }
  return trials;
}

/// What a chunk of so many settings and starts lacks, in words; "": nothing.
std::string lacking(const json& chunk, std::size_t settings, std::size_t starts) {
  const std::vector<std::vector<PartedTrial>> trials = kept_trials(chunk);
  const bool has_all_starts = std::all_of(
      trials.begin(), trials.end(), [&](const auto& setting) { return setting.size() == starts; });
  return !has_all_starts             ? "all starts of its chunk"
         : trials.size() != settings ? "all settings"
                                     : "";
}

/// The files of all chunks. `work` must outlive it.
Sweep parting_sweep(const fs::path& out, std::int64_t chunks, const PartingWork& work) {
  json question = work.question;
  question["number of chunks"] = chunks;
  std::vector<AskedPart> parts;
  for (const auto& [words, value] : question.items()) {
    parts.push_back({(json::json_pointer("/question") / words).to_string(), words});
  }
  return {
      kPartings, out, chunks, {{"question", question}}, parts, [&work, chunks](const json& chunk) {
        const ChunkNumber number{chunk.at("chunk").get<std::int64_t>(), chunks};
        const auto starts = static_cast<std::size_t>(request_of(work, number).starts);
        return lacking(chunk, work.request.settings.size(), starts);
      }};
}

json computed_chunk(const PartingWork& work, const Sweep& sweep, std::int64_t number,
                    const StartOf& start, ChunkMark& mark) {
  ProgressLine line("whole trials of chunk " + std::to_string(number));
  const auto begin = std::chrono::steady_clock::now();
  json trials = json::array();
  for (const PartedTrials& of_setting :
       partings(start, request_of(work, {number, sweep.chunks}), [&](double share) {
         mark.tell(share);
         line.tell(share);
       })) {
    json& all = trials.emplace_back(json::array());
    for (const PartedTrial& trial : of_setting.trials) {
      all.push_back(json_of(trial));
    }
  }
  return {{"build", build_name()},
          {"question", sweep.asked.at("question")},
          {"chunk", number},
          {"took_s", seconds_since(begin)},
          {"trials", trials}};
}

}  // namespace

int list_partings(const fs::path& out, const ChunkOptions& options, const PartingWork& work) {
  return list_chunks(parting_sweep(out, options.chunks, work), options.repeated);
}

int do_parting_chunk(const fs::path& out, const ChunkOptions& options, const PartingWork& work,
                     const StartOf& start) {
  const Sweep sweep = parting_sweep(out, options.chunks, work);
  sweep.require_build(build_name());
  return compute_chunk(sweep, options.chunk, [&](ChunkMark& mark) {
    write_chunk_value(chunk_file(out, options.chunk), kPartings,
                      computed_chunk(work, sweep, options.chunk, start, mark));
  });
}

std::vector<PartedTrials> gathered_partings(const fs::path& out, std::int64_t chunks,
                                            const PartingWork& work) {
  std::vector<PartedTrials> all;
  for (const PartingSetting& setting : work.request.settings) {
    all.push_back({setting, {}});
  }
  const Sweep sweep = parting_sweep(out, chunks, work);
  sweep.read_all([&](const SweptChunk& chunk) {
    std::vector<std::vector<PartedTrial>> trials = kept_trials(chunk.value);
    for (std::size_t i = 0; i < all.size(); ++i) {
      std::move(trials[i].begin(), trials[i].end(), std::back_inserter(all[i].trials));
    }
  });
  sweep.require_build(build_name());  // which measures the rest
  return all;
}

}  // namespace impetus::inline commands
