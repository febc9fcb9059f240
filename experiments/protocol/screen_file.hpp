// The lab's screen: entered once, kept in a small file.
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

#include "experiments/record/lab_screen.hpp"

namespace impetus::inline protocol {

/// $XDG_CONFIG_HOME/impetus/screen.json, or ~/.config/impetus/screen.json.
std::filesystem::path default_screen_file();

/// Sizes in metres; the pixels are the window's and stay 0. Throws InputError.
LabScreen load_screen(const std::filesystem::path& path);

/// The same of a picture of so many pixels. Throws InputError, too, where they are not square and
/// the file does not say so.
ScreenGeometry load_screen_of(const std::filesystem::path& path, int width_px, int height_px);

/// Writes the file whole or not at all; makes its folder. Throws InputError.
void save_screen(const LabScreen& screen, const std::filesystem::path& path);

/// A picture of square pixels, 30.1 cm high and seen from 57 cm: what is assumed where nothing was
/// entered, and, 1280 × 1024 pixels on 37.6 cm × 30.1 cm, what a simulated participant looks at.
ScreenGeometry assumed_screen(int width_px = 1280, int height_px = 1024);

}  // namespace impetus::inline protocol
