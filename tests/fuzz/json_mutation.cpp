// SPDX-License-Identifier: MIT
#include "tests/fuzz/json_mutation.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <vector>

#include "tests/fuzz/targets.hpp"

namespace impetus {
namespace {

using nlohmann::json;

const std::vector<json>& odd_values() {
  static const std::vector<json> values{nullptr,
                                        true,
                                        0,
                                        -1,
                                        1,
                                        2,
                                        0.5,
                                        1e-12,
                                        1e-300,
                                        1e9,
                                        1e18,
                                        1e300,
                                        -1e300,
                                        9223372036854775807,
                                        18446744073709551615U,
                                        "",
                                        "a",
                                        "/",
                                        "/engine/step_hz",
                                        std::string("\0", 1),
                                        "..",
                                        json::array(),
                                        json::object(),
                                        {0, 0, 0},
                                        {1e300, -1e300, 1e300},
                                        {{"kind", "sphere"}}};
  return values;
}

void collect(json& value, std::vector<json*>& places) {
  places.push_back(&value);
  if (value.is_structured()) {
    for (json& part : value) {
      collect(part, places);
    }
  }
}

json* any_of(std::vector<json*>& places, RandomStream& random) {
  return places[random.below(places.size())];
}

void change_members(json& value, const json& other, RandomStream& random) {
  if (value.is_array()) {
    value.push_back(other);
  } else if (value.is_object() && !value.empty()) {
    value.erase(std::next(value.begin(), static_cast<std::ptrdiff_t>(random.below(value.size()))));
  }
}

}  // namespace

std::string mutated_json(std::string_view text, RandomStream& random) {
  json value = json::parse(text, nullptr, /*allow_exceptions=*/false);
  if (value.is_discarded()) {
    return std::string(text);
  }
  std::vector<json*> places;
  collect(value, places);
  const json odd = odd_values()[random.below(odd_values().size())];
  const json own = *any_of(places, random);
  json& place = *any_of(places, random);
  switch (random.below(4)) {
    case 0:
      place = own;
      break;
    case 1:
      change_members(place, own, random);
      break;
    case 2:
      place =
          place.is_number() ? json(place.get<double>() * (random.below(2) == 0 ? -1.0 : 1e3)) : odd;
      break;
    default:
      place = odd;
  }
  return value.dump(-1, ' ', false, json::error_handler_t::replace);
}

std::string mutated_pair(std::string_view texts, RandomStream& random) {
  const std::size_t end = texts.find(kPartSeparator);
  if (end == std::string_view::npos) {
    return mutated_json(texts, random);
  }
  const std::string_view first = texts.substr(0, end);
  const std::string_view second = texts.substr(end + 1);
  return random.below(2) == 0 ? mutated_json(first, random) + kPartSeparator + std::string(second)
                              : std::string(first) + kPartSeparator + mutated_json(second, random);
}

}  // namespace impetus
