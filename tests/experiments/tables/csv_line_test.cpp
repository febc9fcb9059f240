// Cells of CSV, and texts made fit for files.
// SPDX-License-Identifier: MIT
#include "experiments/tables/csv_line.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cstdlib>
#include <limits>

#include "experiments/exports/codebook.hpp"
#include "experiments/store/schema_words.hpp"
#include "experiments/tables/number_text.hpp"
#include "experiments/tables/plain_text.hpp"
#include "tests/experiments/csv_reading.hpp"

namespace impetus::csv_line_test {

constexpr const char* kReplacement = "\xEF\xBF\xBD";

TEST(CsvCell, AnyFiniteDoubleReadsBackToTheBit) {
  std::uint64_t bits = 12345;  // printed when it fails
  for (int i = 0; i < 100'000; ++i) {
    bits = bits * 6364136223846793005U + 1442695040888963407U;
    const auto value = std::bit_cast<double>(bits);
    if (value - value == 0.0) {  // finite
      EXPECT_EQ(std::bit_cast<std::uint64_t>(std::strtod(exact_number(value).c_str(), nullptr)),
                bits);
      EXPECT_EQ(exact_number_by_trial(value), exact_number(value));
    }
  }
  for (const double value : {0.0, -0.0, 1.0, 100000.0, 1e5 + 0.5, 1e21, 1e22, 5e-324, 0.0001, 1e-5,
                             123456789012345678901.0, std::numeric_limits<double>::max()}) {
    EXPECT_EQ(exact_number_by_trial(value), exact_number(value));
  }
  EXPECT_EQ(exact_number(0.1), "0.1");
  EXPECT_EQ(exact_number(60.0), "60");
  EXPECT_EQ(exact_number(-0.0), "-0");
  EXPECT_EQ(exact_number(std::numeric_limits<double>::infinity()), "inf");
}

TEST(CsvCell, BitsAndBytesAreNoNumberToAnybody) {
  EXPECT_EQ(bits_text(-1), "xffffffffffffffff");
  EXPECT_EQ(bits_text(255), "x00000000000000ff");
  EXPECT_EQ(bytes_text(std::string_view("\x00\xa5", 2)), "x00a5");
  EXPECT_EQ(bytes_text(""), "x");
}

TEST(CsvCell, AnyTextReadsBack) {
  for (const std::string text : {"", "a", "\"", "\"\"", "a,b", "a\nb", "a\r\nb", ",", "=1+1",
                                 "Robert'); DROP TABLE trial;--", " a ", "“é”", "\"a\",\"b\""}) {
    const CsvTable table = read_csv(csv_line({"name"}) + csv_text(text) + "\n");
    ASSERT_EQ(table.rows.size(), 1U) << text;
    EXPECT_EQ(table.rows[0][0].text, text);
    EXPECT_TRUE(table.rows[0][0].quoted);
  }
}

TEST(PlainText, WhatIsNoUtf8IsReplacedByteByByte) {
  const std::string fffd = kReplacement;
  EXPECT_EQ(as_utf8("aé€😀"), "aé€😀");
  EXPECT_EQ(as_utf8("a\x80z"), "a" + fffd + "z");
  EXPECT_EQ(as_utf8("\xC3"), fffd);                                   // cut short
  EXPECT_EQ(as_utf8("\xC0\xAF"), fffd + fffd);                        // overlong '/'
  EXPECT_EQ(as_utf8("\xED\xA0\x80"), fffd + fffd + fffd);             // half of a pair
  EXPECT_EQ(as_utf8("\xF4\x90\x80\x80"), fffd + fffd + fffd + fffd);  // beyond U+10FFFF
  EXPECT_EQ(as_utf8(std::string_view("a\0b", 3)), "a" + fffd + "b");
}

TEST(PlainText, MarkupStaysTextInMarkdown) {
  EXPECT_EQ(markdown_text("<script>alert(1)</script>"), "&lt;script&gt;alert(1)&lt;/script&gt;");
  EXPECT_EQ(markdown_text("[a](b) | `c` *d*\ne"), "\\[a\\](b) \\| \\`c\\` \\*d\\* e");
  EXPECT_EQ(markdown_text("_a_ delay_ms"), "\\_a\\_ delay_ms");
}

TEST(PlainText, AFilesNameHoldsLettersAndDigitsAlone) {
  EXPECT_EQ(file_name_text("../../etc/passwd"), "------etc-passwd");
  EXPECT_EQ(file_name_text(std::string(1000, 'a')).size(), 64U);
}

TEST(UnitOf, TheLongerEndingWins) {
  EXPECT_EQ(unit_of("delay_ms"), "ms");
  EXPECT_EQ(unit_of("approach_m_s"), "m/s");
  EXPECT_EQ(unit_of("imposed_spin_a_x_rad_s"), "rad/s");
  EXPECT_EQ(unit_of("resumed_after_s"), "s");
  EXPECT_EQ(unit_of("impulse_Ns"), "N s");
  EXPECT_EQ(unit_of("onset_ns"), "ns");
  EXPECT_EQ(unit_of("bodies"), "");
}

TEST(SchemaWords, CommentsBesideBelowAndAboveBelongToTheirColumns) {
  const SchemaWords words = read_schema_words(R"(
-- Not of a column.
CREATE TABLE one (
  id INTEGER PRIMARY KEY,
  a TEXT NOT NULL CHECK (a IN ('x', 'y')),  -- beside
                                            -- and below
  two_id INTEGER REFERENCES two (id),
  -- Above, of two lines
  -- of words.
  x_m REAL, y_m REAL,
  z_m REAL,
  last TEXT,                                -- its own
  UNIQUE (a, last)
) STRICT;
)");
  const auto& one = words.at("one");
  EXPECT_EQ(one.size(), 7U);
  EXPECT_EQ(one.at("id").meaning, "");
  EXPECT_FALSE(one.at("id").may_be_null);
  EXPECT_EQ(one.at("a").meaning, "beside and below");
  EXPECT_FALSE(one.at("a").may_be_null);
  EXPECT_EQ(one.at("two_id").refers_to, "two");
  for (const char* column : {"x_m", "y_m", "z_m"}) {
    EXPECT_EQ(one.at(column).meaning, "Above, of two lines of words.") << column;
    EXPECT_EQ(one.at(column).type, "REAL");
  }
  EXPECT_EQ(one.at("last").meaning, "its own");
}

TEST(SchemaWords, EveryColumnOfTheStudyHasWordsOrRefersToARow) {
  for (const auto& [table, columns] : schema_words()) {
    for (const auto& [column, words] : columns) {
      EXPECT_TRUE(column == "id" || !words.refers_to.empty() || !words.meaning.empty())
          << table << "." << column;
    }
  }
}

}  // namespace impetus::csv_line_test
