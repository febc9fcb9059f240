// SPDX-License-Identifier: MIT
#include "engine/scheduling/traversals.hpp"

#include <algorithm>

#include "engine/numerics/elementary_functions.hpp"
#include "engine/scheduling/named_kinds.hpp"

namespace impetus::inline scheduling {
namespace {

/// The first pair that is unfinished: one after the other, by falling priority.
class DepthFirst final : public Traversal {
 public:
  [[nodiscard]] unsigned terms() const override { return 0; }
  [[nodiscard]] double urgency(const PairProgress& /*pair*/) const override { return 0.0; }
};

/// The pair at the coarsest level: level after level.
class BreadthFirst final : public Traversal {
 public:
  [[nodiscard]] unsigned terms() const override { return kProgressTerm; }
  [[nodiscard]] double urgency(const PairProgress& pair) const override {
    return -static_cast<double>(pair.level());
  }
};

// Orders of work may expect something of it, what can be seen of a gap, taken off per unit of work:
//
//   best-first     the next level's:
//                    (fit error now − fit error then, in degrees at the eye)
//                    × probability that the surfaces meet, κ ρ_a ρ_b of the likeliest nodes
//                    / what the tests of the next level cost
//   visible-first  of the finer levels, the best one's:
//                    gap expected to open, in degrees at the eye
//                    × acuity there, relative to the fovea's (eccentricity_metric.hpp)
//                    / (what the tests of the next level cost × levels until then)
//                  where somebody's noticing is known (perceived_metric.hpp), of the probability
//                  that this gap is noticed, in place of its degrees and the acuity
//
// A gap shows where coarse bounds touch and surfaces do not. Let the deepest nodes overlap by δ,
// and let D be what the fit errors lose until a finer level. Its bounds lie closer to the surfaces
// by between nothing and D, as far as is known each as likely. Where that is more than δ they part,
// and the gap that goes with them is at least the rest: (D − δ)² / 2D, on average. Of several finer
// levels the one that pays most counts. Bounds that overlap deeply, as those of bodies that
// really touch, so come last, which best-first takes first.
// (Dingliana 2002, eq. 4.6; Klein and Zachmann 2003 for the expectation)

/// Takes the pair whose next level removes most of the visible gap for its work.
class BestFirst final : public Traversal {
 public:
  [[nodiscard]] unsigned terms() const override { return kProgressTerm | kEyeDistanceTerm; }

  [[nodiscard]] double urgency(const PairProgress& pair) const override {
    if (pair.resolved()) {
      return 0.0;
    }
    const int level = pair.level();
    const double removed_m = pair.fit_error_m(level) - pair.fit_error_m(level + 1);
    const double visible_deg = degrees(2.0 * atan2_rad(0.5 * removed_m, pair.eye_distance_m()));
    const double gain =
        visible_deg * pair.likeliest_collision() / static_cast<double>(pair.work_of_next_level());
    return gain > 0.0 ? gain : 0.0;
  }
};

/// Takes the pair of which finer levels remove most of what shows to the eye for their work.
class VisibleFirst final : public Traversal {
 public:
  [[nodiscard]] unsigned terms() const override {
    return kProgressTerm | kEyeDistanceTerm | kAcuityTerm;
  }

  [[nodiscard]] double urgency(const PairProgress& pair) const override {
    if (pair.resolved()) {
      return 0.0;
    }
    const int reached = pair.level();
    const double error_m = pair.fit_error_m(reached);
    const double overlap_m = pair.deepest_overlap_m();
    const bool by_noticing = pair.noticed(0.0).has_value();
    double shown = 0.0;  // per level
    for (int level = reached + 1; level <= pair.finest_level(); ++level) {
      const double gap_m = expected_gap_m(error_m - pair.fit_error_m(level), overlap_m);
      shown = std::max(
          shown, (by_noticing ? *pair.noticed(angle_deg(gap_m, pair)) : gap_m) / (level - reached));
    }
    shown = by_noticing ? shown : pair.acuity() * angle_deg(shown, pair);
    const double gain = shown / static_cast<double>(pair.work_of_next_level());
    return gain > 0.0 ? gain : 0.0;
  }

 private:
  static double angle_deg(double gap_m, const PairProgress& pair) {
    return degrees(2.0 * atan2_rad(0.5 * gap_m, pair.eye_distance_m()));
  }

  /// Of bounds that come closer by at most so much, and overlap so deep.
  static double expected_gap_m(double closer_m, double overlap_m) {
    if (!(closer_m > overlap_m)) {
      return 0.0;
    }
    const double beyond_m = closer_m - overlap_m;
    return 0.5 * beyond_m * beyond_m / closer_m;
  }
};

const NamedKinds<Traversal>& all_traversals() {
  static const NamedKinds<Traversal> all(
      "traversal", {{"depth-first", std::make_shared<const DepthFirst>(),
                     "one pair after the other, by falling priority"},
                    {"breadth-first", std::make_shared<const BreadthFirst>(), "level after level"},
                    {"best-first", std::make_shared<const BestFirst>(),
                     "the pair whose next level should take away most of the visible gap for its "
                     "work"},
                    {"visible-first", std::make_shared<const VisibleFirst>(),
                     "the pair of which finer levels should take away most of what shows to the "
                     "eye, for their work: gaps that only coarse bounds leave, near where one "
                     "looks"}});
  return all;
}

}  // namespace

std::shared_ptr<const Traversal> make_traversal(std::string_view name) {
  return all_traversals().called(name);
}

std::string_view traversal_name(const Traversal& traversal) {
  return all_traversals().name(traversal);
}

std::vector<std::string_view> traversal_names() { return all_traversals().names(); }

std::string traversals_in_words() { return all_traversals().in_words(); }

}  // namespace impetus::inline scheduling
