// Scenes as users write them, drawn at random: whatever they ask for and whatever is cut of their
// steps, no step gains energy, nobody leaves the walls, and the same grants give the same bits.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <string>

#include "engine/numerics/random_stream.hpp"
#include "experiments/protocol/checked_scene.hpp"
#include "experiments/scenes/scene_enclosure.hpp"
#include "tests/engine/builders.hpp"
#include "tests/experiments/test_scenes.hpp"

namespace impetus::random_scenes_test {

constexpr std::uint64_t kSeed = 42;
constexpr int kScenes = 400;
constexpr int kSteps = 120;

/// Draws what a scene says.
class SceneDraw {
 public:
  explicit SceneDraw(std::uint64_t number)
      : random_(kSeed, "scene " + std::to_string(number)),
        of_walls_(kSeed, "walls of scene " + std::to_string(number)) {}

  json scene() {
    json scene = {{"$schema", "scene.schema.json"}, {"schema_version", 1}, {"title", "drawn"}};
    scene["engine"] = engine();
    scene["viewer"] = {{"azimuth_deg", 0}};
    scene["duration_s"] = 5;
    scene["enclosure"] = walls_or_cube(between(5, 40));
    json who = {{"density_kg_m3", between(100, 8000)},
                {"colours", {"#d9813b"}},
                {"speed_deg_s", between(0.1, 300)}};
    if (chance(0.25)) {
      who.update({{"figure", "humanoid.json"},
                  {"count", one_of({1, 2, 4})},
                  {"height_deg", 6},
                  {"spin_deg_s", between(1, 500)}});
      scene["figure_crowd"] = who;
    } else {
      who.update({{"count", static_cast<int>(between(2, 60))},
                  {"shape", shape()},
                  {"spin_deg_s", chance(0.3) ? 0.0 : between(1, 2000)}});
      scene["crowd"] = who;
    }
    return scene;
  }

  /// Half of the time all that is asked for; else some phases get a few units.
  WorkGrants grants() {
    WorkGrants grants;
    if (chance(0.5)) {
      for (std::int64_t& units : grants.units) {
        units = chance(0.4) ? static_cast<std::int64_t>(between(1, 1e5)) - 1 : units;
      }
    }
    return grants;
  }

 private:
  bool chance(double share) { return random_.uniform() < share; }
  /// Evenly by their logarithms.
  double between(double least, double most) {
    return least * std::exp(random_.uniform() * std::log(most / least));
  }
  template <typename T>
  T one_of(std::initializer_list<T> values) {
    return values.begin()[random_.place_below(values.size())];
  }

  json shape() {
    return one_of<json>(
        {{{"kind", "sphere"}, {"radius_deg", between(0.2, 3)}},
         {{"kind", "l-block"}, {"arm_deg", 2}, {"thickness_deg", 0.7}},
         {{"kind", "creature"}, {"length_deg", 2}},
         {{"kind", "box"}, {"width_deg", 2}, {"height_deg", 1}, {"depth_deg", 0.7}},
         {{"kind", "plate"}, {"width_deg", 2}, {"height_deg", 1}, {"thickness_deg", 0.2}}});
  }

  /// What is seen of a depth about as large, in three of ten.
  json walls_or_cube(double edge_deg) {
    if (of_walls_.uniform() < 0.3) {
      const double front = of_walls_.uniform();
      return {{"kind", "view-frustum"},
              {"front_deg", front * edge_deg},
              {"back_deg", (1.0 - front) * edge_deg + 1.0}};
    }
    return {{"edge_deg", edge_deg}};
  }

  json engine() {
    json engine = {{"step_hz", one_of({30, 60, 120, 240})},
                   {"restitution", one_of({0.0, 0.5, 1.0, random_.uniform()})},
                   {"rotation", "energy-kept"},
                   {"tree_depth", one_of({0, 1, 2})},
                   {"tree", {{"kind", one_of({"octree", "voxel", "box"})}}},
                   {"tunnelling", one_of({"ignored", "capped", "stop-at-entry"})},
                   {"response", one_of({"in-turn", "together"})}};
    if (chance(0.7)) {
      engine["contacts"] = {
          {"reduction", one_of({"none", "first", "average", "groups", "density", "weighted"})},
          {"most_per_pair", one_of({1, 2, 4, 16})}};
    }
    if (chance(0.3)) {
      engine["response_passes"] = static_cast<int>(between(1, 100));
    }
    if (chance(0.4)) {
      engine["gravity_m_s2"] = {chance(0.3) ? 2.0 : 0.0, -between(0.1, 20), 0.0};
    }
    if (chance(0.5)) {
      engine["schedule"] = {
          {"scheduler", one_of({"eccentricity", "distance", "perceived", "size"})},
          {"traversal", one_of({"depth-first", "breadth-first", "best-first", "visible-first"})},
          {"persistence_ms", one_of({0, 100, 500})},
          {"pair_shares", {0.3}},
          {"lists", {{{"share", 3}}, {{"share", 1}, {"greatest_level", 0}}}}};
    }
    return engine;
  }

  RandomStream random_;
  RandomStream of_walls_;
};

/// Kinetic, and potential where there is gravity (J).
double energy_J(const World& world) {
  double sum = 0.0;
  for (std::size_t body = 0; body < world.states().size(); ++body) {
    const BodyModel& model = world.models()[body];
    sum +=
        kinetic_energy(model, world.states()[body]) -
        world.settings().gravity_m_s2.dot(world.states()[body].pose.position) / model.inverse_mass;
  }
  return sum;
}

/// What a step may give at most to all that is supported in it (motion.hpp).
double supported_J(const World& world, double dt_s) {
  double mass_kg = 0.0;
  for (const BodyModel& model : world.models()) {
    mass_kg += 1.0 / model.inverse_mass;
  }
  return (kRestingSteps + 0.5) * mass_kg * world.settings().gravity_m_s2.squaredNorm() * dt_s *
         dt_s;
}

/// How far any body's centre goes at most in the step that follows (metres).
double way_m(const World& world, double dt_s) {
  double farthest_m = 0.0;
  for (std::size_t body = 0; body < world.states().size(); ++body) {
    farthest_m =
        std::max(farthest_m, dt_s * velocity(world.models()[body], world.states()[body]).norm() +
                                 dt_s * dt_s * world.settings().gravity_m_s2.norm());
  }
  return farthest_m;
}

/// Steps the scene twice, side by side.
void expect_promises_kept(SceneDraw& draw, StagedScene& staged) {
  World& world = staged.world;
  World again = world;
  const double dt_s = 1.0 / staged.step_hz;
  double longest_way_m = 0.0;
  bool was_cut = false;
  for (int step = 1; step <= kSteps; ++step) {
    const double before_J = energy_J(world);
    longest_way_m = std::max(longest_way_m, way_m(world, dt_s));
    const WorkGrants grants = draw.grants();
    FixedWork meter(grants);
    FixedWork same(grants);
    StepInput input;
    input.dt_s = dt_s;
    input.viewer = staged.viewer_at_time(step * dt_s);
    const StepReport& report = world.step(input, meter);
    ASSERT_EQ(report.degradations & kNotFinite, 0U) << "step " << step;
    ASSERT_EQ(again.step(input, same).state.hash, report.state.hash) << "step " << step;
    const double rounding_J = 1e-9 * std::abs(before_J);
    ASSERT_LE(energy_J(world), before_J + supported_J(world, dt_s) + rounding_J) << "step " << step;
    was_cut |= report.grants.cut_beyond_refinement();
    const bool may_lean_out = !world.settings().figures.empty() &&
                              (!was_cut || !world.settings().gravity_m_s2.isZero(0.0));
    const double most_out_m = may_lean_out ? longest_way_m : 0.0;
    ASSERT_LE(farthest_outside_m(world), most_out_m + 1e-9) << "step " << step;
  }
}

TEST(RandomScenesSlow, GainNoEnergyKeepEverybodyWithinTheWallsAndGiveTheSameBitsAgain) {
  const TemporaryFolder folder;
  folder.write("humanoid.json", shipped("stimuli/humanoid.json"));
  folder.write("head.obj", shipped("stimuli/head.obj"));
  ShapeLibrary shapes;
  int stepped = 0;
  for (int number = 0; number < kScenes; ++number) {
    SceneDraw draw(static_cast<std::uint64_t>(number));
    const json drawn = draw.scene();
    SCOPED_TRACE("scene " + std::to_string(number) + ": " + drawn.dump());
    try {
      const JsonDocument scene = load_scene(folder.write("scene.json", drawn.dump()));
      require_scene(scene, shapes);
      StagedScene staged = build_scene(scene.value, assumed_screen(), 0.0, shapes);
      expect_promises_kept(draw, staged);
      ++stepped;
    } catch (const InputError&) {  // too many for their cube, or together with figures
    }
    ASSERT_FALSE(HasFatalFailure());
  }
  EXPECT_GT(stepped, kScenes / 2);
}

}  // namespace impetus::random_scenes_test
