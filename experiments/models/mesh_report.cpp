// SPDX-License-Identifier: MIT
#include "experiments/models/mesh_report.hpp"

#include <algorithm>
#include <locale>
#include <ostream>
#include <sstream>
#include <vector>

#include "engine/shapes/mesh_components.hpp"
#include "engine/shapes/triangle_mesh.hpp"

namespace impetus::inline models {
namespace {

/// "a", "a and b", "a, b and c".
std::string listed(const std::vector<std::string>& parts) {
  std::string text;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const bool last = i + 1 == parts.size();
    text += (i == 0 ? "" : last ? " and " : ", ") + parts[i];
  }
  return text;
}

/// Defects of one kind that are there at all, in words.
class Found {
 public:
  Found& add(std::int64_t count, const std::string& one, const std::string& many) {
    if (count > 0) {
      parts_.push_back(counted(count, one, many));
    }
    return *this;
  }
  [[nodiscard]] bool none() const { return parts_.empty(); }
  [[nodiscard]] std::string text() const { return listed(parts_); }

  /// What a line of the report says: `good` or the defects.
  [[nodiscard]] std::string or_else(const std::string& good) const {
    return none() ? good : "no: " + text();
  }

 private:
  std::vector<std::string> parts_;
};

Found& add_open(Found& found, const MeshReport& report) {
  return found.add(report.defects.open_edges, "open edge", "open edges");
}

Found& add_misoriented(Found& found, const MeshReport& report) {
  return found.add(report.defects.misoriented_edges, "misoriented edge", "misoriented edges");
}

Found& add_crowded(Found& found, const MeshReport& report) {
  return found.add(report.defects.crowded_edges, "edge of more than two triangles",
                   "edges of more than two triangles");
}

Found& add_faces(Found& found, const MeshReport& report) {
  return found
      .add(report.defects.degenerate_triangles, "triangle without area", "triangles without area")
      .add(report.duplicate_triangles, "duplicate triangle", "duplicate triangles");
}

Found& add_orientation(Found& found, const MeshReport& report) {
  return found.add(report.turned_components, "component inside out", "components inside out")
      .add(report.flat_components, "flat component", "flat components");
}

std::string outward(const MeshReport& report) {
  Found found;
  return report.defects.none() ? add_orientation(found, report).or_else("yes")
                               : "unknown: the surface encloses no solid";
}

std::string manifold(const MeshReport& report) {
  Found found;
  return add_crowded(found, report)
      .add(report.pinched_vertices, "vertex where the surface is pinched",
           "vertices where the surface is pinched")
      .or_else("yes");
}

std::string self_crossing(const MeshReport& report) {
  Found found;
  found
      .add(report.self_intersections.crossing_pairs, "pair of triangles that cross or touch",
           "pairs of triangles that cross or touch")
      .add(report.self_intersections.folded_pairs, "pair of neighbours that fold onto each other",
           "pairs of neighbours that fold onto each other");
  return found.none()    ? "none"
         : !report.solid ? found.text()
                         : found.text() + "; what overlaps counts twice in the volume";
}

void print_solid(std::ostream& out, const MassProperties& solid) {
  const Vector3& c = solid.centre;
  const Matrix3& i = solid.inertia;
  out << "volume        " << solid.volume_m3 << " m^3"
      << (solid.volume_m3 > 0.0 ? "" : ": the surface is inside out") << "\n"
      << "centre        (" << c.x() << ", " << c.y() << ", " << c.z() << ") m\n"
      << "mass          " << solid.mass_kg << " kg at " << kReportDensity_kg_m3 << " kg/m^3\n"
      << "inertia       xx " << i(0, 0) << ", yy " << i(1, 1) << ", zz " << i(2, 2) << ", xy "
      << i(0, 1) << ", xz " << i(0, 2) << ", yz " << i(1, 2) << " kg m^2 about the centre\n";
}

}  // namespace

std::string counted(std::int64_t count, const std::string& one, const std::string& many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

MeshReport report_mesh(const TriangleMesh& mesh) {
  MeshReport report;
  report.triangles = static_cast<std::int64_t>(mesh.triangles.size());
  report.vertices = static_cast<std::int64_t>(mesh.vertices.size());
  const MeshComponents components = find_components(mesh);
  report.components = components.count;
  report.pinched_vertices = components.pinched_vertices;
  report.defects = find_defects(mesh);
  report.duplicate_triangles = count_duplicates(mesh);
  if (report.defects.bad_vertices == 0) {
    report.self_intersections = find_self_intersections(mesh);
  }
  if (report.defects.none() && report.triangles > 0) {
    const ComponentOrientation orientation = orientation_of(mesh, components);
    report.flat_components = std::count(orientation.flat.begin(), orientation.flat.end(), true);
    report.turned_components =
        std::count(orientation.turned.begin(), orientation.turned.end(), true);
    if (report.flat_components < report.components) {
      report.solid = solid_of(mesh, kReportDensity_kg_m3);
    }
  }
  return report;
}

std::string describe(const MeshReport& report) {
  std::ostringstream out;
  out.imbue(std::locale::classic());
  Found open;
  Found misoriented;
  Found faces;
  out << "triangles     " << report.triangles << "\n"
      << "vertices      " << report.vertices << "\n"
      << "components    " << report.components << "\n"
      << "closed        " << add_open(open, report).or_else("yes") << "\n"
      << "oriented      " << add_misoriented(misoriented, report).or_else("yes") << "\n"
      << "outward       " << outward(report) << "\n"
      << "manifold      " << manifold(report) << "\n"
      << "clean faces   " << add_faces(faces, report).or_else("yes") << "\n"
      << "self-crossing " << self_crossing(report) << "\n";
  if (report.solid) {
    print_solid(out, *report.solid);
  } else {
    out << "volume        undefined: the surface encloses no solid\n";
  }
  return out.str();
}

std::string refusal(const MeshReport& report) {
  if (report.usable()) {
    return "";
  }
  Found found;
  found.add(report.defects.bad_vertices, "vertex that is not finite",
            "vertices that are not finite");
  add_open(found, report);
  add_misoriented(found, report);
  add_crowded(found, report);
  add_faces(found, report);
  add_orientation(found, report);
  return "cannot be simulated: it has " + (found.none() ? "no triangles" : found.text());
}

}  // namespace impetus::inline models
