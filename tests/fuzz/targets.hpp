// What a fuzzer feeds: each takes any bytes and returns, or something is wrong.
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace impetus {

/// The first letter chooses the format; the rest is a file of it.
void fuzz_mesh_file(std::string_view bytes);

/// A tree file without its checksum, which is put right first.
void fuzz_tree_file(std::string_view bytes);

}  // namespace impetus
