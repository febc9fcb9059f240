// SPDX-License-Identifier: MIT
#include "experiments/protocol/setting_changes.hpp"

#include <algorithm>

#include "experiments/protocol/checked_scene.hpp"
#include "experiments/scenes/engine_setup.hpp"
#include "experiments/scenes/scene_checks.hpp"
#include "experiments/settings/input_error.hpp"

namespace impetus::inline protocol {
namespace {

using nlohmann::json;

bool is_text(const json& value, const std::string& text) {
  return value.is_string() && value.get_ref<const std::string&>() == text;
}

void put_budget(json& engine, const json& value) {
  if (is_text(value, "unlimited")) {
    engine.erase("budget");
    return;
  }
  json budget = engine.value("budget", json::object());
  budget.erase("ms_per_step");
  budget["tests_per_step"] = value;
  engine["budget"] = budget;
}

json list_at(int level) {
  return json::object({{"least_level", level}, {"greatest_level", level}});
}

/// Limits in the unit of a metric say nothing of another scheduler, and a region has two lists and
/// no limits; others, as shares of the pairs, keep their lists.
void put_scheduler(json& engine, const json& value) {
  json schedule = engine.value("schedule", json::object());
  if (schedule.contains("scheduler") && schedule["scheduler"] == value) {
    return;
  }
  const int deepest = engine.value("tree_depth", 0);
  const bool by_region = is_text(value, kRegionScheduler);
  bool keeps_lists = false;
  for (const std::string& key : limited_list_rule_names()) {
    if (by_region || make_list_rule(key)->limits()->is_of_metric) {
      schedule.erase(key);
    }
    keeps_lists |= schedule.contains(key);
  }
  for (const char* key : {"terms", "point_deg"}) {
    schedule.erase(key);
  }
  if (by_region) {
    schedule["lists"] = json::array({list_at(deepest), list_at(0)});
  } else if (!keeps_lists) {
    schedule["lists"] = json::array({json::object()});
    engine.erase("region");
  }
  engine.erase("level");
  schedule["scheduler"] = value;
  engine["schedule"] = schedule;
}

void put_tree(json& engine, const json& value) {
  json tree = engine.value("tree", json::object());
  if (!tree.contains("kind") || tree["kind"] != value) {
    tree.erase("branching");  // each kind has its own
  }
  tree["kind"] = value;
  engine["tree"] = tree;
}

void put_level(json& engine, const json& value) {
  if (!engine.contains("schedule")) {
    engine["level"] = value;
    return;
  }
  for (json& list : engine["schedule"]["lists"]) {
    list["least_level"] = value;
    list["greatest_level"] = value;
  }
}

/// What a JSON Pointer and those below it start with.
bool holds(const std::string& pointer, const std::string& place) {
  return place == pointer || place.starts_with(pointer + "/");
}

[[noreturn]] void refuse_change(const std::string& given, const std::string& message) {
  throw InputError("--with " + given + ": " + message);
}

json value_of(const std::string& text) {
  json value = json::parse(text, nullptr, /*allow_exceptions=*/false);
  return value.is_discarded() ? json(text) : value;
}

void put(const SettingChange& change, json& scene) {
  try {
    if (change.put != nullptr) {
      change.put(scene["engine"], change.value);
    } else {
      scene[json::json_pointer(change.pointer)] = change.value;
    }
  } catch (const json::exception&) {
    refuse_change(change.given, "expected a place of the scene, got " + change.pointer);
  }
}

/// The change that a problem at `pointer` is owed to: of those that touch the place the most
/// particular, of several the last; or else the last of all.
const SettingChange& blamed(const std::vector<SettingChange>& changes, const std::string& pointer) {
  const SettingChange* found = nullptr;
  for (const SettingChange& change : changes) {
    const bool touches = holds(change.pointer, pointer) || holds(pointer, change.pointer);
    if (touches && (found == nullptr || change.pointer.size() >= found->pointer.size())) {
      found = &change;
    }
  }
  return found == nullptr ? changes.back() : *found;
}

[[noreturn]] void refuse_at(const std::vector<SettingChange>& changes, const std::string& pointer,
                            const std::string& message) {
  const SettingChange& change = blamed(changes, pointer);
  const bool elsewhere = !holds(change.pointer, pointer);
  refuse_change(change.given, (elsewhere ? "at " + pointer + " of the scene: " : "") + message);
}

/// Null where the budget does not go by the clock.
json ms_per_step(const json& engine) {
  return engine.value("budget", json::object()).value("ms_per_step", json());
}

bool follows_another(const EngineSettings& engine) {
  return region_of(engine, 1.0).kind == RegionKind::kRecorded;
}

/// Changes that are more than a value put in its place.
PutSetting special_put(const std::string& key) {
  return key == "budget"      ? put_budget
         : key == "level"     ? put_level
         : key == "scheduler" ? put_scheduler
         : key == "tree"      ? put_tree
                              : nullptr;
}

/// A special one changes what is beside its row, too.
SettingKey key_of_row(const WithKey& row) {
  const PutSetting put = special_put(row.key);
  const json::json_pointer place(row.pointer);
  return {row.key, put == nullptr ? row.pointer : place.parent_pointer().to_string(), row.words,
          put};
}

}  // namespace

const std::vector<SettingKey>& setting_keys() {
  static const std::vector<SettingKey> keys = [] {
    std::vector<SettingKey> all;
    for (const WithKey& row : scene_with_keys()) {
      all.push_back(key_of_row(row));
    }
    std::sort(all.begin(), all.end(),
              [](const SettingKey& a, const SettingKey& b) { return a.name < b.name; });
    return all;
  }();
  return keys;
}

SettingChange setting_change(const std::string& given) {
  const std::size_t equals = given.find('=');
  if (equals == std::string::npos || equals == 0 || equals + 1 == given.size()) {
    refuse_change(given, "expected KEY=VALUE, such as scheduler=distance");
  }
  const std::string key = given.substr(0, equals);
  const json value = value_of(given.substr(equals + 1));
  if (holds("/engine/step_hz", key)) {
    refuse_change(given, "expected a setting that keeps the recorded steps as they are");
  }
  if (holds("/engine", key)) {
    return {given, key, value};
  }
  for (const SettingKey& known : setting_keys()) {
    if (key == known.name) {
      return {given, known.pointer, value, known.put};
    }
  }
  refuse_change(given, "expected one of the keys " + listed(setting_keys(), &SettingKey::name) +
                           ", or a JSON Pointer below /engine, got " + key);
}

json changed_scene(const json& scene, const std::vector<SettingChange>& changes) {
  json changed = scene;
  for (const SettingChange& change : changes) {
    put(change, changed);
  }
  if (const auto problem = find_scene_schema_problem(changed)) {
    refuse_at(changes, problem->pointer, problem->message);
  }
  const json& engine = changed["engine"];
  if (engine["step_hz"] != scene["engine"]["step_hz"]) {
    refuse_at(changes, "/engine/step_hz", "expected the recorded steps to stay as they are");
  }
  for (const SceneProblem& problem : scene_problems(changed)) {
    refuse_at(changes, problem.pointer, problem.message);
  }
  if (!ms_per_step(engine).is_null() && ms_per_step(engine) != ms_per_step(scene["engine"])) {
    refuse_at(changes, "/engine/budget/ms_per_step",
              "expected units of work, which are the same each time, got milliseconds");
  }
  if (follows_another(engine) && !follows_another(scene["engine"])) {
    refuse_at(changes, "/engine/region/kind",
              "expected a region that needs no other participant's gaze, got \"recorded\"");
  }
  return changed;
}

}  // namespace impetus::inline protocol
