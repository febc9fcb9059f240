// SPDX-License-Identifier: MIT
#include "experiments/commands/r_program.hpp"

#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <utility>

#include "experiments/commands/program_start.hpp"
#include "experiments/settings/input_error.hpp"

namespace impetus::inline commands {
namespace {

std::optional<pid_t> start_r_script(const std::vector<std::string>& words,
                                    const std::vector<GivenDescriptor>& given) {
  std::vector<std::string> all{"Rscript", "--vanilla"};
  all.insert(all.end(), words.begin(), words.end());
  return start_program(std::move(all), given);
}

int exit_status(pid_t program) {
  const int status = await_program(program);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

[[noreturn]] void throw_no_rscript() {
  throw InputError("expected R, got no Rscript on the path (apt-get install r-base-core)");
}

}  // namespace

int run_r_script(const std::vector<std::string>& words) {
  const auto child = start_r_script(words, {{STDERR_FILENO, STDOUT_FILENO}});
  return child ? exit_status(*child) : kNoRscript;
}

int run_needed_r_script(const std::vector<std::string>& words) {
  const int status = run_r_script(words);
  if (status == kNoRscript) {
    throw_no_rscript();
  }
  return status;
}

AskingRScript::AskingRScript(const std::vector<std::string>& words) {
  const std::array<int, 2> ends = socket_ends();
  const auto child = start_r_script(words, {{ends[1], STDIN_FILENO}, {ends[1], STDOUT_FILENO}});
  close(ends[1]);
  if (!child) {
    close(ends[0]);
    throw_no_rscript();
  }
  socket_ = ends[0];
  process_ = *child;
}

AskingRScript::~AskingRScript() {
  close(socket_);
  if (process_ > 0) {
    kill(process_, SIGKILL);
    await_program(process_);
  }
}

std::optional<std::string> AskingRScript::hear() {
  std::array<char, 4096> part{};
  std::size_t end = 0;
  while ((end = heard_.find('\n')) == std::string::npos) {
    const ssize_t count = recv(socket_, part.data(), part.size(), 0);
    if (count < 0 && errno == EINTR) {
      continue;
    }
    if (count <= 0) {
      return std::nullopt;
    }
    heard_.append(part.data(), static_cast<std::size_t>(count));
  }
  std::string line = heard_.substr(0, end);
  heard_.erase(0, end + 1);
  return line;
}

bool AskingRScript::tell(const std::string& line) {
  const std::string whole = line + "\n";
  return send_all(socket_, {reinterpret_cast<const std::uint8_t*>(whole.data()), whole.size()});
}

int AskingRScript::await() { return exit_status(std::exchange(process_, 0)); }

}  // namespace impetus::inline commands
