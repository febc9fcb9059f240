// `impetus power`: how many participants a study needs, from whole simulated studies.
//
//   options ─> a question ─> its ledger ─> simulated studies, tested (power_studies.hpp)
//                 │            ^   └─────> Rscript power.R ─> power.html, figure, table
//                 └─> chunks ──┘  each computed by whatever machine:
//
//   --chunks 50 --list ─> 50 commands, and how far each is
//   --chunks 50 --chunk 7 ─> a ledger on this machine's own disk ─> OUT/chunks/chunk-0007.json
//   --chunks 50 ─> all 50 files ─> OUT/power.sqlite ─> the page
//
// SPDX-License-Identifier: MIT
#include <chrono>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "experiments/commands/commands.hpp"
#include "experiments/commands/new_file.hpp"
#include "experiments/commands/power/chunk_list.hpp"
#include "experiments/commands/power/given_words.hpp"
#include "experiments/commands/power/power_options.hpp"
#include "experiments/commands/power/power_simulation.hpp"
#include "experiments/commands/power/power_studies.hpp"
#include "experiments/commands/progress_line.hpp"
#include "experiments/commands/r_program.hpp"
#include "experiments/commands/scratch_folder.hpp"
#include "experiments/exports/r_scripts.hpp"
#include "experiments/models/atomic_file.hpp"
#include "experiments/power/chunk_mark.hpp"
#include "experiments/power/power_chunk.hpp"
#include "experiments/power/power_ledger.hpp"
#include "experiments/settings/input_error.hpp"

namespace impetus::inline commands {
namespace {

namespace fs = std::filesystem;

constexpr const char* kLedgerName = "power.sqlite";

/// Throws InputError unless the folder is new, empty, or one of an earlier power analysis, and is
/// asked for in chunks where it holds chunks that nobody has read together.
void require_power_folder(const fs::path& folder, bool in_chunks) {
  if (!fs::exists(folder)) {
    return;
  }
  const std::string expected =
      folder.string() + ": expected a new folder, an empty one or an earlier power analysis, got ";
  if (!fs::is_directory(folder)) {
    throw InputError(expected + "a file");
  }
  const bool has_chunks = fs::exists(chunk_folder(folder));
  if (fs::exists(folder / kLedgerName) || fs::is_empty(folder) || (has_chunks && in_chunks)) {
    return;
  }
  if (has_chunks) {
    throw InputError(folder.string() +
                     ": expected a power analysis in one piece, got one in chunks; --chunks and "
                     "their number reads them together");
  }
  throw InputError(expected + "one that holds " +
                   fs::directory_iterator(folder)->path().filename().string());
}

/// The page from the ledger.
int write_page(const PowerOptions& options) {
  const fs::path out = options.out;
  const ScratchFolder scratch(out, kScratchBegin);
  const fs::path script = write_r_scripts(scratch.path(), {"power.R"}) / "power.R";
  if (run_needed_r_script({script.string(), (out / kLedgerName).string(), "--out", options.out}) !=
      0) {
    return kCouldNotRun;
  }
  std::printf("%s: open it in a browser\n", (out / "power.html").c_str());
  return kDone;
}

/// False: a package of R is missing, and R has said which.
bool simulate_all(const PowerOptions& options, const PowerTask& task) {
  fs::create_directories(options.out);
  const ScratchFolder scratch(options.out, kScratchBegin);
  const std::optional<PowerTools> tools = power_tools(scratch.path(), task.question.model);
  if (tools) {
    simulate_studies(
        {options, task, *tools, scratch.path(), fs::path(options.out) / kLedgerName, {}});
  }
  return tools.has_value();
}

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

/// Prints a command for each chunk, with its state as a shell's comment, and the sums. Writes
/// nothing.
int list_commands(const PowerOptions& options, const PowerTask& task) {
  return list_chunks({options.out, options.chunks, options.repeated, [&](std::int64_t number) {
                        PowerRequest request = task.request;
                        request.chunk.number = number;
                        return read_chunk(options.out, task.question, request).took_s;
                      }});
}

/// Computes the chunk that was asked for, unless it is there. Throws what keeps it from it, in one
/// sentence that --list repeats; then the chunk is as it was.
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

/// Puts the studies of all chunks into the ledger, all or none. Throws InputError when a chunk is
/// missing, broken or another question's.
void gather_chunks(const PowerOptions& options, const PowerTask& task, const fs::path& ledger) {
  std::vector<TestedStudy> studies;
  for (PowerChunk& chunk : read_all_chunks(options.out, task.question, task.request)) {
    std::move(chunk.studies.begin(), chunk.studies.end(), std::back_inserter(studies));
  }
  PowerLedger(ledger, task.question).add(studies);
}

int power(const PowerOptions& options) {
  const BuildingLine told;
  require_power_folder(options.out, options.chunks > 0);
  const PowerTask task = task_of(options);
  if (options.list) {
    return list_commands(options, task);
  }
  if (options.chunk > 0) {
    return do_chunk(options, task);
  }
  if (options.chunks > 0) {
    gather_chunks(options, task, fs::path(options.out) / kLedgerName);
  } else if (!simulate_all(options, task)) {
    return kCouldNotRun;
  }
  return write_page(options);
}

}  // namespace

void add_power(CLI::App& app, Command& chosen) {
  auto options = std::make_shared<PowerOptions>();
  CLI::App* command = app.add_subcommand(
      "power", "How many participants a study needs: whole simulated studies, tested (needs R)");
  add_options(*command, *options);
  command->callback([options, command, &chosen] {
    options->repeated = given_words(*command, {"--chunk", "--list"});
    chosen = [options] { return power(*options); };
  });
}

}  // namespace impetus::inline commands
