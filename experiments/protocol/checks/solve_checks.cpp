// SPDX-License-Identifier: MIT
#include "experiments/protocol/checks/solve_checks.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "experiments/protocol/checks/protocol_scene_checks.hpp"

namespace impetus::inline protocol {
namespace {

using nlohmann::json;

constexpr const char* kSpinPointer = "/imposed/random_spin";

const std::vector<std::string>& keys_of(const std::string& kind) {
  static const std::vector<std::string> spin{"accurate_level", "runs", "turn_deg", "size_share",
                                             "percentiles"};
  static const std::vector<std::string> lists{"share", "within", "pilot_s"};
  return kind == "equal-lists" ? lists : spin;
}

void check_keys(const JsonDocument& document, const json& entry, const std::string& place) {
  const auto kind = entry["kind"].get<std::string>();
  const std::vector<std::string>& own = keys_of(kind);
  for (const std::string& key : own) {
    if (!entry.contains(key)) {
      refuse(document, place,
             "expected the key \"" + key + "\" for kind " + kind + ", which is missing");
    }
  }
  for (auto key = entry.begin(); key != entry.end(); ++key) {
    const bool shared = key.key() == "kind" || key.key() == "pointer" || key.key() == "for_each";
    if (!shared && std::find(own.begin(), own.end(), key.key()) == own.end()) {
      refuse(document, place + "/" + key.key(), "expected none for kind " + kind);
    }
  }
}

void check_factors(const Protocol& protocol, const json& entry, const std::string& place) {
  const json names = entry.value("for_each", json::array());
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto& factors = protocol.design.factors;
    if (std::none_of(factors.begin(), factors.end(), [&](const Factor& factor) {
          return factor.name == names[i].get<std::string>();
        })) {
      refuse(protocol.document, place + "/for_each/" + std::to_string(i),
             "expected the name of a factor, got " + names[i].dump());
    }
    const auto& adaptive = protocol.design.adaptive;
    if (adaptive && adaptive->factor == names[i].get<std::string>()) {
      refuse(
          protocol.document, place + "/for_each/" + std::to_string(i),
          "expected a factor whose levels are planned, got the adaptive one, " + names[i].dump());
    }
  }
}

void check_spin(const Protocol& protocol, const json& entry, const std::string& place) {
  const json& scene = protocol.scene.value;
  if (entry["pointer"].get<std::string>() != std::string(kSpinPointer)) {
    refuse(protocol.document, place + "/pointer",
           "expected \"" + std::string(kSpinPointer) + "\", got " + entry["pointer"].dump());
  }
  if (!scene.contains(json::json_pointer(kSpinPointer))) {
    refuse(protocol.document, place + "/pointer",
           "expected a scene with " + std::string(kSpinPointer) + ", but " + protocol.scene.name +
               " has none");
  }
  if (!scene["engine"].contains("level")) {
    refuse(protocol.document, place,
           "expected a scene with /engine/level, but " + protocol.scene.name + " has none");
  }
  if (!(entry["percentiles"][0] < entry["percentiles"][1])) {
    refuse(protocol.document, place + "/percentiles",
           "expected the lower first, got " + entry["percentiles"].dump());
  }
}

void check_lists(const Protocol& protocol, const json& entry, const std::string& place) {
  const json& scene = protocol.scene.value;
  const std::string threshold = "/engine/schedule/thresholds/0";
  if (entry["pointer"].get<std::string>() != threshold) {
    refuse(protocol.document, place + "/pointer",
           "expected \"" + threshold + "\", got " + entry["pointer"].dump());
  }
  const bool two_lists =
      names_single_value(scene, threshold) && scene["engine"]["schedule"]["lists"].size() == 2;
  if (!two_lists) {
    refuse(protocol.document, place,
           "expected a scene with two priority lists and a threshold between them, but " +
               protocol.scene.name + " has none");
  }
}

}  // namespace

void check_solve(const Protocol& protocol) {
  const json entries = protocol.document.value.value("solve", json::array());
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const std::string place = "/solve/" + std::to_string(i);
    check_keys(protocol.document, entries[i], place);
    check_factors(protocol, entries[i], place);
    if (entries[i]["kind"].get<std::string>() == std::string("equal-lists")) {
      check_lists(protocol, entries[i], place);
    } else {
      check_spin(protocol, entries[i], place);
    }
  }
}

}  // namespace impetus::inline protocol
