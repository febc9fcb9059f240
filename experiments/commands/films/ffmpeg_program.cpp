// SPDX-License-Identifier: MIT
#include "experiments/commands/films/ffmpeg_program.hpp"

#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <stdexcept>
#include <utility>

#include "experiments/commands/program_start.hpp"
#include "experiments/settings/input_error.hpp"

namespace impetus::inline commands {
namespace {

std::string last_line(std::string text) {
  text.erase(text.find_last_not_of(" \r\n") + 1);
  return text.substr(text.find_last_of("\r\n") + 1);
}

/// "" of a program that ended as it should.
std::string end_words(int status) {
  if (WIFSIGNALED(status)) {
    return "ended by signal " + std::to_string(WTERMSIG(status));
  }
  const int code = WEXITSTATUS(status);
  return code == 0 ? "" : "exit status " + std::to_string(code);
}

}  // namespace

FfmpegProgram::FfmpegProgram(const std::vector<std::string>& words)
    : said_(memfd_create("ffmpeg", MFD_CLOEXEC)) {
  if (said_ < 0) {
    throw std::runtime_error("no file could be made for what ffmpeg says");
  }
  const std::array<int, 2> ends = socket_ends();
  input_ = ends[0];
  std::vector<std::string> all{"ffmpeg", "-hide_banner", "-loglevel", "error", "-xerror"};
  all.insert(all.end(), words.begin(), words.end());
  const auto started = start_program(
      std::move(all), {{ends[1], STDIN_FILENO}, {said_, STDOUT_FILENO}, {said_, STDERR_FILENO}});
  close(ends[1]);
  if (!started) {
    close_input();
    close(said_);
    throw InputError(
        "expected ffmpeg, got none on the path (apt-get install ffmpeg); a folder of PNG files "
        "needs none: --out NAME/");
  }
  process_ = *started;
}

FfmpegProgram::~FfmpegProgram() {
  close_input();
  if (process_ > 0) {
    kill(process_, SIGKILL);
    await_program(process_);
  }
  close(said_);
}

void FfmpegProgram::close_input() {
  if (input_ >= 0) {
    close(std::exchange(input_, -1));
  }
}

bool FfmpegProgram::take(std::span<const std::uint8_t> bytes) { return send_all(input_, bytes); }

std::string FfmpegProgram::await() {
  close_input();
  const std::string end = end_words(await_program(std::exchange(process_, 0)));
  // It complains of what keeps it from writing, and may still say with its status that all is well.
  const std::string complaint = last_line(said());
  return complaint.empty() ? end : complaint;
}

std::string FfmpegProgram::said() const {
  std::string text;
  std::array<char, 4096> part{};
  ssize_t count = 0;
  while ((count = pread(said_, part.data(), part.size(), static_cast<off_t>(text.size()))) > 0) {
    text.append(part.data(), static_cast<std::size_t>(count));
  }
  return text;
}

void require_encoder(const std::string& encoder) {
  FfmpegProgram program({"-encoders"});
  static_cast<void>(program.await());
  if (program.said().find(" " + encoder + " ") == std::string::npos) {
    throw InputError("expected an ffmpeg with the encoder " + encoder +
                     ", got one without it; another ending of --out needs another encoder");
  }
}

}  // namespace impetus::inline commands
