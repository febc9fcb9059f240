// SPDX-License-Identifier: MIT
#include "engine/world.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "engine/collision_reports.hpp"
#include "engine/scheduling/eccentricity_metric.hpp"
#include "engine/scheduling/relative_acuity.hpp"

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

const StepReport& World::step(const StepInput& input, WorkMeter& meter) {
  restart(memory_.report);
  move_and_pair(input.dt_s);
  prioritise(input);
  refine(input, meter);
  model();
  respond(input.dt_s);
  note_touching(input.viewer);
  hash_state(states_, memory_.report.state);
  return memory_.report;
}

void World::move_and_pair(double dt_s) {
  const bool stops_fast_pairs = settings_.tunnelling == Tunnelling::kStopAtEntry;
  if (stops_fast_pairs) {
    memory_.before = states_;
  }
  find_falls(dt_s);
  std::vector<MovedBound>& bounds = memory_.bounds;
  bounds.clear();
  for (std::size_t body = 0; body < models_.size(); ++body) {
    const double travelled_m = advance(models_[body], states_[body], dt_s, settings_.rotation,
                                       memory_.falls.empty() ? Fall{} : memory_.falls[body]);
    const Sphere bound{states_[body].pose.position, models_[body].tree->bounding_radius_m()};
    bounds.push_back({bound, travelled_m, models_[body].inverse_mass > 0.0});
  }
  broad_phase_.find(bounds, memory_.candidates);
  if (stops_fast_pairs) {
    stop_fast_pairs(dt_s);
  }
  for (std::size_t body = 0; body < models_.size(); ++body) {
    placed_[body].move_to(states_[body].pose);
    bounds[body].bound.centre = states_[body].pose.position;
  }
  if (settings_.enclosure) {
    add_wall_candidates();
  }
  for (PairBounds& pair : memory_.candidates) {
    measure_motion_and_fit(pair);
  }
}

void World::find_falls(double dt_s) {
  memory_.falls.clear();
  if (settings_.gravity_m_s2.isZero(0.0)) {
    return;
  }
  memory_.falls.resize(models_.size());
  for (const TouchingPair& pair : touching_) {
    for (const std::int32_t body : {pair.bodies.a, pair.bodies.b}) {
      if (!is_wall(body)) {
        memory_.falls[at(body)].supported = true;
      }
    }
  }
  for (std::size_t body = 0; body < models_.size(); ++body) {
    memory_.falls[body] = fall_of(models_[body], states_[body], memory_.falls[body].supported,
                                  settings_.gravity_m_s2, dt_s);
  }
}

void World::stop_fast_pairs(double dt_s) {
  int greatest_level = 0;
  for (const PriorityList& list : settings_.schedule.lists) {
    greatest_level = std::max(greatest_level, list.greatest_level);
  }
  std::vector<PairBounds>& candidates = memory_.candidates;
  const Stopping& stopping =
      stop_at_entry({dt_s, models_, memory_.before, candidates, greatest_level, settings_.costs,
                     settings_.rotation, kMostStops, memory_.falls, settings_.most_entry_tests},
                    states_, placed_, memory_.entries);
  for (PairBounds& pair : candidates) {
    pair.a.centre = states_[at(pair.pair.a)].pose.position;
    pair.b.centre = states_[at(pair.pair.b)].pose.position;
  }
  StepReport& report = memory_.report;
  report.work_floor = stopping.work;
  report.stopped = stopping.stopped;
  if (!report.stopped.empty()) {
    report.degradations |= kStoppedShort;
  }
  if (stopping.ran_out) {
    report.degradations |= kEntryTestsSpent;
  }
}

void World::add_wall_candidates() {
  for (std::size_t body = 0; body < memory_.bounds.size(); ++body) {
    const auto& [bound, travelled_m, movable] = memory_.bounds[body];
    if (movable && reaches_wall(*settings_.enclosure, bound)) {
      memory_.candidates.push_back({{static_cast<std::int32_t>(body), kEnclosure}, bound, bound});
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
         (settings_.tunnelling == Tunnelling::kStopAtEntry &&
          memory_.entries.result.lacked_tests(bodies));
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

void World::prioritise(const StepInput& input) {
  std::vector<MeasuredPair>& pairs = memory_.order;
  measure(memory_.candidates, settings_.schedule, input.viewer, input.fixation, input.region,
          pairs);
  priorities_.raise(pairs, settings_.schedule.persistence_steps);
  put_in_order(pairs);
}

void World::refine(const StepInput& input, WorkMeter& meter) {
  memory_.refined.clear();
  for (const MeasuredPair& pair : memory_.order) {
    begin_refining(pair.scheduled, input);
  }
  StepReport& report = memory_.report;
  const Schedule& schedule = settings_.schedule;
  const WorkDone& work = memory_.refinement.refine(
      memory_.refined.all(), schedule.lists, meter,
      {schedule.traversal, settings_.costs, settings_.contacts, report.work_floor});
  report.work_granted = work.granted;
  report.work_spent = work.spent;
  report.work_floor = work.floor;
  report.work_reserved = work.reserved;
  report.work_peak = work.peak;
  report.list_work = work.by_list;
  if (report.work_granted < report.work_floor) {
    report.degradations |= kFloorOverBudget;
  }
}

void World::begin_refining(const ScheduledPair& pair, const StepInput& input) {
  const auto& [bodies, list] = pair;
  const int greatest = settings_.schedule.lists[at(list)].greatest_level;
  const int capped = level_capped_by_speed(bodies, input.dt_s, greatest);
  const StopReason at_greatest =
      capped < greatest ? StopReason::kCapped : StopReason::kGreatestLevel;
  const bool walls = is_wall(bodies.b);
  RefinedPair& begun = memory_.refined.add();
  begun.bodies = bodies;
  begun.list = list;
  begun.walls = walls ? walls_in_reach(at(bodies.a)) : 1;
  PlacedTree& a = placed_[at(bodies.a)];
  if (walls) {
    begun.refinement.begin(a, *settings_.enclosure, greatest);
  } else {
    begun.refinement.begin(a, placed_[at(bodies.b)], capped, at_greatest);
  }
  const Traversal traversal = settings_.schedule.traversal;
  if (traversal == Traversal::kBestFirst || traversal == Traversal::kVisibleFirst) {
    const auto bound = [this](std::int32_t body) {
      return Sphere{states_[at(body)].pose.position, models_[at(body)].tree->bounding_radius_m()};
    };
    const PairBounds bounds{bodies, bound(bodies.a), bound(walls ? bodies.a : bodies.b)};
    begun.eye_distance_m = (collision_place(bounds) - input.viewer.eye).norm();
    if (traversal == Traversal::kVisibleFirst) {
      begun.acuity = relative_acuity(
          eccentricity_deg(bounds, input.viewer, input.fixation, /*point=*/std::nullopt));
    }
  }
}

int World::walls_in_reach(std::size_t body) const {
  const Sphere all{states_[body].pose.position, placed_[body].reach_m()};
  int count = 0;
  for (int wall = 0; wall < kWallCount; ++wall) {
    count += reach_beyond(*settings_.enclosure, wall, all) >= 0.0 ? 1 : 0;
  }
  return count;
}

MovingTree World::moving(std::size_t body) {
  const BodyModel& model = models_[body];
  const BodyState& state = states_[body];
  return {placed_[body],
          {state.pose.position, velocity(model, state), angular_velocity(model, state)}};
}

void World::model() {
  StepReport& report = memory_.report;
  ModelledCollisions& modelled = memory_.modelled;
  modelled.clear();
  const PriorityMetric* metric = settings_.schedule.metric.get();
  std::size_t place = 0;  // pairs are refined in the order they were put in
  for (const RefinedPair& pair : memory_.refined.all()) {
    const MeasuredPair& measured = memory_.order[place++];
    if (!pair.refinement.overlapping().empty()) {
      add_contacts_of(pair);
      CollisionReport collision;
      collision.list = pair.list;
      collision.level = pair.refinement.level();
      collision.stop = pair.refinement.stop_reason();
      if (metric != nullptr) {
        collision.measured = metric->priority(measured.priority);  // its sign turned back
      }
      modelled.add_contacts_as(collision);
    }
  }
  modelled.report_in_order(report);
  for (CollisionReport& collision : report.collisions) {
    collision.began = touched_before(collision.bodies) == nullptr;
  }
  count_later_phases();
}

void World::add_contacts_of(const RefinedPair& pair) {
  const BodyPair bodies = pair.bodies;
  const PairRefinement& refinement = pair.refinement;
  std::vector<Contact>* watched = watches_node_contacts_ ? &memory_.report.node_contacts : nullptr;
  const MovingTree a = moving(at(bodies.a));
  if (is_wall(bodies.b)) {
    memory_.modelling.add_wall_contacts(bodies.a, refinement, a, *settings_.enclosure,
                                        settings_.contacts, memory_.modelled.contacts(), watched);
    return;
  }
  const MovingTree b = moving(at(bodies.b));
  NormalFallbacks fallbacks{a.motion.centre_of_mass - b.motion.centre_of_mass,
                            b.motion.velocity - a.motion.velocity};
  if (const TouchingPair* before = touched_before(bodies)) {
    fallbacks.last_normal = before->normal;
  }
  memory_.modelling.add_pair_contacts(bodies, refinement, a, b, fallbacks, settings_.contacts,
                                      memory_.modelled.contacts(), watched);
}

void World::count_later_phases() {
  const PhaseCosts costs(settings_.costs, settings_.contacts);
  StepReport& report = memory_.report;
  for (const RefinedPair& pair : memory_.refined.all()) {
    const auto nodes = static_cast<std::int64_t>(pair.refinement.overlapping().size());
    report.work_spent += costs.of_modelling(pair, nodes);
  }
  report.work_spent += costs.of_response(static_cast<std::int64_t>(report.contacts.size()));
}

const ResponseResult& World::response_to_contacts(double dt_s) {
  contacts_to_respond_to(memory_.report, memory_.contacts);
  Restitutions{settings_.restitution, settings_.materials, settings_.wall_material}.find(
      memory_.contacts, models_, memory_.restitutions);
  ResponseRules rules;
  rules.method = settings_.response;
  rules.most_passes = settings_.most_response_passes;
  rules.resting_m_s = kRestingSteps * settings_.gravity_m_s2.norm() * dt_s;
  return memory_.responder.respond(memory_.contacts, memory_.restitutions, rules, models_, states_);
}

void World::respond(double dt_s) {
  StepReport& report = memory_.report;
  touching_.clear();
  for (const CollisionReport& collision : report.collisions) {
    touching_.push_back({collision.bodies, collision.contact.touch.normal});
  }
  const ResponseResult& result = response_to_contacts(dt_s);
  report_response(result, report);
  impositions_.impose(settings_, models_, report.collisions, states_);
  if (result.residual_approach_m_s > 0.0) {
    report.degradations |= kApproachRemains;
  }
  if (!std::all_of(states_.begin(), states_.end(), is_finite)) {
    report.degradations |= kNotFinite;
  }
}

void World::note_touching(const Viewer& viewer) {
  std::vector<BodyPair>& touching = memory_.touching;
  std::vector<TouchingLevel>& levels = memory_.touching_levels;
  touching.clear();
  levels.clear();
  for (const CollisionReport& collision : memory_.report.collisions) {
    touching.push_back(collision.bodies);
    levels.push_back({collision.bodies, collision.level, collision.contact.touch.point});
  }
  priorities_.note_touching(touching);
  levels_.note(levels, models_, viewer, memory_.report.pops);
}

const TouchingPair* World::touched_before(BodyPair bodies) const {
  const auto found = std::lower_bound(touching_.begin(), touching_.end(), bodies,
                                      [](const TouchingPair& pair, const BodyPair& wanted) {
                                        return std::pair(pair.bodies.a, pair.bodies.b) <
                                               std::pair(wanted.a, wanted.b);
                                      });
  return found != touching_.end() && found->bodies == bodies ? &*found : nullptr;
}

}  // namespace impetus
