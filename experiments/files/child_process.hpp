// Work that may crash, done by a copy of the process: what comes of it are bytes, or nothing.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace impetus::inline files {

/// What a copy of the process may use.
struct ChildLimits {
  int seconds{0};               ///< of computing
  std::uint64_t more_bytes{0};  ///< of memory, beyond what the process has
};

/// What `work` returns; nothing when the copy crashed, threw, or computed for longer than it may.
/// Beyond the memory it may have it gets std::bad_alloc. Changes that `work` makes in memory are
/// lost. Throws std::runtime_error when no copy can be made.
std::optional<std::string> done_by_child(const std::function<std::string()>& work,
                                         const ChildLimits& limits);

}  // namespace impetus::inline files
