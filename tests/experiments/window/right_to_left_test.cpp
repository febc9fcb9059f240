// Hebrew and Arabic lines as they are drawn: order after Unicode's bidirectional algorithm, letters
// in the forms that they have beside their neighbours. Expected lines stand in code points, as no
// editor shows both orders alike.
// SPDX-License-Identifier: MIT
#include "experiments/window/right_to_left.hpp"

#include <gtest/gtest.h>

#include "experiments/languages/language_file.hpp"

namespace impetus::right_to_left_test {

TEST(RightToLeft, ATextIsReadAsItsFirstLetterIs) {
  EXPECT_TRUE(is_right_to_left("\u05E9\u05DC\u05D5\u05DD abc"));
  EXPECT_TRUE(is_right_to_left("1. \u0646\u0639\u0645"));
  EXPECT_FALSE(is_right_to_left("abc \u05E9\u05DC\u05D5\u05DD"));
  EXPECT_FALSE(is_right_to_left("3 – 5"));
  EXPECT_FALSE(is_right_to_left(""));
  EXPECT_TRUE(is_right_to_left("3 – 5", true));
}

TEST(RightToLeft, WhatIsReadFromTheLeftIsDrawnAsItIs) {
  for (const char* text : {"", "Größe (Y)", "\u4E2D\u6587", "½ ≤ 2"}) {
    EXPECT_EQ(visual_line(text, false), text);
  }
}

TEST(RightToLeft, HebrewIsDrawnFromItsLastLetterToItsFirst) {
  // shalom: shin, lamed, vav, final mem
  EXPECT_EQ(visual_label("\u05E9\u05DC\u05D5\u05DD"), "\u05DD\u05D5\u05DC\u05E9");
}

TEST(RightToLeft, ArabicLettersJoinAndLamTakesAlefIn) {
  // na'am: initial noon, medial ain, final meem
  EXPECT_EQ(visual_label("\u0646\u0639\u0645"), "\uFEE2\uFECC\uFEE7");
  // la: one ligature for two letters
  EXPECT_EQ(visual_label("\u0644\u0627"), "\uFEFB");
}

TEST(RightToLeft, NumbersAndLatinWordsKeepTheirOrderAndBracketsAreTurned) {
  const std::string no = "\u05DC\u05D0";
  const std::string drawn = "\u05D0\u05DC";
  EXPECT_EQ(visual_line(no + " 12 (Esc)", true), "(Esc) 12 " + drawn);
  EXPECT_EQ(visual_line("Esc " + no, false), "Esc " + drawn);
  EXPECT_EQ(visual_line("Esc " + no, true), drawn + " Esc");
  EXPECT_EQ(visual_line(no + ".", true), "." + drawn);
}

TEST(RightToLeft, EveryArabicTextIsDrawnInFormsAlone) {
  for (const std::string& text : shipped_languages().at("ar").texts()) {
    const std::string drawn = visual_line(text, is_right_to_left(text));
    for (std::size_t at = 0; at + 1 < drawn.size(); ++at) {
      const auto lead = static_cast<unsigned char>(drawn[at]);
      const auto next = static_cast<unsigned char>(drawn[at + 1]);
      // U+0622 to U+064A in UTF-8: all but the hamza, which joins nothing.
      const bool is_letter = (lead == 0xD8U && next >= 0xA2U) || (lead == 0xD9U && next <= 0x8AU);
      EXPECT_FALSE(is_letter) << text;
    }
  }
}

}  // namespace impetus::right_to_left_test
