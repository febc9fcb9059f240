// SPDX-License-Identifier: MIT
#include "experiments/commands/r_program.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include "experiments/commands/program_start.hpp"
#include "experiments/settings/input_error.hpp"

namespace impetus::inline commands {

int run_r_script(const std::vector<std::string>& words) {
  std::vector<std::string> all{"Rscript", "--vanilla"};
  all.insert(all.end(), words.begin(), words.end());
  const auto child = start_program(std::move(all), {{STDERR_FILENO, STDOUT_FILENO}});
  if (!child) {
    return kNoRscript;
  }
  const int status = await_program(*child);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

int run_needed_r_script(const std::vector<std::string>& words) {
  const int status = run_r_script(words);
  if (status == kNoRscript) {
    throw InputError("expected R, got no Rscript on the path (apt-get install r-base-core)");
  }
  return status;
}

}  // namespace impetus::inline commands
