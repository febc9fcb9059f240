// Programs of the user's path that a command has something done by.
// SPDX-License-Identifier: MIT
#pragma once

#include <sys/types.h>

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace impetus::inline commands {

/// A descriptor of ours that the program has as its own, such as our pipe as its input.
struct GivenDescriptor {
  int ours{0};
  int its{0};
};

/// Starts a program with its words, its name first. None: there is none of that name.
std::optional<pid_t> start_program(std::vector<std::string> words,
                                   const std::vector<GivenDescriptor>& given);

/// Waits until it ends: its status, as waitpid() tells it.
int await_program(pid_t program);

/// Both ends of a socket, closed in programs that are started but as they are given. No pipe: who
/// writes to a program that ended is told so, and gets no signal. Throws std::runtime_error.
std::array<int, 2> socket_ends();

/// Sends all of it; false: nobody listens any more.
bool send_all(int socket, std::span<const std::uint8_t> bytes);

}  // namespace impetus::inline commands
