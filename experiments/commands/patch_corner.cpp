// SPDX-License-Identifier: MIT
#include "experiments/commands/patch_corner.hpp"

#include "experiments/settings/input_error.hpp"

namespace impetus::inline commands {

ScreenCorner patch_corner(const std::string& option, const std::string& name) {
  const auto corner = corner_named(name);
  if (!corner) {
    throw InputError(option + ": expected top left, top right, bottom left or bottom right, got " +
                     name);
  }
  return *corner;
}

}  // namespace impetus::inline commands
