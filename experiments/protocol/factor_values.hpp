// What a factor's levels put into the scene: one value by its pointer, or several by those of its
// sets.
//
//   pointer                                      "sets"
//   /meeting/gap_arcmin   30                     "clip 1": {"/bodies/0/position_px": [830, 550],
//                                                           "/bodies/1/position_px": [829, 100]}
//
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "experiments/design/design.hpp"

namespace impetus::inline protocol {

/// What the level puts into the scene, by JSON Pointer; empty for a factor of keys, and for a level
/// that has no set.
nlohmann::json values_of(const Factor& factor, const LevelValue& level);

/// Whether the level is a word that the factor's sets have.
bool has_set(const Factor& factor, const LevelValue& level);

/// The pointers to all that the factor overrides, each once.
std::vector<std::string> overridden_by(const Factor& factor);

}  // namespace impetus::inline protocol
