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
#include <filesystem>
#include <fstream>
#include <functional>
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
#include "experiments/commands/power/power_studies.hpp"
#include "experiments/commands/progress_line.hpp"
#include "experiments/commands/r_program.hpp"
#include "experiments/commands/scratch_folder.hpp"
#include "experiments/exports/r_scripts.hpp"
#include "experiments/power/power_chunk.hpp"
#include "experiments/power/power_ledger.hpp"
#include "experiments/provenance/build_name.hpp"
#include "experiments/settings/input_error.hpp"

namespace impetus::inline commands {
namespace {

namespace fs = std::filesystem;

constexpr const char* kLedgerName = "power.sqlite";
constexpr const char* kScratchBegin = "simulating-";  ///< of folders of what is thrown away

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

/// What tests studies of a model, written into a folder. None when R lacks a package, which R has
/// said. Throws InputError when there is no R.
std::optional<PowerTools> power_tools(const fs::path& folder, const std::string& model) {
  const fs::path script = write_r_scripts(folder, {"power-fits.R"}) / "power-fits.R";
  const fs::path versions = folder / "versions.txt";
  if (run_needed_r_script({script.string(), "--check", model, versions.string()}) != 0) {
    return std::nullopt;
  }
  std::string words;
  std::getline(std::ifstream(versions), words);
  return PowerTools{script, std::string(build_name()) + " with " + words};
}

/// What is simulated, and where.
struct PowerSimulation {
  const PowerOptions& options;
  const PowerTask& task;
  PowerTools tools;
  fs::path scratch;                  ///< a folder for what is thrown away
  fs::path ledger;                   ///< may not be there yet
  std::function<void(double)> told;  ///< the share that is done; may be empty
};

void say_what_is_not_simulated(const std::string& response) {
  std::fprintf(stderr,
               "note: no type-I error: how this observer's %s would be without the effect is "
               "not known; --null FILE gives one\n",
               response == "rating"   ? "ratings"
               : response == "answer" ? "answers"
                                      : "clicks");
}

PowerWork work_of(const PowerSimulation& simulation) {
  PowerWork work;
  const PowerTask& task = simulation.task;
  work.run = task.run;
  work.planted = task.planted;
  solve_what_is_asked(work.planted);
  build_shapes(work.planted);
  work.without = work.planted;
  work.without.lab.observer = task.without ? task.without : work.planted.lab.observer;
  work.request = task.request;
  work.seed = task.question.seed;
  work.jobs = jobs_of(simulation.options.jobs);
  work.tools = simulation.tools;
  work.scratch = simulation.scratch;
  work.ledger = simulation.ledger;
  work.told = simulation.told;
  return work;
}

/// Simulates and tests all that the ledger lacks of the request's chunk. Throws InputError when the
/// ledger is another's, and the first error of a study.
void simulate_studies(const PowerSimulation& simulation) {
  const PowerTask& task = simulation.task;
  PowerLedger ledger(simulation.ledger, task.question);
  if (!task.without && !simulation.options.no_null) {
    say_what_is_not_simulated(task.question.response);
  }
  PowerWork work = work_of(simulation);
  do_power_studies(work, ledger);
}

/// False: a package of R is missing, and R has said which.
bool simulate_all(const PowerOptions& options, const PowerTask& task) {
  make_out_folder(options.out);
  const ScratchFolder scratch(options.out, kScratchBegin);
  const std::optional<PowerTools> tools = power_tools(scratch.path(), task.question.model);
  if (tools) {
    simulate_studies(
        {options, task, *tools, scratch.path(), fs::path(options.out) / kLedgerName, {}});
  }
  return tools.has_value();
}

/// The chunk's studies from a ledger of its own, which no other machine sees.
PowerChunk computed_chunk(const PowerOptions& options, const PowerTask& task, const Sweep& sweep,
                          ChunkMark& mark) {
  const auto begin = std::chrono::steady_clock::now();
  const ScratchFolder scratch(own_disk(), std::string("impetus-") + kScratchBegin);
  const fs::path ledger = scratch.path() / "chunk.sqlite";
  const auto told = [&mark](double share) { mark.tell(share); };
  const std::optional<PowerTools> tools = power_tools(scratch.path(), task.question.model);
  if (!tools) {
    throw std::runtime_error("a package of R is missing; R has said which");
  }
  sweep.require_build(tools->build);
  simulate_studies({options, task, *tools, scratch.path(), ledger, told});
  PowerChunk chunk{task.question, task.request, tools->build, 0.0, {}};
  chunk.studies = PowerLedger(ledger, task.question).studies();
  chunk.took_s = seconds_since(begin);
  return chunk;
}

/// Puts the studies of all chunks into the ledger, all or none. Throws InputError when a chunk is
/// missing, broken or another question's.
void gather_chunks(const Sweep& sweep, const PowerQuestion& question) {
  std::vector<TestedStudy> studies;
  sweep.read_all([&](const SweptChunk& chunk) {
    std::vector<TestedStudy> more = tested_studies(chunk);
    std::move(more.begin(), more.end(), std::back_inserter(studies));
  });
  PowerLedger(sweep.out / kLedgerName, question).add(studies);
}

int power(const PowerOptions& options) {
  const BuildingLine told;
  require_power_folder(options.out, options.chunks > 0);
  const PowerTask task = task_of(options);
  const Sweep sweep = power_sweep(options.out, task.question, task.request);
  if (options.list) {
    return list_chunks(sweep, options.repeated);
  }
  if (options.chunk > 0) {
    return compute_chunk(sweep, options.chunk, [&](ChunkMark& mark) {
      write_chunk(sweep.out, computed_chunk(options, task, sweep, mark));
    });
  }
  if (options.chunks > 0) {
    gather_chunks(sweep, task.question);
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
