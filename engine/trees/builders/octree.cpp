// SPDX-License-Identifier: MIT
#include "engine/trees/builders/octree.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "engine/shapes/mass_properties.hpp"
#include "engine/shapes/surface_distance.hpp"
#include "engine/trees/node_description.hpp"

namespace impetus::inline trees {
namespace {

/// Shares of the solid's size. What lies nearer than this to a wall between cells lies in it:
/// otherwise a face that rounding put beside the wall would leave a sliver in each cell along it.
constexpr double kSnap = 1e-13;
/// Radii exceed what they were measured to need by this, far above the rounding and the snapping.
constexpr double kCubeMargin = 1e-11;

/// A node in the making: its cell and the surface in it. Without facets it is solid throughout.
struct Part {
  Bounds cell;
  SurfacePart facets;
};

/// A mesh and the distance to its surface.
class Solid {
 public:
  explicit Solid(const TriangleMesh& mesh) : mesh_(&mesh), description_(mesh) {
    for (const Vector3& vertex : mesh.vertices) {
      near_m_ = std::max(near_m_, kNear * vertex.norm());
    }
  }

  [[nodiscard]] const TriangleMesh& mesh() const { return *mesh_; }
  [[nodiscard]] const NodeDescription& description() const { return description_; }

  /// Near the surface the winding number decides, as it would everywhere.
  [[nodiscard]] bool contains(const Vector3& point) const {
    const double distance_m = description_.distance().signed_distance_m(point);
    return std::fabs(distance_m) > near_m_ ? distance_m < 0.0 : impetus::contains(*mesh_, point);
  }

  /// How far a sphere reaches beyond the solid at most: a point of the sphere lies within r of the
  /// centre, and the solid holds the ball about a centre inside that reaches to its surface.
  [[nodiscard]] double protrusion_m(const Sphere& sphere) const {
    const double distance_m = description_.distance().nearest(sphere.centre).distance_m;
    const double signed_m = contains(sphere.centre) ? -distance_m : distance_m;
    return std::max(0.0, sphere.radius_m + signed_m);
  }

 private:
  static constexpr double kNear = 1e-9;  ///< share of the size

  const TriangleMesh* mesh_;
  NodeDescription description_;
  double near_m_{0.0};
};

/// The plane between two cells.
struct Wall {
  int axis;
  double at;
  double snap_m;
};

/// The piece of `facet` on one side of the wall. A facet in the wall itself belongs to the side
/// that the solid lies on.
Facet clipped(const Facet& facet, const Wall& wall, bool keep_above) {
  const auto& [axis, at, snap_m] = wall;
  const double sign = keep_above ? 1.0 : -1.0;
  const auto height = [&](const Vector3& p) {
    const double above = p[wall.axis] - wall.at;
    return std::fabs(above) <= wall.snap_m ? 0.0 : sign * above;
  };
  Facet piece{{}, facet.normal, facet.triangle};
  bool in_plane = true;
  for (std::size_t i = 0; i < facet.corners.size(); ++i) {
    const Vector3& from = facet.corners[i];
    const Vector3& to = facet.corners[(i + 1) % facet.corners.size()];
    const double h_from = height(from);
    const double h_to = height(to);
    in_plane = in_plane && h_from == 0.0;
    if (h_from >= 0.0) {
      piece.corners.push_back(from);
    }
    if ((h_from > 0.0 && h_to < 0.0) || (h_from < 0.0 && h_to > 0.0)) {
      Vector3 crossing = from + h_from / (h_from - h_to) * (to - from);
      crossing[axis] = at;
      piece.corners.push_back(crossing);
    }
  }
  if (piece.corners.size() < 3 || (in_plane && sign * facet.normal[axis] > 0.0)) {
    piece.corners.clear();
  }
  return piece;
}

SurfacePart on_side(const SurfacePart& facets, const Wall& wall, bool above) {
  SurfacePart pieces;
  for (const Facet& facet : facets) {
    Facet piece = clipped(facet, wall, above);
    if (!piece.corners.empty()) {
      pieces.push_back(std::move(piece));
    }
  }
  return pieces;
}

/// The halves of a part along one axis, below and above the middle.
std::array<Part, 2> halves(const Part& part, int axis, double snap_m) {
  const double middle = 0.5 * (part.cell.least[axis] + part.cell.most[axis]);
  std::array<Part, 2> result;
  for (const bool above : {false, true}) {
    Part& half = result[above ? 1 : 0];
    half.cell = part.cell;
    (above ? half.cell.least : half.cell.most)[axis] = middle;
    half.facets = on_side(part.facets, {axis, middle, snap_m}, above);
  }
  return result;
}

/// The eighths of a part that hold anything of the solid, in a fixed order.
std::vector<Part> children_of(const Part& part, const Solid& solid, double snap_m) {
  std::vector<Part> children;
  for (const Part& x : halves(part, 0, snap_m)) {
    for (const Part& y : halves(x, 1, snap_m)) {
      for (Part& z : halves(y, 2, snap_m)) {
        if (!z.facets.empty() || part.facets.empty() || solid.contains(z.cell.middle())) {
          children.push_back(std::move(z));
        }
      }
    }
  }
  return children;
}

/// The corners of the part's polyhedron: whatever holds them holds the part.
std::vector<Vector3> corners_of(const Part& part, const Solid& solid) {
  std::vector<Vector3> corners;
  for (const Facet& facet : part.facets) {
    corners.insert(corners.end(), facet.corners.begin(), facet.corners.end());
  }
  for (int index = 0; index < 8; ++index) {
    const Vector3 corner(index & 1 ? part.cell.most.x() : part.cell.least.x(),
                         index & 2 ? part.cell.most.y() : part.cell.least.y(),
                         index & 4 ? part.cell.most.z() : part.cell.least.z());
    if (part.facets.empty() || solid.contains(corner)) {
      corners.push_back(corner);
    }
  }
  return corners;
}

/// The sphere about `centre` that holds all points.
Sphere sphere_about(const Vector3& centre, const std::vector<Vector3>& points, double margin_m) {
  double radius_m = 0.0;
  for (const Vector3& point : points) {
    radius_m = std::max(radius_m, (point - centre).norm());
  }
  return {centre, radius_m + margin_m};
}

Sphere sphere_round(const std::vector<Vector3>& points, double margin_m) {
  return sphere_about(bounds_of(points).middle(), points, margin_m);
}

/// A cube about the solid, a margin wider, that holds it whole.
Part whole(const TriangleMesh& solid) {
  Part root;
  Bounds bounds{solid.vertices.front(), solid.vertices.front()};
  root.facets = whole_surface(solid);
  for (const Facet& facet : root.facets) {
    for (const Vector3& corner : facet.corners) {
      bounds.include(corner);
    }
  }
  const double half_edge = (0.5 + kCubeMargin) * bounds.sides().maxCoeff();
  const Vector3 centre = bounds.middle();
  root.cell = {centre - Vector3::Constant(half_edge), centre + Vector3::Constant(half_edge)};
  return root;
}

void require_solid(const TriangleMesh& solid, int depth) {
  if (depth < 0 || depth > kGreatestOctreeDepth) {
    throw std::invalid_argument("octree: expected a depth from 0 to " +
                                std::to_string(kGreatestOctreeDepth) + ", got " +
                                std::to_string(depth));
  }
  if (solid.triangles.empty() || !find_defects(solid).none() ||
      !(solid_of(solid, /*density_kg_m3=*/1.0).volume_m3 > 0.0)) {
    throw std::invalid_argument("octree: expected a closed mesh with its triangles facing outward");
  }
}

/// Builds level by level, so that nodes come in breadth-first order.
class OctreeBuilder {
 public:
  explicit OctreeBuilder(const TriangleMesh& solid) : solid_(solid) {}

  Octree build(int depth) {
    level_.push_back(whole(solid_.mesh()));
    const double size_m = level_.front().cell.sides().norm();
    margin_m_ = kCubeMargin * size_m;
    snap_m_ = kSnap * size_m;
    add_level({sphere_about(Vector3::Zero(), solid_.mesh().vertices, margin_m_)});
    for (int made = 0; made < depth && split_level(); ++made) {
    }
    return {VolumeTree(nodes_, std::move(starts_)), std::move(cells_)};
  }

 private:
  /// Adds nodes for the parts of this level; `spheres` one for each.
  void add_level(const std::vector<Sphere>& spheres) {
    starts_.push_back(static_cast<std::int32_t>(nodes_.size()));
    protrusions_m_.clear();
    for (std::size_t i = 0; i < level_.size(); ++i) {
      protrusions_m_.push_back(solid_.protrusion_m(spheres[i]));
      nodes_.push_back(
          {spheres[i], 0, 0,
           solid_.description().of(spheres[i], level_[i].facets, protrusions_m_.back())});
      cells_.push_back(level_[i].cell);
    }
  }

  /// Splits every part whose sphere reaches beyond the solid; false when none does.
  bool split_level() {
    std::vector<Part> finer;
    std::vector<Sphere> spheres;
    for (std::size_t i = 0; i < level_.size(); ++i) {
      if (protrusions_m_[i] == 0.0) {
        continue;
      }
      VolumeNode& node = nodes_[static_cast<std::size_t>(starts_.back()) + i];
      node.first_child = static_cast<std::int32_t>(nodes_.size() + finer.size());
      for (Part& child : children_of(level_[i], solid_, snap_m_)) {
        spheres.push_back(sphere_round(corners_of(child, solid_), margin_m_));
        finer.push_back(std::move(child));
        ++node.child_count;
      }
    }
    if (finer.empty()) {
      return false;
    }
    level_.swap(finer);
    add_level(spheres);
    return true;
  }

  Solid solid_;
  double margin_m_{0.0};
  double snap_m_{0.0};
  std::vector<Part> level_;
  std::vector<double> protrusions_m_;
  std::vector<VolumeNode> nodes_;
  std::vector<std::int32_t> starts_;
  std::vector<Bounds> cells_;
};

}  // namespace

Octree build_octree(const TriangleMesh& solid, int depth) {
  require_solid(solid, depth);
  return OctreeBuilder(solid).build(depth);
}

VolumeTree octree(const TriangleMesh& solid, int depth) { return build_octree(solid, depth).tree; }

}  // namespace impetus::inline trees
