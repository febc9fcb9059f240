// SPDX-License-Identifier: MIT
#include "engine/world.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

#include "engine/collision_reports.hpp"
#include "engine/dynamics/simultaneous_response.hpp"

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

World::World(std::vector<BodyModel> models, std::vector<BodyState> states, WorldSettings settings)
    : models_(std::move(models)), states_(std::move(states)), settings_(std::move(settings)) {
  require(models_.size() == states_.size(), "world: one state per body model is needed");
  const std::string problem = problem_of(settings_);
  require(problem.empty(), problem.c_str());
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
  WorldSettings changed = settings_;
  changed.schedule = std::move(schedule);
  change_settings(std::move(changed));
}

void World::set_contacts(ContactModel contacts) {
  WorldSettings changed = settings_;
  changed.contacts = std::move(contacts);
  change_settings(std::move(changed));
}

void World::set_costs(const WorkCosts& costs) {
  WorldSettings changed = settings_;
  changed.costs = costs;
  change_settings(std::move(changed));
}

void World::change_settings(WorldSettings changed) {
  const std::string problem = problem_of(changed);
  require(problem.empty(), problem.c_str());
  settings_ = std::move(changed);
}

StepReport World::step(const StepInput& input, WorkMeter& meter) {
  StepReport report;
  const std::vector<PairBounds> candidates = move_and_pair(input.dt_s, report);
  const std::vector<ScheduledPair> order = prioritise(candidates, input);
  const std::vector<RefinedPair> refined = refine(order, input, meter, report);
  model(refined, report);
  count_later_phases(refined, report);
  respond_to(report);
  note_touching(input.viewer, report);
  report.state = hash_state(states_);
  return report;
}

std::vector<PairBounds> World::move_and_pair(double dt_s, StepReport& report) {
  const bool stops_fast_pairs = settings_.tunnelling == Tunnelling::kStopAtEntry;
  const std::vector<BodyState> before = stops_fast_pairs ? states_ : std::vector<BodyState>{};
  std::vector<MovedBound> bounds;
  bounds.reserve(models_.size());
  for (std::size_t body = 0; body < models_.size(); ++body) {
    const double travelled_m = advance(models_[body], states_[body], dt_s, settings_.rotation);
    const Sphere bound{states_[body].pose.position, models_[body].tree->bounding_radius_m()};
    bounds.push_back({bound, travelled_m, models_[body].inverse_mass > 0.0});
  }
  std::vector<PairBounds> candidates = broad_phase_.candidates(bounds);
  if (stops_fast_pairs) {
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
  const Stopping& stopping =
      stop_at_entry({dt_s, models_, before, candidates, greatest_level, settings_.costs,
                     settings_.rotation, kMostStops, settings_.most_entry_tests},
                    states_, placed_, entries_);
  for (PairBounds& pair : candidates) {
    pair.a.centre = states_[at(pair.pair.a)].pose.position;
    pair.b.centre = states_[at(pair.pair.b)].pose.position;
  }
  report.work_floor = stopping.work;
  report.stopped = stopping.stopped;
  if (!report.stopped.empty()) {
    report.degradations |= kStoppedShort;
  }
  if (stopping.ran_out) {
    report.degradations |= kEntryTestsSpent;
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

bool World::is_capped_by_speed(BodyPair bodies) const {
  if (is_wall(bodies.b)) {
    return false;
  }
  return settings_.tunnelling == Tunnelling::kCapped ||
         (settings_.tunnelling == Tunnelling::kStopAtEntry && entries_.result.lacked_tests(bodies));
}

int World::level_capped_by_speed(BodyPair bodies, double dt_s, int greatest_level) const {
  if (!is_capped_by_speed(bodies)) {
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

std::vector<ScheduledPair> World::prioritise(const std::vector<PairBounds>& candidates,
                                             const StepInput& input) {
  std::vector<MeasuredPair> pairs =
      measured(candidates, settings_.schedule, input.viewer, input.fixation, input.region);
  priorities_.raise(pairs, settings_.schedule.persistence_steps);
  return in_order(std::move(pairs));
}

std::vector<RefinedPair> World::refine(const std::vector<ScheduledPair>& order,
                                       const StepInput& input, WorkMeter& meter,
                                       StepReport& report) {
  std::vector<RefinedPair> refined;
  refined.reserve(order.size());
  for (const ScheduledPair& pair : order) {
    refined.push_back(begin_refining(pair, input));
  }
  const Schedule& schedule = settings_.schedule;
  WorkDone work =
      refine_by_lists(refined, schedule.lists, meter,
                      {schedule.traversal, settings_.costs, settings_.contacts, report.work_floor});
  report.work_granted = work.granted;
  report.work_spent = work.spent;
  report.work_floor = work.floor;
  report.work_reserved = work.reserved;
  report.work_peak = work.peak;
  report.list_work = std::move(work.by_list);
  if (report.work_granted < report.work_floor) {
    report.degradations |= kFloorOverBudget;
  }
  return refined;
}

RefinedPair World::begin_refining(const ScheduledPair& pair, const StepInput& input) {
  const auto& [bodies, list] = pair;
  const int greatest = settings_.schedule.lists[at(list)].greatest_level;
  const int capped = level_capped_by_speed(bodies, input.dt_s, greatest);
  const StopReason at_greatest =
      capped < greatest ? StopReason::kCapped : StopReason::kGreatestLevel;
  PlacedTree& a = placed_[at(bodies.a)];
  const bool walls = is_wall(bodies.b);
  RefinedPair begun{bodies, list,
                    walls ? PairRefinement(a, *settings_.enclosure, greatest)
                          : PairRefinement(a, placed_[at(bodies.b)], capped, at_greatest)};
  begun.walls = walls ? walls_in_reach(at(bodies.a)) : 1;
  if (settings_.schedule.traversal == Traversal::kBestFirst) {
    const auto bound = [this](std::int32_t body) {
      return Sphere{states_[at(body)].pose.position, models_[at(body)].tree->bounding_radius_m()};
    };
    const PairBounds bounds{bodies, bound(bodies.a), bound(walls ? bodies.a : bodies.b)};
    begun.eye_distance_m = (collision_place(bounds) - input.viewer.eye).norm();
  }
  return begun;
}

int World::walls_in_reach(std::size_t body) const {
  const Sphere all{states_[body].pose.position, placed_[body].reach_m()};
  int count = 0;
  for (int wall = 0; wall < kWallCount; ++wall) {
    count += reach_beyond(*settings_.enclosure, wall, all) >= 0.0 ? 1 : 0;
  }
  return count;
}

void World::count_later_phases(const std::vector<RefinedPair>& refined, StepReport& report) const {
  const PhaseCosts costs(settings_.costs, settings_.contacts);
  for (const RefinedPair& pair : refined) {
    const auto nodes = static_cast<std::int64_t>(pair.refinement.overlapping().size());
    report.work_spent += costs.of_modelling(pair, nodes);
  }
  report.work_spent += costs.of_response(static_cast<std::int64_t>(report.contacts.size()));
}

MovingTree World::moving(std::size_t body) {
  const BodyModel& model = models_[body];
  const BodyState& state = states_[body];
  return {placed_[body],
          {state.pose.position, velocity(model, state), angular_velocity(model, state)}};
}

std::vector<Contact> World::contacts_of(const RefinedPair& pair, std::vector<Contact>* watched) {
  const BodyPair bodies = pair.bodies;
  const PairRefinement& refinement = pair.refinement;
  if (refinement.overlapping().empty()) {
    return {};
  }
  const MovingTree a = moving(at(bodies.a));
  if (is_wall(bodies.b)) {
    return wall_contacts(bodies.a, refinement, a, *settings_.enclosure, settings_.contacts,
                         watched);
  }
  const MovingTree b = moving(at(bodies.b));
  NormalFallbacks fallbacks{a.motion.centre_of_mass - b.motion.centre_of_mass,
                            b.motion.velocity - a.motion.velocity};
  if (const TouchingPair* before = touched_before(bodies)) {
    fallbacks.last_normal = before->normal;
  }
  return pair_contacts(bodies, refinement, a, b, fallbacks, settings_.contacts, watched);
}

void World::model(const std::vector<RefinedPair>& refined, StepReport& report) {
  std::vector<ModelledCollision> modelled;
  for (const RefinedPair& pair : refined) {
    const std::vector<Contact> contacts =
        contacts_of(pair, watches_node_contacts_ ? &report.node_contacts : nullptr);
    CollisionReport collision;
    collision.list = pair.list;
    collision.level = pair.refinement.level();
    collision.stop = pair.refinement.stop_reason();
    add_by_bodies(collision, contacts, modelled);
  }
  report_in_order(std::move(modelled), report);
  for (CollisionReport& collision : report.collisions) {
    collision.began = touched_before(collision.bodies) == nullptr;
  }
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
  touching_.clear();
  for (const CollisionReport& collision : report.collisions) {
    touching_.push_back({collision.bodies, collision.contact.touch.normal});
  }
  const ResponseResult result = response_to(contacts_to_respond_to(report));
  report_response(result, report);
  for (CollisionReport& collision : report.collisions) {
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

void World::note_touching(const Viewer& viewer, StepReport& report) {
  std::vector<BodyPair> touching;
  std::vector<TouchingLevel> levels;
  for (const CollisionReport& collision : report.collisions) {
    touching.push_back(collision.bodies);
    levels.push_back({collision.bodies, collision.level, collision.contact.touch.point});
  }
  priorities_.note_touching(std::move(touching));
  report.pops = levels_.note(std::move(levels), models_, viewer);
}

const TouchingPair* World::touched_before(BodyPair bodies) const {
  const auto found =
      std::find_if(touching_.begin(), touching_.end(),
                   [bodies](const TouchingPair& pair) { return pair.bodies == bodies; });
  return found == touching_.end() ? nullptr : &*found;
}

}  // namespace impetus
