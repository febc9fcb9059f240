// A collision at every level as one picture: a row for each level, before, at and after contact.
//
//   level 0    ○ ○   ○○    ○ ○       nodes in contact are drawn as shells, contacts before the
//   level 1    ○ ○   ○○    ○ ○       reduction red, after it yellow with their normals, and
//   ...                              where the bodies are going as arrows
//
// All in the scene's own view, drawn closer.
// (Dingliana 2002, figures 6.1 to 6.3)
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/run/level_collision.hpp"
#include "experiments/window/pixels.hpp"

namespace impetus::inline viewers {

/// Each picture has this size; the whole is three wide and as high as there are levels. Throws
/// std::runtime_error with one sentence when no OpenGL 3.3 can be had.
Pixels strip_of(const CollisionByLevel& collision, const StagedScene& scene,
                const PictureSize& size);

}  // namespace impetus::inline viewers
