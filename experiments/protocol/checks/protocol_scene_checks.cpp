// SPDX-License-Identifier: MIT
#include "experiments/protocol/checks/protocol_scene_checks.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "experiments/design/between_participants.hpp"
#include "experiments/protocol/checked_scene.hpp"
#include "experiments/questions/two_interval.hpp"
#include "experiments/scenes/engine_setup.hpp"
#include "experiments/scenes/scene_file.hpp"
#include "experiments/tables/number_text.hpp"

namespace impetus::inline protocol {
namespace {

using nlohmann::json;

/// Every cell, and what is shown beside them.
std::vector<Condition> shown_conditions(const Design& design) {
  std::vector<Condition> conditions = cells(design);
  for (const ConditionBeside& beside : conditions_beside(design)) {
    const std::vector<Condition> shown = in_every_group(beside.condition, design);
    conditions.insert(conditions.end(), shown.begin(), shown.end());
  }
  return conditions;
}

std::string milliseconds(double seconds) { return printed("%.2f ms", seconds * 1e3); }

/// Refuses a duration at `place` that is no whole number of frames.
void require_frames(const JsonDocument& document, const std::string& place, double duration,
                    double unit_s, double hz) {
  const double frames = duration * unit_s * hz;
  if (!(std::abs(frames - std::round(frames)) < 1e-3)) {
    const std::string rate = printed("%g", hz);
    refuse(document, place,
           "expected a whole number of " + std::string(rate) + " Hz frames (" +
               milliseconds(1.0 / hz) + "), got " + json_text(duration));
  }
}

/// The same of a value of the scene that no factor points to: the scene's own, and what the words
/// of factors put in its place.
void require_frames_of_scene(const Protocol& protocol, const FrameBoundValue& bound, double hz) {
  const json::json_pointer pointer(bound.pointer);
  const json& scene = protocol.scene.value;
  const auto require = [&](const JsonDocument& document, const std::string& place,
                           const json& shown) {
    if (shown.contains(pointer)) {
      require_frames(document, place, shown[pointer].get<double>(), bound.unit_s, hz);
    }
  };
  bool is_overridden = false;
  for (std::size_t i = 0; i < protocol.design.factors.size(); ++i) {
    const Factor& factor = protocol.design.factors[i];
    bool is_by_all = !factor.sets.empty();
    for (const auto& [word, values] : factor.sets) {
      const json shown = scene_under(protocol, {{factor.name, word}});
      const bool is_own =
          shown.contains(pointer) && scene.contains(pointer) && shown[pointer] == scene[pointer];
      if (!is_own) {
        require(protocol.document, item("/design/factors", i) + "/sets/" + word, shown);
      }
      is_by_all = is_by_all && !is_own;
    }
    is_overridden = is_overridden || is_by_all;
  }
  if (!is_overridden) {
    require(protocol.scene, bound.pointer, scene);
  }
}

void check_frame_bound(const Protocol& protocol, const FrameBoundValue& bound, double hz) {
  for (std::size_t i = 0; i < protocol.script.demonstrations.size(); ++i) {
    for (const auto& [pointer, value] : protocol.script.demonstrations[i].set) {
      if (pointer == bound.pointer) {
        require_frames(protocol.document, item("/session/demonstrations", i) + "/set",
                       std::get<double>(value), bound.unit_s, hz);
      }
    }
  }
  const std::vector<Factor>& factors = protocol.design.factors;
  const auto factor = std::find_if(factors.begin(), factors.end(), [&](const Factor& each) {
    return each.pointer == bound.pointer;
  });
  if (factor == factors.end()) {
    require_frames_of_scene(protocol, bound, hz);
    return;
  }
  const auto require_level = [&](const std::string& place, const LevelValue& level) {
    require_frames(protocol.document, place, std::get<double>(level), bound.unit_s, hz);
  };
  const auto require_condition = [&](const std::string& place, const Condition& condition) {
    if (const FactorLevel* level = find_level(condition, factor->name)) {
      require_level(place + "/" + factor->name, level->value);
    }
  };
  if (const TwoIntervalQuestion* question = find_two_interval(protocol.script)) {
    require_condition("/two_interval/standard", question->standard_levels());
  }
  const std::string levels =
      item("/design/factors", factor_place(protocol.design, factor->name)) + "/levels";
  for (std::size_t i = 0; i < factor->levels.size(); ++i) {
    require_level(item(levels, i), factor->levels[i]);
  }
  for (const ConditionBeside& beside : conditions_beside(protocol.design)) {
    require_condition(beside.place, beside.condition);
  }
}

}  // namespace

std::string complaint(const json& scene, ShapeLibrary& shapes) {
  if (const auto problem = find_scene_schema_problem(scene)) {
    return problem->message;
  }
  const auto problems = scene_problems(scene, shapes);
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

void require_level_in_schema(const Protocol& protocol, const FactorLevel& level,
                             const std::string& place) {
  if (const auto problem = find_scene_schema_problem(scene_under(protocol, {level}))) {
    refuse(protocol.document, place, problem->message);
  }
}

void refuse_fault(const Protocol& protocol, const Condition& levels, const LevelPlace& place_of,
                  const std::string& message) {
  for (const FactorLevel& level : levels) {
    if (complaint(scene_under(protocol, {level}), *protocol.shapes) == message) {
      refuse(protocol.document, place_of(level), message);
    }
  }
}

void check_levels(const Protocol& protocol) {
  const auto place_of = [&](const FactorLevel& level) {
    const std::size_t place = factor_place(protocol.design, level.factor);
    const std::vector<LevelValue>& levels = protocol.design.factors[place].levels;
    const auto at = std::find(levels.begin(), levels.end(), level.value) - levels.begin();
    return item(item("/design/factors", place) + "/levels", static_cast<std::size_t>(at));
  };
  for (const Factor& factor : protocol.design.factors) {
    for (const LevelValue& value : factor.levels) {
      const FactorLevel level{factor.name, value};
      require_level_in_schema(protocol, level, place_of(level));
    }
  }
  for (const Condition& cell : cells(protocol.design)) {
    const auto problems = scene_problems(scene_under(protocol, cell), *protocol.shapes);
    if (!problems.empty()) {
      refuse_fault(protocol, cell, place_of, problems.front().message);
      refuse(protocol.document, "/design/factors",
             problems.front().pointer + " of the scene under " + to_json(cell).dump() + ": " +
                 problems.front().message);
    }
  }
}

void check_scenes_beside(const Protocol& protocol) {
  for (const ConditionBeside& beside : conditions_beside(protocol.design)) {
    const auto place_of = [&](const FactorLevel& level) {
      return beside.place + "/" + level.factor;
    };
    for (const FactorLevel& level : beside.condition) {
      require_level_in_schema(protocol, level, place_of(level));
    }
    for (const Condition& condition : in_every_group(beside.condition, protocol.design)) {
      const std::string message = complaint(scene_under(protocol, condition), *protocol.shapes);
      if (!message.empty()) {
        refuse_fault(protocol, beside.condition, place_of, message);
        refuse(protocol.document, beside.place, message);
      }
    }
  }
}

void check_named_bodies(const Protocol& protocol) {
  for (const auto& question : protocol.script.asked) {
    for (const NamedBody& body : question->named_bodies()) {
      for (const Condition& condition : shown_conditions(protocol.design)) {
        const Scene scene = scene_under(protocol, condition);
        const auto bodies = scene.named_bodies();
        if (std::none_of(bodies.begin(), bodies.end(),
                         [&](const BodySettings& each) { return each.name == body.name; })) {
          refuse(protocol.document, body.place,
                 "expected the name of a body of the scene, got " + json_text(body.name));
        }
      }
    }
  }
}

void check_demonstrations(const Protocol& protocol) {
  std::set<std::string> ids;
  for (std::size_t i = 0; i < protocol.script.demonstrations.size(); ++i) {
    const Demonstration& demonstration = protocol.script.demonstrations[i];
    const std::string place = item("/session/demonstrations", i);
    if (!ids.insert(demonstration.id).second) {
      refuse(protocol.document, place + "/id",
             "expected an id of its own, got " + json_text(demonstration.id) + " again");
    }
    for (const auto& [pointer, value] : demonstration.set) {
      if (!names_single_value(protocol.scene.value, pointer)) {
        refuse(protocol.document, place + "/set",
               "expected pointers to single values of " + protocol.scene.name + ", got \"" +
                   pointer + "\"");
      }
    }
    const json scene = demonstration_scene(protocol, demonstration);
    const std::string message = complaint(scene, *protocol.shapes);
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
  if (protocol.script.gaze || !protocol.has_participants) {
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
  if (!protocol.has_participants || allow_rounding) {
    return;
  }
  const FixationTime& cross = protocol.script.timing.fixation;
  for (const double duration_ms : {cross.least_ms, cross.most_ms}) {
    require_frames(protocol.document, "/timing/fixation_ms", duration_ms, 1e-3, refresh_hz);
  }
  if (const TwoIntervalQuestion* two = find_two_interval(protocol.script)) {
    require_frames(protocol.document, "/two_interval/between_ms", two->between_ms(), 1e-3,
                   refresh_hz);
  }
}

}  // namespace impetus::inline protocol
