// Work that may crash, done by a copy of the process: what comes of it are bytes, or nothing.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>

namespace impetus {

/// What `work` returns; nothing when the copy crashed, threw, or computed for longer than
/// `seconds`. Changes that `work` makes in memory are lost. Throws std::runtime_error when no copy
/// can be made.
std::optional<std::string> done_by_child(const std::function<std::string()>& work, int seconds);

}  // namespace impetus
