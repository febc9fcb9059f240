// The letters that screens can show, by code point: those that the stage loads of its fonts, and
// those of Chinese, Japanese and Korean, where the language has any. What needs several code points
// for a letter is not among them.
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

/// Signs and punctuation of Chinese, Japanese and Korean, kana, ideographs, syllables, wide forms.
/// Few fonts have them, and there are too many to load them all.
inline constexpr std::array<LetterRange, 5> kWideLetters{
    {{0x3000, 0x30FF}, {0x3400, 0x4DBF}, {0x4E00, 0x9FFF}, {0xAC00, 0xD7A3}, {0xFF01, 0xFFEE}}};

/// Hebrew, and Arabic with the letters of Persian and Urdu that the fonts have: without vowel
/// signs.
inline constexpr std::array<LetterRange, 16> kRightToLeftLetters{{{0x05BE, 0x05BE},
                                                                  {0x05D0, 0x05EA},
                                                                  {0x05F3, 0x05F4},
                                                                  {0x060C, 0x060C},
                                                                  {0x061B, 0x061B},
                                                                  {0x061F, 0x061F},
                                                                  {0x0621, 0x063A},
                                                                  {0x0640, 0x064A},
                                                                  {0x0660, 0x066C},
                                                                  {0x067E, 0x067E},
                                                                  {0x0686, 0x0686},
                                                                  {0x0698, 0x0698},
                                                                  {0x06A9, 0x06A9},
                                                                  {0x06AF, 0x06AF},
                                                                  {0x06CC, 0x06CC},
                                                                  {0x06F0, 0x06F9}}};

template <std::size_t kSize>
bool is_within(const std::array<LetterRange, kSize>& ranges, std::uint32_t code_point) {
  return std::any_of(ranges.begin(), ranges.end(), [&](const LetterRange& range) {
    return range.first <= code_point && code_point <= range.last;
  });
}

inline bool is_shown_letter(std::uint32_t code_point) {
  return is_within(kShownLetters, code_point);
}

inline bool is_right_to_left_letter(std::uint32_t code_point) {
  return is_within(kRightToLeftLetters, code_point);
}

inline bool is_wide_letter(std::uint32_t code_point) { return is_within(kWideLetters, code_point); }

}  // namespace impetus::inline record
