// Runs the program itself, as a shell would, and tells what came of it.
// SPDX-License-Identifier: MIT
#pragma once

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

#include "tests/experiments/temporary_folder.hpp"
#include "tests/places/places.hpp"

namespace impetus {

struct ProgramResult {
  int status{-1};  ///< −1: ended by a signal
  std::string output;
  std::string errors;
};

/// Starts the program in `folder` without a display; its output goes to files there. Returns its
/// process. `before` runs in the child, just before the program takes over.
inline pid_t start_program(const TemporaryFolder& folder, const std::vector<std::string>& arguments,
                           const std::function<void()>& before = {}) {
  std::string program = program_file();
  std::vector<std::string> words = arguments;
  std::vector<char*> pointers{program.data()};
  for (std::string& word : words) {
    pointers.push_back(word.data());
  }
  pointers.push_back(nullptr);
  const std::string output = folder / "stdout";
  const std::string errors = folder / "stderr";
  const pid_t child = fork();
  if (child == 0) {
    for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "SDL_VIDEODRIVER"}) {
      unsetenv(name);
    }
    setenv("XDG_CONFIG_HOME", folder.path().c_str(), 1);
    setenv("XDG_CACHE_HOME", folder.path().c_str(), 1);
    const int flags = O_WRONLY | O_CREAT | O_TRUNC;
    const bool ready = chdir(folder.path().c_str()) == 0 &&
                       dup2(open(output.c_str(), flags, 0644), STDOUT_FILENO) >= 0 &&
                       dup2(open(errors.c_str(), flags, 0644), STDERR_FILENO) >= 0;
    if (before) {
      before();
    }
    if (ready) {
      execv(program.c_str(), pointers.data());
    }
    _exit(127);
  }
  return child;
}

inline ProgramResult wait_for(const TemporaryFolder& folder, pid_t child) {
  int status = 0;
  waitpid(child, &status, 0);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text_of(folder / "stdout"),
          text_of(folder / "stderr")};
}

inline ProgramResult run_program(const TemporaryFolder& folder,
                                 const std::vector<std::string>& arguments,
                                 const std::function<void()>& before = {}) {
  return wait_for(folder, start_program(folder, arguments, before));
}

inline std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t start = 0; start < text.size();) {
    const std::size_t end = std::min(text.find('\n', start), text.size());
    lines.push_back(text.substr(start, end - start));
    start = end + 1;
  }
  return lines;
}

/// What the program said on stderr but for its progress, such as "simulating 8 %, about 12 s left",
/// which a slow machine makes it tell.
inline std::string complaints_of(const ProgramResult& result) {
  std::string complaints;
  for (const std::string& line : lines_of(result.errors)) {
    complaints += line.ends_with(" %") || line.ends_with(" left") ? "" : line + "\n";
  }
  return complaints;
}

/// The shipped protocol.
inline std::string causality_file() { return source_folder() + "/protocols/causality.json"; }

/// "run protocol --db a.sqlite --observer causality", and more.
inline std::vector<std::string> simulated_run(const std::vector<std::string>& more) {
  std::vector<std::string> words{"run",      causality_file(), "--db",
                                 "a.sqlite", "--observer",     "causality"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

}  // namespace impetus
