// Whether a protocol has what its participants need: something to answer, words that screens can
// show, scenes for both intervals; or nothing of it where nobody takes part.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/protocol/protocol_file.hpp"

namespace impetus::inline protocol {

/// Throws InputError where participants lack timing or session, or nobody is asked something.
void check_participants(const Protocol& protocol);

/// Every letter of pages and questions is one of kShownLetters, a line break or a tab; of
/// kWideLetters too, where the language has any. Throws InputError. Asked of files alone: what a
/// study holds was shown.
void check_texts(const Protocol& protocol);

/// The same of a lab's language file, in which wide letters may stand.
void check_letters(const JsonDocument& language);

/// There is something to answer, unless the protocol has no participants; what a question names is
/// a factor of the design. Throws InputError.
void check_responses(const Protocol& protocol);

/// Training has practice conditions and a question with a right answer, and is the only rule.
/// Throws InputError.
void check_training(const Protocol& protocol);

/// Of two intervals, the standard can be shown under every condition. Throws InputError.
void check_standard(const Protocol& protocol);

}  // namespace impetus::inline protocol
