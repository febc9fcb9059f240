// SPDX-License-Identifier: MIT
#include "experiments/models/named_shape.hpp"

#include <algorithm>
#include <stdexcept>

#include "engine/shapes/solids/ball_meshes.hpp"
#include "engine/shapes/solids/block_meshes.hpp"
#include "engine/shapes/solids/creature_mesh.hpp"
#include "engine/shapes/solids/ring_meshes.hpp"

namespace impetus::inline models {
namespace {

constexpr int kLeastResolution = 4;
constexpr int kGreatestResolution = 12;

/// A shape, how fine it usually is, and who makes it.
struct NamedShape {
  const char* name;
  int usual_resolution;  ///< 0: it takes none
  TriangleMesh (*make)(int resolution);
};

const NamedShape kShapes[] = {
    {"sphere", 8, [](int resolution) { return icosphere_mesh(0.5, resolution / 2 - 1); }},
    {"box", 0,
     [](int) {
       return box_mesh({1.0, 0.75, 0.5});
     }},
    {"l-block", 0, [](int) { return l_block_mesh(1.0, 0.35); }},
    {"plate", 0,
     [](int) {
       return box_mesh({1.0, 1.0, 0.05});
     }},
    {"torus", 10, [](int sides) { return torus_mesh(0.35, 0.15, 3 * sides, sides); }},
    {"knot", 8, [](int sides) { return knot_mesh(0.45, 0.09, 8 * sides, sides); }},
    {"creature", 4, [](int resolution) { return creature_mesh(1.0, 4 * resolution); }},
    {"line-swept", 4, [](int resolution) { return swept_mesh(0.0, 0.3, 0.2, 2 * resolution - 3); }},
    {"rectangle-swept", 4,
     [](int resolution) { return swept_mesh(0.35, 0.2, 0.15, 2 * resolution - 3); }},
};

const NamedShape* find_shape(const std::string& name) {
  const auto* const found =
      std::find_if(std::begin(kShapes), std::end(kShapes),
                   [&](const NamedShape& shape) { return name == shape.name; });
  return found == std::end(kShapes) ? nullptr : found;
}

}  // namespace

const std::vector<std::string>& shape_names() {
  static const std::vector<std::string> kNames = [] {
    std::vector<std::string> names;
    for (const NamedShape& shape : kShapes) {
      names.emplace_back(shape.name);
    }
    return names;
  }();
  return kNames;
}

TriangleMesh shape_named(const std::string& name, std::optional<int> resolution) {
  const NamedShape* shape = find_shape(name);
  if (shape == nullptr) {
    std::string names;
    for (const std::string& known : shape_names()) {
      names += (names.empty() ? "" : ", ") + known;
    }
    throw std::invalid_argument("expected a mesh file or one of the shapes " + names + ", got \"" +
                                name + "\"");
  }
  if (resolution && shape->usual_resolution == 0) {
    throw std::invalid_argument("expected no resolution for the shape " + name + ", got " +
                                std::to_string(*resolution));
  }
  const int chosen = resolution.value_or(shape->usual_resolution);
  if (shape->usual_resolution > 0 && (chosen < kLeastResolution || chosen > kGreatestResolution)) {
    throw std::invalid_argument("expected a resolution from 4 to 12, got " +
                                std::to_string(chosen));
  }
  return shape->make(chosen);
}

}  // namespace impetus::inline models
