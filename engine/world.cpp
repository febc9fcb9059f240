// SPDX-License-Identifier: MIT
#include "engine/world.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

#include "engine/dynamics/simultaneous_response.hpp"
#include "engine/dynamics/stop_at_entry.hpp"

namespace impetus {
namespace {

void require(bool condition, const char* message) {
  if (!condition) {
    throw std::invalid_argument(message);
  }
}

void require_no_problem(const std::string& problem) {
  require(problem.empty(), ("world: " + problem).c_str());
}

bool is_finite(const BodyState& state) {
  return state.pose.position.allFinite() && state.pose.orientation.coeffs().allFinite() &&
         state.linear_momentum.allFinite() && state.angular_momentum.allFinite();
}

std::size_t at(std::int32_t index) { return static_cast<std::size_t>(index); }

}  // namespace

World::World(std::vector<BodyModel> models, std::vector<BodyState> states, WorldSettings settings)
    : models_(std::move(models)), states_(std::move(states)), settings_(std::move(settings)) {
  require(models_.size() == states_.size(), "world: one state per body model is needed");
  require(settings_.restitution >= 0.0 && settings_.restitution <= 1.0,
          "world: restitution must lie in [0, 1]");
  require_no_problem(problem_of(settings_.materials));
  require(settings_.imposed_hold_s >= 0.0, "world: an imposed hold cannot be negative");
  if (settings_.enclosure) {
    require_no_problem(problem_of(*settings_.enclosure));
  }
  require(problem_of(settings_.schedule).empty(), problem_of(settings_.schedule).c_str());
  for (BodyModel& body : models_) {
    require(body.tree != nullptr, "world: every body needs a volume tree");
    require(body.inverse_mass >= 0.0, "world: an inverse mass cannot be negative");
    if (body.inverse_mass == 0.0) {
      body.inverse_inertia.setZero();
    }
    placed_.emplace_back(*body.tree);
  }
}

void World::set_schedule(Schedule schedule) {
  require(problem_of(schedule).empty(), problem_of(schedule).c_str());
  settings_.schedule = std::move(schedule);
}

StepReport World::step(const StepInput& input, WorkMeter& meter) {
  StepReport report;
  const std::vector<PairBounds> candidates = move_and_pair(input.dt_s, report);
  const std::vector<ScheduledPair> order =
      scheduled(candidates, settings_.schedule, input.viewer, input.fixation, input.region);
  const std::vector<RefinedPair> refined = refine(order, input.dt_s, meter, report);
  model(refined, report);
  respond_to(report);
  report.state = hash_state(states_);
  return report;
}

std::vector<PairBounds> World::move_and_pair(double dt_s, StepReport& report) {
  const std::vector<BodyState> before = states_;
  std::vector<MovedBound> bounds;
  bounds.reserve(models_.size());
  for (std::size_t body = 0; body < models_.size(); ++body) {
    const double travelled_m = advance(models_[body], states_[body], dt_s, settings_.rotation);
    const Sphere bound{states_[body].pose.position, models_[body].tree->bounding_radius_m()};
    bounds.push_back({bound, travelled_m, models_[body].inverse_mass > 0.0});
  }
  std::vector<PairBounds> candidates = broad_phase_.candidates(bounds);
  if (settings_.tunnelling == Tunnelling::kStopAtEntry) {
    stop_fast_pairs(before, dt_s, candidates, report);
  }
  for (std::size_t body = 0; body < models_.size(); ++body) {
    placed_[body].move_to(states_[body].pose);
    bounds[body].bound.centre = states_[body].pose.position;
  }
  if (settings_.enclosure) {
    add_wall_candidates(bounds, candidates);
  }
  for (PairBounds& pair : candidates) {
    measure_motion_and_fit(pair);
  }
  return candidates;
}

void World::stop_fast_pairs(const std::vector<BodyState>& before, double dt_s,
                            std::vector<PairBounds>& candidates, StepReport& report) {
  int greatest_level = 0;
  for (const PriorityList& list : settings_.schedule.lists) {
    greatest_level = std::max(greatest_level, list.greatest_level);
  }
  Stopping stopping = stop_at_entry(
      {dt_s, models_, before, candidates, greatest_level, settings_.costs, settings_.rotation},
      states_, placed_);
  for (PairBounds& pair : candidates) {
    pair.a.centre = states_[at(pair.pair.a)].pose.position;
    pair.b.centre = states_[at(pair.pair.b)].pose.position;
  }
  report.work_floor = stopping.work;
  report.stopped = std::move(stopping.stopped);
  if (!report.stopped.empty()) {
    report.degradations |= kStoppedShort;
  }
}

void World::add_wall_candidates(const std::vector<MovedBound>& bounds,
                                std::vector<PairBounds>& candidates) const {
  for (std::size_t body = 0; body < bounds.size(); ++body) {
    const Sphere& bound = bounds[body].bound;
    if (bounds[body].movable && reaches_wall(*settings_.enclosure, bound)) {
      candidates.push_back({{static_cast<std::int32_t>(body), kEnclosure}, bound, bound});
    }
  }
}

void World::measure_motion_and_fit(PairBounds& pair) const {
  constexpr int kLevelBeforeRefinement = 0;
  const std::size_t a = at(pair.pair.a);
  const std::size_t b = is_wall(pair.pair.b) ? a : at(pair.pair.b);
  pair.velocity_a = velocity(models_[a], states_[a]);
  pair.velocity_b = velocity(models_[b], states_[b]);
  pair.fit_error_m = models_[a].tree->fit_error_m(kLevelBeforeRefinement);
  if (!is_wall(pair.pair.b)) {
    pair.fit_error_m += models_[b].tree->fit_error_m(kLevelBeforeRefinement);
  }
}

int World::level_capped_by_speed(BodyPair bodies, double dt_s, int greatest_level) const {
  if (settings_.tunnelling != Tunnelling::kCapped || is_wall(bodies.b)) {
    return greatest_level;
  }
  const auto turning_m_s = [&](std::int32_t body) {
    return angular_velocity(models_[at(body)], states_[at(body)]).norm() *
           models_[at(body)].tree->bounding_radius_m();
  };
  const auto velocity_of = [&](std::int32_t body) {
    return velocity(models_[at(body)], states_[at(body)]);
  };
  const double speed_m_s = (velocity_of(bodies.a) - velocity_of(bodies.b)).norm() +
                           turning_m_s(bodies.a) + turning_m_s(bodies.b);
  return capped_level(*models_[at(bodies.a)].tree, *models_[at(bodies.b)].tree, speed_m_s * dt_s,
                      greatest_level);
}

std::vector<RefinedPair> World::refine(const std::vector<ScheduledPair>& order, double dt_s,
                                       WorkMeter& meter, StepReport& report) {
  std::vector<RefinedPair> refined;
  refined.reserve(order.size());
  for (const auto& [bodies, list] : order) {
    const int greatest = settings_.schedule.lists[at(list)].greatest_level;
    const int capped = level_capped_by_speed(bodies, dt_s, greatest);
    const StopReason at_greatest =
        capped < greatest ? StopReason::kCapped : StopReason::kGreatestLevel;
    PlacedTree& a = placed_[at(bodies.a)];
    refined.push_back({bodies, list,
                       is_wall(bodies.b)
                           ? PairRefinement(a, *settings_.enclosure, greatest)
                           : PairRefinement(a, placed_[at(bodies.b)], capped, at_greatest)});
  }
  WorkDone work = refine_by_lists(refined, settings_.schedule.lists, meter, report.work_floor);
  report.work_granted = work.granted;
  report.work_spent = work.spent;
  report.work_floor = work.floor;
  report.list_work = std::move(work.by_list);
  if (report.work_granted < report.work_floor) {
    report.degradations |= kFloorOverBudget;
  }
  return refined;
}

std::vector<Contact> World::contacts_of(const RefinedPair& pair) {
  const auto& [bodies, list, refinement] = pair;
  if (refinement.overlapping().empty()) {
    return {};
  }
  if (is_wall(bodies.b)) {
    return wall_contacts(bodies.a, refinement, placed_[at(bodies.a)], *settings_.enclosure);
  }
  const BodyState& a = states_[at(bodies.a)];
  const BodyState& b = states_[at(bodies.b)];
  const NormalFallbacks fallbacks{
      a.pose.position - b.pose.position,
      velocity(models_[at(bodies.b)], b) - velocity(models_[at(bodies.a)], a)};
  return {
      average_contact(bodies, refinement, placed_[at(bodies.a)], placed_[at(bodies.b)], fallbacks)};
}

void World::model(const std::vector<RefinedPair>& refined, StepReport& report) {
  for (const RefinedPair& pair : refined) {
    for (const Contact& contact : contacts_of(pair)) {
      CollisionReport collision;
      collision.bodies = contact.bodies;
      collision.list = pair.list;
      collision.level = pair.refinement.level();
      collision.stop = pair.refinement.stop_reason();
      collision.began = !touched_before(contact.bodies);
      collision.contact = contact;
      report.collisions.push_back(collision);
    }
  }
  // The response must not depend on who was refined first, only on what was found.
  std::sort(report.collisions.begin(), report.collisions.end(),
            [](const CollisionReport& x, const CollisionReport& y) {
              return std::pair(x.bodies.a, x.bodies.b) < std::pair(y.bodies.a, y.bodies.b);
            });
}

ResponseResult World::response_to(const std::vector<Contact>& contacts) {
  const std::vector<double> restitutions =
      Restitutions{settings_.restitution, settings_.materials, settings_.wall_material}.of(contacts,
                                                                                           models_);
  return settings_.response == ResponseMethod::kInTurn
             ? respond(contacts, restitutions, models_, states_)
             : respond_together(contacts, restitutions, models_, states_);
}

void World::respond_to(StepReport& report) {
  std::vector<Contact> contacts;
  touching_.clear();
  for (const CollisionReport& collision : report.collisions) {
    contacts.push_back(collision.contact);
    touching_.push_back(collision.bodies);
  }
  const ResponseResult result = response_to(contacts);
  for (std::size_t i = 0; i < report.collisions.size(); ++i) {
    CollisionReport& collision = report.collisions[i];
    collision.approach_m_s = result.approach_m_s[i];
    collision.impulse_Ns = result.impulse_Ns[i];
    if (collision.began && collision.impulse_Ns > 0.0 && settings_.imposed_hold_s > 0.0) {
      collision.imposed_hold_s = settings_.imposed_hold_s;
      for (const std::int32_t body : {collision.bodies.a, collision.bodies.b}) {
        if (!is_wall(body)) {
          states_[at(body)].held_s = settings_.imposed_hold_s;
        }
      }
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
