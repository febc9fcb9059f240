// SPDX-License-Identifier: MIT
#include "engine/trees/builders/swept_tree.hpp"

#include <variant>

#include "engine/shapes/mass_properties.hpp"
#include "engine/shapes/solids/ball_meshes.hpp"
#include "engine/trees/builders/volume_fits.hpp"
#include "engine/trees/volume_tree.hpp"

namespace impetus::inline trees {
namespace {

/// Share of the volume's size by which it may grow against rounding.
constexpr double kSweptMargin = 1e-12;

double inner_radius_m(const TriangleMesh& solid, const Volume& volume) {
  if (const auto* line = std::get_if<LineSwept>(&volume)) {
    return swept_inner_radius_m(solid, line->half_axis, Vector3::Zero());
  }
  if (const auto* rectangle = std::get_if<RectangleSwept>(&volume)) {
    return swept_inner_radius_m(solid, rectangle->half_u, rectangle->half_v);
  }
  return swept_inner_radius_m(solid, Vector3::Zero(), Vector3::Zero());
}

/// Nodes and the first of each level, one level after the other.
class Levels {
 public:
  void add_alone(const Volume& volume, const NodeSurface& surface) {
    link_last(1);
    starts_.push_back(size());
    nodes_.push_back({volume, 0, 0, surface});
  }

  /// All levels of a tree but its root, below what there is.
  void add_below_root(const VolumeTree& tree) {
    if (tree.level_count() < 2) {
      return;
    }
    const std::int32_t shift = size() - 1;  // the root takes no place of its own
    link_last(tree.links(0).child_count);
    for (int level = 1; level < tree.level_count(); ++level) {
      starts_.push_back(tree.level_begin(level) + shift);
    }
    for (std::int32_t node = 1; node < tree.node_count(); ++node) {
      const NodeLinks& links = tree.links(node);
      nodes_.push_back({tree.volume(node), links.child_count > 0 ? links.first_child + shift : 0,
                        links.child_count, tree.surface(node)});
    }
  }

  [[nodiscard]] VolumeTree tree() && { return {nodes_, std::move(starts_)}; }

 private:
  [[nodiscard]] std::int32_t size() const { return static_cast<std::int32_t>(nodes_.size()); }

  void link_last(std::int32_t children) {
    if (!nodes_.empty()) {
      nodes_.back().first_child = size();
      nodes_.back().child_count = children;
    }
  }

  std::vector<VolumeNode> nodes_;
  std::vector<std::int32_t> starts_;
};

}  // namespace

std::optional<TreeSettings> finer_settings(const SweptLevels& levels,
                                           const TreeSettings& settings) {
  const int above = levels.sphere_first ? 1 : 0;
  if (!levels.finer || levels_to_build(settings) <= above) {
    return std::nullopt;
  }
  TreeSettings finer = settings;
  finer.depth -= above;
  finer.built_depth -= above;
  return finer;
}

VolumeTree swept_tree(const TriangleMesh& solid, const Volume& volume, const SweptLevels& levels,
                      const TreeSettings& settings, const VolumeTree* finer) {
  const std::vector<Vector3>& corners = solid.vertices;
  const double margin_m = kSweptMargin * bounding_sphere(volume).radius_m;
  const Volume exact = grown_to_hold(volume, corners, margin_m);
  // No point of a volume with this radius about the core, or about the centre, is farther away.
  const double within_m = inner_radius_m(solid, volume);
  const double solid_m3 = solid_of(solid, 1.0).volume_m3;
  Levels built;
  const auto add = [&](const Volume& whole) {
    NodeSurface surface;  // of a closed surface opposite sides cancel: it faces no way
    surface.occupancy = static_cast<float>(solid_m3 / content_m3(whole));
    surface.group = 0;
    surface.fit_error_m = rounded_up(cored(whole).radius_m - within_m);
    built.add_alone(whole, surface);
  };
  if (levels.sphere_first) {
    add(grown_to_hold(Volume(bounding_sphere(exact)), corners, margin_m));
  }
  if (!levels.sphere_first || levels_to_build(settings) > 0) {
    add(exact);
  }
  if (finer != nullptr) {
    built.add_below_root(*finer);
  }
  return std::move(built).tree();
}

}  // namespace impetus::inline trees
