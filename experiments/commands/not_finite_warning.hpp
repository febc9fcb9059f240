// A word on what the engine could not go on with.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/store/study_writer.hpp"

namespace impetus {

/// Warns of trials that are marked, since a body's state was not finite.
void tell_not_finite(const StudyWriter& writer);

}  // namespace impetus
