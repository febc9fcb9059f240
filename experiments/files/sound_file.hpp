// Sounds from files, by libsndfile.
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "experiments/record/sound.hpp"

namespace impetus::inline files {

/// A WAV, FLAC or OGG file, its channels as one. Throws std::runtime_error that names it: it cannot
/// be read, holds nothing, or lasts longer than five seconds.
SoundSamples load_sound(const std::filesystem::path& path);

}  // namespace impetus::inline files
