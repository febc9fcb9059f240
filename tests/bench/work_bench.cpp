// What the phases cost beside the test of two spheres: the ratios behind kAllPhases
// (engine/scheduling/work_costs.hpp). Run alone, the ratios of one run are compared.
// SPDX-License-Identifier: MIT
#include <benchmark/benchmark.h>

#include "engine/collision/contact_model.hpp"
#include "tests/engine/crowds.hpp"
#include "tests/engine/once.hpp"

namespace impetus {
namespace {

/// Trees of one kind, two bodies that lie in each other.
struct Touching {
  explicit Touching(std::size_t kind)
      : model(bodies_of_every_tree_kind()[kind]), a(*model.tree), b(*model.tree) {
    RandomStream random(1, "turn");
    pose.position = Vector3(0.02, 0.01, 0.0);
    pose.orientation = random_turn(random);
    b.move_to(pose);
  }
  BodyModel model;
  Pose pose;
  PlacedTree a;
  PlacedTree b;
};

const char* name_of_kind(std::int64_t kind) {
  constexpr std::array kNames{"spheres", "voxels", "boxes", "lines", "rectangles", "mixed"};
  return kNames[static_cast<std::size_t>(kind)];
}

/// Time per node-pair test of a whole descent, its bookkeeping and placing of nodes included.
void test_of_nodes(benchmark::State& state) {
  Touching pair(static_cast<std::size_t>(state.range(0)));
  std::int64_t tests = 0;
  for (auto unused : state) {
    pair.b.move_to(pair.pose);
    pair.a.move_to({});
    PairRefinement refinement(pair.a, pair.b);
    ++tests;
    while (!refinement.resolved()) {
      tests += refinement.next_block();
      refinement.refine_one_block();
    }
    benchmark::DoNotOptimize(refinement.overlapping().size());
  }
  state.SetLabel(name_of_kind(state.range(0)));
  state.SetItemsProcessed(tests);
}
BENCHMARK(test_of_nodes)->DenseRange(0, 5);

/// Time per node of a tree against the walls.
void test_of_walls(benchmark::State& state) {
  Touching pair(static_cast<std::size_t>(state.range(0)));
  const Enclosure walls{ClosedCube{0.03}};
  std::int64_t tests = 0;
  for (auto unused : state) {
    pair.a.move_to({});
    PairRefinement refinement(pair.a, walls);
    ++tests;
    while (!refinement.resolved()) {
      tests += refinement.next_block();
      refinement.refine_one_block();
    }
  }
  state.SetLabel(name_of_kind(state.range(0)));
  state.SetItemsProcessed(tests);
}
BENCHMARK(test_of_walls)->DenseRange(0, 5);

/// Time per overlapping pair of nodes that is made a contact and averaged.
void modelling_of_nodes(benchmark::State& state) {
  Touching pair(static_cast<std::size_t>(state.range(0)));
  PairRefinement refinement(pair.a, pair.b);
  while (!refinement.resolved()) {
    refinement.refine_one_block();
  }
  for (auto unused : state) {
    benchmark::DoNotOptimize(
        pair_contacts({0, 1}, refinement, {pair.a}, {pair.b}, {}, ContactModel{}));
  }
  state.SetLabel(name_of_kind(state.range(0)));
  state.SetItemsProcessed(state.iterations() *
                          static_cast<std::int64_t>(refinement.overlapping().size()));
}
BENCHMARK(modelling_of_nodes)->DenseRange(0, 5);

/// Time per contact of an island: a row of balls, each touching the next at four points.
void response_to_contacts(benchmark::State& state) {
  const auto balls = static_cast<std::int32_t>(state.range(0));
  const bool together = state.range(1) != 0;
  RandomStream random(2, "row");
  const std::vector<BodyModel> models(static_cast<std::size_t>(balls), ball(0.1, 1.0));
  std::vector<BodyState> states;
  std::vector<Contact> contacts;
  for (std::int32_t i = 0; i < balls; ++i) {
    states.push_back(moving(models[0], {0.2 * i, 0.0, 0.0}, random_in_cube(random, 1.0)));
    for (int point = 0; i > 0 && point < 4; ++point) {
      Contact contact;
      contact.bodies = {i - 1, i};
      contact.touch.normal = -(Vector3::UnitX() + random_in_cube(random, 0.2)).normalized();
      contact.touch.point = Vector3(0.2 * i - 0.1, 0.0, 0.0) + random_in_cube(random, 0.03);
      contacts.push_back(contact);
    }
  }
  const std::vector<double> restitutions(contacts.size(), 0.5);
  for (auto unused : state) {
    std::vector<BodyState> changed = states;
    benchmark::DoNotOptimize(together ? respond_together(contacts, restitutions, models, changed)
                                      : respond(contacts, 0.5, models, changed));
  }
  state.SetLabel(std::to_string(contacts.size()) + (together ? " together" : " in turn"));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(contacts.size()));
}
BENCHMARK(response_to_contacts)->ArgsProduct({{2, 3, 5, 9, 17}, {0, 1}});

}  // namespace
}  // namespace impetus
