// SPDX-License-Identifier: MIT
#include "engine/world/world.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "engine/numerics/at.hpp"
#include "engine/scheduling/eccentricity_metric.hpp"
#include "engine/scheduling/relative_acuity.hpp"
#include "engine/world/collision_reports.hpp"
#include "engine/world/world_checks.hpp"

namespace impetus::inline world {
namespace {

void require(bool condition, const char* message) {
  if (!condition) {
    throw std::invalid_argument(message);
  }
}

}  // namespace

World::World(std::vector<BodyModel> models, std::vector<BodyState> states, WorldSettings settings)
    : models_(std::move(models)), states_(std::move(states)), settings_(std::move(settings)) {
  const std::string of_figures = problem_of(settings_.figures, models_);
  for (const std::string& problem : {problem_of(models_, states_), problem_of(settings_),
                                     of_figures.empty() ? of_figures : "world: " + of_figures}) {
    require(problem.empty(), problem.c_str());
  }
  for (BodyModel& body : models_) {
    if (body.inverse_mass == 0.0) {
      body.inverse_inertia.setZero();
    }
    placed_.emplace_back(*body.tree);
  }
  if (!settings_.figures.empty()) {
    figures_ = ValuePointer(Figures(settings_.figures, models_));
    figures_->begin(settings_.figures, states_);
  }
}

void World::set_response(ResponseMethod response) {
  WorldSettings changed = settings_;
  changed.response = response;
  change_settings(std::move(changed));
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

std::int64_t World::nodes_transformed() const {
  std::int64_t count = 0;
  for (const PlacedTree& tree : placed_) {
    count += tree.nodes_transformed();
  }
  return count;
}

const StepReport& World::step(const StepInput& input, WorkMeter& meter) {
  require(input.dt_s >= 0.0 && std::isfinite(input.dt_s),
          "world: expected a time step of 0 s or more, a finite number");
  restart(memory_.report);
  finite_.begin(states_, memory_.report.not_finite);
  move_and_pair(input.dt_s);
  prioritise(input);
  refine(input, meter);
  model(input);
  respond(input.dt_s);
  note_touching(input.viewer);
  hash_state(states_, memory_.report.state);
  return memory_.report;
}

bool World::is_capped_by_speed(BodyPair bodies) const {
  if (is_wall(bodies.b)) {
    return false;
  }
  return settings_.tunnelling == Tunnelling::kCapped ||
         (settings_.tunnelling == Tunnelling::kStopAtEntry &&
          (is_of_figure(bodies) || memory_.entries.result.lacked_tests(bodies)));
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

Measuring World::measuring(const StepInput& input) const {
  return {settings_.schedule, input, models_, states_};
}

void World::prioritise(const StepInput& input) {
  memory_.order.put_into_lists(memory_.candidates, measuring(input));
  priorities_.raise(memory_.order.pairs(), settings_.schedule.persistence_steps);
}

void World::refine(const StepInput& input, WorkMeter& meter) {
  memory_.refined.clear();
  memory_.report.work_floor += folds_work();
  for (const MeasuredPair& pair : memory_.order.pairs()) {
    begin_refining(pair.scheduled, input);
  }
  StepReport& report = memory_.report;
  const Schedule& schedule = settings_.schedule;
  const std::span<RefinedPair> pairs = memory_.refined.all();
  const RefinementSettings settings{schedule.traversal, settings_.costs, settings_.contacts,
                                    report.work_floor};
  const std::size_t waiting = memory_.refinement.do_floor(pairs, schedule.lists, settings);
  const std::span<const std::size_t> order =
      memory_.order.places_by_priority(waiting, measuring(input));
  report_work(memory_.refinement.refine(pairs, schedule.lists, order, meter, settings), report);
  memory_.pairs.clear();
  if (watches_pairs_) {
    memory_.order.list_pairs(measuring(input), memory_.pairs);
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
  begun.hinged = is_of_figure(bodies);
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

void World::model(const StepInput& input) {
  StepReport& report = memory_.report;
  ModelledCollisions& modelled = memory_.modelled;
  modelled.clear();
  const std::span<RefinedPair> pairs = memory_.refined.all();
  for (std::size_t place = 0; place < pairs.size(); ++place) {
    const RefinedPair& pair = pairs[place];
    if (!pair.refinement.overlapping().empty()) {
      add_contacts_of(pair);
      CollisionReport collision;
      collision.list = pair.list;
      collision.level = pair.refinement.level();
      collision.stop = pair.refinement.stop_reason();
      if (settings_.schedule.metric != nullptr) {
        collision.measured = memory_.order.measured(place, measuring(input));
      }
      modelled.add_contacts_as(collision);
    }
  }
  model_folds();
  modelled.report_in_order(report);
  for (CollisionReport& collision : report.collisions) {
    collision.began = touched_before(collision.bodies) == nullptr;
  }
  count_later_phases();
}

/// Neighbours that are folded together: nothing of theirs is refined.
void World::model_folds() {
  if (!figures_) {
    return;
  }
  for (const Contact& fold : figures_->folds()) {
    memory_.modelled.contacts().push_back(fold);
    memory_.modelled.add_contacts_as(CollisionReport{});
  }
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
  auto contacts = static_cast<std::int64_t>(report.contacts.size());
  if (figures_) {
    std::int64_t hinged = 0;
    for (const CollisionReport& collision : report.collisions) {
      hinged += is_of_figure(collision.bodies) ? collision.contact_count : 0;
    }
    contacts -= hinged;
    report.work_spent += costs.of_response(hinged, /*hinged=*/true) - folds_work();
  }
  report.work_spent += costs.of_response(contacts, /*hinged=*/false);
}

/// Of folds, which the floor pays for.
std::int64_t World::folds_work() const {
  if (!figures_) {
    return 0;
  }
  const PhaseCosts costs(settings_.costs, settings_.contacts);
  return costs.of_response(static_cast<std::int64_t>(figures_->folds().size()), /*hinged=*/true);
}

const ResponseResult& World::response_to_contacts(double dt_s) {
  contacts_to_respond_to(memory_.report, memory_.contacts);
  Restitutions{settings_.restitution, settings_.materials, settings_.wall_material}.find(
      memory_.contacts, models_, memory_.restitutions);
  ResponseRules rules;
  rules.method = settings_.response;
  rules.most_passes = settings_.most_response_passes;
  rules.resting_m_s = kRestingSteps * settings_.gravity_m_s2.norm() * dt_s;
  if (figures_) {
    return figures_->respond(settings_.figures, memory_.contacts, memory_.restitutions, rules, dt_s,
                             models_, finite_, states_);
  }
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
  note_not_finite();
}

void World::note_not_finite() {
  StepReport& report = memory_.report;
  for (std::size_t body = 0; body < states_.size(); ++body) {
    finite_.check(body, states_[body], report.not_finite);
  }
  if (finite_.any_out()) {
    report.degradations |= kNotFinite;
  }
}

void World::note_touching(const Viewer& viewer) {
  if (settings_.schedule.persistence_steps > 0) {
    std::vector<BodyPair>& touching = memory_.touching;
    touching.clear();
    for (const TouchingPair& pair : touching_) {
      touching.push_back(pair.bodies);
    }
    priorities_.note_touching(touching);
  }
  std::vector<TouchingLevel>& levels = memory_.touching_levels;
  levels.clear();
  for (const CollisionReport& collision : memory_.report.collisions) {
    levels.push_back({collision.bodies, collision.level, collision.contact.touch.point});
  }
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

}  // namespace impetus::inline world
