// Whether the criterion of training can be met; each refusal is one sentence.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/settings/json_document.hpp"

namespace impetus::inline protocol {

/// As many right answers fit into the trials that are looked at as train_until asks for, and these
/// into the most that there are. Throws InputError.
void check_training_criterion(const JsonDocument& protocol);

}  // namespace impetus::inline protocol
