// What each kind of tree, level and reduction costs and errs, over random impacts of two bodies.
//
//   approaches ──every kind, level──> first touch of the bounds: gap, false collisions
//        └─ exact impacts ──every kind, level──> tests, overlapping nodes
//                                 └─every reduction──> contacts, time; normal, point, velocities
//                                                      against the exact and the finest level's
//
// Impacts are judged at the exact first touch, where every level that covers the surfaces overlaps:
// all levels and kinds answer the same question. All but times follows from the seed.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "experiments/record/ports.hpp"
#include "experiments/trade/impacts/impact.hpp"

namespace impetus::inline trade {

/// What to measure. Kinds are those that the bodies have trees of.
struct ImpactSettings {
  std::vector<TreeKind> kinds;
  std::vector<int> levels;  ///< those that a tree has not are left out
  std::vector<std::string> reductions;
  int impacts{200};
  std::uint64_t seed{1};
};

/// Of a level of a kind of tree, whatever the reduction; values are one an impact or approach.
struct BoundsMeasures {
  TreeKind kind{TreeKind::kOctree};
  int level{0};
  double bytes{0.0};  ///< of both trees' nodes to this level; of one tree where both are the same
  std::vector<double> tests;         ///< of node pairs, to this level
  std::vector<double> overlaps;      ///< of nodes at this level
  std::vector<double> refine_us;     ///< placing and tests
  std::int64_t missed{0};            ///< impacts that the level does not see: none should be
  std::int64_t collisions{0};        ///< approaches at which the bounds touch
  std::int64_t false_collisions{0};  ///< of these, those whose surfaces do not
  /// Between the surfaces where the bounds first touch: share of ImpactPair::size_m(), and seen
  /// from the viewer's place at the screen's centre, turned as they come, with nothing hidden.
  std::vector<double> gaps;
  std::vector<double> gaps_arcmin;
};

/// The errors of all impacts, one value an impact.
struct ErrorSamples {
  std::vector<double> normal_deg;
  std::vector<double> point;
  std::vector<double> linear;
  std::vector<double> angular;

  void add(const ImpactErrors& errors);
};

/// Of a reduction at a level of a kind; values are one an impact that the level sees.
struct ContactMeasures {
  TreeKind kind{TreeKind::kOctree};
  int level{0};
  std::string reduction;
  std::vector<double> contacts;  ///< left by the reduction and the cap
  std::vector<double> pair_us;   ///< placing, refinement, contacts and response
  ErrorSamples exact;            ///< against the exact impact
  ErrorSamples finest;           ///< against the finest level that was measured of this kind
};

/// All that was measured of a pair of bodies, or of several pairs together.
struct ImpactMeasures {
  std::string subject;
  bool spins{true};  ///< something can turn one of the bodies
  std::int64_t approaches{0};
  std::int64_t touching{0};  ///< approaches whose surfaces meet
  std::vector<BoundsMeasures> bounds;
  std::vector<ContactMeasures> contacts;
};

/// Measures until `settings.impacts` approaches have an impact. Throws std::runtime_error when
/// hardly any has. `progress` hears the share that is done.
ImpactMeasures measure_impacts(const ImpactPair& pair, const ImpactSettings& settings,
                               const Clock& clock, const Progress& progress = {});

}  // namespace impetus::inline trade
