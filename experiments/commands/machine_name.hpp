// What this machine calls itself and its system.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace impetus {

/// "Linux 6.1.0-18-amd64 x86_64"
std::string machine_name();

}  // namespace impetus
