// SPDX-License-Identifier: MIT
#include "tests/fuzz/asked_work.hpp"

#include <array>
#include <string_view>
#include <utility>

namespace impetus {
namespace {

using nlohmann::json;

/// What a number may be at most, by the last part of its place.
constexpr std::array<std::pair<std::string_view, double>, 5> kMost{{
    {"/tree_depth", 2.0},
    {"/resolution", 4.0},
    {"/count", 8.0},
    {"/repetitions", 20.0},
    {"/trials_per_track", 20.0},
}};
constexpr std::size_t kMostBodies = 8;
constexpr std::size_t kMostCells = 16;

/// Trees and meshes that take more than moments to build.
bool is_slow_kind(const json& value) {
  for (const char* kind : {"medial", "heterogeneous", "swept", "creature", "knot"}) {
    if (value.is_string() && value.get_ref<const std::string&>() == kind) {
      return true;
    }
  }
  return false;
}

bool is_much(const std::string& place, const json& value) {
  for (const auto& [ending, most] : kMost) {
    if (place.ends_with(ending) && value.is_number() && value.get<double>() > most) {
      return true;
    }
  }
  return is_slow_kind(value);
}

bool holds_much(const json& value, const std::string& place = "") {
  if (value.is_structured()) {
    for (const auto& [key, part] : value.items()) {
      if (holds_much(part, place + "/" + key)) {
        return true;
      }
    }
    return place.ends_with("/bodies") && value.size() > kMostBodies;
  }
  return is_much(place, value);
}

/// Whether a factor puts much into the scene; multiplies `cells` by its levels.
bool factor_asks_for_much(const json& factor, std::size_t& cells) {
  const json levels = factor.is_object() ? factor.value("levels", json()) : json();
  const json pointer = factor.is_object() ? factor.value("pointer", json()) : json();
  cells *= levels.is_array() && !levels.empty() ? levels.size() : 1;
  for (const json& level : levels) {
    if (pointer.is_string() && is_much(pointer.get_ref<const std::string&>(), level)) {
      return true;
    }
  }
  return cells > kMostCells;
}

}  // namespace

bool asks_for_much(const json& scene, const json& protocol) {
  if (holds_much(scene) || holds_much(protocol)) {
    return true;
  }
  const json::json_pointer place("/design/factors");
  const json factors = protocol.contains(place) ? protocol[place] : json();
  std::size_t cells = 1;
  for (const json& factor : factors) {
    if (factor_asks_for_much(factor, cells)) {
      return true;
    }
  }
  return false;
}

}  // namespace impetus
