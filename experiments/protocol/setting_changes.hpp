// Settings of a scene's engine that are asked for in place of its own, as "KEY=VALUE".
//
//   scheduler=distance            one of a few keys, each for a place of the scene
//   /engine/tree/kind=octree      any place below /engine, by its JSON Pointer
//
// A value is JSON; a word that is none is text. Changes are done in the order given, on the scene
// as its trial had it, and what comes out must be a scene that could be shown.
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace impetus::inline protocol {

/// Changes a scene's "engine"; `value` may be of any type.
using PutSetting = void (*)(nlohmann::json& engine, const nlohmann::json& value);

/// A name by which a setting of the engine is changed.
struct SettingKey {
  std::string name;
  std::string pointer;  ///< the place, or the place above all that it changes
  std::string meaning;
  PutSetting put;  ///< null: the value is put there as it is
};

/// All that a key can be, in alphabetical order: the rows of a scene that say so.
const std::vector<SettingKey>& setting_keys();

/// One setting of the engine, changed.
struct SettingChange {
  std::string given;  ///< "scheduler=distance"
  std::string pointer;
  nlohmann::json value;
  PutSetting put{nullptr};
};

/// What `given` says. Throws InputError, in one sentence that lists what is possible, when it is no
/// KEY=VALUE, or no place below /engine, or one by which the recorded steps would not stay steps.
SettingChange setting_change(const std::string& given);

/// The scene with the changes. Throws InputError that names the change when the outcome could not
/// be shown, or not simulated again alike. Precondition: `scene` can be shown.
nlohmann::json changed_scene(const nlohmann::json& scene,
                             const std::vector<SettingChange>& changes);

}  // namespace impetus::inline protocol
