// SPDX-License-Identifier: MIT
#include "experiments/commands/power/power_chunks.hpp"

#include <chrono>
#include <cstdio>
#include <exception>
#include <optional>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "experiments/commands/commands.hpp"
#include "experiments/commands/new_file.hpp"
#include "experiments/commands/power/chunk_list.hpp"
#include "experiments/commands/power/power_simulation.hpp"
#include "experiments/commands/power/power_studies.hpp"
#include "experiments/commands/scratch_folder.hpp"
#include "experiments/models/atomic_file.hpp"
#include "experiments/power/chunk_mark.hpp"
#include "experiments/power/power_chunk.hpp"
#include "experiments/power/power_ledger.hpp"
#include "experiments/settings/input_error.hpp"

namespace impetus::inline commands {
namespace {

namespace fs = std::filesystem;

/// The chunk's studies from a ledger of its own, which no other machine sees.
PowerChunk computed_chunk(const PowerOptions& options, const PowerTask& task, ChunkMark& mark) {
  const auto begin = std::chrono::steady_clock::now();
  const ScratchFolder scratch(own_disk(), std::string("impetus-") + kScratchBegin);
  const fs::path ledger = scratch.path() / "chunk.sqlite";
  const auto told = [&mark](double share) { mark.tell(share); };
  const std::optional<PowerTools> tools = power_tools(scratch.path(), task.question.model);
  if (!tools) {
    throw std::runtime_error("a package of R is missing; R has said which");
  }
  require_build(options.out, task.question, task.request, tools->build);
  simulate_studies({options, task, *tools, scratch.path(), ledger, told});
  PowerChunk chunk{task.question, task.request, tools->build, 0.0, {}};
  chunk.studies = PowerLedger(ledger, task.question).studies();
  chunk.took_s = seconds_since(begin);
  return chunk;
}

}  // namespace

int list_chunks(const PowerOptions& options, const PowerTask& task) {
  return list_chunks({options.out, options.chunks, options.repeated, [&](std::int64_t number) {
                        PowerRequest request = task.request;
                        request.chunk.number = number;
                        return read_chunk(options.out, task.question, request).took_s;
                      }});
}

int do_chunk(const PowerOptions& options, const PowerTask& task) {
  const fs::path out = options.out;
  const fs::path file = chunk_file(out, options.chunk);
  make_out_folder(chunk_folder(out));
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
