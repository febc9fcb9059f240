// Convergence: over 1,000 random impacts, what each level of each kind of tree is wrong by, for
// every reduction.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <iterator>
#include <numbers>
#include <string>

#include "tests/engine/exact_impacts.hpp"

namespace impetus::convergence_test {

constexpr std::uint64_t kSeed = 1;
constexpr int kImpacts = 1'000;
constexpr int kLevels = 4;

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

using Medians = std::array<double, kLevels>;
/// Of the normal (degrees), the point and the velocity; see KnownImpactErrors.
using Convergence = std::array<Medians, 3>;

std::vector<Convergence> convergence_of(TreeKind kind, const std::vector<ImpactSolid>& solids,
                                        const std::vector<KnownImpact>& impacts) {
  std::vector<ContactModel> reductions;
  for (const std::string_view name : reduction_names()) {
    reductions.push_back({make_reduction(name), 4});
  }
  std::vector<BodyModel> models;
  for (const ImpactSolid& solid : solids) {
    models.push_back(impact_model(
        solid, std::make_shared<VolumeTree>(build_tree(solid.mesh, {kind, kLevels - 1, 8}))));
  }
  using Samples = std::array<std::vector<double>, kLevels>;
  std::vector<std::array<Samples, 3>> samples(reductions.size());
  for (const KnownImpact& impact : impacts) {
    const auto errors =
        errors_by_level(impact, solids, {models[impact.solid_a], models[impact.solid_b]},
                        reductions, kLevels, /*restitution=*/0.5);
    for (std::size_t i = 0; i < reductions.size(); ++i) {
      for (std::size_t level = 0; level < kLevels; ++level) {
        const KnownImpactErrors& each = errors[i].at(level);
        samples[i][0][level].push_back(each.normal_rad * 180.0 / std::numbers::pi);
        samples[i][1][level].push_back(each.point);
        samples[i][2][level].push_back(each.velocity);
      }
    }
  }
  std::vector<Convergence> found(reductions.size());
  for (std::size_t i = 0; i < reductions.size(); ++i) {
    for (std::size_t measure = 0; measure < 3; ++measure) {
      for (std::size_t level = 0; level < kLevels; ++level) {
        found[i][measure][level] = median(samples[i][measure][level]);
      }
    }
  }
  return found;
}

/// What a level of a tree of grid cells or of spheres round them says of a single pair of nodes:
/// the line of their centres joins points of a grid, and is no nearer to the surface's normal
/// however small the cells are. Reductions that take the normal of single nodes show it; means over
/// a patch do not.
constexpr const char* kGridNormals = "the direction between two cells of grids is chance";

/// At a corner the surface has no one outward normal: the smaller a node, the more it lies on one
/// face of the corner alone. A corner on a face is the commonest impact of solids with corners. The
/// thesis recommends density normals for voxels and octrees alone (sec. 4.2.4), whose cells are
/// large against such nodes.
constexpr const char* kCornersHaveNoNormal = "a small node at a corner has the normal of one face";

enum Measure { kNormal, kPoint, kVelocity };

/// Medians that do not fall with every level, and why.
struct Exception {
  TreeKind kind;
  std::string_view reduction;
  Measure measure;
  const char* why;
};

constexpr Exception kExceptions[] = {
    {TreeKind::kOctree, "none", kNormal, kGridNormals},
    {TreeKind::kOctree, "first", kNormal, kGridNormals},
    {TreeKind::kVoxel, "none", kNormal, kGridNormals},
    {TreeKind::kVoxel, "none", kVelocity, kGridNormals},
    {TreeKind::kVoxel, "first", kNormal, kGridNormals},
    {TreeKind::kMedial, "density", kNormal, kCornersHaveNoNormal},
    {TreeKind::kMedial, "density", kVelocity, kCornersHaveNoNormal},
    {TreeKind::kSwept, "density", kNormal, kCornersHaveNoNormal},
    {TreeKind::kSwept, "density", kVelocity, kCornersHaveNoNormal},
    // Of medial spheres where those are worth more (build_tree.cpp).
    {TreeKind::kHeterogeneous, "density", kNormal, kCornersHaveNoNormal},
};

bool is_exception(TreeKind kind, std::string_view reduction, Measure measure) {
  return std::any_of(std::begin(kExceptions), std::end(kExceptions), [&](const Exception& each) {
    return each.kind == kind && each.reduction == reduction && each.measure == measure;
  });
}

/// The eight cells of a voxel tree's first level fill its root: they bound nothing more tightly.
std::size_t first_level_of(TreeKind kind) { return kind == TreeKind::kVoxel ? 1 : 0; }

void print(const char* what, const Medians& medians, double unit) {
  std::printf("  %s", what);
  for (const double each : medians) {
    std::printf(" %5.1f", each * unit);
  }
}

void expect_falls(TreeKind kind, std::string_view reduction, Measure measure,
                  const Medians& medians) {
  const std::string where = name_of(kind) + ", " + std::string(reduction) + ", measure " +
                            std::to_string(measure) + ", level ";
  bool falls = true;
  for (std::size_t level = first_level_of(kind) + 1; level < kLevels; ++level) {
    falls = falls && medians[level] < medians[level - 1];
    if (!is_exception(kind, reduction, measure)) {
      EXPECT_LT(medians[level], medians[level - 1]) << where << level << ", seed " << kSeed;
    }
  }
  EXPECT_NE(falls, is_exception(kind, reduction, measure)) << where << ": a stale exception";
}

TEST(Convergence, MedianErrorsFallWithEveryLevelOfEveryKindAndReductionButForWhatIsListed) {
  const std::vector<ImpactSolid> solids = impact_solids();
  RandomStream random(kSeed, "impacts");
  std::vector<KnownImpact> impacts;
  while (impacts.size() < kImpacts) {
    impacts.push_back(next_impact(random, solids));
  }
  for (const std::string& name : tree_kind_names()) {
    const TreeKind kind = tree_kind(name);
    const std::vector<Convergence> found = convergence_of(kind, solids, impacts);
    for (std::size_t i = 0; i < found.size(); ++i) {
      const std::string_view reduction = reduction_names()[i];
      std::printf("%-14s %-9s", name.c_str(), std::string(reduction).c_str());
      print("normal/deg", found[i][kNormal], 1.0);
      print("point/%", found[i][kPoint], 100.0);
      print("velocity/%", found[i][kVelocity], 100.0);
      std::printf("\n");
      for (const Measure measure : {kNormal, kPoint, kVelocity}) {
        expect_falls(kind, reduction, measure, found[i][measure]);
      }
    }
    // Chapter 4's order where cells are of unequal occupancy.
    const auto finest = [&](std::size_t reduction, Measure measure) {
      return found[reduction][measure][kLevels - 1];
    };
    enum { kGroups = 3, kDensity = 4, kWeighted = 5 };
    if (kind == TreeKind::kOctree || kind == TreeKind::kVoxel) {
      EXPECT_LT(finest(kWeighted, kNormal), finest(kGroups, kNormal)) << name;
      EXPECT_LT(finest(kWeighted, kPoint), finest(kGroups, kPoint)) << name;
      EXPECT_LT(finest(kWeighted, kVelocity), finest(kGroups, kVelocity)) << name;
      EXPECT_LT(finest(kDensity, kVelocity), finest(kGroups, kVelocity)) << name;
    }
  }
}

}  // namespace impetus::convergence_test
