// Which collisions are refined first.
//
// A metric measures each pair, in degrees of visual angle where it is an angle, and says whether
// large or small values come first, and which terms of a pair it looks at: no others are computed.
// A new metric is one file and one line in the table of metrics.cpp; of one's own, a class alone.
// (Dingliana 2002, sec. 5.1.2 and 5.2)
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "engine/scheduling/viewer.hpp"
#include "engine/volumes/sphere.hpp"

namespace impetus::inline scheduling {

/// In the place of the second body: the enclosure as a whole, which is also its wall 0; wall w is
/// kEnclosure − w.
inline constexpr std::int32_t kEnclosure = -1;

inline constexpr bool is_wall(std::int32_t index) { return index < 0; }
inline constexpr std::int32_t wall_index(int wall) { return kEnclosure - wall; }

/// Two bodies by their index in the world, a < b; or a body and a wall, is_wall(b).
struct BodyPair {
  std::int32_t a{0};
  std::int32_t b{0};

  friend bool operator==(const BodyPair&, const BodyPair&) = default;
};

/// What a metric may look at, in world. For a body and the enclosure, both are that body. Terms
/// that it does not look at (PriorityMetric::terms) are left as they are here.
struct PairBounds {
  BodyPair pair;
  Sphere a;  ///< bounding spheres about the centres of mass
  Sphere b;
  Vector3 velocity_a{Vector3::Zero()};  ///< m/s
  Vector3 velocity_b{Vector3::Zero()};
  double fit_error_m{0.0};  ///< of both trees together, at the level the pair stands at
};

/// Where the two bounds meet. (Dingliana 2002, eq. 3.8, corrected: between the centres in the ratio
/// of the radii)
inline Vector3 collision_place(const PairBounds& bounds) {
  return touch(bounds.a, bounds.b, Vector3::UnitX()).point;
}

/// What a metric may look at beyond the bounds of a pair and the viewer, as bits.
enum PairTerm : unsigned {
  kMotionTerm = 1,    ///< velocity_a, velocity_b
  kFitErrorTerm = 2,  ///< fit_error_m
  kFixationTerm = 4,  ///< where the viewer looks: with it the gaze decides what is refined
};

/// Who notices gaps: where one looks, at rest, half of those of `threshold_arcmin`, but for those
/// that are missed however large. As it stands, what the simulated participant of the
/// gaze-contingent study is assumed to be.
struct Noticing {
  double threshold_arcmin{10.0};
  double width_log10{0.2};  ///< a standard deviation
  double miss_rate{0.1};
};

/// Which end of a metric's scale is refined first.
enum class Urgent { kLarge, kSmall };

/// What orders collisions, by a measure of each pair.
class PriorityMetric {
 public:
  explicit PriorityMetric(Urgent urgent) : urgent_(urgent) {}
  virtual ~PriorityMetric() = default;

  /// The terms that measure() looks at; all, unless the metric says less.
  [[nodiscard]] virtual unsigned terms() const {
    return kMotionTerm | kFitErrorTerm | kFixationTerm;
  }

  /// In the metric's own unit.
  [[nodiscard]] virtual double measure(const PairBounds& bounds, const Viewer& viewer,
                                       const Fixation& fixation) const = 0;

  /// Whose noticing it goes by; null: nobody's.
  [[nodiscard]] virtual const Noticing* noticing() const { return nullptr; }

  /// Whether `measured` meets a threshold or is more urgent.
  [[nodiscard]] bool meets(double measured, double threshold) const {
    return urgent_ == Urgent::kLarge ? measured >= threshold : measured <= threshold;
  }

  /// The measure with its sign turned so that larger means sooner.
  [[nodiscard]] double priority(double measured) const {
    return urgent_ == Urgent::kLarge ? measured : -measured;
  }

 private:
  Urgent urgent_;
};

}  // namespace impetus::inline scheduling
