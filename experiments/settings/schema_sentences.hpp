// Validation against a JSON Schema, with an answer a person can act on.
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "experiments/settings/json_document.hpp"

namespace impetus::inline settings {

/// The first place at which a value breaks its schema.
struct SchemaProblem {
  std::string pointer;  ///< JSON Pointer into the value; "" is the whole
  std::string message;  ///< "expected a number ≥ 0, got -3"
};

/// Judged by valijson (draft 7); the words are made from the schema at the place of the problem.
std::optional<SchemaProblem> find_schema_problem(const nlohmann::json& schema,
                                                 const nlohmann::json& value);

/// Throws InputError, which names the document and the place, when it breaks the schema.
void require_schema(const JsonDocument& document, const nlohmann::json& schema);

}  // namespace impetus::inline settings
