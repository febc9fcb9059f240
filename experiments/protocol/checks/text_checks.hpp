// Whether screens can show what a protocol has them say.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/settings/json_document.hpp"

namespace impetus::inline protocol {

/// Every letter of pages and questions is one of kShownLetters, a line break or a tab. `protocol`
/// fulfils its schema. Throws InputError. Asked of files alone: what a study holds was shown.
void check_texts(const JsonDocument& protocol);

}  // namespace impetus::inline protocol
