// Which simulated participants have parameters that can be fitted.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/protocol/observer_file.hpp"

namespace impetus::inline commands {

/// Throws InputError, naming the kinds that can, where the observer's cannot.
void require_fittable(const ObserverFile& observer);

}  // namespace impetus::inline commands
