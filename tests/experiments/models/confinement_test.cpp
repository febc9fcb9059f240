// A protocol, a scene, a mesh or a study that somebody else made opens no file outside its folder.
// SPDX-License-Identifier: MIT
#include <sys/stat.h>

#include <nlohmann/json.hpp>

#include "experiments/files/mesh_file.hpp"
#include "experiments/files/protocol_files.hpp"
#include "experiments/files/scene_files.hpp"
#include "experiments/models/readable_file.hpp"
#include "experiments/protocol/series_file.hpp"
#include "tests/engine/mesh_files.hpp"
#include "tests/experiments/command_lines.hpp"
#include "tests/experiments/refusals.hpp"

namespace impetus::confinement_test {

/// study/protocols/a.json beside study/stimuli/two-spheres.json; a scene outside of study/.
struct Lab : TemporaryFolder {
  Lab() {
    write("study/stimuli/two-spheres.json", shipped(kSceneName));
    write("elsewhere/scene.json", shipped(kSceneName));
  }

  std::filesystem::path protocol(const std::string& scene) const {
    json text = json::parse(shipped(kProtocolName));
    text["scene"] = scene;
    return write("study/protocols/a.json", text.dump());
  }
};

std::string protocol_refusal(const std::filesystem::path& path) {
  return refusal([&] { load_protocol(path); });
}

TEST(Confinement, AProtocolNamesASceneWithinTheFolderAboveItsOwn) {
  const Lab lab;
  EXPECT_EQ(protocol_refusal(lab.protocol("../stimuli/two-spheres.json")), "accepted");
  const std::string within =
      ":/scene: expected a file within " + (lab / "study").string() + ", seen from this one, got ";
  for (const std::string scene :
       {"../../elsewhere/scene.json", "../stimuli/../../elsewhere/scene.json",
        "../../elsewhere/none.json", "../../study2/scene.json"}) {
    const auto path = lab.protocol(scene);
    EXPECT_EQ(protocol_refusal(path), path.string() + within + json(scene).dump());
  }
}

TEST(Confinement, AnAbsolutePathIsRefusedThoughItIsWithin) {
  const Lab lab;
  const std::string scene = lab / "study/stimuli/two-spheres.json";
  const auto path = lab.protocol(scene);
  EXPECT_EQ(protocol_refusal(path), path.string() + ":/scene: expected a file within " +
                                        (lab / "study").string() + ", seen from this one, got " +
                                        json(scene).dump());
}

TEST(Confinement, ALinkOutOfTheFolderIsRefused) {
  const Lab lab;
  std::filesystem::create_symlink(lab / "elsewhere/scene.json", lab / "study/stimuli/link.json");
  const auto path = lab.protocol("../stimuli/link.json");
  EXPECT_EQ(protocol_refusal(path),
            path.string() + ":/scene: expected a file within " + (lab / "study").string() +
                ", seen from this one, got \"../stimuli/link.json\", which is a link out of it");
  std::filesystem::create_symlink(lab / "study/stimuli/two-spheres.json",
                                  lab / "study/stimuli/inner.json");
  EXPECT_EQ(protocol_refusal(lab.protocol("../stimuli/inner.json")), "accepted");
}

TEST(Confinement, AProtocolIsReadFromWhereverOneStands) {
  const Lab lab;
  lab.protocol("../stimuli/two-spheres.json");
  const auto from = [&](const std::string& place, const std::string& protocol) {
    return run_program(lab, {"check", protocol},
                       [&] {
                         if (chdir((lab / place).c_str()) != 0) {
                           _exit(126);
                         }
                       })
        .status;
  };
  EXPECT_EQ(from("study/protocols", "a.json"), 0);
  EXPECT_EQ(from("study/protocols", "../protocols/a.json"), 0);
  EXPECT_EQ(from("study", "protocols/a.json"), 0);
  EXPECT_EQ(from("elsewhere", "../study/protocols/a.json"), 0);
}

TEST(Confinement, ASeriesNamesProtocolsWithinTheFolderAboveItsOwn) {
  const Lab lab;
  lab.protocol("../stimuli/two-spheres.json");
  lab.write("study/protocols/b.json", text_of(lab / "study/protocols/a.json"));
  const auto series = [&](const std::string& protocol) {
    const json text{{"schema_version", 1},
                    {"series", "s"},
                    {"title", "S"},
                    {"protocols", {protocol, "../b.json"}}};
    return lab.write("study/protocols/series/s.json", text.dump());
  };
  EXPECT_EQ(refusal([&] { load_series(series("../a.json")); }), "accepted");
  const auto path = series("../../../elsewhere/scene.json");
  EXPECT_EQ(refusal([&] { load_series(path); }),
            path.string() + ":/protocols/0: expected a protocol's file within " +
                (lab / "study/protocols").string() +
                ", seen from this one, got \"../../../elsewhere/scene.json\"");
}

// ---------------------------------------------------------------- meshes

/// A scene whose first body is a mesh file.
std::filesystem::path scene_with_mesh(const Lab& lab, const std::string& file) {
  json scene = json::parse(shipped(kSceneName));
  scene["bodies"][0]["shape"] = {{"kind", "mesh"}, {"file", file}, {"size_deg", 2}};
  return lab.write("study/stimuli/mesh.json", scene.dump());
}

TEST(Confinement, ASceneNamesMeshesWithinItsFolderLinksFollowed) {
  const Lab lab;
  lab.write("elsewhere/box.obj", cube_obj());
  std::filesystem::create_symlink(lab / "elsewhere/box.obj", lab / "study/stimuli/link.obj");
  for (const std::string file : {"../../elsewhere/box.obj", "link.obj"}) {
    const std::string sentence = refusal([&] { read_scene(scene_with_mesh(lab, file)); });
    EXPECT_NE(sentence.find("within the scene's folder, got " + json(file).dump()),
              std::string::npos)
        << sentence;
  }
}

/// A glTF file whose one buffer is the file that `uri` names.
std::string gltf_with_buffer(const std::string& uri) {
  const json text{{"asset", {{"version", "2.0"}}},
                  {"scene", 0},
                  {"scenes", {{{"nodes", {0}}}}},
                  {"nodes", {{{"mesh", 0}}}},
                  {"meshes", {{{"primitives", {{{"attributes", {{"POSITION", 0}}}}}}}}},
                  {"accessors",
                   {{{"bufferView", 0},
                     {"componentType", 5126},
                     {"count", 3},
                     {"type", "VEC3"},
                     {"min", {0, 0, 0}},
                     {"max", {1, 1, 0}}}}},
                  {"bufferViews", {{{"buffer", 0}, {"byteLength", 36}}}},
                  {"buffers", {{{"byteLength", 36}, {"uri", uri}}}}};
  return text.dump();
}

/// Meshes in study/stimuli, their buffers beside them and elsewhere.
struct MeshLab : Lab {
  MeshLab() {
    const float corners[] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    const std::string bytes(reinterpret_cast<const char*>(corners), sizeof corners);
    for (const std::string place : {"elsewhere/", "study/", "study/stimuli/near/"}) {
      write(place + "secret.bin", bytes);
    }
    write("study/stimuli/two words.bin", bytes);
  }

  /// What load_mesh() says of the mesh, without its name.
  [[nodiscard]] std::string refused(const std::string& uri) const {
    const auto file = write("study/stimuli/a.gltf", gltf_with_buffer(uri));
    const std::string sentence = refusal([&] {
      try {
        static_cast<void>(load_mesh(file));
      } catch (const std::runtime_error& error) {
        throw InputError(error.what());
      }
    });
    const std::string start = file.string() + ": cannot be read as a mesh: /buffers/0/uri: ";
    return sentence.starts_with(start) ? sentence.substr(start.size()) : sentence;
  }
};

TEST(Confinement, AGltfFileNamesBuffersWithinItsFolder) {
  const MeshLab lab;
  for (const std::string uri : {"near/secret.bin", "./near/secret.bin", "two words.bin",
                                "two%20words.bin", "near%2Fsecret.bin"}) {
    EXPECT_EQ(lab.refused(uri), "accepted") << uri;
  }
  const std::string elsewhere = lab / "elsewhere/secret.bin";
  for (const std::string& uri :
       {std::string("../secret.bin"), std::string("../../elsewhere/secret.bin"),
        std::string("%2e%2e/secret.bin"), std::string("%2E%2E%2Fsecret.bin"),
        std::string("..\\secret.bin"), std::string("near/../../secret.bin"), "file://" + elsewhere,
        "FILE:" + elsewhere, std::string("https://a.org/secret.bin"), elsewhere,
        "%2f" + elsewhere.substr(1), std::string("/dev/zero")}) {
    EXPECT_EQ(lab.refused(uri),
              "expected a path within the mesh's folder, got " + json(uri).dump());
  }
}

TEST(Confinement, ABufferThatIsALinkOutOrNoFileIsRefusedInOurWords) {
  const MeshLab lab;
  const std::filesystem::path stimuli = lab / "study/stimuli";
  std::filesystem::create_symlink("../../elsewhere/secret.bin", stimuli / "link.bin");
  std::filesystem::create_symlink("../../elsewhere", stimuli / "link");
  for (const std::string uri : {"link.bin", "link/secret.bin"}) {
    EXPECT_EQ(lab.refused(uri), "expected a file within the mesh's folder, got " +
                                    json(uri).dump() + ", which is a link out of it");
  }
  std::filesystem::create_symlink("loop.bin", stimuli / "loop.bin");
  ASSERT_EQ(mkfifo((stimuli / "pipe.bin").c_str(), 0600), 0);
  const std::string long_name(300, 'x');
  const std::vector<std::pair<std::string, std::string>> cases{
      {"none.bin", "there is no such file"},
      {"loop.bin", "its links lead round in a circle"},
      {"pipe.bin", "it is a named pipe, not a file"},
      {"near", "it is a directory, not a file"},
      {long_name, "its name is too long"}};
  for (const auto& [uri, reason] : cases) {
    EXPECT_EQ(lab.refused(uri),
              "expected a file of the mesh's, but " + (stimuli / uri).string() + ": " + reason);
  }
}

/// Textures are dropped, so that a mesh need not have them.
TEST(Confinement, AGltfsImagesAreNotOpened) {
  const MeshLab lab;
  ASSERT_EQ(mkfifo((lab / "study/stimuli/pipe.png").c_str(), 0600), 0);
  json text = json::parse(gltf_with_buffer("near/secret.bin"));
  text["images"] = {{{"uri", "pipe.png"}}, {{"uri", "../../elsewhere/none.png"}}};
  text["textures"] = {{{"source", 0}}, {{"source", 1}}};
  text["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}},
                       {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 1}}}}}}};
  EXPECT_EQ(load_mesh(lab.write("study/stimuli/b.gltf", text.dump())).triangles.size(), 1U);
}

// ---------------------------------------------------------------- pipes, loops, devices

TEST(Confinement, WhatAProtocolNamesIsAFile) {
  const Lab lab;
  ASSERT_EQ(mkfifo((lab / "study/stimuli/pipe.json").c_str(), 0600), 0);
  std::filesystem::create_symlink("loop.json", lab / "study/stimuli/loop.json");
  const std::string long_name = std::string(300, 'x') + ".json";
  const std::vector<std::pair<std::string, std::string>> cases{
      {"pipe.json", "it is a named pipe, not a file"},
      {"loop.json", "its links lead round in a circle"},
      {long_name, "its name is too long"}};
  for (const auto& [name, reason] : cases) {
    const auto path = lab.protocol("../stimuli/" + name);
    EXPECT_EQ(protocol_refusal(path),
              path.string() + ":/scene: expected a file, seen from this one, got \"../stimuli/" +
                  name + "\", but " + (lab / "study/stimuli" / name).string() + ": " + reason);
  }
}

TEST(Confinement, WhatASceneNamesIsAFile) {
  const Lab lab;
  ASSERT_EQ(mkfifo((lab / "study/stimuli/pipe.obj").c_str(), 0600), 0);
  std::filesystem::create_symlink("loop.obj", lab / "study/stimuli/loop.obj");
  const std::vector<std::pair<std::string, std::string>> cases{
      {"pipe.obj", "it is a named pipe, not a file"},
      {"loop.obj", "its links lead round in a circle"}};
  for (const auto& [name, reason] : cases) {
    const auto scene = scene_with_mesh(lab, name);
    EXPECT_EQ(refusal([&] { read_scene(scene); }),
              scene.string() + ":/bodies/0/shape/file: expected a mesh file, but " +
                  (lab / "study/stimuli" / name).string() + ": " + reason);
  }
}

TEST(Confinement, AStudysOwnSceneOpensNoFile) {
  const TemporaryFolder folder;
  run_program(folder, simulated_run({"--participant", "S01"}));
  folder.write("box.obj", cube_obj());
  for (const std::string& file : {(folder / "box.obj").string(), std::string("box.obj")}) {
    change(folder,
           "UPDATE protocol SET scene_json = json_set(scene_json, '$.bodies[0].shape', "
           "json_object('kind', 'mesh', 'size_deg', 2, 'file', '" +
               file + "'))");
    const ProgramResult result = run_program(folder, {"replay", "a.sqlite", "--trial", "1"});
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.errors,
              "impetus: a.sqlite, protocol causality, scene:/bodies/0/shape/file: expected a mesh "
              "whose content the scene holds, got " +
                  json(file).dump() + "\n");
  }
}

TEST(FilePlace, WithinIsByWholeNames) {
  EXPECT_TRUE(is_named_within("/a/b/c", "/a/b"));
  EXPECT_TRUE(is_named_within("/a/b/c", "/a/b/"));
  EXPECT_TRUE(is_named_within("/a/b/../b/c", "/a/b"));
  EXPECT_FALSE(is_named_within("/a/bc", "/a/b"));
  EXPECT_FALSE(is_named_within("/a/b/../c", "/a/b"));
  EXPECT_FALSE(is_named_within("/a", "/a/b"));
}

}  // namespace impetus::confinement_test
