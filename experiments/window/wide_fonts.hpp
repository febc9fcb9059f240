// Fonts for Chinese, Japanese and Korean, beside the one that writes all else: looked for among
// what Debian's packages install, for the machine and for the user.
//
//   letters of a study ─> first_letter_without_font() ─none─> Gui ─> only these letters are loaded
//
// SPDX-License-Identifier: MIT
#pragma once

#include <imgui.h>

#include <cstdint>
#include <optional>
#include <set>
#include <string>

namespace impetus::inline window {

/// Where the letters of one font are.
struct WideFont {
  std::string plain;  ///< a file
  std::string bold;   ///< a file; the same where there is no bold one
  int face{0};        ///< in a file of several
  float scale{1.0F};  ///< of a size, so that its letters are as large as those beside them
};

/// The first of the known fonts that is installed.
std::optional<WideFont> find_wide_font();

/// Ranges of code points, as ImGui reads them, of these letters; where participants type, also
/// those that are common in the same script.
ImVector<ImWchar> wide_ranges(const std::set<std::uint16_t>& letters, bool is_typed);

}  // namespace impetus::inline window
