// SPDX-License-Identifier: MIT
#include "experiments/commands/r_program.hpp"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>

#include "experiments/settings/input_error.hpp"

namespace impetus::inline commands {

int run_r_script(const std::vector<std::string>& words) {
  std::vector<std::string> all{"Rscript", "--vanilla"};
  all.insert(all.end(), words.begin(), words.end());
  std::vector<char*> pointers;
  pointers.reserve(all.size() + 1);
  for (std::string& word : all) {
    pointers.push_back(word.data());
  }
  pointers.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, STDERR_FILENO, STDOUT_FILENO);
  pid_t child = 0;
  const int error =
      posix_spawnp(&child, pointers.front(), &actions, nullptr, pointers.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) {
    return kNoRscript;
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
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
