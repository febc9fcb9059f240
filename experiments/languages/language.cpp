// SPDX-License-Identifier: MIT
#include "experiments/languages/language.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "experiments/languages/language_file.hpp"

namespace impetus::inline languages {
namespace {

/// Calls `literal` with what stands between placeholders, and `name` with each of those.
template <typename Literal, typename Name>
void take_apart(std::string_view text, const Literal& literal, const Name& name) {
  while (!text.empty()) {
    const std::size_t open = text.find('{');
    const std::size_t close = open == text.npos ? text.npos : text.find('}', open);
    if (close == text.npos) {
      literal(text);
      return;
    }
    literal(text.substr(0, open));
    name(text.substr(open + 1, close - open - 1));
    text.remove_prefix(close + 1);
  }
}

/// What is put in is not looked at again: it may hold braces.
std::string filled(std::string_view text, std::initializer_list<Filling> fillings) {
  std::string whole;
  take_apart(
      text, [&](std::string_view literal) { whole += literal; },
      [&](std::string_view name) {
        const auto* const found =
            std::find_if(fillings.begin(), fillings.end(),
                         [&](const Filling& each) { return each.name == name; });
        whole += found == fillings.end() ? "{" + std::string(name) + "}" : found->words;
      });
  return whole;
}

}  // namespace

Language::Language() : Language(english()) {}

Language::Language(std::string title, std::vector<std::string> texts)
    : said_(std::make_shared<Said>(Said{std::move(title), std::move(texts)})) {}

std::string Language::text(TextKey key, std::initializer_list<Filling> fillings) const {
  return filled(texts()[key.place()], fillings);
}

std::string Language::counted_text(CountedKey key, std::int64_t count) const {
  return filled(texts()[key.place(count)], {{"count", std::to_string(count)}});
}

std::string Language::quoted(const std::string& words) const {
  return text("quoted", {{"words", words}});
}

std::string Language::number(std::string written) const {
  const std::size_t point = written.find('.');
  return point == written.npos ? written : written.replace(point, 1, text("decimal_mark"));
}

std::string Language::percent(double share) const {
  return text("percent", {{"number", std::to_string(std::lround(100.0 * share))}});
}

std::vector<std::string> placeholders(std::string_view text) {
  std::vector<std::string> names;
  take_apart(
      text, [](std::string_view /*literal*/) {},
      [&](std::string_view name) { names.emplace_back(name); });
  return names;
}

}  // namespace impetus::inline languages
