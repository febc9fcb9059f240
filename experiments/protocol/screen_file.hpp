// The lab's screen: entered once, kept in a small file.
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "engine/scheduling/viewer.hpp"

namespace impetus {

/// $XDG_CONFIG_HOME/impetus/screen.json, or ~/.config/impetus/screen.json.
std::filesystem::path default_screen_file();

/// Sizes in metres; the pixels are the window's and stay 0. Throws InputError.
ScreenGeometry load_screen(const std::filesystem::path& path);

/// Writes the file whole or not at all; makes its folder. Throws InputError.
void save_screen(const ScreenGeometry& screen, const std::filesystem::path& path);

/// A 5:4 picture of 37.6 cm × 30.1 cm, 1280 × 1024 pixels, seen from 57 cm: what is assumed where
/// nothing was entered, and what a simulated participant looks at.
ScreenGeometry assumed_screen();

}  // namespace impetus
