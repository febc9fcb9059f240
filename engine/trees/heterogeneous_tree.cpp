// SPDX-License-Identifier: MIT
#include "engine/trees/heterogeneous_tree.hpp"

#include <cmath>
#include <utility>

#include "engine/trees/fitted_tree.hpp"
#include "engine/trees/medial_tree.hpp"

namespace impetus {
namespace {

double finest_reach_m(const VolumeTree& tree) { return tree.fit_error_m(tree.level_count() - 1); }

bool is_as_good_as_exact(const VolumeTree& tree) {
  constexpr double kNegligible = 1e-6;  // of the size
  return finest_reach_m(tree) <= kNegligible * tree.bounding_radius_m();
}

/// The part of `progress` from `begin` to `end`.
Progress part_of(const Progress& progress, double begin, double end) {
  return [&progress, begin, end](double share) {
    if (progress) {
      progress(begin + share * (end - begin));
    }
  };
}

}  // namespace

BuiltTree heterogeneous_tree(const TriangleMesh& solid, const TreeSettings& settings,
                             const Progress& progress) {
  BuiltTree mixed = build_fitted_tree(solid, settings, part_of(progress, 0.0, 0.6));
  if (is_as_good_as_exact(mixed.tree)) {
    return mixed;
  }
  BuiltTree spheres = medial_tree(solid, {TreeKind::kMedial, settings.depth, settings.branching},
                                  part_of(progress, 0.6, 1.0));
  const bool of_spheres = !mixed.tree.volumes().all_spheres().empty();
  const double price = of_spheres ? 1.0 : std::sqrt(kMixedTestCost);
  return finest_reach_m(mixed.tree) * price <= finest_reach_m(spheres.tree) ? std::move(mixed)
                                                                            : std::move(spheres);
}

}  // namespace impetus
