// SPDX-License-Identifier: MIT
#include "experiments/exports/factor_labels.hpp"

#include <nlohmann/json.hpp>

#include "experiments/exports/row_query.hpp"

namespace impetus::inline exports {
namespace {

using nlohmann::json;

/// What a text is at a pointer; null when it is no JSON or has nothing there. What a study holds
/// is never trusted to be a protocol.
json value_at(const std::string& text, const std::string& pointer) {
  const json value = json::parse(text, nullptr, false);
  const json::json_pointer place(pointer);
  return !value.is_discarded() && value.contains(place) ? value.at(place) : json();
}

void add_labels(const std::string& protocol, FactorLabels& labels) {
  const json factors = value_at(protocol, "/design/factors");
  for (const json& factor : factors.is_array() ? factors : json::array()) {
    const json::json_pointer name("/name");
    const json::json_pointer label("/label");
    if (factor.contains(name) && factor.at(name).is_string() && factor.contains(label) &&
        factor.at(label).is_string()) {
      const auto found = labels.find(factor.at(name).get<std::string>());
      if (found != labels.end() && found->second.empty()) {
        found->second = factor.at(label).get<std::string>();
      }
    }
  }
}

}  // namespace

FactorLabels factor_labels(SQLite::Database& database) {
  FactorLabels labels;
  RowQuery names(database,
                 "SELECT DISTINCT key FROM trial, json_each(trial.condition) WHERE key IS NOT NULL "
                 "AND json_type(trial.condition) = 'object'");
  while (names.step()) {
    labels[names.text(0)] = "";
  }
  RowQuery protocols(database, "SELECT protocol_json FROM protocol ORDER BY id");
  while (protocols.step()) {
    add_labels(protocols.text(0), labels);
  }
  return labels;
}

}  // namespace impetus::inline exports
