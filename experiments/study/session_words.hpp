// The list of a study's sessions, in words for a terminal and as JSON for programs.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "experiments/store/session_list.hpp"

namespace impetus::inline study {

/// Tables of who takes part and how each sitting went, then what is left out and what notes say;
/// one sentence where nobody takes part. `name` is the study's.
std::string session_words(const std::string& name, const SessionList& list);

/// The same as one JSON object; keys are the names of the structs' members.
std::string session_json(const std::string& name, const SessionList& list);

}  // namespace impetus::inline study
