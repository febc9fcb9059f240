// SPDX-License-Identifier: MIT
#include "experiments/protocol/checks/resume_checks.hpp"

#include <string>

namespace impetus::inline protocol {

void check_resume(const JsonDocument& protocol) {
  const nlohmann::json session = protocol.value.value("session", nlohmann::json::object());
  if (!session.contains("resume") || session["resume"]["at"].get<std::string>() != "block") {
    return;
  }
  const nlohmann::json& design = protocol.value["design"];
  if (!design.contains("blocks")) {
    refuse(protocol, "/session/resume/at",
           "expected \"trial\" where /design has no blocks, got \"block\"");
  }
  if (design.contains("adaptive")) {
    refuse(protocol, "/session/resume/at",
           "expected \"trial\" where levels are adaptive (they followed from the answers that "
           "would be set aside), got \"block\"");
  }
}

}  // namespace impetus::inline protocol
