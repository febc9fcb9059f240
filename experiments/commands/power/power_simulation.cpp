// SPDX-License-Identifier: MIT
#include "experiments/commands/power/power_simulation.hpp"

#include <cstdio>
#include <string>

#include "experiments/commands/power/power_studies.hpp"
#include "experiments/commands/r_program.hpp"
#include "experiments/exports/r_scripts.hpp"
#include "experiments/power/power_ledger.hpp"

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
  work.scratch = simulation.scratch;
  work.ledger = simulation.ledger;
  work.told = simulation.told;
  return work;
}

}  // namespace

bool simulate_studies(const PowerSimulation& simulation) {
  const PowerTask& task = simulation.task;
  const std::filesystem::path script =
      write_r_scripts(simulation.scratch, {"power-fits.R"}) / "power-fits.R";
  if (run_needed_r_script({script.string(), "--check", task.question.model}) != 0) {
    return false;
  }
  PowerLedger ledger(simulation.ledger, task.question);
  if (!task.without && !simulation.options.no_null) {
    say_what_is_not_simulated(task.question.response);
  }
  PowerWork work = work_of(simulation);
  work.script = script;
  do_power_studies(work, ledger);
  return true;
}

}  // namespace impetus::inline commands
