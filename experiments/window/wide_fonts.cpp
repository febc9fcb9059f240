// SPDX-License-Identifier: MIT
#include "experiments/window/wide_fonts.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <iterator>

#include "experiments/record/shown_letters.hpp"
#include "experiments/window/window.hpp"

namespace impetus::inline window {
namespace {

namespace fs = std::filesystem;

/// A font by the place that its package gives it.
struct KnownFont {
  const char* plain;
  const char* bold;
  int face;
  float scale;
};

/// From fonts-noto-cjk (its face of simplified Chinese), fonts-wqy-microhei, fonts-droid-fallback.
constexpr std::array<KnownFont, 3> kKnownFonts{
    {{"opentype/noto/NotoSansCJK-Regular.ttc", "opentype/noto/NotoSansCJK-Bold.ttc", 2, 1.24F},
     {"truetype/wqy/wqy-microhei.ttc", "truetype/wqy/wqy-microhei.ttc", 0, 1.0F},
     {"truetype/droid/DroidSansFallbackFull.ttf", "truetype/droid/DroidSansFallbackFull.ttf", 0,
      1.12F}}};

fs::path users_fonts() {
  const char* home = std::getenv("HOME");
  return home == nullptr ? fs::path() : fs::path(home) / ".local/share/fonts";
}

bool has_any_within(const std::set<std::uint16_t>& letters, int first, int last) {
  const auto from = letters.lower_bound(static_cast<std::uint16_t>(first));
  return from != letters.end() && *from <= last;
}

/// What somebody who reads these letters may type.
const ImWchar* common_letters(const std::set<std::uint16_t>& letters, ImFontAtlas& atlas) {
  return has_any_within(letters, 0xAC00, 0xD7A3)   ? atlas.GetGlyphRangesKorean()
         : has_any_within(letters, 0x3041, 0x30FF) ? atlas.GetGlyphRangesJapanese()
                                                   : atlas.GetGlyphRangesChineseSimplifiedCommon();
}

}  // namespace

std::optional<WideFont> find_wide_font() {
  for (const fs::path& folder : {fs::path("/usr/share/fonts"), users_fonts()}) {
    for (const KnownFont& font : kKnownFonts) {
      std::error_code ignored;
      if (fs::is_regular_file(folder / font.plain, ignored)) {
        const bool has_bold = fs::is_regular_file(folder / font.bold, ignored);
        return WideFont{folder / font.plain, folder / (has_bold ? font.bold : font.plain),
                        font.face, font.scale};
      }
    }
  }
  return std::nullopt;
}

ImVector<ImWchar> wide_ranges(const std::set<std::uint16_t>& letters, bool is_typed) {
  ImFontAtlas atlas;
  ImFontGlyphRangesBuilder builder;
  for (const std::uint16_t letter : letters) {
    builder.AddChar(letter);
  }
  if (is_typed) {
    builder.AddRanges(common_letters(letters, atlas));
  }
  ImVector<ImWchar> ranges;
  builder.BuildRanges(&ranges);
  return ranges;
}

std::optional<std::uint16_t> first_letter_without_font(const std::set<std::uint16_t>& shown) {
  std::set<std::uint16_t> letters;  // all others are in the font of every screen
  std::copy_if(shown.begin(), shown.end(), std::inserter(letters, letters.end()), is_wide_letter);
  const auto file = find_wide_font();
  if (letters.empty() || !file) {
    return letters.empty() ? std::nullopt : std::optional(*letters.begin());
  }
  constexpr float kSmall_px = 8.0F;
  ImFontAtlas atlas;  // needs no window
  ImFontConfig config;
  config.FontNo = file->face;
  const ImVector<ImWchar> ranges = wide_ranges(letters, /*is_typed=*/false);
  const ImFont* font =
      atlas.AddFontFromFileTTF(file->plain.c_str(), kSmall_px, &config, ranges.Data);
  atlas.Build();
  const auto missing = std::find_if(letters.begin(), letters.end(), [&](std::uint16_t letter) {
    return font->FindGlyphNoFallback(letter) == nullptr;
  });
  return missing == letters.end() ? std::nullopt : std::optional(*missing);
}

}  // namespace impetus::inline window
