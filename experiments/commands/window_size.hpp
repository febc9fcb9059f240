// The option --window WIDTHxHEIGHT.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "experiments/stage/window.hpp"

namespace impetus {

/// Fullscreen for "". Throws InputError for anything but WIDTHxHEIGHT of at least 640x480.
WindowOptions window_options(const std::string& size);

}  // namespace impetus
