// SPDX-License-Identifier: MIT
#include "experiments/questions/question_order.hpp"

#include <algorithm>
#include <numeric>
#include <string>

#include "engine/numerics/random_stream.hpp"

namespace impetus::inline questions {
namespace {

constexpr const char* kKey = "question_order";
constexpr const char* kRandom = "random";

QuestionOrder read_order(const nlohmann::json& value) {
  QuestionOrder order;
  order.is_drawn = value.is_string();
  if (value.is_array()) {
    order.questions = value.get<std::vector<std::string>>();
  }
  return order;
}

std::vector<std::string> questions_with_a_page(const Script& script) {
  std::vector<std::string> keys;
  for (const auto& question : script.asked) {
    if (!question->kind().during_stimulus) {
      keys.push_back(question->kind().protocol_key);
    }
  }
  return keys;
}

}  // namespace

Row<Script> question_order_row() {
  const OrderedJson schema{{"type", {"string", "array"}}, {"items", {{"type", "string"}}}};
  return row(
      "question_order", &Script::question_order, Kind<QuestionOrder>{{schema}, read_order},
      "Of the questions after the stimulus: all of them by their keys (yes_no, rating, ...) in "
      "the order in which they are asked, or random: drawn for each trial. Rating, yes_no, "
      "two_interval, choice, slider, free_text when left out.");
}

void check_question_order(const JsonDocument& protocol, const Script& script) {
  if (!protocol.value.contains(kKey)) {
    return;
  }
  const nlohmann::json& given = protocol.value[kKey];
  std::vector<std::string> asked = questions_with_a_page(script);
  std::vector<std::string> order = script.question_order.questions;
  const std::string all = nlohmann::json(asked).dump();
  std::sort(asked.begin(), asked.end());
  std::sort(order.begin(), order.end());
  if (script.question_order.is_drawn ? given != kRandom : order != asked) {
    refuse(protocol, std::string("/") + kKey,
           "expected \"random\" or the questions after the stimulus, each once, in some order (" +
               all + "), got " + given.dump());
  }
}

std::vector<std::size_t> order_of_questions(const Script& script, std::uint64_t trial_seed) {
  std::vector<std::size_t> places(script.asked.size());
  std::iota(places.begin(), places.end(), 0);
  const QuestionOrder& order = script.question_order;
  if (order.is_drawn) {
    RandomStream(trial_seed, "order of questions").shuffle(places);
  }
  const auto rank = [&](std::size_t place) {
    const std::string& key = script.asked[place]->kind().protocol_key;
    return std::find(order.questions.begin(), order.questions.end(), key) - order.questions.begin();
  };
  std::stable_sort(places.begin(), places.end(),
                   [&](std::size_t a, std::size_t b) { return rank(a) < rank(b); });
  return places;
}

}  // namespace impetus::inline questions
