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

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/dynamics/responder.hpp"
#include "engine/numerics/random_stream.hpp"
#include "experiments/record/ports.hpp"
#include "experiments/trade/impacts/impact_pair.hpp"

namespace impetus::inline trade {

/// Two bodies that have just touched, and what is exactly true of it.
struct ExactImpact {
  std::vector<BodyState> states;  ///< of a and b, before the response
  TouchPoint touch;               ///< normal from b to a
  double approach_m_s{0.0};       ///< along the normal, spins included; more than 0
};

/// Random approaches of two bodies, and the exact impact where they touch.
///
///   a random line, random turns ──> straight and unturned ──> first touch of the surfaces, or past
///   the closest points just before ──> exact normal and point; speeds and spins of the scene's own
///
/// Lines are uniform: of any direction, through any place at which the balls about the bodies meet.
/// Spins count at the impact alone. Then a is moved on by so little that the surfaces cross: bounds
/// that cover them must overlap.
struct Approach {
  Pose pose_a;  ///< where a starts: far from b
  Pose pose_b;
  Vector3 direction{Vector3::UnitX()};  ///< unit, of a
  bool touches{false};                  ///< the surfaces meet on the way
  /// None when they do not, or only graze: when they approach each other, as the centres do and as
  /// the points that touch do, at less than a fifth of the centres' speed.
  std::optional<ExactImpact> impact{};
};

/// The next approach of the stream.
Approach next_approach(RandomStream& random, const ImpactPair& pair);

/// Of both bodies after an impact, in world.
struct ImpactOutcome {
  /// Direction of the impulses' sum and their mean place; the deepest contact when none pushes.
  TouchPoint net;
  std::array<Vector3, 2> velocity_m_s;
  std::array<Vector3, 2> spin_rad_s;
};

/// Precondition: there are contacts, between bodies 0 and 1, which are the pair's a and b.
ImpactOutcome outcome_of(const std::vector<Contact>& contacts, const ExactImpact& impact,
                         const ImpactPair& pair, Responder& responder);

/// How far an outcome is from another.
struct ImpactErrors {
  double normal_deg{0.0};
  double point{0.0};  ///< share of ImpactPair::size_m()
  /// Of the velocities of the centres of mass, sqrt(Σ |Δv|²), and of the bodies' surfaces by their
  /// spins, sqrt(Σ (r |Δω|)²) with r the radius about the centre of mass: as shares of the speed at
  /// which the points that touch approached. A share stays finite where what it is of is small.
  double linear{0.0};
  double angular{0.0};
};

ImpactErrors errors_of(const ImpactOutcome& found, const ImpactOutcome& reference,
                       const ExactImpact& impact, const ImpactPair& pair);

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
