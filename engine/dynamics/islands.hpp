// Groups contacts that can affect each other: those connected through bodies that can move.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "engine/collision/contact_model.hpp"
#include "engine/dynamics/body.hpp"

namespace impetus {

/// Indices of `contacts`, island by island in the order of each island's first contact, rising
/// within an island. Bodies that nothing moves, and walls, connect nothing.
std::vector<std::vector<std::size_t>> islands_of(const std::vector<Contact>& contacts,
                                                 const std::vector<BodyModel>& models);

}  // namespace impetus
