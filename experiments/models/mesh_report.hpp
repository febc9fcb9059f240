// What a mesh is: its counts, its defects and, when it encloses a solid, the solid.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "engine/shapes/mass_properties.hpp"
#include "engine/shapes/triangle_mesh.hpp"

namespace impetus {

/// Density of the solid in a report: water.
inline constexpr double kReportDensity_kg_m3 = 1000.0;

struct MeshReport {
  std::int64_t triangles{0};
  std::int64_t vertices{0};
  std::int64_t components{0};  ///< parts that share no vertex
  MeshDefects defects;
  /// At kReportDensity_kg_m3; nothing when the defects leave no solid. A volume below zero means
  /// that the surface is inside out.
  std::optional<MassProperties> solid;

  /// Whether the mesh can be a body: a closed surface around a positive volume.
  [[nodiscard]] bool usable() const { return solid && solid->volume_m3 > 0.0; }
};

/// Every vertex index must be within `mesh.vertices`.
MeshReport report_mesh(const TriangleMesh& mesh);

/// The report as lines of text, the last one ending in a newline.
std::string describe_mesh(const TriangleMesh& mesh);

}  // namespace impetus
