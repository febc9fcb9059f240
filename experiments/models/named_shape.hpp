// The shapes that a command can name without a file, in sizes of about a metre.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/shapes/triangle_mesh.hpp"

namespace impetus::inline models {

/// sphere, box, l-block, plate, torus, knot, creature, line-swept, rectangle-swept.
const std::vector<std::string>& shape_names();

/// A closed mesh whose longest side is about a metre. `resolution`, 4 to 12, counts the sides of a
/// torus' or a knot's tube and a quarter of the cells along a creature, rounds what is swept as in
/// scenes, and gives four times the triangles of a sphere with every second step. Throws
/// std::invalid_argument (expected
/// ..., got ...) for another name or resolution, or one for a shape that takes none.
TriangleMesh shape_named(const std::string& shape, std::optional<int> resolution = {});

}  // namespace impetus::inline models
