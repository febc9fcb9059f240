// SPDX-License-Identifier: MIT
#include "experiments/exports/bids_labels.hpp"

#include <cctype>

#include "experiments/exports/row_query.hpp"

namespace impetus::inline exports {
namespace {

constexpr std::size_t kLongestLabel = 64;

bool is_ascii_word(char letter) {
  return static_cast<unsigned char>(letter) < 0x80 &&
         std::isalnum(static_cast<unsigned char>(letter)) != 0;
}

std::string in_small_letters(std::string text) {
  for (char& letter : text) {
    letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  }
  return text;
}

std::map<std::int64_t, std::string> labels_of(SQLite::Database& database, const std::string& sql) {
  std::map<std::int64_t, std::string> labels;
  BidsLabels given;
  RowQuery query(database, sql);
  while (query.step()) {
    labels[query.integer(0)] = given.label_for(query.bytes(1));
  }
  return labels;
}

}  // namespace

std::string BidsLabels::label_for(std::string_view name) {
  std::string letters;
  for (const char letter : name) {
    if (is_ascii_word(letter) && letters.size() < kLongestLabel) {
      letters += letter;
    }
  }
  std::string label = letters;
  for (int number = 2; label.empty() || !given_.insert(in_small_letters(label)).second; ++number) {
    label = (letters.empty() ? "X" : letters + "X") + std::to_string(number);
  }
  return label;
}

BidsNames bids_names(SQLite::Database& database) {
  return {labels_of(database, "SELECT id, pseudonym FROM participant ORDER BY id"),
          labels_of(database, "SELECT id, name FROM protocol ORDER BY id")};
}

}  // namespace impetus::inline exports
