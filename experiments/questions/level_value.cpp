// SPDX-License-Identifier: MIT
#include "experiments/questions/level_value.hpp"

#include <string>

namespace impetus::inline questions {

LevelValue level_value(const nlohmann::json& value) {
  if (value.is_string()) {
    return value.get<std::string>();
  }
  if (value.is_boolean()) {
    return value.get<bool>();
  }
  return value.get<double>();
}

}  // namespace impetus::inline questions
