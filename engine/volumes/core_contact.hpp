// The contact of two cored volumes.
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/volumes/sphere.hpp"

namespace impetus::inline volumes {

/// See touch() of two volumes, which states what it is. The same bits both ways round.
TouchPoint core_contact(const CoredVolume& a, const CoredVolume& b, const Vector3& fallback);

}  // namespace impetus::inline volumes
