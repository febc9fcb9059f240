// SPDX-License-Identifier: MIT
#include "experiments/questions/answer_keys.hpp"

#include <algorithm>
#include <numeric>
#include <set>
#include <sstream>
#include <utility>

namespace impetus::inline questions {
namespace {

std::vector<std::string> split(const std::string& text) {
  std::istringstream words(text);
  std::vector<std::string> keys;
  for (std::string key; words >> key;) {
    keys.push_back(key);
  }
  return keys;
}

bool is_letter_or_digit(const std::string& key) {
  return key.size() == 1 && ((key[0] >= 'a' && key[0] <= 'z') || (key[0] >= '0' && key[0] <= '9'));
}

const KeyFactor* find_key_factor(const Script& script, const Question& question) {
  for (const KeyFactor& factor : script.key_factors) {
    if (factor.question == question.kind().protocol_key) {
      return &factor;
    }
  }
  return nullptr;
}

std::vector<std::string> keys_under(const KeyFactor& factor, const Condition& condition) {
  for (const FactorLevel& level : condition) {
    if (level.factor == factor.factor) {
      return keys_of_level(level.value);
    }
  }
  return {};
}

/// The answers in the order in which their keys stand from left to right.
void sort_by_places(std::vector<std::size_t>& answers, const std::vector<std::string>& keys,
                    const std::vector<std::string>& places) {
  const auto place = [&](std::size_t answer) {
    const bool has_key = answer < keys.size();
    return (has_key ? std::find(places.begin(), places.end(), keys[answer]) : places.end()) -
           places.begin();
  };
  std::stable_sort(answers.begin(), answers.end(),
                   [&](std::size_t a, std::size_t b) { return place(a) < place(b); });
}

}  // namespace

Kind<std::vector<std::string>> answer_keys_kind() {
  return {defined("answer_keys", text(),
                  "Keys of the answers in their order, a blank between: letters from a to z, or "
                  "digits. The language's, or 1, 2 and so on, when left out."),
          [](const nlohmann::json& value) { return split(value.get<std::string>()); }};
}

std::vector<std::string> keys_of_level(const LevelValue& level) {
  const auto* keys = std::get_if<std::string>(&level);
  return keys == nullptr ? std::vector<std::string>{} : split(*keys);
}

KeyFactor key_factor(const Factor& factor) {
  return {factor.keys_of, factor.name, keys_of_level(factor.levels.front())};
}

KeyedPage with_keys(Page page, const Question& question, const Script& script,
                    const Condition& condition) {
  std::vector<std::size_t> answers(page.choices.size());
  std::iota(answers.begin(), answers.end(), 0);
  const KeyFactor* factor = find_key_factor(script, question);
  const std::vector<std::string> keys =
      factor == nullptr ? question.keys() : keys_under(*factor, condition);
  for (std::size_t answer = 0; answer < std::min(keys.size(), answers.size()); ++answer) {
    page.choices[answer].key = keys[answer];
  }
  if (factor != nullptr) {
    sort_by_places(answers, keys, factor->places);
    const std::vector<Choice> choices = page.choices;
    std::transform(answers.begin(), answers.end(), page.choices.begin(),
                   [&](std::size_t answer) { return choices[answer]; });
    const auto positive = std::find(answers.begin(), answers.end(), page.positive_choice);
    page.positive_choice = static_cast<std::size_t>(positive - answers.begin());
  }
  return {std::move(page), std::move(answers)};
}

void check_keys(const JsonDocument& protocol, const std::string& place,
                const std::vector<std::string>& keys, std::size_t answers) {
  const bool are_keys = std::all_of(keys.begin(), keys.end(), is_letter_or_digit);
  const bool differ = std::set<std::string>(keys.begin(), keys.end()).size() == keys.size();
  if (keys.size() != answers || !are_keys || !differ) {
    refuse(protocol, place,
           "expected " + std::to_string(answers) +
               " keys that differ, letters from a to z or digits, a blank between (\"f j\"), got " +
               protocol.value[nlohmann::json::json_pointer(place)].dump());
  }
}

}  // namespace impetus::inline questions
