// Which key stands for which answer: the language's, the question's own, or those of a factor's
// level.
//
//   yes_no                    "keys": "f j"              yes F    no J
//   factor, keys_of yes_no    level "f j"                yes F    no J
//                             level "j f"                no F     yes J
//
// The keys of a factor keep their sides of the screen, as the first level has them: it is the
// answers that change sides. What was pressed for an answer follows from the protocol and the
// trial's condition; what is recorded is the answer.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "experiments/questions/response_kinds.hpp"

namespace impetus::inline questions {

/// "f j" as a file has it.
Kind<std::vector<std::string>> answer_keys_kind();

/// The keys of a level, "f j", of a factor of keys; none where the level is no text.
std::vector<std::string> keys_of_level(const LevelValue& level);

/// A factor whose levels are keys, as its script needs it.
KeyFactor key_factor(const Factor& factor);

/// A question's page with its keys, and which answer each of its choices stands for.
struct KeyedPage {
  Page page;
  std::vector<std::size_t> answers;
};
KeyedPage with_keys(Page page, const Question& question, const Script& script,
                    const Condition& condition);

/// Refuses keys, given at `place`, that are not as many letters or digits as there are answers, or
/// not all different.
void check_keys(const JsonDocument& protocol, const std::string& place,
                const std::vector<std::string>& keys, std::size_t answers);

}  // namespace impetus::inline questions
