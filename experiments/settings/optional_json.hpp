// A number, a yes or a no that may be missing, in JSON: null where it is.
//
// Whoever makes JSON of such a value, or reads one of it, includes this header; without it neither
// compiles.
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <type_traits>

template <typename T>
requires std::is_arithmetic_v<T>
struct nlohmann::adl_serializer<std::optional<T>> {
  static void to_json(auto& json, const std::optional<T>& value) {
    if (value) {
      json = *value;
    } else {
      json = nullptr;
    }
  }

  static void from_json(const auto& json, std::optional<T>& value) {
    value = json.is_null() ? std::nullopt : std::optional(json.template get<T>());
  }
};
