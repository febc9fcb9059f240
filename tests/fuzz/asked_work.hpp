// How much work a scene asks for: a fuzzer leaves out what would rightly take minutes.
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace impetus {

/// Whether the scene, or one under the levels of the protocol's factors and demonstrations, asks
/// for deep trees, fine meshes or many bodies. Any JSON is taken.
bool asks_for_much(const nlohmann::json& scene,
                   const nlohmann::json& protocol = nlohmann::json::object());

}  // namespace impetus
