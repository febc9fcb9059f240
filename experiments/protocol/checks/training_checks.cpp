// SPDX-License-Identifier: MIT
#include "experiments/protocol/checks/training_checks.hpp"

#include <string>

namespace impetus::inline protocol {

using nlohmann::json;

void check_training_criterion(const JsonDocument& protocol) {
  const json& design = protocol.value["design"];
  if (!design.contains("train_until")) {
    return;
  }
  const std::string place = "/design/train_until";
  const json& rule = design["train_until"];
  if (rule["right"].get<std::int64_t>() > rule["of"].get<std::int64_t>()) {
    refuse(protocol, place + "/right",
           "expected at most the " + rule["of"].dump() + " trials that are looked at, got " +
               rule["right"].dump());
  }
  if (rule["of"].get<std::int64_t>() > rule["most_trials"].get<std::int64_t>()) {
    refuse(protocol, place + "/of",
           "expected at most the " + rule["most_trials"].dump() +
               " trials that there are (most_trials), got " + rule["of"].dump());
  }
}

}  // namespace impetus::inline protocol
