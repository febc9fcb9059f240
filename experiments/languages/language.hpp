// A language: every built-in text that participants see, by key, with what is put into it.
//
//   experiments/languages/de.json ─┐
//   a lab's own file ──────────────┼─> Language ─> text("break_progress", {{"done", "3"}, ...})
//   /texts of a protocol ──────────┘
//
// A key that no row names does not compile; a language that lacks a text is refused when it is
// read. What researchers read is English, as is what is recorded.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <initializer_list>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/languages/text_keys.hpp"

namespace impetus::inline languages {

/// A key of the table.
class TextKey {
 public:
  consteval TextKey(const char* key)  // NOLINT(google-explicit-constructor): a key is its name
      : place_(find_text(key)) {
    if (place_ == kTextRows.size()) {
      throw "no row of the table has this key";
    }
  }
  [[nodiscard]] std::size_t place() const { return place_; }

 private:
  std::size_t place_;
};

/// A key that has a text for a count of one beside the one for other counts.
class CountedKey {
 public:
  consteval CountedKey(const char* key)  // NOLINT(google-explicit-constructor): a key is its name
      : one_(find_text(key, "_one")), other_(find_text(key)) {
    if (one_ == kTextRows.size() || other_ == kTextRows.size()) {
      throw "no two rows of the table have this key";
    }
  }
  [[nodiscard]] std::size_t place(std::int64_t count) const { return count == 1 ? one_ : other_; }

 private:
  std::size_t one_;
  std::size_t other_;
};

/// What stands where a text has `{name}`.
struct Filling {
  std::string_view name;
  std::string words;
};

/// The texts of one language; a copy shares them.
class Language {
 public:
  Language();  ///< English
  /// `texts` in the order of the table.
  Language(std::string title, std::vector<std::string> texts);

  /// For researchers: "English", "German (Deutsch)".
  [[nodiscard]] const std::string& title() const { return said_->title; }
  /// In the order of the table; as written, with their placeholders.
  [[nodiscard]] const std::vector<std::string>& texts() const { return said_->texts; }

  /// The text, filled in; empty where a protocol switched it off.
  [[nodiscard]] std::string text(TextKey key, std::initializer_list<Filling> fillings = {}) const;
  /// The text for a count, which stands for `{count}`.
  [[nodiscard]] std::string counted_text(CountedKey key, std::int64_t count) const;

  /// In the language's quotation marks.
  [[nodiscard]] std::string quoted(const std::string& words) const;
  /// A number that is written with a decimal point, in the language's way.
  [[nodiscard]] std::string number(std::string written) const;
  /// `share`, from 0 to 1, in whole per cent.
  [[nodiscard]] std::string percent(double share) const;

 private:
  /// The texts by their keys' places; copies of a language share them.
  struct Said {
    std::string title;
    std::vector<std::string> texts;
  };
  std::shared_ptr<const Said> said_;
};

/// The placeholders of a text, `seconds` for `{seconds}`, in order.
std::vector<std::string> placeholders(std::string_view text);

}  // namespace impetus::inline languages
