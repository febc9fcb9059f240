// SPDX-License-Identifier: MIT
#include "experiments/models/mesh_report.hpp"

#include <locale>
#include <numeric>
#include <ostream>
#include <sstream>
#include <vector>

namespace impetus {
namespace {

/// Union-find over vertices: the first vertex of the part that `vertex` belongs to.
std::uint32_t part_of(std::vector<std::uint32_t>& parent, std::uint32_t vertex) {
  while (parent[vertex] != vertex) {
    parent[vertex] = parent[parent[vertex]];
    vertex = parent[vertex];
  }
  return vertex;
}

std::int64_t count_components(const TriangleMesh& mesh) {
  std::vector<std::uint32_t> parent(mesh.vertices.size());
  std::iota(parent.begin(), parent.end(), 0U);
  std::vector<bool> used(mesh.vertices.size(), false);
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle) {
      used[corner] = true;
      parent[part_of(parent, corner)] = part_of(parent, triangle[0]);
    }
  }
  std::int64_t components = 0;
  for (std::uint32_t vertex = 0; vertex < parent.size(); ++vertex) {
    components += used[vertex] && parent[vertex] == vertex ? 1 : 0;
  }
  return components;
}

void print_defects(std::ostream& out, const MeshDefects& defects) {
  if (defects.none()) {
    out << "defects       none: a closed, consistently oriented surface\n";
    return;
  }
  out << "defects       " << defects.open_edges << " open edges, " << defects.misoriented_edges
      << " misoriented edges, " << defects.crowded_edges << " edges of more than two triangles, "
      << defects.degenerate_triangles << " degenerate triangles, " << defects.bad_vertices
      << " vertices that are not finite\n";
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

MeshReport report_mesh(const TriangleMesh& mesh) {
  MeshReport report;
  report.triangles = static_cast<std::int64_t>(mesh.triangles.size());
  report.vertices = static_cast<std::int64_t>(mesh.vertices.size());
  report.components = count_components(mesh);
  report.defects = find_defects(mesh);
  if (report.defects.none() && report.triangles > 0) {
    report.solid = solid_of(mesh, kReportDensity_kg_m3);
  }
  return report;
}

std::string describe_mesh(const TriangleMesh& mesh) {
  const MeshReport report = report_mesh(mesh);
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out << "triangles     " << report.triangles << "\n"
      << "vertices      " << report.vertices << "\n"
      << "components    " << report.components << "\n";
  print_defects(out, report.defects);
  if (report.solid) {
    print_solid(out, *report.solid);
  } else {
    out << "volume        undefined: the surface encloses no solid\n";
  }
  return out.str();
}

}  // namespace impetus
