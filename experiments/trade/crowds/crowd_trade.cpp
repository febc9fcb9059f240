// SPDX-License-Identifier: MIT
#include "experiments/trade/crowds/crowd_trade.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "engine/numerics/random_stream.hpp"
#include "experiments/run/scene_run.hpp"
#include "experiments/trade/crowds/removal_curve.hpp"
#include "experiments/trade/crowds/trajectory.hpp"
#include "experiments/trade/crowds/work_beyond_floor.hpp"

namespace impetus::inline trade {
namespace {

constexpr std::array<ErrorOf, 2> kGapAndBound{&VisibleError::gap, &VisibleError::bound};
constexpr int kChanceOrders = 16;

/// Kinetic energy, and what gravity could add to it (J).
struct Energy {
  double of_motion{0.0};
  double of_place{0.0};
};

Energy energy_of(const World& world) {
  Energy energy;
  for (std::size_t body = 0; body < world.models().size(); ++body) {
    const BodyModel& model = world.models()[body];
    const BodyState& state = world.states()[body];
    energy.of_motion += kinetic_energy(model, state);
    if (model.inverse_mass > 0.0) {
      energy.of_place -=
          world.settings().gravity_m_s2.dot(state.pose.position) / model.inverse_mass;
    }
  }
  return energy;
}

double relative_change(const Energy& before, const Energy& after) {
  const double change_J = after.of_motion - before.of_motion + after.of_place - before.of_place;
  return before.of_motion > 0.0 ? change_J / before.of_motion : change_J;
}

std::vector<Pose> poses_of(const World& world) {
  std::vector<Pose> poses;
  for (const BodyState& state : world.states()) {
    poses.push_back(state.pose);
  }
  return poses;
}

/// The error that the levels in a report leave. Precondition: the pairs are the step's.
VisibleError left_after(const StepReport& report, const std::vector<PairLevels>& pairs) {
  std::map<std::pair<std::int32_t, std::int32_t>, const PairLevels*> by_bodies;
  for (const PairLevels& pair : pairs) {
    by_bodies[{pair.bodies.a, pair.bodies.b}] = &pair;
  }
  VisibleError left;
  BodyPair last{-1, -1};
  for (const CollisionReport& collision : report.collisions) {
    const BodyPair bodies{collision.bodies.a,
                          is_wall(collision.bodies.b) ? kEnclosure : collision.bodies.b};
    if (bodies == last) {
      continue;  // a further wall of the enclosure, which counts as a whole
    }
    last = bodies;
    const auto found = by_bodies.find({bodies.a, bodies.b});
    if (found == by_bodies.end()) {
      throw std::logic_error("a collision was reported of bodies whose roots are apart");
    }
    const VisibleError& of_pair =
        found->second->levels.at(static_cast<std::size_t>(collision.level)).left;
    left.gap += of_pair.gap;
    left.bound += of_pair.bound;
  }
  return left;
}

/// What can be removed of a step's errors by so much work, in orders that know no priority, and at
/// most.
class References {
 public:
  References(const std::vector<PairLevels>& pairs, std::uint64_t seed) {
    RandomStream random(seed, "orders by chance");
    std::vector<std::size_t> order(pairs.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    for (const ErrorOf error : kGapAndBound) {
      in_hindsight_.push_back(RemovalCurve::in_hindsight(pairs, error));
    }
    for (int i = 0; i < kChanceOrders; ++i) {
      random.shuffle(order);
      for (const ErrorOf error : kGapAndBound) {
        by_chance_.push_back(RemovalCurve::depth_first(pairs, error, order));
        breadth_first_.push_back(RemovalCurve::breadth_first(pairs, error, order));
      }
    }
  }

  void compare(OrderedStep& step) const {
    step.by_chance = mean_removed(by_chance_, step.work);
    step.breadth_first = mean_removed(breadth_first_, step.work);
    step.in_hindsight = mean_removed(in_hindsight_, step.work);
  }

 private:
  /// `curves` come by turns for each of the errors.
  static VisibleError mean_removed(const std::vector<RemovalCurve>& curves, std::int64_t work) {
    VisibleError mean;
    for (std::size_t i = 0; i < curves.size(); ++i) {
      mean.*kGapAndBound[i % kGapAndBound.size()] += curves[i].removed(work);
    }
    const std::size_t of_each = curves.size() / kGapAndBound.size();
    const auto count = static_cast<double>(of_each);
    return {mean.gap / count, mean.bound / count};
  }

  std::vector<RemovalCurve> in_hindsight_;
  std::vector<RemovalCurve> by_chance_;
  std::vector<RemovalCurve> breadth_first_;
};

/// Takes the scene along its trajectory and tries the orders on sampled steps.
class Crowd {
 public:
  Crowd(const StagedScene& scene, const CrowdRequest& request, const Clock& clock,
        const Progress& progress)
      : scene_(scene), request_(request), clock_(clock), progress_(progress) {
    scene_.world.set_costs(costs_of_tests(scene.world.settings().costs));
  }

  CrowdTrade measure() {
    CrowdTrade trade;
    const bool is_asked = !request_.budgets.empty();
    for (const std::int64_t budget :
         is_asked ? request_.budgets : usual_budgets(scene_, request_)) {
      for (const TriedOrder& order : request_.orders) {
        trade.orders.push_back({order, budget, {}});
      }
    }
    for_each_moment(scene_, request_, progress_, [&](const Moment& moment) {
      sample(moment, trade);
      trade.steps.back().step = moment.before.number() + 1;
    });
    return trade;
  }

 private:
  /// Gives the step all orders, each from where the trajectory is.
  void sample(const Moment& moment, CrowdTrade& trade) {
    SceneRun coarsest = tried_run(moment, {});
    FixedWork nothing(0);
    const std::int64_t roots = coarsest.step(moment.fixation, moment.region, nothing).work_spent;
    const std::vector<PairLevels> pairs =
        pair_levels(scene_, poses_of(coarsest.world()), {coarsest.input().viewer, moment.fixation});
    trade.steps.push_back(described(pairs));
    const References references(pairs, moment.seed);
    for (OrderedCrowd& tried : trade.orders) {
      OrderedStep done = try_order(tried, moment, roots, pairs);
      for (const ErrorOf error : kGapAndBound) {
        done.removed.*error = trade.steps.back().at_roots.*error - done.left.*error;
      }
      references.compare(done);
      tried.steps.push_back(done);
    }
  }

  static SampledStep described(const std::vector<PairLevels>& pairs) {
    SampledStep step;
    step.pairs = static_cast<std::int64_t>(pairs.size());
    for (const PairLevels& pair : pairs) {
      step.finest_work += pair.levels.back().work;
    }
    for (const ErrorOf error : kGapAndBound) {
      step.at_roots.*error = left_at_roots(pairs, error);
      step.at_finest.*error = left_at_finest(pairs, error);
    }
    return step;
  }

  /// The scene as the trajectory has it before the step, for one order to try.
  static SceneRun tried_run(const Moment& moment, Schedule schedule) {
    SceneRun tried = moment.before;
    tried.world().set_schedule(std::move(schedule));
    tried.world().set_tunnelling(Tunnelling::kIgnored);
    return tried;
  }

  OrderedStep try_order(const OrderedCrowd& tried, const Moment& moment, std::int64_t roots,
                        const std::vector<PairLevels>& pairs) {
    SceneRun run = tried_run(moment, schedule_of(tried.order, scene_, moment.seed));
    FixedWork meter(roots + tried.budget);
    const std::int64_t start_ns = clock_.now_ns();
    const StepReport& report = run.step(moment.fixation, moment.region, meter);
    OrderedStep done;
    done.ns = clock_.now_ns() - start_ns;
    done.work = report.work_spent - roots;
    done.left = left_after(report, pairs);
    done.contacts = static_cast<std::int64_t>(report.contacts.size());
    done.energy_change = relative_change(energy_of(moment.before.world()), energy_of(run.world()));
    return done;
  }

  StagedScene scene_;  ///< counting tests alone
  const CrowdRequest& request_;
  const Clock& clock_;
  const Progress& progress_;
};

}  // namespace

std::vector<std::int64_t> usual_budgets(const StagedScene& scene, const CrowdRequest& request) {
  constexpr std::int64_t kFinestPart = 64;
  StagedScene counted = scene;
  counted.world.set_costs(costs_of_tests(scene.world.settings().costs));
  std::vector<std::int64_t> work;
  Trajectory pilot(counted, request.sampled_every_s, request.seed);
  for (std::int64_t step = 1; step <= count_steps(counted, request.longest_s); ++step) {
    pilot.look();
    const bool is_sampled = pilot.is_sampled();
    const StepReport& report = pilot.step();
    if (is_sampled) {
      work.push_back(report.work_spent - report.work_floor);
    }
  }
  if (work.empty()) {
    return {};
  }
  const auto middle = work.begin() + static_cast<std::ptrdiff_t>(work.size() / 2);
  std::nth_element(work.begin(), middle, work.end());
  std::vector<std::int64_t> budgets;
  for (std::int64_t part = kFinestPart; part > 0; part /= 2) {
    budgets.push_back(std::max<std::int64_t>(1, *middle / part));
  }
  budgets.erase(std::unique(budgets.begin(), budgets.end()), budgets.end());
  return budgets;
}

CrowdTrade crowd_trade(const StagedScene& scene, const CrowdRequest& request, const Clock& clock,
                       const Progress& progress) {
  return Crowd(scene, request, clock, progress).measure();
}

}  // namespace impetus::inline trade
