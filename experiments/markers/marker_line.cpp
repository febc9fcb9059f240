// SPDX-License-Identifier: MIT
#include "experiments/markers/marker_line.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/socket.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <functional>
#include <utility>

#include "experiments/connections/lsl.hpp"
#include "experiments/connections/tcp.hpp"
#include "experiments/settings/input_error.hpp"

namespace impetus::inline markers {
namespace {

using Milliseconds = std::chrono::milliseconds;

constexpr Milliseconds kLongestWrite{100};
constexpr Milliseconds kLongestOpening{2000};
constexpr Milliseconds kLongestReopening{50};  ///< markers wait meanwhile
constexpr std::chrono::seconds kTriedAgainAfter{1};

/// As write(2), but a socket whose other end is gone is an error and not a signal.
ssize_t write_some(int file, const char* bytes, std::size_t size) {
  const ssize_t count = send(file, bytes, size, MSG_NOSIGNAL);
  return count < 0 && errno == ENOTSOCK ? ::write(file, bytes, size) : count;
}

bool write_whole(int file, const std::string& bytes) {
  const auto until = std::chrono::steady_clock::now() + kLongestWrite;
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t count = write_some(file, bytes.data() + done, bytes.size() - done);
    if (count > 0) {
      done += static_cast<std::size_t>(count);
      continue;
    }
    const auto left =
        std::chrono::duration_cast<Milliseconds>(until - std::chrono::steady_clock::now());
    const bool may_wait = count < 0 && (errno == EAGAIN || errno == EINTR);
    if (!may_wait || left.count() <= 0 || !await_file(file, POLLOUT, left)) {
      return false;
    }
  }
  return true;
}

/// Opens it, in at most that time. Throws InputError, saying what was there.
using Opening = std::function<OpenFile(Milliseconds longest)>;

/// A line that is opened again when it was lost.
class ReopenedLine final : public MarkerLine {
 public:
  ReopenedLine(Opening open, std::string (*bytes_of)(MarkedEvent, std::int64_t))
      : open_(std::move(open)), bytes_of_(bytes_of), file_(open_(kLongestOpening)) {}

  bool write(MarkedEvent event, std::int64_t code, std::int64_t /*event_ns*/) override {
    if (!file_.is_open() && !reopen()) {
      return false;
    }
    if (write_whole(file_.get(), bytes_of_(event, code))) {
      return true;
    }
    file_.close();
    lost_at_ = std::chrono::steady_clock::now();
    return false;
  }

 private:
  bool reopen() {
    if (std::chrono::steady_clock::now() - lost_at_ < kTriedAgainAfter) {
      return false;
    }
    lost_at_ = std::chrono::steady_clock::now();
    try {
      file_ = open_(kLongestReopening);
    } catch (const InputError&) {  // still away
    }
    return file_.is_open();
  }

  Opening open_;
  std::string (*bytes_of_)(MarkedEvent, std::int64_t);
  OpenFile file_;
  std::chrono::steady_clock::time_point lost_at_;
};

std::string byte_of(MarkedEvent /*event*/, std::int64_t code) { return {static_cast<char>(code)}; }

std::string words_of(MarkedEvent event, std::int64_t code) {
  return std::to_string(code) + " " + std::string(name_of(event));
}

std::string line_of(MarkedEvent event, std::int64_t code) { return words_of(event, code) + "\n"; }

[[noreturn]] void refuse_address(const std::string& address, const std::string& expected) {
  throw InputError("--markers: expected " + expected + ", got " + address);
}

[[noreturn]] void refuse_line(const std::string& address, const char* expected,
                              const std::string& instead) {
  throw InputError(std::string("--markers: expected ") + expected + ", got " + address + ": " +
                   instead);
}

// ---------------------------------------------------------------- a serial port

/// A speed of the line, as an address and as the system names it.
struct Speed {
  std::string_view words;
  speed_t speed;
};
constexpr std::array<Speed, 7> kSpeeds{{{"9600", B9600},
                                        {"19200", B19200},
                                        {"38400", B38400},
                                        {"57600", B57600},
                                        {"115200", B115200},
                                        {"230400", B230400},
                                        {"460800", B460800}}};

speed_t speed_of(const std::string& address, const std::string& words) {
  std::vector<std::string> known;
  for (const Speed& each : kSpeeds) {
    if (each.words == words) {
      return each.speed;
    }
    known.emplace_back(each.words);
  }
  refuse_address(address, "a baud of " + listed(known));
}

constexpr const char* kPort = "a serial port that opens";

OpenFile open_port(const std::string& address, const std::string& port, speed_t speed) {
  OpenFile file(::open(port.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
  termios settings{};
  if (!file.is_open() || tcgetattr(file.get(), &settings) != 0) {
    refuse_line(address, kPort, std::strerror(errno));
  }
  cfmakeraw(&settings);
  settings.c_cflag |= CLOCAL;
  cfsetspeed(&settings, speed);
  if (tcsetattr(file.get(), TCSANOW, &settings) != 0) {
    refuse_line(address, kPort, std::strerror(errno));
  }
  return file;
}

std::unique_ptr<MarkerLine> serial_line(const std::string& address, const std::string& rest) {
  constexpr std::string_view kBaud = "?baud=";
  const std::size_t mark = rest.find('?');
  const std::string port = rest.substr(0, mark);
  const std::string query = mark == std::string::npos ? "" : rest.substr(mark);
  if (port.empty() || port.front() != '/' || (!query.empty() && !query.starts_with(kBaud))) {
    refuse_address(address, "serial:///dev/PORT or serial:///dev/PORT?baud=115200");
  }
  const speed_t speed = speed_of(address, query.empty() ? "115200" : query.substr(kBaud.size()));
  return std::make_unique<ReopenedLine>(
      [=](Milliseconds /*longest*/) { return open_port(address, port, speed); }, byte_of);
}

// ---------------------------------------------------------------- a socket

constexpr const char* kProgram = "a program that listens";

OpenFile open_socket(const std::string& address, const std::string& host, const std::string& port,
                     Milliseconds longest) {
  try {
    return connect_tcp(host, port, longest);
  } catch (const NotConnected& refused) {
    refuse_line(address, kProgram, refused.what());
  }
}

std::unique_ptr<MarkerLine> socket_line(const std::string& address, const std::string& rest) {
  const std::size_t colon = rest.rfind(':');
  const std::string port = colon == std::string::npos ? "" : rest.substr(colon + 1);
  if (colon == 0 || port.empty() || port.find_first_not_of("0123456789") != std::string::npos) {
    refuse_address(address, "tcp://HOST:PORT");
  }
  const std::string host = rest.substr(0, colon);
  return std::make_unique<ReopenedLine>(
      [=](Milliseconds longest) { return open_socket(address, host, port, longest); }, line_of);
}

// ---------------------------------------------------------------- the Lab Streaming Layer

/// Whoever listens to the stream gets it; nobody need.
class StreamedLine final : public MarkerLine {
 public:
  explicit StreamedLine(const std::string& name) : outlet_(name, "Markers") {}

  bool write(MarkedEvent event, std::int64_t code, std::int64_t event_ns) override {
    return outlet_.push(words_of(event, code), event_ns);
  }

 private:
  LslOutlet outlet_;
};

std::unique_ptr<MarkerLine> streamed_line(const std::string& address, const std::string& name) {
  if (name.empty()) {
    refuse_address(address, "lsl://NAME, the name of the stream");
  }
  try {
    return std::make_unique<StreamedLine>(name);
  } catch (const std::runtime_error& missing) {
    refuse_line(address, "the library liblsl, which Debian has not (github.com/sccn/liblsl)",
                missing.what());
  }
}

}  // namespace

std::unique_ptr<MarkerLine> open_marker_line(const std::string& address) {
  const std::size_t end = address.find("://");
  const std::string scheme = address.substr(0, end == std::string::npos ? 0 : end);
  const std::string rest = end == std::string::npos ? "" : address.substr(end + 3);
  if (scheme == "serial") {
    return serial_line(address, rest);
  }
  if (scheme == "tcp") {
    return socket_line(address, rest);
  }
  if (scheme == "lsl") {
    return streamed_line(address, rest);
  }
  refuse_address(address, "serial:///dev/PORT, tcp://HOST:PORT or lsl://NAME");
}

}  // namespace impetus::inline markers
