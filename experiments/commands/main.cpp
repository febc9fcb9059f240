// The program `impetus`: reads the command line, runs one command, prints one sentence on failure.
// SPDX-License-Identifier: MIT
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <memory>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "experiments/commands/commands.hpp"
#include "experiments/provenance/build_name.hpp"
#include "experiments/run/scene_run.hpp"
#include "experiments/settings/input_error.hpp"
#include "experiments/workers/worker_pool.hpp"

namespace impetus::inline commands {
namespace {

/// In the order in which help lists them.
constexpr AddCommand* kCommands[] = {
    add_run,     add_check,   add_collect, add_exclude,   add_export, add_extremes, add_film,
    add_fit,     add_merge,   add_new,     add_observers, add_power,  add_predict,  add_preview,
    add_publish, add_recover, add_replay,  add_report,    add_screen, add_serve,    add_sessions,
    add_timing,  add_verify,  add_mesh,    add_tree,      add_trade};

}  // namespace
}  // namespace impetus::inline commands

namespace {

constexpr int kMostThreads = 64;

std::size_t letters_apart(const std::string& x, const std::string& y) {
  std::vector<std::size_t> apart(y.size() + 1);  // of what was read of x, from each beginning of y
  std::iota(apart.begin(), apart.end(), std::size_t{0});
  for (std::size_t i = 0; i < x.size(); ++i) {
    std::size_t diagonal = apart[0];
    apart[0] = i + 1;
    for (std::size_t j = 0; j < y.size(); ++j) {
      const std::size_t changed = diagonal + (x[i] == y[j] ? 0 : 1);
      diagonal = apart[j + 1];
      apart[j + 1] = std::min({changed, apart[j] + 1, diagonal + 1});
    }
  }
  return apart.back();
}

/// Of `words` the one that takes the fewest letters added, left out or changed to become `given`,
/// the first of equals; empty when that is more than two, or half of the word. (Levenshtein 1966)
std::string nearest_word(const std::string& given, const std::vector<std::string>& words) {
  std::string nearest;
  std::size_t least = std::min<std::size_t>(2, given.size() / 2) + 1;
  for (const std::string& word : words) {
    const std::size_t apart = letters_apart(given, word);
    if (apart < least) {
      nearest = word;
      least = apart;
    }
  }
  return nearest;
}

std::string perhaps(const std::string& given, const std::vector<std::string>& words) {
  const std::string meant = nearest_word(given, words);
  return meant.empty() ? "" : "; did you mean " + meant + "?";
}

std::string unknown_command(const CLI::App& app, const std::string& given) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    names.push_back(command->get_name());
  }
  return "expected one of the commands " + impetus::listed(names) + ", got " +
         (given.empty() ? "none" : given) + perhaps(given, names);
}

/// What was not understood of a command's arguments, and which option may have been meant.
std::string unknown_argument(const CLI::App& command, const CLI::ParseError& error) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    names.push_back(option->get_name());
  }
  const std::vector<std::string> unknown = command.remaining();
  return error.what() + (unknown.empty() ? "" : perhaps(unknown.front(), names));
}

/// Options whose words are lists would take what stands behind them for more of the list, so usages
/// name what has no option first.
class PlainFormatter final : public CLI::Formatter {
 public:
  std::string make_usage(const CLI::App* app, std::string name) const override {
    std::string usage = Formatter::make_usage(app, std::move(name));
    const std::string options = " [" + get_label("OPTIONS") + "]";
    const std::size_t at = usage.find(options + " ");
    if (at != std::string::npos && !app->get_options(is_positional).empty()) {
      usage.erase(at, options.size());
      usage.insert(usage.find_last_not_of('\n') + 1, options);
    }
    return usage;
  }

 private:
  static bool is_positional(const CLI::Option* option) { return option->get_positional(); }
};

/// Refuses whole numbers that the library would read by another base: 010 is 8 to it, 0x10 is 16.
void require_decimal_numbers(const CLI::App& app) {
  for (const CLI::Option* option : app.get_options()) {
    const std::string type = option->get_type_name();
    for (const std::string& given : option->results()) {
      const std::size_t first = given.find_first_not_of("+-");
      if ((type.starts_with("INT") || type.starts_with("UINT")) && first + 1 < given.size() &&
          given[first] == '0') {
        throw CLI::ValidationError(option->get_name(),
                                   "expected a whole number without a 0 before it, got " + given);
      }
    }
  }
  for (const CLI::App* command : app.get_subcommands()) {
    require_decimal_numbers(*command);
  }
}

/// Whether all that was printed was written, or nobody was meant to read it; else says so.
bool told_all() {
  const bool written = std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
  if (!written && ::fcntl(STDOUT_FILENO, F_GETFD) != -1) {
    std::fprintf(stderr, "impetus: what was to be printed could not be written in full\n");
    return false;
  }
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // a file that may grow no further is a failed write, not the end
  CLI::App app{"Impetus: experiments on how believable an approximated collision looks."};
  app.formatter(std::make_shared<PlainFormatter>());
  app.require_subcommand(1);
  app.set_version_flag("--version", impetus::version_text());
  int threads = 1;
  app.add_option(
         "--threads", threads,
         "Threads that share a step of a crowd, where no budget is in milliseconds; what it "
         "comes to stays the same")
      ->check(CLI::Range(1, kMostThreads))
      ->envname("IMPETUS_THREADS")
      ->capture_default_str();
  impetus::Command chosen;
  for (impetus::AddCommand* add : impetus::kCommands) {
    add(app, chosen);
  }
  try {
    app.parse(argc, argv);
    require_decimal_numbers(app);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) {  // --help or --version
      return app.exit(error);
    }
    const std::string reason = app.get_subcommands().empty()
                                   ? unknown_command(app, argc > 1 ? argv[1] : "")
                                   : unknown_argument(*app.get_subcommands().back(), error);
    std::fprintf(stderr, "impetus: %s\n", reason.c_str());
    return impetus::kCouldNotRun;
  }
  try {
    if (threads > 1) {
      impetus::SceneRun::share_work_with(std::make_shared<impetus::WorkerPool>(threads));
    }
    const int status = chosen();
    return told_all() ? status : impetus::kCouldNotRun;
  } catch (const std::exception& error) {
    std::fflush(stdout);
    std::fprintf(stderr, "impetus: %s\n", error.what());
    return impetus::kCouldNotRun;
  }
}
