// SPDX-License-Identifier: MIT
#include "tests/bench/bounded_child.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <exception>
#include <new>

namespace impetus {
namespace {

constexpr int kRefusedStatus = 3;

void bound(int most_cpu_s) {
  const auto seconds = static_cast<rlim_t>(most_cpu_s);
  const rlimit cpu{seconds, seconds + 1};
  setrlimit(RLIMIT_CPU, &cpu);
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  constexpr rlim_t kMostMemory = rlim_t{3} << 30;
  const rlimit memory{kMostMemory, kMostMemory};
  setrlimit(RLIMIT_AS, &memory);
}

void be_silent() {
  const int nowhere = open("/dev/null", O_WRONLY);
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
}

[[noreturn]] void be_child(const std::function<std::vector<double>()>& work, int out) {
  int status = 0;
  try {
    const std::vector<double> found = work();
    const std::size_t bytes = found.size() * sizeof(double);
    status = write(out, found.data(), bytes) == static_cast<ssize_t>(bytes) ? 0 : 1;
  } catch (const std::bad_alloc&) {
    status = 1;
  } catch (const std::exception&) {
    status = kRefusedStatus;
  }
  _exit(status);
}

ChildEnd end_of(int status) {
  if (WIFSIGNALED(status)) {
    const int signal = WTERMSIG(status);
    return signal == SIGXCPU || signal == SIGKILL ? ChildEnd::kHung : ChildEnd::kCrashed;
  }
  const int code = WEXITSTATUS(status);
  return code == 0                ? ChildEnd::kDone
         : code == kRefusedStatus ? ChildEnd::kRefused
                                  : ChildEnd::kCrashed;
}

}  // namespace

ChildResult in_bounded_child(const std::function<std::vector<double>()>& work, int most_cpu_s) {
  std::fflush(nullptr);
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) {
    return {};
  }
  const pid_t child = fork();
  if (child == 0) {
    close(ends[0]);
    bound(most_cpu_s);
    be_silent();
    be_child(work, ends[1]);
  }
  close(ends[1]);
  ChildResult result;
  double number = 0.0;
  while (read(ends[0], &number, sizeof number) == static_cast<ssize_t>(sizeof number)) {
    result.found.push_back(number);
  }
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  result.end = end_of(status);
  return result;
}

}  // namespace impetus
