// SPDX-License-Identifier: MIT
#include "engine/world/world.hpp"

#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "engine/figures/as_one_body.hpp"
#include "engine/world/phases.hpp"

namespace impetus::inline world {
namespace {

void require(bool condition, const char* message) {
  if (!condition) {
    throw std::invalid_argument(message);
  }
}

/// Forgets what `report` said, and keeps its memory.
void restart(StepReport& report) {
  StepReport fresh;
  const auto keep = [](auto& memory, auto& empty) {
    memory.clear();
    empty.swap(memory);
  };
  keep(report.collisions, fresh.collisions);
  keep(report.list_work, fresh.list_work);
  keep(report.state.bodies, fresh.state.bodies);
  keep(report.contacts, fresh.contacts);
  keep(report.pops, fresh.pops);
  keep(report.stopped, fresh.stopped);
  keep(report.node_contacts, fresh.node_contacts);
  keep(report.not_finite, fresh.not_finite);
  report = std::move(fresh);
}

}  // namespace

World::World(std::vector<BodyModel> models, std::vector<BodyState> states, WorldSettings settings)
    : settings_(std::move(settings)), state_(std::move(models), std::move(states), settings_) {}

const StepReport& World::step(const StepInput& input, WorkMeter& meter) {
  require(input.dt_s >= 0.0 && std::isfinite(input.dt_s),
          "world: expected a time step of 0 s or more, a finite number");
  restart(memory_.report);
  const Step step{settings_, input, state_, memory_, meter};
  move_bodies(step);
  pair_bodies(step);
  prioritise_pairs(step);
  refine_pairs(step);
  model_contacts(step);
  respond_to_contacts(step);
  remember_contacts(step);
  meter.finish();
  return memory_.report;
}

template <typename Value>
void World::change(Value WorldSettings::*setting, Value value) {
  WorldSettings changed = settings_;
  changed.*setting = std::move(value);
  const std::string problem = problem_of(changed);
  require(problem.empty(), problem.c_str());
  settings_ = std::move(changed);
}

void World::set_response(ResponseMethod response) { change(&WorldSettings::response, response); }

void World::set_schedule(Schedule schedule) {
  change(&WorldSettings::schedule, std::move(schedule));
}

void World::set_contacts(ContactModel contacts) {
  change(&WorldSettings::contacts, std::move(contacts));
}

void World::set_costs(const WorkCosts& costs) { change(&WorldSettings::costs, costs); }

void World::set_recording_format(int format) { change(&WorldSettings::recording_format, format); }

double World::kinetic_energy_J() const { return kinetic_energy(models(), states()); }

std::int64_t World::nodes_transformed() const {
  std::int64_t count = 0;
  for (const PlacedTree& tree : state_.placed) {
    count += tree.nodes_transformed();
  }
  return count;
}

}  // namespace impetus::inline world
