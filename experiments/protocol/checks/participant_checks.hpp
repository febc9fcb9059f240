// Whether a protocol has what its participants need, or nothing that nobody would see.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/settings/json_document.hpp"

namespace impetus::inline protocol {

/// Whether people or simulated participants take part. `protocol` is valid by its schema.
bool has_participants(const nlohmann::json& protocol);

/// Throws InputError where participants lack timing or session, or nobody is asked something.
void check_participants(const JsonDocument& protocol);

}  // namespace impetus::inline protocol
