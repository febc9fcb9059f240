// SPDX-License-Identifier: MIT
#include "experiments/commands/power/power_simulation.hpp"

#include <cstdio>
#include <fstream>
#include <string>

#include "experiments/commands/power/power_studies.hpp"
#include "experiments/commands/r_program.hpp"
#include "experiments/exports/r_scripts.hpp"
#include "experiments/power/power_ledger.hpp"
#include "experiments/provenance/build_name.hpp"

namespace impetus::inline commands {
namespace {

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

}  // namespace

std::optional<PowerTools> power_tools(const std::filesystem::path& folder,
                                      const std::string& model) {
  const std::filesystem::path script = write_r_scripts(folder, {"power-fits.R"}) / "power-fits.R";
  const std::filesystem::path versions = folder / "versions.txt";
  if (run_needed_r_script({script.string(), "--check", model, versions.string()}) != 0) {
    return std::nullopt;
  }
  std::string words;
  std::getline(std::ifstream(versions), words);
  return PowerTools{script, std::string(build_name()) + " with " + words};
}

void simulate_studies(const PowerSimulation& simulation) {
  const PowerTask& task = simulation.task;
  PowerLedger ledger(simulation.ledger, task.question);
  if (!task.without && !simulation.options.no_null) {
    say_what_is_not_simulated(task.question.response);
  }
  PowerWork work = work_of(simulation);
  do_power_studies(work, ledger);
}

}  // namespace impetus::inline commands
