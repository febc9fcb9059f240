// The letters that screens can show, by code point: those that the stage loads of its fonts. What
// is written from right to left is not among them, nor is what needs several code points for a
// letter.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

namespace impetus::inline record {

/// Code points from the first to the last.
struct LetterRange {
  std::uint16_t first{0};
  std::uint16_t last{0};
};

/// Latin, Greek, Cyrillic, punctuation (without marks of direction), super- and subscripts,
/// currencies, letterlike symbols, fractions, arrows, mathematics, geometric shapes.
inline constexpr std::array<LetterRange, 8> kShownLetters{{{0x0020, 0x007E},
                                                           {0x00A0, 0x024F},
                                                           {0x0370, 0x052F},
                                                           {0x2010, 0x2027},
                                                           {0x202F, 0x205F},
                                                           {0x2070, 0x20BF},
                                                           {0x2100, 0x22FF},
                                                           {0x25A0, 0x25FF}}};

inline bool is_shown_letter(std::uint32_t code_point) {
  return std::any_of(kShownLetters.begin(), kShownLetters.end(), [&](const LetterRange& range) {
    return range.first <= code_point && code_point <= range.last;
  });
}

}  // namespace impetus::inline record
