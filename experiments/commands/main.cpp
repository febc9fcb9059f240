// The program `impetus`: reads the command line, runs one command, prints one sentence on failure.
// SPDX-License-Identifier: MIT
#include <cstdio>
#include <exception>

#include "build_info.hpp"
#include "experiments/commands/commands.hpp"

int main(int argc, char** argv) {
  CLI::App app{"Impetus: experiments on how believable an approximated collision looks."};
  app.require_subcommand(1);
  app.set_version_flag("--version", impetus::kBuild);
  impetus::Command chosen;
  impetus::add_run(app, chosen);
  impetus::add_check(app, chosen);
  impetus::add_replay(app, chosen);
  impetus::add_screen(app, chosen);
  impetus::add_mesh(app, chosen);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? impetus::kDone : impetus::kCouldNotRun;
  }
  try {
    return chosen();
  } catch (const std::exception& error) {
    std::fflush(stdout);
    std::fprintf(stderr, "impetus: %s\n", error.what());
    return impetus::kCouldNotRun;
  }
}
