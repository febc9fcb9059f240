// What can be known of the display before a window opens.
// SPDX-License-Identifier: MIT
#pragma once

namespace impetus {

/// The display's nominal refresh rate; 60 when it does not say. Throws std::runtime_error with one
/// sentence when there is no display.
double display_refresh_hz();

}  // namespace impetus
