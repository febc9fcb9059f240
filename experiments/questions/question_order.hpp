// The order in which the questions after a stimulus are asked.
//
//   left out                            as kinds are listed
//
//   "question_order": ["yes_no", ...]   as it says
//
//   "question_order": "random"          drawn for each trial, by its seed alone
//
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "experiments/questions/response_kinds.hpp"

namespace impetus::inline questions {

Row<Script> question_order_row();

/// Refuses an order that is not made of the script's questions, each once.
void check_question_order(const JsonDocument& protocol, const Script& script);

/// Places in `script.asked`, in the order in which a trial of this seed asks.
std::vector<std::size_t> order_of_questions(const Script& script, std::uint64_t trial_seed);

}  // namespace impetus::inline questions
