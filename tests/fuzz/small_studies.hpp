// The golden recordings, cut down to what a fuzzer can go through many times a second.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "experiments/lines/published_study.hpp"

namespace impetus {

/// Files of studies with a few trials of a few steps.
const std::vector<std::string>& small_studies();

/// Texts that the golden recordings keep: a protocol, kPartSeparator and its scene, each made small
/// enough to check in moments.
std::vector<std::string> small_protocols();

/// One of these, as it is published.
PublishedStudy small_published_study();

}  // namespace impetus
