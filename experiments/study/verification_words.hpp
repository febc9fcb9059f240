// What `impetus verify` found, in words for a terminal and as JSON for programs.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "experiments/study/verification.hpp"

namespace impetus::inline study {

/// A line for each check, each failure and each remark; the last line alone says whether the study
/// `name` can be published, and if not, the first reason.
std::string verification_words(const std::string& name, const Verification& verification);

/// The same as one JSON object.
std::string verification_json(const std::string& name, const Verification& verification);

}  // namespace impetus::inline study
