// SPDX-License-Identifier: MIT
#include "experiments/window/right_to_left.hpp"

#include <fribidi.h>

#include <algorithm>
#include <vector>

#include "experiments/record/shown_letters.hpp"

namespace impetus::inline window {
namespace {

/// What joining leaves in the place of a letter that was taken into the one before it.
constexpr FriBidiChar kTakenIn = FRIBIDI_CHAR_FILL;

using Letters = std::vector<FriBidiChar>;

Letters letters_of(std::string_view text) {
  Letters letters(text.size() + 1);
  const FriBidiStrIndex count =
      fribidi_charset_to_unicode(FRIBIDI_CHAR_SET_UTF8, text.data(),
                                 static_cast<FriBidiStrIndex>(text.size()), letters.data());
  letters.resize(static_cast<std::size_t>(count));
  return letters;
}

std::string text_of(const Letters& letters) {
  constexpr std::size_t kMostBytes = 4;  // of a letter in UTF-8
  std::string text(kMostBytes * letters.size() + 1, '\0');
  const FriBidiStrIndex bytes =
      fribidi_unicode_to_charset(FRIBIDI_CHAR_SET_UTF8, letters.data(),
                                 static_cast<FriBidiStrIndex>(letters.size()), text.data());
  text.resize(static_cast<std::size_t>(bytes));
  return text;
}

}  // namespace

bool is_right_to_left(std::string_view text, bool without) {
  for (const FriBidiChar letter : letters_of(text)) {
    const FriBidiCharType type = fribidi_get_bidi_type(letter);
    if (FRIBIDI_IS_LETTER(type)) {
      return FRIBIDI_IS_RTL(type);
    }
  }
  return without;
}

bool has_right_to_left(std::string_view text) {
  const Letters letters = letters_of(text);
  return std::any_of(letters.begin(), letters.end(), is_right_to_left_letter);
}

std::string visual_line(std::string_view line, bool from_right) {
  if (!from_right && !has_right_to_left(line)) {
    return std::string(line);
  }
  const Letters read = letters_of(line);
  Letters drawn(read.size() + 1);
  FriBidiParType direction = from_right ? FRIBIDI_PAR_RTL : FRIBIDI_PAR_LTR;
  if (fribidi_log2vis(read.data(), static_cast<FriBidiStrIndex>(read.size()), &direction,
                      drawn.data(), nullptr, nullptr, nullptr) == 0) {
    return std::string(line);
  }
  drawn.resize(read.size());
  std::erase(drawn, kTakenIn);
  return text_of(drawn);
}

std::string visual_label(std::string_view label) {
  return visual_line(label, is_right_to_left(label));
}

}  // namespace impetus::inline window
