// A script that stands in for a tracker, as a child of the test.
// SPDX-License-Identifier: MIT
#pragma once

#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>
#include <csignal>
#include <string>

#include "tests/places/places.hpp"

namespace impetus {

/// A port that nobody listens at.
inline int free_port() {
  const int probe = socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  const bool found = bind(probe, reinterpret_cast<sockaddr*>(&address), size) == 0 &&
                     getsockname(probe, reinterpret_cast<sockaddr*>(&address), &size) == 0;
  close(probe);
  return found ? ntohs(address.sin_port) : 0;
}

/// Debian's Python, which has Debian's packages.
inline constexpr const char* kPython = "/usr/bin/python3";

inline bool python_has(const std::string& modules) {
  const std::string command = std::string(kPython) + " -c 'import " + modules + "' 2>/dev/null";
  return std::system(command.c_str()) == 0;
}

/// Runs from its making until it is destroyed, killed as a machine that loses power is.
class StandIn {
 public:
  /// "drops": it goes, and comes back, again and again.
  StandIn(const std::string& name, int port, const std::string& shift_s,
          const std::string& drops = "") {
    const std::string script = source_folder() + "/tests/trackers/" + name;
    const std::string port_words = std::to_string(port);
    process_ = fork();
    if (process_ == 0) {
      execl(kPython, kPython, script.c_str(), port_words.c_str(), shift_s.c_str(), drops.c_str(),
            nullptr);
      _exit(127);
    }
  }
  ~StandIn() {
    kill(process_, SIGKILL);
    waitpid(process_, nullptr, 0);
  }
  StandIn(const StandIn&) = delete;
  StandIn& operator=(const StandIn&) = delete;

 private:
  pid_t process_{-1};
};

}  // namespace impetus
