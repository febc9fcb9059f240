// SPDX-License-Identifier: MIT
#include "experiments/files/child_process.hpp"

#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <string_view>

namespace impetus::inline files {
namespace {

void limit(int what, rlim_t most) {
  const rlimit both{most, most};
  setrlimit(static_cast<__rlimit_resource>(what), &both);
}

/// A crash is to end the copy at once, whatever the process does about its own.
void crash_plainly() {
  for (const int crash : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGXCPU, SIGPIPE}) {
    std::signal(crash, SIG_DFL);
  }
}

bool write_all(int pipe, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = write(pipe, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) {
      continue;
    }
    if (written < 0) {
      return false;
    }
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

/// Bytes that the process may write to and nobody else reads: what RLIMIT_DATA counts.
std::uint64_t own_bytes() {
  std::ifstream statm("/proc/self/statm");  // in pages: total, resident, shared, text, 0, data
  std::uint64_t pages = 0;
  for (int field = 0; field < 6; ++field) {
    statm >> pages;
  }
  return pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

[[noreturn]] void be_child(const std::function<std::string()>& work, int pipe,
                           const ChildLimits& limits) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);  // nobody would read what it finds
  crash_plainly();
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_CPU, static_cast<rlim_t>(limits.seconds));
  limit(RLIMIT_DATA, own_bytes() + limits.more_bytes);
  bool done = false;
  try {
    done = write_all(pipe, work());
  } catch (...) {
    // The status says so.
  }
  _exit(done ? 0 : 1);
}

std::string read_all(int pipe) {
  std::string bytes;
  std::array<char, 1 << 16> part{};
  while (true) {
    const ssize_t count = read(pipe, part.data(), part.size());
    if (count > 0) {
      bytes.append(part.data(), static_cast<std::size_t>(count));
    } else if (count == 0 || errno != EINTR) {
      return bytes;
    }
  }
}

int status_of(pid_t child) {
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

}  // namespace

std::optional<std::string> done_by_child(const std::function<std::string()>& work,
                                         const ChildLimits& limits) {
  std::fflush(nullptr);  // what waits to be printed is printed once
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) {
    throw std::runtime_error("no pipe could be made");
  }
  const pid_t child = fork();
  if (child == 0) {
    close(ends[0]);
    be_child(work, ends[1], limits);
  }
  close(ends[1]);
  if (child < 0) {
    close(ends[0]);
    throw std::runtime_error("no process could be started");
  }
  std::string bytes = read_all(ends[0]);
  close(ends[0]);
  const int status = status_of(child);
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
    return std::nullopt;
  }
  return bytes;
}

}  // namespace impetus::inline files
