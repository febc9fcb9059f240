// Bytes as a gzip file: the same bytes give the same file, for it holds no name and no time.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace impetus::inline exports {

/// Throws std::runtime_error when there is no memory for it.
std::string gzip(std::string_view bytes);

}  // namespace impetus::inline exports
