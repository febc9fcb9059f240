// Mesh files that are no files, or claim what cannot be: each is refused before its reader tries.
// SPDX-License-Identifier: MIT
#include "experiments/files/mesh_claims.hpp"

#include <sys/stat.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "experiments/files/child_process.hpp"
#include "tests/engine/mesh_files.hpp"

namespace impetus::mesh_claims_test {

class MeshClaims : public MeshFiles {};

TEST_F(MeshClaims, OnlyRegularFilesAreOpened) {
  ASSERT_EQ(mkfifo((folder_ / "pipe.obj").c_str(), 0600), 0);
  EXPECT_EQ(refusal(folder_ / "pipe.obj"), "pipe.obj: it is a named pipe, not a file");
  std::filesystem::create_symlink("loop.obj", folder_ / "loop.obj");
  EXPECT_EQ(refusal(folder_ / "loop.obj"), "loop.obj: its links lead round in a circle");
  const std::string long_name = std::string(300, 'x') + ".obj";
  EXPECT_EQ(refusal(folder_ / long_name), long_name + ": its name is too long");
}

TEST_F(MeshClaims, AMaterialThatIsNoFileIsNotOpened) {
  ASSERT_EQ(mkfifo((folder_ / "pipe.mtl").c_str(), 0600), 0);
  std::filesystem::create_directory(folder_ / "folder.mtl");
  for (const std::string material : {"pipe.mtl", "folder.mtl", "/dev/zero"}) {
    EXPECT_EQ(
        load_mesh(write("cube.obj", "mtllib " + material + "\n" + cube_obj())).triangles.size(),
        12U);
  }
}

TEST_F(MeshClaims, APolygonThatWouldTakeMinutesToCutIsRefused) {
  const int corners = 100'000;
  std::ostringstream vertices;
  std::string face;
  for (int i = 0; i < corners; ++i) {
    vertices << std::cos(6.283 * i / corners) << " " << std::sin(6.283 * i / corners) << " 0\n";
    face += " " + std::to_string(i);
  }
  const std::string sentence =
      ": a face has 100000 corners, more than the 10000 that are cut into triangles";
  std::istringstream lines(vertices.str());
  std::string obj;
  for (std::string line; std::getline(lines, line);) {
    obj += "v " + line + "\n";
  }
  std::string indices = "f";
  for (int i = 1; i <= corners; ++i) {
    indices += " " + std::to_string(i);
  }
  EXPECT_EQ(refusal(write("round.obj", obj + indices + "\n")), "round.obj" + sentence);
  EXPECT_EQ(refusal(write("round.ply", ply_header("ascii", corners, 1, "int") + vertices.str() +
                                           std::to_string(corners) + face + "\n")),
            "round.ply" + sentence);
  EXPECT_EQ(refusal(write("round.off", "OFF\n100000 1 0\n" + vertices.str() +
                                           std::to_string(corners) + face + "\n")),
            "round.off: cannot be read as a mesh: its line 100003 has " +
                std::to_string(6 + face.size()) + " letters, more than the 4095 that are read");
}

TEST_F(MeshClaims, CountsBeyondTheFileAreRefusedBeforeTheyAreBelieved) {
  const std::string corners = "0 0 0\n1 0 0\n0 1 0\n";
  const auto refused = [&](const std::string& name, const std::string& text) {
    return refusal(write(name, text));
  };
  const auto beyond = [](const std::string& text) {
    return ", but the file has " + std::to_string(text.size()) + " bytes";
  };
  const std::string said = ": cannot be read as a mesh: ";
  for (const std::string format : {"ascii", "binary_little_endian", "binary_big_endian"}) {
    const std::string vertices = ply_header(format, 1'000'000'000, 1, "uchar") + corners;
    EXPECT_EQ(refused("a.ply", vertices),
              "a.ply" + said + "its PLY header claims 1000000000 of the element \"vertex\"" +
                  beyond(vertices));
    const std::string faces = ply_header(format, 3, 1'000'000'000, "uchar") + corners;
    EXPECT_EQ(refused("a.ply", faces),
              "a.ply" + said + "its PLY header claims 1000000000 of the element \"face\"" +
                  beyond(faces));
  }
  const std::string list = ply_header("ascii", 3, 1, "uint") + corners + "1000000000 0 1 2\n";
  const std::string long_list = "a list \"vertex_indices\" of it claims 1000000000 values";
  EXPECT_EQ(refused("a.ply", list), "a.ply" + said + long_list + beyond(list));
  const std::string binary = ply_header("binary_big_endian", 3, 1, "uint") + std::string(36, '\0') +
                             "\x3b\x9a\xca" + std::string(13, '\0');
  EXPECT_EQ(refused("a.ply", binary), "a.ply" + said + long_list + beyond(binary));
  std::string properties = "ply\nformat ascii 1.0\nelement vertex 3\n";
  for (int i = 0; i < 100'000; ++i) {
    properties += "property float p" + std::to_string(i) + "\n";
  }
  EXPECT_EQ(refused("a.ply", properties + "end_header\n"),
            "a.ply" + said + "its PLY header has more than 1000 elements and properties");
  EXPECT_EQ(refused("a.off", "OFF\n1000000000 1 0\n" + corners),
            "a.off" + said + "it claims 1000000000 vertices, but has 37 bytes");
  EXPECT_EQ(refused("a.off", "OFF # many\n3 1000000000 0\n" + corners),
            "a.off" + said + "it claims 1000000000 faces, but has 44 bytes");
}

TEST_F(MeshClaims, AnStlFileThatWasCutSaysSo) {
  const auto stl = [](std::size_t triangles) {
    std::string bytes(84, '\0');
    bytes[80] = 2;
    for (std::size_t i = 0; i < triangles; ++i) {
      const std::array<float, 12> numbers{0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, static_cast<float>(i)};
      bytes.append(reinterpret_cast<const char*>(numbers.data()), sizeof numbers);
      bytes.append(2, '\0');
    }
    return bytes;
  };
  const std::string said = "a.stl: cannot be read as a mesh: its STL header ";
  EXPECT_EQ(refusal(write("a.stl", stl(2))), "accepted");
  EXPECT_EQ(refusal(write("a.stl", stl(1))),
            said + "claims 2 triangles, with which it has 184 bytes, but the file has 134 bytes");
  EXPECT_EQ(refusal(write("a.stl", stl(0).substr(0, 60))),
            said + "takes 84 bytes, but the file has 60 bytes");
}

TEST_F(MeshClaims, AFormatThatNoPlyFileHasIsRefused) {
  EXPECT_EQ(refusal(write("a.ply", ply_header("binary_middle_endian", 3, 1, "uchar"))),
            "a.ply: cannot be read as a mesh: its PLY header names the format "
            "\"binary_middle_endian\", none of ascii, binary_little_endian and binary_big_endian");
}

/// The tetrahedron with a part of its text replaced.
std::string changed_gltf(const std::string& from, const std::string& to) {
  std::string text = tetrahedron_gltf("1");
  return text.replace(text.find(from), from.size(), to);
}

TEST_F(MeshClaims, AGltfThatClaimsWhatCannotBeIsRefusedAtItsPlace) {
  const auto refused = [&](const std::string& text) { return refusal(write("a.gltf", text)); };
  const std::string said = "a.gltf: cannot be read as a mesh: ";
  const std::string many = changed_gltf("\"count\":4", "\"count\":1000000000");
  EXPECT_EQ(refused(many), said + "/accessors/0/count: expected at most the " +
                               std::to_string(many.size()) + " bytes of the files, got 1000000000");
  EXPECT_EQ(refused(changed_gltf("{\"children\":[1]", "{\"children\":[1,1]")),
            said + "/nodes/0/children: expected each node once and in one list, got 1 again");
  std::string nodes;
  for (int i = 1; i <= 1000; ++i) {
    nodes += "{\"children\":[" + std::to_string(i) + "]},";
  }
  EXPECT_EQ(refused(changed_gltf("{\"children\":[1],\"translation\":[0,10,0]},", nodes)),
            said + "/nodes: expected at most 1000 nodes one within another, got more");
  EXPECT_EQ(refused(changed_gltf("[{\"nodes\":[0]}]", "[{\"nodes\":[0,0]}]")),
            said + "/scenes/0/nodes: expected each node once and in one list, got 0 again");
  EXPECT_EQ(refused("{\"x\":" + std::string(100'000, '[')),
            said + "its JSON has more than 64 levels of nesting");
  EXPECT_EQ(
      refusal(write("a.glb", std::string("glTF\2\0\0\0\x40\0\0\0\xf0\xff\xff\xffJSON{}", 22))),
      "a.glb: cannot be read as a mesh: its JSON is longer than the file, which has 22 bytes");
}

TEST_F(MeshClaims, AMeshPlacedWithoutEndIsRefused) {
  std::string places;
  for (int i = 0; i < 300'000; ++i) {
    places += "{\"mesh\":0},";
  }
  std::string primitives = "{\"attributes\":{\"POSITION\":0},\"indices\":1}";
  for (int i = 0; i < 99; ++i) {
    primitives += ",{\"attributes\":{\"POSITION\":0},\"indices\":1}";
  }
  std::string text = changed_gltf("{\"mesh\":0,", places + "{\"mesh\":0,");
  const std::string one = "{\"attributes\":{\"POSITION\":0},\"indices\":1}";
  text.replace(text.find(one), one.size(), primitives);
  EXPECT_EQ(refusal(write("a.gltf", text)),
            "a.gltf: cannot be read as a mesh: /nodes: expected meshes of at most 20000000 "
            "triangles together, got 120000400");
}

TEST_F(MeshClaims, OnlyThePromisedFormatsAreRead) {
  EXPECT_EQ(refusal(write("a.x", "xof 0303txt 0032\n")),
            "a.x: cannot be read as a mesh: No suitable reader found for the file format of "
            "file \"" +
                (folder_ / "a.x").string() + "\".");
}

TEST(ChildProcess, MemoryBeyondItsLimitIsNotHad) {
  const auto taken = [](std::uint64_t more_bytes) {
    return done_by_child(
        [] {
          const std::string much(1'000'000'000, 'x');
          return std::string(much.back() == 'x' ? "had" : "");
        },
        {/*seconds=*/60, more_bytes});
  };
  EXPECT_EQ(taken(4'000'000'000), "had");
  EXPECT_EQ(taken(500'000'000), std::nullopt);
}

}  // namespace impetus::mesh_claims_test
