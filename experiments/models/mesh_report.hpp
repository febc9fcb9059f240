// What a mesh is: its counts, its defects and, when it encloses a solid, the solid.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "engine/shapes/mass_properties.hpp"
#include "engine/shapes/self_intersections.hpp"
#include "engine/shapes/triangle_mesh.hpp"

namespace impetus::inline models {

/// Density of the solid in a report: water.
inline constexpr double kReportDensity_kg_m3 = 1000.0;

/// Everything that is counted of a mesh, before anybody judges it.
struct MeshReport {
  std::int64_t triangles{0};
  std::int64_t vertices{0};
  std::int64_t components{0};        ///< parts that share no edge
  std::int64_t pinched_vertices{0};  ///< where parts of the surface meet in a corner only
  MeshDefects defects;
  std::int64_t duplicate_triangles{0};
  SelfIntersections self_intersections;
  std::int64_t flat_components{0};    ///< known when `defects` are none
  std::int64_t turned_components{0};  ///< inside out; known when `defects` are none
  /// At kReportDensity_kg_m3; nothing when the defects leave no solid. A volume below zero means
  /// that the surface is inside out.
  std::optional<MassProperties> solid;

  /// Whether the mesh can be a body: a closed surface whose every component looks the right way and
  /// encloses a volume. Pinched vertices and self-intersections do not stand in the way: what
  /// overlaps counts twice in the volume and is otherwise simulated as it is.
  [[nodiscard]] bool usable() const {
    return solid && flat_components == 0 && turned_components == 0 && duplicate_triangles == 0;
  }
};

/// "1 open edge", "2 open edges".
std::string counted(std::int64_t count, const std::string& one, const std::string& many);

/// Every vertex index must be within `mesh.vertices`.
MeshReport report_mesh(const TriangleMesh& mesh);

/// The report as lines of text, the last one ending in a newline.
std::string describe(const MeshReport& report);

/// Why the mesh cannot be a body, with the counts and no full stop; empty when it can.
std::string refusal(const MeshReport& report);

}  // namespace impetus::inline models
