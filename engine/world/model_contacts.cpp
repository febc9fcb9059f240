// The fifth phase of a step: overlapping nodes become a few contacts of each pair, and are
// reported.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>

#include "engine/numerics/at.hpp"
#include "engine/world/phases.hpp"

namespace impetus::inline world {
namespace {

bool comes_first(const CollisionReport& x, const CollisionReport& y) {
  return std::pair(x.bodies.a, x.bodies.b) < std::pair(y.bodies.a, y.bodies.b);
}

bool is_shallower(const Contact& x, const Contact& y) { return x.touch.depth_m < y.touch.depth_m; }

/// Its spin is found where the reduction goes by when nodes met.
MovingTree moving_tree(const Step& step, std::int32_t body) {
  const BodyModel& model = step.world.models[at(body)];
  const BodyState& state = step.world.states[at(body)];
  BodyMotion motion{state.pose.position, velocity(model, state)};
  if ((reduction_of(step.settings.contacts).terms() & kEntryTerm) != 0) {
    motion.spin = angular_velocity(model, state);
  }
  return {step.world.placed[at(body)], motion};
}

void add_contacts(const Step& step, const RefinedPair& pair) {
  const BodyPair bodies = pair.bodies;
  const PairRefinement& refinement = pair.refinement;
  StepMemory& memory = step.memory;
  std::vector<Contact>* watched =
      step.world.watches_node_contacts ? &memory.report.node_contacts : nullptr;
  const MovingTree a = moving_tree(step, bodies.a);
  if (is_wall(bodies.b)) {
    memory.modelling.add_wall_contacts(bodies.a, refinement, a, *step.settings.enclosure,
                                       step.settings.contacts, memory.modelled.contacts(), watched);
    return;
  }
  const MovingTree b = moving_tree(step, bodies.b);
  NormalFallbacks fallbacks{a.motion.centre_of_mass - b.motion.centre_of_mass,
                            b.motion.velocity - a.motion.velocity};
  if (const TouchingPair* before = step.world.touched_before(bodies)) {
    fallbacks.last_normal = before->normal;
  }
  memory.modelling.add_pair_contacts(bodies, refinement, a, b, fallbacks, step.settings.contacts,
                                     memory.modelled.contacts(), watched);
}

void model_pair(const Step& step, std::size_t place, const RefinedPair& pair) {
  const Schedule& schedule = step.settings.schedule;
  add_contacts(step, pair);
  CollisionReport collision;
  collision.list = pair.list;
  collision.level = pair.refinement.level();
  collision.stop = pair.refinement.stop_reason();
  if (schedule.metric != nullptr) {
    collision.measured = step.memory.order.measured(
        place, {schedule, step.input, step.world.models, step.world.states});
  }
  step.memory.modelled.add_contacts_as(collision);
}

/// Neighbours that are folded together: nothing of theirs is refined.
void model_folds(const Step& step) {
  if (!step.world.figures) {
    return;
  }
  for (const Contact& fold : step.world.figures->folds()) {
    step.memory.modelled.contacts().push_back(fold);
    step.memory.modelled.add_contacts_as(CollisionReport{});
  }
}

/// What it takes to model a pair, beside an overlapping pair of nodes.
constexpr std::int64_t kPairUnits = 12;

std::int64_t units_of(const RefinedPair& pair) {
  const auto nodes = static_cast<std::int64_t>(pair.refinement.overlapping().size());
  return nodes == 0 ? 0 : nodes + kPairUnits;
}

bool touches(const RefinedPair& pair) { return !pair.refinement.overlapping().empty(); }

void model_all(const Step& step, std::span<const RefinedPair> pairs) {
  for (std::size_t place = 0; place < pairs.size(); ++place) {
    if (touches(pairs[place])) {
      model_pair(step, place, pairs[place]);
    }
  }
}

/// Those with walls, and of the others those that are granted, the most urgent first. Nothing is
/// put in order where what is granted is not enough for a pair.
void model_most_urgent(const Step& step, std::span<const RefinedPair> pairs, PhaseWork& work) {
  StepReport& report = step.memory.report;
  report.degradations |= kContactsLeft;
  for (std::size_t place = 0; place < pairs.size(); ++place) {
    const RefinedPair& pair = pairs[place];
    if (is_wall(pair.bodies.b) && touches(pair)) {
      model_pair(step, place, pair);
    }
    report.contacts_left += !is_wall(pair.bodies.b) && touches(pair) ? 1 : 0;
  }
  if (work.granted() <= kPairUnits) {
    return;
  }
  for (const std::size_t place : step.memory.order.all_places_by_priority(
           {step.settings.schedule, step.input, step.world.models, step.world.states})) {
    const RefinedPair& pair = pairs[place];
    if (!is_wall(pair.bodies.b) && touches(pair) && work.spend(units_of(pair))) {
      model_pair(step, place, pair);
      --report.contacts_left;
    }
  }
}

void model_pairs(const Step& step) {
  const std::span<const RefinedPair> pairs = step.memory.refined.all();
  std::int64_t at_walls = 0;
  std::int64_t units = 0;
  for (const RefinedPair& pair : pairs) {
    at_walls += is_wall(pair.bodies.b) && touches(pair) ? 1 : 0;
    units += is_wall(pair.bodies.b) ? 0 : units_of(pair);
  }
  step.meter.begin(StepPart::kModel, at_walls);
  PhaseWork work = step.work_of(WorkPhase::kModel);
  if (work.spend(units)) {
    model_all(step, pairs);
  } else {
    model_most_urgent(step, pairs, work);
  }
}

/// Of modelling, which is done, and of the response, which follows.
void count_later_phases(const Step& step) {
  const PhaseCosts costs(step.settings.costs, step.settings.contacts);
  StepReport& report = step.memory.report;
  for (const RefinedPair& pair : step.memory.refined.all()) {
    const auto nodes = static_cast<std::int64_t>(pair.refinement.overlapping().size());
    report.work_spent += costs.of_modelling(pair, nodes);
  }
  auto contacts = static_cast<std::int64_t>(report.contacts.size());
  if (step.world.figures) {
    std::int64_t hinged = 0;
    for (const CollisionReport& collision : report.collisions) {
      hinged += step.world.is_of_figure(collision.bodies) ? collision.contact_count : 0;
    }
    contacts -= hinged;
    report.work_spent += costs.of_response(hinged, /*hinged=*/true) - step.memory.work_of_folds;
  }
  report.work_spent += costs.of_response(contacts, /*hinged=*/false);
}

}  // namespace

void ModelledCollisions::clear() {
  collisions_.clear();
  contacts_.clear();
  taken_ = 0;
}

void ModelledCollisions::add_contacts_as(const CollisionReport& like) {
  for (; taken_ < contacts_.size(); ++taken_) {
    const BodyPair& bodies = contacts_[taken_].bodies;
    if (taken_ == 0 || !(bodies == contacts_[taken_ - 1].bodies)) {
      collisions_.push_back(like);
      collisions_.back().bodies = bodies;
      collisions_.back().first_contact = static_cast<std::int32_t>(taken_);
      collisions_.back().contact_count = 0;
    }
    ++collisions_.back().contact_count;
  }
}

void ModelledCollisions::report_in_order(StepReport& report) {
  order_.resize(collisions_.size());
  std::iota(order_.begin(), order_.end(), std::size_t{0});
  std::sort(order_.begin(), order_.end(), [&](std::size_t x, std::size_t y) {
    return comes_first(collisions_[x], collisions_[y]);
  });
  for (const std::size_t place : order_) {
    CollisionReport& each = collisions_[place];
    const auto first = contacts_.begin() + each.first_contact;
    const auto end = first + each.contact_count;
    each.contact = *std::max_element(first, end, is_shallower);
    each.first_contact = static_cast<std::int32_t>(report.contacts.size());
    report.collisions.push_back(each);
    for (auto contact = first; contact != end; ++contact) {
      report.contacts.push_back({contact->touch});
    }
  }
}

void model_contacts(const Step& step) {
  ModelledCollisions& modelled = step.memory.modelled;
  modelled.clear();
  model_pairs(step);
  model_folds(step);
  modelled.report_in_order(step.memory.report);
  for (CollisionReport& collision : step.memory.report.collisions) {
    collision.began = step.world.touched_before(collision.bodies) == nullptr;
  }
  count_later_phases(step);
}

}  // namespace impetus::inline world
