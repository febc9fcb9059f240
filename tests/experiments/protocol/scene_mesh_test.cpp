// Scenes with mesh files and trees of a chosen kind: what they hold, and what is refused.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "engine/numerics/elementary_functions.hpp"
#include "engine/numerics/random_stream.hpp"
#include "experiments/files/protocol_files.hpp"
#include "experiments/files/scene_files.hpp"
#include "experiments/models/base64.hpp"
#include "experiments/protocol/checked_scene.hpp"
#include "experiments/protocol/protocol_scenes.hpp"
#include "experiments/protocol/screen_file.hpp"
#include "experiments/scenes/engine_setup.hpp"
#include "experiments/scenes/scene_file.hpp"
#include "experiments/scenes/scene_meshes.hpp"
#include "tests/experiments/refusals.hpp"

namespace impetus::scene_mesh_test {

const char kTetrahedron[] =
    "v 0 0 0\nv 2 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

/// A ball and, 4° wide, the mesh in meshes/a.obj.
json mesh_scene() {
  return json::parse(R"({
    "schema_version": 1, "title": "a mesh",
    "engine": {"step_hz": 240, "restitution": 1, "tree_depth": 2},
    "viewer": {"azimuth_deg": 0},
    "duration_s": 2,
    "bodies": [
      {"name": "ball", "shape": {"kind": "sphere", "radius_deg": 1}, "density_kg_m3": 1000,
       "colour": "#ffffff", "position_deg": [-5, 0, 0]},
      {"name": "mesh", "shape": {"kind": "mesh", "file": "meshes/a.obj", "size_deg": 4},
       "density_kg_m3": 1000, "colour": "#ffffff", "position_deg": [5, 0, 0]}]})");
}

json changed(json scene, const std::string& pointer, json value) {
  scene[json::json_pointer(pointer)] = std::move(value);
  return scene;
}

class MeshScene : public ::testing::Test {
 protected:
  MeshScene() { folder_.write("meshes/a.obj", kTetrahedron); }

  JsonDocument loaded(const json& scene) const {
    return load_scene(folder_.write("scene.json", scene.dump()));
  }

  /// Without the file's name, and with "FOLDER" for the folder's.
  std::string refused(const json& scene) const {
    std::string sentence = refusal([&] { loaded(scene); });
    const std::string folder = folder_.path().string();
    for (auto at = sentence.find(folder); at != std::string::npos; at = sentence.find(folder)) {
      sentence.replace(at, folder.size(), "FOLDER");
    }
    const std::string name = "FOLDER/scene.json:";
    return sentence.starts_with(name) ? sentence.substr(name.size()) : sentence;
  }

  TemporaryFolder folder_;
};

TEST_F(MeshScene, TheLongestSideHasTheSizeAsked) {
  ShapeLibrary library{TreeCache()};
  const StagedScene scene = build_scene(loaded(mesh_scene()).value, assumed_screen(), 0.0, library);
  const TriangleMesh& mesh = *scene.looks[1].mesh;
  Eigen::AlignedBox3d bounds;
  for (const Vector3& vertex : mesh.vertices) {
    bounds.extend(vertex);
  }
  const double degree_m = metres_per_degree(assumed_screen().viewing_distance_m);
  EXPECT_NEAR(bounds.sizes().x(), 4.0 * degree_m, 1e-12);
  EXPECT_NEAR(bounds.sizes().y(), 2.0 * degree_m, 1e-12);
}

TEST_F(MeshScene, TheSceneHoldsTheMeshAndNeedsItsFileNoMore) {
  const JsonDocument scene = loaded(mesh_scene());
  std::filesystem::remove(folder_ / "meshes/a.obj");
  const JsonDocument again = parse_json("a study", scene.text);
  EXPECT_EQ(again.value, scene.value);
  EXPECT_EQ(refusal([&] { require_scene(again); }), "accepted");
  ShapeLibrary library{TreeCache()};
  const StagedScene staged = build_scene(again.value, assumed_screen(), 0.0, library);
  EXPECT_EQ(staged.looks[1].mesh->triangles.size(), 4U);
}

TEST_F(MeshScene, AChangedFileIsAnotherScene) {
  const JsonDocument before = loaded(mesh_scene());
  folder_.write("meshes/a.obj", "v 0 0 0.5\n" + std::string(kTetrahedron).substr(8));
  EXPECT_NE(loaded(mesh_scene()).text, before.text);
}

TEST_F(MeshScene, ContentThatIsNotWhatItSaysIsRefused) {
  const JsonDocument scene = loaded(mesh_scene());
  const std::string place = "/meshes/meshes~1a.obj";
  json other = changed(scene.value, place + "/hash", std::string(32, '0'));
  EXPECT_EQ(refused(other),
            "/bodies/1/shape/file: expected a mesh with the hash 00000000000000000000000000000000, "
            "got " +
                scene.value["meshes"]["meshes/a.obj"]["hash"].get<std::string>() +
                " for \"meshes/a.obj\"");
  other = changed(scene.value, place + "/base64", "AA=?");
  EXPECT_EQ(refused(other),
            "/bodies/1/shape/file: expected base64, got a letter that has no place in it for "
            "\"meshes/a.obj\"");
  other = changed(scene.value, place + "/vertices", 5);
  EXPECT_TRUE(refused(other).starts_with("/bodies/1/shape/file: expected ")) << refused(other);
}

TEST_F(MeshScene, FilesThatAreNoClosedMeshWithinTheFolderAreRefused) {
  const auto with = [&](const char* file) {
    return refused(changed(mesh_scene(), "/bodies/1/shape/file", file));
  };
  EXPECT_EQ(with("/etc/passwd"),
            "/bodies/1/shape/file: expected a path within the scene's folder, got "
            "\"/etc/passwd\"");
  EXPECT_EQ(with("meshes/../../a.obj"),
            "/bodies/1/shape/file: expected a path within the scene's folder, got "
            "\"meshes/../../a.obj\"");
  EXPECT_EQ(with("none.obj"),
            "/bodies/1/shape/file: expected a mesh file, but FOLDER/none.obj: there is no such "
            "file");
  folder_.write("open.obj", std::string(kTetrahedron).substr(0, 56));
  EXPECT_EQ(with("open.obj"),
            "/bodies/1/shape/file: expected a closed mesh, but FOLDER/open.obj cannot be "
            "simulated: it has 3 open edges");
  json sized = mesh_scene();
  sized["bodies"][1]["shape"].erase("size_deg");
  EXPECT_EQ(refused(sized),
            "/bodies/1/shape: expected the key \"size_deg\" for kind mesh, which is missing");
}

TEST_F(MeshScene, ATreeOfAnyKindCanBeAskedFor) {
  const json scene = mesh_scene();
  EXPECT_EQ(tree_settings_of(scene["engine"]), (TreeSettings{TreeKind::kOctree, 2, 8}));
  const json swept = json::parse(R"({"kind": "swept", "branching": 4})");
  const json engine = changed(scene, "/engine/tree", swept)["engine"];
  EXPECT_EQ(tree_settings_of(engine), (TreeSettings{TreeKind::kSwept, 2, 4}));
}

TEST_F(MeshScene, TreesThatCannotBeAreRefused) {
  const auto with = [&](const char* tree) {
    return refused(changed(mesh_scene(), "/engine/tree", json::parse(tree)));
  };
  EXPECT_EQ(with(R"({"kind": "octree"})"), "accepted");
  EXPECT_EQ(with(R"({"kind": "octree", "branching": 4})"),
            "/engine/tree: expected a branching of 8 for an octree, got 4");
  EXPECT_EQ(with(R"({"kind": "voxel", "branching": 9})"),
            "/engine/tree: expected a branching of 8, 27 or 64 for voxels, got 9");
  EXPECT_EQ(with(R"({"kind": "quadtree"})"),
            "/engine/tree/kind: expected one of \"octree\", \"medial\", \"voxel\", \"box\", "
            "\"swept\", \"heterogeneous\", got \"quadtree\"");
  json shallow = mesh_scene();
  shallow["engine"] = json::parse(R"({"step_hz": 240, "restitution": 1, "tree": {"kind": "box"}})");
  EXPECT_EQ(refused(shallow),
            "/engine: expected the key \"tree_depth\" beside \"tree\", which is missing");
}

TEST_F(MeshScene, ShapesAreTheSameWithACacheAndWithout) {
  const JsonDocument scene =
      loaded(changed(mesh_scene(), "/engine/tree", json::parse(R"({"kind": "box"})")));
  const auto tree_with = [&](TreeCache cache) {
    ShapeLibrary library(std::move(cache));
    return build_scene(scene.value, assumed_screen(), 0.0, library).world.models()[1].tree;
  };
  const auto without = tree_with(TreeCache());
  const auto built = tree_with(TreeCache(folder_ / "trees"));
  const auto fetched = tree_with(TreeCache(folder_ / "trees"));
  EXPECT_FALSE(std::filesystem::is_empty(folder_ / "trees"));
  for (const auto& tree : {built, fetched}) {
    ASSERT_EQ(tree->node_count(), without->node_count());
    for (std::int32_t node = 0; node < tree->node_count(); ++node) {
      const Sphere one = bounding_sphere(tree->volume(node));
      const Sphere other = bounding_sphere(without->volume(node));
      EXPECT_EQ(one.centre, other.centre);
      EXPECT_EQ(one.radius_m, other.radius_m);
    }
  }
}

TEST_F(MeshScene, AProtocolsHashCoversItsMeshesAndThoseOfItsLevels) {
  json protocol = json::parse(shipped("protocols/gap.json"));
  json scene = json::parse(shipped("stimuli/two-l-blocks.json"));
  for (json& body : scene["bodies"]) {
    body["shape"] = json::parse(R"({"kind": "mesh", "file": "a.obj", "size_deg": 4})");
  }
  folder_.write("a.obj", kTetrahedron);
  folder_.write("b.obj", "v 0 0 0.25\n" + std::string(kTetrahedron).substr(8));
  folder_.write("scene.json", scene.dump());
  protocol["scene"] = "scene.json";
  const auto hash = [&] {
    return load_protocol(folder_.write("protocol.json", protocol.dump())).hash;
  };
  const std::string before = hash();
  EXPECT_EQ(hash(), before);
  folder_.write("a.obj", "v 0 0 0.5\n" + std::string(kTetrahedron).substr(8));
  EXPECT_NE(hash(), before);
}

TEST(Base64, ComesBackAsItWas) {
  EXPECT_EQ(base64("Man"), "TWFu");  // RFC 4648's neighbours: "TWE=" and "TQ=="
  EXPECT_EQ(base64("Ma"), "TWE=");
  EXPECT_EQ(base64("M"), "TQ==");
  RandomStream random(7, "base64");
  for (std::size_t length = 0; length < 100; ++length) {
    std::string bytes;
    for (std::size_t i = 0; i < length; ++i) {
      bytes += static_cast<char>(random.below(256));
    }
    EXPECT_EQ(bytes_from_base64(base64(bytes)), bytes);
  }
  EXPECT_THROW(bytes_from_base64("ABC"), std::runtime_error);
}

}  // namespace impetus::scene_mesh_test
