// Whether a session can be resumed as its protocol says; each refusal is one sentence.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/settings/json_document.hpp"

namespace impetus::inline protocol {

/// Only a design that has blocks, and whose levels do not follow from answers that would be set
/// aside, is resumed at a block's start. Throws InputError.
void check_resume(const JsonDocument& protocol);

}  // namespace impetus::inline protocol
