// The samples of a sound, made before it is played.
//
//   struck      damped modes of a bar with free ends: sum of 1/k exp(−π f_k tan φ t) sin(2π f_k t),
//               f_k = f_1 · (1, 2.76, 5.40, 8.93); f_1 and the material's damping tan φ make it
//               sound like wood or glass (Wildes and Richards 1988; Klatzky, Pai and Krotkov 2000)
//   tone        a sine with raised-cosine ramps of 2 ms
//   file        as it was recorded, at the device's rate
//
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "experiments/record/sound.hpp"

namespace impetus::inline sound {

/// Mono, its onset at the first sample; empty for silence. `rate_hz` > 0.
std::vector<float> waveform_of(const SoundTask& task, double rate_hz);

}  // namespace impetus::inline sound
