// Connections over TCP that never block.
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <stdexcept>
#include <string>

#include "experiments/connections/open_file.hpp"

namespace impetus::inline connections {

/// Nobody answers; what() says why, in the system's words.
class NotConnected : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Connects to the first address of the host that answers, each within that time; small messages
/// are sent at once (no Nagle). Throws NotConnected.
OpenFile connect_tcp(const std::string& host, const std::string& port,
                     std::chrono::milliseconds longest);

/// Whether the events of poll(2) came within that time; a connection that is gone has come, too.
bool await_file(int file, short events, std::chrono::milliseconds longest);

}  // namespace impetus::inline connections
