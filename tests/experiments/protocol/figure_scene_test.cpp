// Figures of scenes and the worlds they become: parts, hinges, starts, motions, crowds.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/volumes/volume.hpp"
#include "experiments/files/scene_files.hpp"
#include "experiments/protocol/checked_scene.hpp"
#include "experiments/protocol/protocol_scenes.hpp"
#include "experiments/scenes/figures/scene_figures.hpp"
#include "tests/experiments/figure_scenes.hpp"

namespace impetus::figure_scene_test {

constexpr double kPi = std::numbers::pi;

double radians_of(double degrees_) { return degrees_ * kPi / 180.0; }

const Figure& figure_of(const StagedScene& scene, std::size_t index = 0) {
  return scene.world.settings().figures.at(index);
}

std::vector<Pose> poses_in(const StagedScene& scene, const Figure& figure) {
  std::vector<Pose> poses;
  for (std::int32_t part = 0; part < figure.part_count; ++part) {
    poses.push_back(scene.world.states()[static_cast<std::size_t>(figure.first_part + part)].pose);
  }
  return poses;
}

TEST(FigureScene, PartsAreBodiesNamedForTheFigureAfterTheNamedBodies) {
  json scene = doll_scene();
  scene["bodies"] = json::array({free_scene()["bodies"][0]});
  scene["bodies"][0]["position_deg"] = {-20, 0, 0};
  EXPECT_EQ(scene_refusal(scene), "accepted");
  const StagedScene staged = built(scene);
  std::vector<std::string> names;
  for (const BodyModel& model : staged.world.models()) {
    names.push_back(model.name);
  }
  EXPECT_EQ(names, (std::vector<std::string>{"ball", "anna/trunk", "anna/arm", "anna/forearm"}));
  EXPECT_EQ(figure_of(staged).first_part, 1);
  EXPECT_EQ(figure_of(staged).part_count, 3);
  EXPECT_EQ(staged.looks[1].colour, (std::array{0.0F, 0.0F, 1.0F})) << "the trunk's, number 1";
  EXPECT_EQ(staged.looks[2].colour, (std::array{1.0F, 0.0F, 0.0F}));
}

TEST(FigureScene, LengthsAreSharesOfTheHeight) {
  const StagedScene staged = built(doll_scene());
  const Volume trunk = staged.world.models()[0].tree->volume(0);
  ASSERT_TRUE(std::holds_alternative<RectangleSwept>(trunk));
  EXPECT_NEAR(std::get<RectangleSwept>(trunk).half_u.x(), metres_of(1.0), 1e-12);
  EXPECT_NEAR(std::get<RectangleSwept>(trunk).half_v.y(), metres_of(2.0), 1e-12);
  EXPECT_NEAR(std::get<RectangleSwept>(trunk).radius_m, metres_of(1.0), 1e-10);
  EXPECT_NEAR(staged.looks[2].radius_m, metres_of(0.5), 1e-12);
}

TEST(FigureScene, HingesHaveTheFilesAnchorsAxesAndAngles) {
  const Figure figure = figure_of(built(doll_scene()));
  ASSERT_EQ(figure.hinges.size(), 2U);
  const Hinge& shoulder = figure.hinges[0];
  EXPECT_EQ(shoulder.child, 1);
  EXPECT_EQ(shoulder.parent, 0);
  EXPECT_LT((shoulder.of_parent.anchor - metres_of(10.0) * Vector3(0.3, 0.2, 0.0)).norm(), 1e-12);
  EXPECT_LT((shoulder.of_child.anchor - metres_of(10.0) * Vector3(0.0, 0.1, 0.0)).norm(), 1e-12);
  EXPECT_EQ(shoulder.of_parent.axis, Vector3::UnitZ());
  EXPECT_EQ(shoulder.of_child.axis, Vector3::UnitZ());
  EXPECT_EQ(shoulder.of_child.zero, shoulder.of_parent.zero) << "frames are alike at 0 degrees";
  EXPECT_EQ(shoulder.of_parent.core, -Vector3::UnitY()) << "as the file says";
  EXPECT_EQ(shoulder.of_child.core, -Vector3::UnitY()) << "from the anchor to the centre";
  EXPECT_NEAR(shoulder.rest_rad, radians_of(30.0), 1e-15);
  EXPECT_NEAR(shoulder.least_rad, radians_of(-10.0), 1e-15);
  EXPECT_NEAR(shoulder.most_rad, radians_of(170.0), 1e-15);
  EXPECT_NEAR(shoulder.fold_rad, radians_of(40.0), 1e-15);
  EXPECT_FALSE(figure.hinges[1].is_limited());
  EXPECT_TRUE(std::isinf(figure.hinges[1].fold_rad));
}

TEST(FigureScene, AFigureStartsAtTheAnglesThatTheSceneSaysAndAtRestElse) {
  for (const double asked_deg : {-5.0, 30.0, 90.0}) {
    json scene = doll_scene();
    scene["figures"][0]["orientation"] = json::parse(R"([{"axis": "x", "angle_deg": 40}])");
    if (asked_deg != 30.0) {
      scene["figures"][0]["angles_deg"] = {{"shoulder", asked_deg}};
    }
    const StagedScene staged = built(scene);
    const Figure& figure = figure_of(staged);
    const std::vector<Pose> poses = poses_in(staged, figure);
    EXPECT_LT((poses[0].position - metres_of(1.0) * Vector3(1.0, 2.0, 3.0)).norm(), 1e-12);
    EXPECT_NEAR(angle_of(figure.hinges[0], poses[1], poses[0]), radians_of(asked_deg), 1e-12);
    EXPECT_NEAR(angle_of(figure.hinges[1], poses[2], poses[1]), 0.0, 1e-12);
    EXPECT_LT(anchor_gap_m(figure.hinges[0], poses[1], poses[0]), 1e-15);
    EXPECT_LT(anchor_gap_m(figure.hinges[1], poses[2], poses[1]), 1e-15);
  }
}

// v of a part = v of the root + ω × (its centre − the root's)
TEST(FigureScene, AFreeFigureStartsAsOneRigidBody) {
  json scene = doll_scene();
  scene["figures"][0]["velocity_deg_s"] = {3, 0, 0};
  scene["figures"][0]["spin_deg_s"] = {0, 0, 90};
  const StagedScene staged = built(scene);
  const Vector3 root = staged.world.states()[0].pose.position;
  for (std::size_t part = 0; part < 3; ++part) {
    const BodyModel& model = staged.world.models()[part];
    const BodyState& state = staged.world.states()[part];
    const Vector3 spin(0.0, 0.0, kPi / 2.0);
    const Vector3 expected =
        metres_of(3.0) * Vector3::UnitX() + spin.cross(state.pose.position - root);
    EXPECT_LT((velocity(model, state) - expected).norm(), 1e-12);
    EXPECT_LT((angular_velocity(model, state) - spin).norm(), 1e-12);
  }
  EXPECT_FALSE(figure_of(staged).driven.has_value());
}

// angle = middle + amplitude sin(2π (cycles t / period + phase))
TEST(FigureScene, AMotionDrivesItsJointsAndLeavesTheOthersWhereTheSceneHasThem) {
  json scene = doll_scene();
  scene["figures"][0]["motion"] = "flap";
  scene["figures"][0]["path_deg_s"] = {2, 0, 0};
  scene["figures"][0]["angles_deg"] = {{"elbow", 15}};
  EXPECT_EQ(scene_refusal(scene), "accepted");
  const StagedScene staged = built(scene);
  const JointMotion motion = *figure_of(staged).driven;
  for (const double time_s : {0.0, 0.3, 1.7}) {
    const double expected_deg = 60.0 + 20.0 * std::sin(2.0 * kPi * (3.0 * time_s / 2.0 + 0.25));
    EXPECT_NEAR(joint_angle(motion, 0, time_s), radians_of(expected_deg), 1e-12);
    EXPECT_NEAR(joint_angle(motion, 1, time_s), radians_of(15.0), 1e-15);
  }
  EXPECT_LT((motion.root.bob_m - metres_of(1.0) * Vector3::UnitY()).norm(), 1e-12);
  EXPECT_LT((motion.root.velocity_m_s - metres_of(2.0) * Vector3::UnitX()).norm(), 1e-12);
  EXPECT_LT((motion.root.spin_rad_s - 0.5 * kPi * Vector3::UnitY()).norm(), 1e-15);
  const std::vector<Pose> poses = poses_in(staged, figure_of(staged));
  EXPECT_NEAR(angle_of(figure_of(staged).hinges[0], poses[1], poses[0]), radians_of(80.0), 1e-12);
}

TEST(FigureScene, RecordedKeysArePassedAtTheirTimes) {
  const StagedScene staged = built(changed(doll_scene(), "/figures/0/motion", "recorded"));
  const JointMotion motion = *figure_of(staged).driven;
  EXPECT_TRUE(motion.repeats);
  EXPECT_NEAR(joint_angle(motion, 0, 0.0), radians_of(10.0), 1e-15);
  EXPECT_NEAR(joint_angle(motion, 0, 3.0), radians_of(50.0), 1e-15);
  EXPECT_NEAR(joint_angle(motion, 1, 1.0), radians_of(20.0), 1e-15);
  EXPECT_NEAR(joint_angle(motion, 1, 2.0), 0.0, 1e-15) << "at rest where a key has no angle";
}

TEST(FigureScene, SelfCollisionIsAsTheSceneSays) {
  EXPECT_TRUE(figure_of(built(doll_scene())).self_collision.others);
  EXPECT_TRUE(figure_of(built(doll_scene())).self_collision.neighbours);
  const json off = json::parse(R"({"others": false, "neighbours": false})");
  const StagedScene staged = built(changed(doll_scene(), "/figures/0/self_collision", off));
  EXPECT_FALSE(figure_of(staged).self_collision.others);
  EXPECT_FALSE(figure_of(staged).self_collision.neighbours);
}

TEST(FigureScene, TreesAreAsDeepAsPartsAskAndTheEngineAllows) {
  json scene = doll_scene();
  const auto levels = [&](std::size_t part) {
    return built(scene).world.models()[part].tree->level_count();
  };
  EXPECT_EQ(levels(0), 1) << "a swept volume is its own tree";
  scene["figures"][0]["coarsest"] = "sphere";
  EXPECT_EQ(levels(0), 2);
  scene["figure_files"]["doll.json"]["parts"][0]["shape"]["deeper"] = true;
  EXPECT_EQ(levels(0), 3) << "tree_depth 2";
  scene["figure_files"]["doll.json"]["parts"][1]["tree"] = {{"kind", "swept"}, {"depth", 1}};
  EXPECT_EQ(levels(1), 2) << "its own depth of 1";
  EXPECT_EQ(levels(2), 1) << "a sphere needs none";
}

TEST(FigureScene, TheShippedHumanoidStandsWithSixteenPartsApartAndUnfolded) {
  EXPECT_EQ(scene_refusal(humanoid_scene()), "accepted");
  const StagedScene staged = built(humanoid_scene());
  EXPECT_EQ(staged.world.models().size(), 16U);
  Eigen::AlignedBox3d bounds;
  for (std::size_t part = 0; part < 16; ++part) {
    for (const Vector3& vertex : staged.looks[part].mesh->vertices) {
      bounds.extend(staged.world.states()[part].pose.transform(vertex));
    }
  }
  EXPECT_NEAR(bounds.sizes().y(), metres_of(10.0), 0.02 * metres_of(10.0)) << "as high as it says";
}

TEST(FigureScene, EveryMotionOfTheShippedHumanoidIsAccepted) {
  const json motions = json::parse(shipped("stimuli/humanoid.json"))["motions"];
  std::vector<std::string> names;
  for (auto motion = motions.begin(); motion != motions.end(); ++motion) {
    names.push_back(motion.key());
    EXPECT_EQ(scene_refusal(changed(humanoid_scene(), "/figures/0/motion", motion.key())),
              "accepted");
  }
  EXPECT_EQ(names, (std::vector<std::string>{"tumble", "walk", "wave"}));
}

/// Parts of one figure that may collide and do, and of several.
int overlapping_parts(const StagedScene& scene) {
  const auto& figures = scene.world.settings().figures;
  const auto& models = scene.world.models();
  const auto bound = [&](std::size_t body) {
    return placed(models[body].tree->volume(0), scene.world.states()[body].pose);
  };
  int found = 0;
  for (std::size_t a = 0; a < models.size(); ++a) {
    for (std::size_t b = a + 1; b < models.size(); ++b) {
      bool may = true;
      for (const Figure& figure : figures) {
        may =
            may && !leaves_out(figure, static_cast<std::int32_t>(a), static_cast<std::int32_t>(b));
      }
      found += may && overlap(bound(a), bound(b)) ? 1 : 0;
    }
  }
  return found;
}

TEST(FigureCrowd, StartsWithinTheWallsApartAndUnfolded) {
  for (int repetition = 1; repetition <= 3; ++repetition) {
    const StagedScene scene = built(humanoid_crowd(20, 24.0), "main/" + std::to_string(repetition));
    ASSERT_EQ(scene.world.settings().figures.size(), 20U);
    EXPECT_EQ(overlapping_parts(scene), 0);
    const Enclosure walls = *scene.world.settings().enclosure;
    for (std::size_t body = 0; body < scene.world.models().size(); ++body) {
      EXPECT_FALSE(reaches_wall(walls, placed(scene.world.models()[body].tree->volume(0),
                                              scene.world.states()[body].pose)));
    }
    for (const Figure& figure : scene.world.settings().figures) {
      const std::vector<Pose> poses = poses_in(scene, figure);
      EXPECT_EQ(folded_hinge(figure, poses), nullptr);
      for (const Hinge& hinge : figure.hinges) {
        const auto pose = [&](std::int32_t body) {
          return poses[static_cast<std::size_t>(body - figure.first_part)];
        };
        const double angle = angle_of(hinge, pose(hinge.child), pose(hinge.parent));
        EXPECT_GE(angle, hinge.least_rad - 1e-12);
        EXPECT_LE(angle, hinge.most_rad + 1e-12);
      }
    }
  }
}

TEST(FigureCrowd, FollowsFromItsNameAndNumberAlone) {
  const auto hash = [](const StagedScene& scene) { return hash_state(scene.world.states()).hash; };
  const json scene = humanoid_crowd(3, 20.0);
  const std::uint64_t first = hash(built(scene));
  EXPECT_EQ(hash(built(scene)), first);
  EXPECT_NE(hash(built(scene, "main/2")), first);
  EXPECT_NE(hash(built(changed(scene, "/figure_crowd/start", 2))), first);
}

TEST(FigureCrowd, MovesAtTheSpeedOfTheSceneAndIsNamedByNumbers) {
  const StagedScene scene = built(humanoid_crowd(3, 20.0));
  for (const Figure& figure : scene.world.settings().figures) {
    const auto root = static_cast<std::size_t>(figure.first_part);
    EXPECT_NEAR(velocity(scene.world.models()[root], scene.world.states()[root]).norm(),
                metres_of(5.0), 1e-12);
  }
  EXPECT_EQ(scene.world.models()[17].name, "2/abdomen");
}

// edge = edge_at_count (count / at)^(1/3)
TEST(FigureCrowd, TheEnclosureKeepsItsDensity) {
  json scene = humanoid_crowd(16, 12.0);
  scene["enclosure"]["edge_at_count"] = 2;
  EXPECT_NEAR(closed_cube(built(scene).world.settings().enclosure)->half_edge_m, metres_of(12.0),
              1e-12);
}

TEST(FigureFiles, AreHeldByContentAndNeededNoMore) {
  TemporaryFolder folder;
  folder.write("doll.json", doll().dump());
  json named = doll_scene();
  named.erase("figure_files");
  const JsonDocument scene = load_scene(folder.write("scene.json", named.dump()));
  std::filesystem::remove(folder / "doll.json");
  const JsonDocument again = parse_json("a study", scene.text);
  EXPECT_EQ(again.value, doll_scene());
  EXPECT_EQ(refusal([&] { require_scene(again); }), "accepted");
  EXPECT_EQ(built(again.value).world.models().size(), 3U);
}

TEST(FigureFiles, MayHaveMeshesThatTheSceneHoldsToo) {
  TemporaryFolder folder;
  folder.write("head.obj",
               "v 0 0 0\nv 2 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  json figure = doll();
  figure["parts"][2]["shape"] = {{"kind", "mesh"}, {"file", "head.obj"}, {"size_share", 0.1}};
  folder.write("doll.json", figure.dump());
  json named = doll_scene();
  named.erase("figure_files");
  const JsonDocument scene = load_scene(folder.write("scene.json", named.dump()));
  EXPECT_EQ(scene.value["meshes"]["head.obj"]["triangles"], 4);
  EXPECT_EQ(built(scene.value).looks[2].mesh->triangles.size(), 4U);
  figure["parts"][2]["shape"]["file"] = "../head.obj";
  folder.write("doll.json", figure.dump());
  const std::string sentence =
      refusal([&] { load_scene(folder.write("scene.json", named.dump())); });
  EXPECT_TRUE(
      sentence.ends_with("/figure_files/doll.json/parts/2/shape/file: expected a path within "
                         "the scene's folder, got \"../head.obj\""))
      << sentence;
}

}  // namespace impetus::figure_scene_test
