// JSON with one value changed for another: what gets past the parser, which changed bytes seldom
// do.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "engine/numerics/random_stream.hpp"

namespace impetus {

/// One value anywhere in `text` replaced by one that a reader may not expect, or by another of the
/// text's own; a key left out, or one put in. `text` as it is, when it is not JSON.
std::string mutated_json(std::string_view text, RandomStream& random);

/// The same of one of two texts with kPartSeparator between them.
std::string mutated_pair(std::string_view texts, RandomStream& random);

}  // namespace impetus
