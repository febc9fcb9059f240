// SPDX-License-Identifier: MIT
#include "experiments/trade/impacts/impact_measures.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <utility>

#include "experiments/run/collision_truth.hpp"
#include "experiments/trade/impacts/level_touch.hpp"

namespace impetus::inline trade {
namespace {

/// Microseconds that `work` takes when it has just been done, by a clock that is much coarser: the
/// median of three batches, each as often as fits into 20 µs, at most 64 times: enough for a clock
/// that itself takes .3 µs.
template <typename Work>
double timed_us(const Clock& clock, const Work& work) {
  constexpr std::int64_t kBatch_ns = 20'000;
  constexpr std::int64_t kMostTimes = 64;
  const auto batch_us = [&](std::int64_t times) {
    const std::int64_t start_ns = clock.now_ns();
    for (std::int64_t i = 0; i < times; ++i) {
      work();
    }
    return static_cast<double>(clock.now_ns() - start_ns) / (1e3 * static_cast<double>(times));
  };
  const double first_us = batch_us(1);
  const std::int64_t times = std::clamp<std::int64_t>(
      kBatch_ns / std::max<std::int64_t>(1, static_cast<std::int64_t>(1e3 * first_us)), 1,
      kMostTimes);
  std::array<double, 3> found{batch_us(times), batch_us(times), batch_us(times)};
  std::sort(found.begin(), found.end());
  return found[1];
}

bool can_turn(const BodyModel& model) { return model.inverse_inertia != Matrix3::Zero(); }

/// Between two points, as seen when their middle is at the screen's centre.
double arcmin_at_centre(const Viewer& viewer, const ClosestPoints& gap) {
  const Vector3 half = 0.5 * (gap.on_a - gap.on_b);
  return kArcminPerDegree * visual_angle_deg(viewer, half, -half);
}

/// One kind of tree about both bodies, and what is measured of it.
class KindMeasurement {
 public:
  KindMeasurement(const ImpactPair& pair, TreeKind kind, const ImpactSettings& settings,
                  const Clock& clock)
      : pair_(pair), clock_(clock), a_(*pair.a.trees.at(kind)), b_(*pair.b.trees.at(kind)) {
    const int levels = std::max(a_.tree().level_count(), b_.tree().level_count());
    for (const int level : settings.levels) {
      if (level < levels) {
        add_level(kind, level, settings.reductions);
      }
    }
    for (const std::string& reduction : settings.reductions) {
      models_.push_back({make_reduction(reduction), pair.most_contacts});
    }
  }

  void measure_approach(const Approach& approach) {
    a_.move_to(approach.pose_a);
    b_.move_to(approach.pose_b);
    for (BoundsMeasures& level : bounds_) {
      const auto way_m = first_touch_of_bounds(a_, b_, approach.direction, level.level);
      if (!way_m) {
        continue;
      }
      ++level.collisions;
      level.false_collisions += approach.touches ? 0 : 1;
      Pose pose_a = approach.pose_a;
      pose_a.position += *way_m * approach.direction;
      const ClosestPoints gap =
          closest_surfaces(pair_.a.look, pose_a, pair_.b.look, approach.pose_b);
      level.gaps.push_back(gap.distance_m / pair_.size_m());
      level.gaps_arcmin.push_back(arcmin_at_centre(pair_.viewer, gap));
    }
  }

  void measure_impact(const ExactImpact& impact, const ImpactOutcome& exact) {
    std::vector<std::optional<ImpactOutcome>> outcomes;  // by level, then reduction
    for (BoundsMeasures& level : bounds_) {
      refine_and_time(impact, level);
      for (std::size_t i = 0; i < models_.size(); ++i) {
        outcomes.push_back(measure_contacts(impact, models_[i], contacts_[outcomes.size()],
                                            level.refine_us.back()));
      }
    }
    for (std::size_t i = 0; i < outcomes.size(); ++i) {
      const std::size_t finest = outcomes.size() - models_.size() + i % models_.size();
      if (outcomes[i] && outcomes[finest]) {
        contacts_[i].exact.add(errors_of(*outcomes[i], exact, impact, pair_));
        contacts_[i].finest.add(errors_of(*outcomes[i], *outcomes[finest], impact, pair_));
      }
    }
  }

  void hand_over(ImpactMeasures& measures) {
    std::move(bounds_.begin(), bounds_.end(), std::back_inserter(measures.bounds));
    std::move(contacts_.begin(), contacts_.end(), std::back_inserter(measures.contacts));
  }

 private:
  void add_level(TreeKind kind, int level, const std::vector<std::string>& reductions) {
    BoundsMeasures& bounds = bounds_.emplace_back();
    bounds.kind = kind;
    bounds.level = level;
    bounds.bytes = bytes_of(a_.tree(), level);
    if (&a_.tree() != &b_.tree()) {
      bounds.bytes += bytes_of(b_.tree(), level);
    }
    for (const std::string& reduction : reductions) {
      ContactMeasures& contacts = contacts_.emplace_back();
      contacts.kind = kind;
      contacts.level = level;
      contacts.reduction = reduction;
    }
  }

  /// Of the nodes to `level`: a node takes as much at every level.
  static double bytes_of(const VolumeTree& tree, int level) {
    const int last = std::min(level, tree.level_count() - 1);
    return static_cast<double>(tree.bytes()) * tree.level_end(last) / tree.node_count();
  }

  void place(const ExactImpact& impact) {
    a_.move_to(impact.states[0].pose);
    b_.move_to(impact.states[1].pose);
  }

  std::int64_t refine(const ExactImpact& impact, int level) {
    place(impact);
    refinement_.begin(a_, b_, level);
    std::int64_t tests = 1;
    while (!refinement_.resolved()) {
      tests += refinement_.next_block();
      refinement_.refine_one_block();
    }
    return tests;
  }

  /// Leaves the refinement at the level.
  void refine_and_time(const ExactImpact& impact, BoundsMeasures& level) {
    level.tests.push_back(static_cast<double>(refine(impact, level.level)));
    level.overlaps.push_back(static_cast<double>(refinement_.overlapping().size()));
    level.missed += refinement_.overlapping().empty() ? 1 : 0;
    level.refine_us.push_back(timed_us(clock_, [&] { refine(impact, level.level); }));
  }

  [[nodiscard]] MovingTree moving(PlacedTree& tree, const BodyModel& model,
                                  const BodyState& state) const {
    return {tree, {state.pose.position, velocity(model, state), angular_velocity(model, state)}};
  }

  void find_contacts(const ExactImpact& impact, const ContactModel& model) {
    found_.clear();
    const MovingTree a = moving(a_, pair_.a.model, impact.states[0]);
    const MovingTree b = moving(b_, pair_.b.model, impact.states[1]);
    const NormalFallbacks fallbacks{a.motion.centre_of_mass - b.motion.centre_of_mass,
                                    b.motion.velocity - a.motion.velocity};
    modelling_.add_pair_contacts({0, 1}, refinement_, a, b, fallbacks, model, found_);
  }

  std::optional<ImpactOutcome> measure_contacts(const ExactImpact& impact,
                                                const ContactModel& model,
                                                ContactMeasures& measures, double refine_us) {
    find_contacts(impact, model);
    if (found_.empty()) {
      return std::nullopt;
    }
    measures.contacts.push_back(static_cast<double>(found_.size()));
    const ImpactOutcome outcome = outcome_of(found_, impact, pair_, responder_);
    measures.pair_us.push_back(refine_us + timed_us(clock_, [&] {
                                 find_contacts(impact, model);
                                 respond(impact);
                               }));
    return outcome;
  }

  /// As outcome_of() does, without what a step does not need.
  void respond(const ExactImpact& impact) {
    states_ = impact.states;
    restitutions_.assign(found_.size(), pair_.restitution);
    ResponseRules rules;
    rules.method = pair_.response;
    responder_.respond(found_, restitutions_, rules, both_, states_);
  }

  const ImpactPair& pair_;
  const Clock& clock_;
  PlacedTree a_;
  PlacedTree b_;
  std::vector<ContactModel> models_;
  PairRefinement refinement_;
  ContactModelling modelling_;
  Responder responder_;
  std::vector<Contact> found_;
  std::vector<BodyModel> both_{pair_.a.model, pair_.b.model};
  std::vector<BodyState> states_;
  std::vector<double> restitutions_;
  std::vector<BoundsMeasures> bounds_;
  std::vector<ContactMeasures> contacts_;  ///< by level, then reduction
};

/// One of these approaches must be an impact for the pair to be worth measuring.
constexpr int kMostApproachesAnImpact = 200;

}  // namespace

void ErrorSamples::add(const ImpactErrors& errors) {
  normal_deg.push_back(errors.normal_deg);
  point.push_back(errors.point);
  linear.push_back(errors.linear);
  angular.push_back(errors.angular);
}

ImpactMeasures measure_impacts(const ImpactPair& pair, const ImpactSettings& settings,
                               const Clock& clock, const Progress& progress) {
  ImpactMeasures measures;
  measures.subject = pair.name();
  measures.spins = can_turn(pair.a.model) || can_turn(pair.b.model);
  std::vector<KindMeasurement> kinds;
  kinds.reserve(settings.kinds.size());
  for (const TreeKind kind : settings.kinds) {
    kinds.emplace_back(pair, kind, settings, clock);
  }
  RandomStream random(settings.seed, "impacts of " + measures.subject);
  Responder responder;
  for (int impacts = 0; impacts < settings.impacts;) {
    if (measures.approaches > std::int64_t{kMostApproachesAnImpact} * (impacts + 10)) {
      throw std::runtime_error(measures.subject + ": hardly any random approach is an impact");
    }
    const Approach approach = next_approach(random, pair);
    ++measures.approaches;
    measures.touching += approach.touches ? 1 : 0;
    for (KindMeasurement& kind : kinds) {
      kind.measure_approach(approach);
    }
    if (!approach.impact) {
      continue;
    }
    const ImpactOutcome exact =
        outcome_of({{{0, 1}, approach.impact->touch}}, *approach.impact, pair, responder);
    for (KindMeasurement& kind : kinds) {
      kind.measure_impact(*approach.impact, exact);
    }
    ++impacts;
    if (progress) {
      progress(static_cast<double>(impacts) / settings.impacts);
    }
  }
  for (KindMeasurement& kind : kinds) {
    kind.hand_over(measures);
  }
  return measures;
}

}  // namespace impetus::inline trade
