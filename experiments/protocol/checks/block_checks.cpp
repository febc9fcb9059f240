// SPDX-License-Identifier: MIT
#include "experiments/protocol/checks/block_checks.hpp"

#include <algorithm>
#include <string>

namespace impetus::inline protocol {

using nlohmann::json;

void check_blocks(const JsonDocument& protocol) {
  const json& design = protocol.value["design"];
  if (!design.contains("blocks")) {
    return;
  }
  const json& names = design["blocks"]["factors"];
  const json& factors = design["factors"];
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string place = "/design/blocks/factors/" + std::to_string(i);
    const auto name = names[i].get<std::string>();
    const bool known = std::any_of(factors.begin(), factors.end(), [&](const json& factor) {
      return factor["name"].get<std::string>() == name;
    });
    if (!known) {
      refuse(protocol, place, "expected the name of a factor, got " + names[i].dump());
    }
    if (design.contains("adaptive") && design["adaptive"]["factor"].get<std::string>() == name) {
      refuse(protocol, place,
             "expected a factor whose levels are known beforehand, got " + names[i].dump() +
                 ", which is adaptive");
    }
  }
}

}  // namespace impetus::inline protocol
