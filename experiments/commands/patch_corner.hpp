// The option that names the corner of a photodiode patch.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "experiments/record/photodiode_patch.hpp"

namespace impetus::inline commands {

/// Throws InputError, naming the option, unless `name` is one of the four corners.
ScreenCorner patch_corner(const std::string& option, const std::string& name);

}  // namespace impetus::inline commands
