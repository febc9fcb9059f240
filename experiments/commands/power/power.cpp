// `impetus power`: how many participants a study needs, from whole simulated studies.
//
//   options ─> a question ─> its ledger ─> simulated studies, tested (power_studies.hpp)
//                 │            ^   └─────> Rscript power.R ─> power.html, figure, table
//                 └─> chunks ──┘  each computed by whatever machine (power_chunks.hpp)
//
// SPDX-License-Identifier: MIT
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

#include "experiments/commands/commands.hpp"
#include "experiments/commands/power/given_words.hpp"
#include "experiments/commands/power/power_chunks.hpp"
#include "experiments/commands/power/power_options.hpp"
#include "experiments/commands/power/power_simulation.hpp"
#include "experiments/commands/progress_line.hpp"
#include "experiments/commands/r_program.hpp"
#include "experiments/commands/scratch_folder.hpp"
#include "experiments/exports/r_scripts.hpp"
#include "experiments/power/power_chunk.hpp"
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

int power(const PowerOptions& options) {
  const BuildingLine told;
  require_power_folder(options.out, options.chunks > 0);
  const PowerTask task = task_of(options);
  if (options.list) {
    return list_chunks(options, task);
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
