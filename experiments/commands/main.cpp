// The program `impetus`: reads the command line, runs one command, prints one sentence on failure.
// SPDX-License-Identifier: MIT
#include <cstdio>
#include <exception>
#include <string>

#include "experiments/commands/build_name.hpp"
#include "experiments/commands/commands.hpp"

namespace {

std::string unknown_command(const CLI::App& app, const std::string& given) {
  std::string names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    names += (names.empty() ? "" : ", ") + command->get_name();
  }
  return "expected one of the commands " + names + ", got " + (given.empty() ? "none" : given);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Impetus: experiments on how believable an approximated collision looks."};
  app.require_subcommand(1);
  app.set_version_flag("--version", impetus::version_text());
  impetus::Command chosen;
  impetus::add_run(app, chosen);
  impetus::add_check(app, chosen);
  impetus::add_exclude(app, chosen);
  impetus::add_export(app, chosen);
  impetus::add_extremes(app, chosen);
  impetus::add_merge(app, chosen);
  impetus::add_power(app, chosen);
  impetus::add_preview(app, chosen);
  impetus::add_replay(app, chosen);
  impetus::add_report(app, chosen);
  impetus::add_screen(app, chosen);
  impetus::add_sessions(app, chosen);
  impetus::add_timing(app, chosen);
  impetus::add_verify(app, chosen);
  impetus::add_mesh(app, chosen);
  impetus::add_tree(app, chosen);
  impetus::add_trade(app, chosen);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) {  // --help or --version
      return app.exit(error);
    }
    const std::string reason = app.get_subcommands().empty()
                                   ? unknown_command(app, argc > 1 ? argv[1] : "")
                                   : error.what();
    std::fprintf(stderr, "impetus: %s\n", reason.c_str());
    return impetus::kCouldNotRun;
  }
  try {
    return chosen();
  } catch (const std::exception& error) {
    std::fflush(stdout);
    std::fprintf(stderr, "impetus: %s\n", error.what());
    return impetus::kCouldNotRun;
  }
}
