// SPDX-License-Identifier: MIT
#include "engine/world.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "engine/collision/broad_phase.hpp"
#include "engine/dynamics/motion.hpp"

namespace impetus {
namespace {

void require(bool condition, const char* message) {
  if (!condition) {
    throw std::invalid_argument(message);
  }
}

bool is_finite(const BodyState& state) {
  return state.pose.position.allFinite() && state.pose.orientation.coeffs().allFinite() &&
         state.linear_momentum.allFinite() && state.angular_momentum.allFinite();
}

std::size_t at(std::int32_t index) { return static_cast<std::size_t>(index); }

}  // namespace

struct World::RefinedPair {
  BodyPair bodies;
  PairRefinement refinement;
};

World::World(std::vector<BodyModel> models, std::vector<BodyState> states, WorldSettings settings)
    : models_(std::move(models)), states_(std::move(states)), settings_(settings) {
  require(models_.size() == states_.size(), "world: one state per body model is needed");
  require(settings_.restitution >= 0.0 && settings_.restitution <= 1.0,
          "world: restitution must lie in [0, 1]");
  require(settings_.imposed_hold_s >= 0.0, "world: an imposed hold cannot be negative");
  for (const BodyModel& body : models_) {
    require(body.tree != nullptr, "world: every body needs a volume tree");
    placed_.emplace_back(*body.tree);
  }
}

StepReport World::step(const StepInput& input, WorkMeter& meter) {
  StepReport report;
  const std::vector<PairBounds> candidates = move_and_pair(input.dt_s);
  const std::vector<BodyPair> order = prioritised(candidates, DistancePriority{}, input.viewer);
  const std::vector<RefinedPair> refined = refine(order, meter, report);
  model(refined, report);
  respond_to(report);
  report.state = hash_state(states_);
  return report;
}

std::vector<PairBounds> World::move_and_pair(double dt_s) {
  std::vector<MovedBound> bounds;
  bounds.reserve(models_.size());
  for (std::size_t body = 0; body < models_.size(); ++body) {
    const double travelled_m = advance(models_[body], states_[body], dt_s);
    placed_[body].move_to(states_[body].pose);
    const Sphere bound{states_[body].pose.position, models_[body].tree->bounding_radius_m()};
    bounds.push_back({bound, travelled_m, models_[body].inverse_mass > 0.0});
  }
  return candidate_pairs(bounds);
}

std::vector<World::RefinedPair> World::refine(const std::vector<BodyPair>& order, WorkMeter& meter,
                                              StepReport& report) {
  std::vector<RefinedPair> refined;
  refined.reserve(order.size());
  for (const BodyPair& bodies : order) {
    refined.push_back({bodies, PairRefinement(placed_[at(bodies.a)], placed_[at(bodies.b)])});
  }
  report.work_floor = static_cast<std::int64_t>(order.size());
  report.work_spent = report.work_floor;
  report.work_granted = meter.request(report.work_spent);
  if (report.work_granted < report.work_floor) {
    report.degradations |= kFloorOverBudget;
  }
  for (RefinedPair& pair : refined) {
    while (!pair.refinement.resolved()) {
      const std::int64_t needed = report.work_spent + pair.refinement.next_block();
      report.work_granted = std::max(report.work_granted, meter.request(needed));
      if (report.work_granted < needed) {
        break;
      }
      pair.refinement.refine_one_block();
      report.work_spent = needed;
    }
  }
  return refined;
}

void World::model(const std::vector<RefinedPair>& refined, StepReport& report) {
  for (const auto& [bodies, refinement] : refined) {
    if (refinement.overlapping().empty()) {
      continue;
    }
    const BodyState& a = states_[at(bodies.a)];
    const BodyState& b = states_[at(bodies.b)];
    const NormalFallbacks fallbacks{
        a.pose.position - b.pose.position,
        velocity(models_[at(bodies.b)], b) - velocity(models_[at(bodies.a)], a)};
    CollisionReport collision;
    collision.bodies = bodies;
    collision.level = refinement.level();
    collision.stop = refinement.stop_reason();
    collision.began = !touched_before(bodies);
    collision.contact = average_contact(bodies, refinement, placed_[at(bodies.a)],
                                        placed_[at(bodies.b)], fallbacks);
    report.collisions.push_back(collision);
  }
  // The response must not depend on who was refined first, only on what was found.
  std::sort(report.collisions.begin(), report.collisions.end(),
            [](const CollisionReport& x, const CollisionReport& y) {
              return std::pair(x.bodies.a, x.bodies.b) < std::pair(y.bodies.a, y.bodies.b);
            });
}

void World::respond_to(StepReport& report) {
  std::vector<Contact> contacts;
  touching_.clear();
  for (const CollisionReport& collision : report.collisions) {
    contacts.push_back(collision.contact);
    touching_.push_back(collision.bodies);
  }
  const ResponseResult result = respond(contacts, settings_.restitution, models_, states_);
  for (std::size_t i = 0; i < report.collisions.size(); ++i) {
    CollisionReport& collision = report.collisions[i];
    collision.approach_m_s = result.approach_m_s[i];
    collision.impulse_Ns = result.impulse_Ns[i];
    if (collision.began && collision.impulse_Ns > 0.0 && settings_.imposed_hold_s > 0.0) {
      collision.imposed_hold_s = settings_.imposed_hold_s;
      states_[at(collision.bodies.a)].held_s = settings_.imposed_hold_s;
      states_[at(collision.bodies.b)].held_s = settings_.imposed_hold_s;
    }
  }
  if (result.residual_approach_m_s > 0.0) {
    report.degradations |= kApproachRemains;
  }
  if (!std::all_of(states_.begin(), states_.end(), is_finite)) {
    report.degradations |= kNotFinite;
  }
}

bool World::touched_before(BodyPair bodies) const {
  return std::find(touching_.begin(), touching_.end(), bodies) != touching_.end();
}

}  // namespace impetus
