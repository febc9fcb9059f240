// The sound of a scene's contacts, as its file says it.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/record/sound.hpp"
#include "experiments/settings/setting_rows.hpp"

namespace impetus::inline scenes {

struct Scene;
class SceneProblems;

/// Of `/sound`.
Kind<SoundTask> sound_kind();

/// Adds what is wrong with it: a sound before a contact that cannot be foreseen, a contact where
/// nothing touches, a time after the end.
void add_sound_problems(const Scene& scene, SceneProblems& problems);

}  // namespace impetus::inline scenes
