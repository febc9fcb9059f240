// What this machine and its system are; not whose, nor what it is called in its network.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace impetus::inline provenance {

/// "Debian GNU/Linux 12 (bookworm), Linux 6.1.0-18-amd64 x86_64, AMD Ryzen 7 5800X 8-Core
/// Processor, 16 cores, 31.3 GiB"; without what the system does not tell.
std::string machine_name();

}  // namespace impetus::inline provenance
