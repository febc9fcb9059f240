// Bytes as text (RFC 4648, section 4).
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace impetus::inline models {

std::string base64(std::string_view bytes);

/// Throws std::runtime_error (expected ..., got ...) for what base64() does not make.
std::string bytes_from_base64(std::string_view text);

}  // namespace impetus::inline models
