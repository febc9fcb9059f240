// What a scene file may say of two bodies that meet, and of what is done to them: rows of
// scene.cpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/scenes/scene.hpp"
#include "experiments/settings/setting_rows.hpp"

namespace impetus::inline scenes {

/// Of a scene's space.
Kind<Vector3> vector_kind();

Kind<MeetingSettings> meeting_kind();
Kind<DistractorSettings> distractors_kind();
Kind<ImposedSettings> imposed_kind();

}  // namespace impetus::inline scenes
