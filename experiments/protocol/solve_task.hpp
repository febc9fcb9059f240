// One entry of a protocol's "solve", at certain levels of its factors.
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "experiments/design/design.hpp"
#include "experiments/settings/json_document.hpp"

namespace impetus::inline protocol {

struct SolveTask {
  const JsonDocument* document;  ///< the protocol's, for refusals
  std::string place;             ///< JSON Pointer to the entry
  nlohmann::json entry;
  Condition condition;
  nlohmann::json scene;  ///< under the condition
};

}  // namespace impetus::inline protocol
