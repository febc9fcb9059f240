// SPDX-License-Identifier: MIT
#include "experiments/protocol/checks/protocol_scene_checks.hpp"

#include <cmath>
#include <cstdio>
#include <set>

#include "experiments/protocol/checks/participant_checks.hpp"
#include "experiments/protocol/scene_loading.hpp"
#include "experiments/questions/two_interval.hpp"
#include "experiments/scenes/engine_setup.hpp"
#include "experiments/scenes/scene_file.hpp"

namespace impetus::inline protocol {
namespace {

using nlohmann::json;

/// Every cell, and every catch trial's condition.
std::vector<Condition> shown_conditions(const Design& design) {
  std::vector<Condition> conditions = cells(design);
  for (const CatchTrials& kind : design.catch_trials) {
    conditions.push_back(kind.condition);
  }
  return conditions;
}

std::string milliseconds(double seconds) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f ms", seconds * 1e3);
  return text;
}

bool on_grid(double duration_s, double hz) {
  const double frames = duration_s * hz;
  return std::abs(frames - std::round(frames)) < 1e-3;
}

std::string off_grid_message(const json& value, double hz) {
  char rate[32];
  std::snprintf(rate, sizeof rate, "%g", hz);
  return "expected a whole number of " + std::string(rate) + " Hz frames (" +
         milliseconds(1.0 / hz) + "), got " + value.dump();
}

void check_catch_frames(const Protocol& protocol, const std::string& factor,
                        const FrameBoundValue& bound, double hz) {
  const json kinds = protocol.document.value["design"].value("catch_trials", json::array());
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    const json& level = kinds[i]["condition"][factor];
    if (!on_grid(level.get<double>() * bound.unit_s, hz)) {
      refuse(protocol.document, item("/design/catch_trials", i) + "/condition/" + factor,
             off_grid_message(level, hz));
    }
  }
}

/// Of a standard's level, which need not be one of the factor's.
void check_standard_bound(const Protocol& protocol, const std::string& factor,
                          const FrameBoundValue& bound, double hz) {
  const json::json_pointer standard("/two_interval/standard");
  const json& document = protocol.document.value;
  if (!document.contains(standard) || !document[standard].contains(factor)) {
    return;
  }
  const json& level = document[standard][factor];
  if (!on_grid(level.get<double>() * bound.unit_s, hz)) {
    refuse(protocol.document, (standard / factor).to_string(), off_grid_message(level, hz));
  }
}

void check_frame_bound(const Protocol& protocol, const FrameBoundValue& bound, double hz) {
  const json& factors = protocol.document.value["design"]["factors"];
  for (std::size_t i = 0; i < factors.size(); ++i) {
    if (factors[i]["pointer"] != bound.pointer) {
      continue;
    }
    check_standard_bound(protocol, factors[i]["name"].get<std::string>(), bound, hz);
    const json& levels = factors[i]["levels"];
    for (std::size_t j = 0; j < levels.size(); ++j) {
      if (!on_grid(levels[j].get<double>() * bound.unit_s, hz)) {
        refuse(protocol.document, item(item("/design/factors", i) + "/levels", j),
               off_grid_message(levels[j], hz));
      }
    }
    check_catch_frames(protocol, factors[i]["name"].get<std::string>(), bound, hz);
    return;
  }
  const json::json_pointer pointer(bound.pointer);
  if (!protocol.scene.value.contains(pointer)) {
    return;
  }
  const json& value = protocol.scene.value[pointer];
  if (!on_grid(value.get<double>() * bound.unit_s, hz)) {
    refuse(protocol.scene, bound.pointer, off_grid_message(value, hz));
  }
}

}  // namespace

std::string complaint(const json& scene) {
  if (const auto problem = find_scene_schema_problem(scene)) {
    return problem->message;
  }
  const auto problems = scene_problems(scene);
  return problems.empty() ? "" : problems.front().message;
}

bool names_single_value(const json& scene, const std::string& pointer) {
  try {
    return scene.contains(json::json_pointer(pointer)) &&
           scene[json::json_pointer(pointer)].is_primitive();
  } catch (const json::exception&) {
    return false;
  }
}

void check_levels(const Protocol& protocol) {
  for (std::size_t i = 0; i < protocol.design.factors.size(); ++i) {
    const Factor& factor = protocol.design.factors[i];
    for (std::size_t j = 0; j < factor.levels.size(); ++j) {
      const json scene = scene_under(protocol, {{factor.name, factor.levels[j]}});
      const std::string message = complaint(scene);
      if (!message.empty()) {
        refuse(protocol.document, item(item("/design/factors", i) + "/levels", j), message);
      }
    }
  }
  for (const Condition& cell : cells(protocol.design)) {
    const auto problems = scene_problems(scene_under(protocol, cell));
    if (!problems.empty()) {
      refuse(protocol.document, "/design/factors",
             problems.front().pointer + " of the scene under " + to_json(cell).dump() + ": " +
                 problems.front().message);
    }
  }
}

void check_catch_scenes(const Protocol& protocol) {
  for (std::size_t i = 0; i < protocol.design.catch_trials.size(); ++i) {
    for (const FactorLevel& level : protocol.design.catch_trials[i].condition) {
      const std::string message = complaint(scene_under(protocol, {level}));
      if (!message.empty()) {
        refuse(protocol.document,
               item("/design/catch_trials", i) + "/condition" + "/" + level.factor, message);
      }
    }
    const std::string message =
        complaint(scene_under(protocol, protocol.design.catch_trials[i].condition));
    if (!message.empty()) {
      refuse(protocol.document, item("/design/catch_trials", i) + "/condition", message);
    }
  }
}

void check_demonstrations(const Protocol& protocol) {
  const json entries = protocol.document.value.value("session", json::object())
                           .value("demonstrations", json::array());
  std::set<std::string> ids;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const std::string place = item("/session/demonstrations", i);
    const auto id = entries[i]["id"].get<std::string>();
    if (!ids.insert(id).second) {
      refuse(protocol.document, place + "/id",
             "expected an id of its own, got " + json(id).dump() + " again");
    }
    const json& values = entries[i]["set"];
    for (auto value = values.begin(); value != values.end(); ++value) {
      if (!names_single_value(protocol.scene.value, value.key())) {
        refuse(protocol.document, place + "/set",
               "expected pointers to single values of " + protocol.scene.name + ", got \"" +
                   value.key() + "\"");
      }
    }
    const json scene = demonstration_scene(protocol, id);
    const std::string message = complaint(scene);
    if (!message.empty()) {
      refuse(protocol.document, place + "/set", message);
    }
    if (depends_on_gaze(scene["engine"])) {
      refuse(
          protocol.document, place + "/set",
          "expected a scene whose detail does not depend on the gaze, which is not followed yet");
    }
  }
}

void check_gaze(const Protocol& protocol) {
  if (protocol.document.value.contains("gaze") || !has_participants(protocol.document.value)) {
    return;  // nobody's gaze is the screen's centre
  }
  for (const Condition& cell : shown_conditions(protocol.design)) {
    if (depends_on_gaze(scene_under(protocol, cell)["engine"])) {
      refuse(
          protocol.document, "",
          "expected the key \"gaze\", because the detail of collisions depends on the gaze under " +
              to_json(cell).dump() + ", but it is missing");
    }
  }
}

void check_frames(const Protocol& protocol, double refresh_hz, bool allow_rounding) {
  for (const FrameBoundValue& bound : frame_bound_values()) {
    if (!(allow_rounding && bound.may_round)) {
      check_frame_bound(protocol, bound, refresh_hz);
    }
  }
  if (!protocol.document.value.contains("timing")) {
    return;
  }
  const json& fixation = protocol.document.value["timing"]["fixation_ms"];
  if (!allow_rounding && !on_grid(fixation.get<double>() * 1e-3, refresh_hz)) {
    refuse(protocol.document, "/timing/fixation_ms", off_grid_message(fixation, refresh_hz));
  }
  const TwoIntervalQuestion* two = find_two_interval(protocol.script);
  if (!allow_rounding && two != nullptr && !on_grid(two->between_ms() * 1e-3, refresh_hz)) {
    refuse(protocol.document, "/two_interval/between_ms",
           off_grid_message(json(two->between_ms()), refresh_hz));
  }
}

}  // namespace impetus::inline protocol
