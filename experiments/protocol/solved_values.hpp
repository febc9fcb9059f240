// Values of a scene that are solved before a plan is stored, and how they get into trials.
//
//   /solve of the protocol ──for each level of its factors──> simulations ──> values
//   values ──put_solved()──> every trial of the plan ──> stored ──> the scene, whenever it is
//   staged
//
// Protocol and scene alone decide them: the screen is an assumed one, random streams have names of
// their own, and nothing is kept between runs. A replay takes what was stored and solves nothing.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "experiments/design/plan.hpp"
#include "experiments/protocol/protocol_file.hpp"
#include "experiments/scenes/scene.hpp"
#include "experiments/scenes/shape_library.hpp"

namespace impetus::inline protocol {

/// One entry of a protocol's "solve", at certain levels of its factors.
struct SolveTask {
  const JsonDocument* document;  ///< the protocol's, for refusals
  std::string place;             ///< JSON Pointer to the entry
  SolveEntry entry;
  Condition condition;
  Scene scene;  ///< under the condition
};

/// Of the trials that have these levels.
struct SolvedFor {
  Condition condition;
  std::vector<SolvedValue> values;
};

/// One entry of a protocol's "solve".
Kind<SolveEntry> solve_kind();

/// Kinds have their keys, pointers lead to what they solve, factors exist. Whether there is a
/// solution shows when it is looked for. Throws InputError.
void check_solve(const Protocol& protocol);

/// Everything the protocol asks to be solved. Throws InputError, naming the entry, when there is no
/// solution.
std::vector<SolvedFor> solve(const Protocol& protocol, ShapeLibrary& shapes,
                             const Progress& progress = {});

/// Gives each trial of the plan the values of its condition.
void put_solved(const std::vector<SolvedFor>& solved, Plan& plan);

/// The scene with the values put in.
void put_into_scene(const std::vector<SolvedValue>& values, nlohmann::json& scene);

/// {"/pointer": number}; and back.
nlohmann::json solved_values_json(const std::vector<SolvedValue>& values);
std::vector<SolvedValue> solved_values_from_json(const nlohmann::json& object);

/// The same as text, "" for none.
std::string to_text(const std::vector<SolvedValue>& values);
std::vector<SolvedValue> solved_values_from(const std::string& text);

}  // namespace impetus::inline protocol
