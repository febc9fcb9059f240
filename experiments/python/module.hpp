// The module _impetus: what the package `impetus` for Python is made of.
//
//   world.cpp   the engine: a scene's world, stepped          files.cpp   protocols and scenes
//   study.cpp   a study's tables, replays and what-ifs        pilot.cpp   sessions that nobody
//   keeps
//
// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include <cstdint>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "experiments/protocol/protocol_file.hpp"
#include "experiments/record/staged_scene.hpp"

namespace impetus::inline python {

void add_metrics(pybind11::module_& module);
void add_steps(pybind11::module_& module);
void add_trees(pybind11::module_& module);
void add_worlds(pybind11::module_& module);
void add_files(pybind11::module_& module);
void add_studies(pybind11::module_& module);
void add_pilots(pybind11::module_& module);

/// JSON as Python's own dictionaries, lists, texts and numbers, and back; where JSON cannot hold
/// it, an InputError that begins with the name.
pybind11::object as_python(const nlohmann::json& value);
nlohmann::json as_json(const pybind11::object& value, const std::string& name);

/// "x0123456789abcdef": 64 bits as an export has them.
std::string bits_of(std::uint64_t bits);

/// A world in Python's hands, at the start of the scene.
pybind11::object world_of(StagedScene scene, std::uint64_t seed);

/// What a metric written in Python measures pairs by: a function of a pair. Throws ValueError where
/// `urgent` is neither "large" nor "small".
std::shared_ptr<const PriorityMetric> metric_of_function(pybind11::function measure,
                                                         const std::string& urgent);

/// From the next step on.
void put_metric(World& world, std::shared_ptr<const PriorityMetric> metric);

}  // namespace impetus::inline python
