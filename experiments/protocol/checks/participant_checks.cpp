// SPDX-License-Identifier: MIT
#include "experiments/protocol/checks/participant_checks.hpp"

#include <string>

#include "experiments/settings/schema_check.hpp"

namespace impetus::inline protocol {

bool has_participants(const nlohmann::json& protocol) { return !protocol.contains("participants"); }

void check_participants(const JsonDocument& protocol) {
  if (has_participants(protocol.value)) {
    for (const char* key : {"timing", "session"}) {
      if (!protocol.value.contains(key)) {
        refuse(protocol, "", "expected the key \"" + std::string(key) + "\", which is missing");
      }
    }
    return;
  }
  for (const char* key :
       {"timing", "session", "rating", "yes_no", "two_interval", "free_text", "clicks", "gaze"}) {
    if (protocol.value.contains(key)) {
      refuse(protocol, "/" + std::string(key), "expected none where nobody takes part");
    }
  }
  for (const char* key : {"practice", "practice_until", "train_until", "adaptive"}) {
    if (protocol.value["design"].contains(key)) {
      refuse(protocol, "/design/" + std::string(key), "expected none where nobody takes part");
    }
  }
}

}  // namespace impetus::inline protocol
