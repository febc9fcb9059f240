// Mesh files for tests, in every format, and the sentence with which one is refused.
// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>

#include "experiments/files/mesh_file.hpp"

namespace impetus {

/// A folder of its own for each test, removed afterwards.
class MeshFiles : public ::testing::Test {
 protected:
  void SetUp() override {
    const std::string name = ::testing::UnitTest::GetInstance()->current_test_info()->name();
    folder_ = std::filesystem::temp_directory_path() / ("impetus_mesh_file_" + name);
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path write(const std::string& name, const std::string& text) {
    std::ofstream(folder_ / name) << text;
    return folder_ / name;
  }

  /// What load_mesh says about the file, without the folder; "accepted" when it loads.
  std::string refusal(const std::filesystem::path& file) {
    try {
      load_mesh(file);
    } catch (const std::runtime_error& error) {
      const std::string text = error.what();
      const std::string start = folder_.string() + "/";
      EXPECT_EQ(text.compare(0, start.size(), start), 0) << text;
      return text.substr(start.size());
    }
    return "accepted";
  }

  std::filesystem::path folder_;
};

/// A cube of side 2 m about the origin, as six quadrilaterals.
inline const char kCubeObj[] =
    "v -1 -1 -1\nv 1 -1 -1\nv -1 1 -1\nv 1 1 -1\nv -1 -1 1\nv 1 -1 1\nv -1 1 1\nv 1 1 1\n";
inline const char kCubeObjFaces[] =
    "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";
inline const char kCubeVertices[] =
    "-1 -1 -1\n1 -1 -1\n-1 1 -1\n1 1 -1\n-1 -1 1\n1 -1 1\n-1 1 1\n1 1 1\n";
inline const char kCubeFaces[] =
    "4 0 2 3 1\n4 4 5 7 6\n4 0 1 5 4\n4 2 6 7 3\n4 0 4 6 2\n4 1 3 7 5\n";

inline std::string cube_obj() { return std::string(kCubeObj) + kCubeObjFaces; }

inline std::string cube_off() { return std::string("OFF\n8 6 0\n") + kCubeVertices + kCubeFaces; }

inline std::string ply_header(const std::string& format, int vertices, int faces,
                              const std::string& length_type) {
  return "ply\nformat " + format + " 1.0\nelement vertex " + std::to_string(vertices) +
         "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
         std::to_string(faces) + "\nproperty list " + length_type +
         " int vertex_indices\nend_header\n";
}

inline std::string cube_ply() {
  return ply_header("ascii", 8, 6, "uchar") + kCubeVertices + kCubeFaces;
}

/// STL repeats every vertex of every triangle.
inline std::string as_stl(const TriangleMesh& mesh) {
  std::ostringstream out;
  out << "solid cube\n";
  for (const auto& triangle : mesh.triangles) {
    out << "facet normal 0 0 0\nouter loop\n";
    for (const std::uint32_t corner : triangle) {
      out << "vertex " << mesh.vertices[corner].transpose() << "\n";
    }
    out << "endloop\nendfacet\n";
  }
  out << "endsolid cube\n";
  return out.str();
}

/// Twelve floats (the corners 0, x, y, z), then twelve unsigned shorts (four triangles).
inline const char kTetrahedronBytes[] =
    "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAAAAAAAAAAAAIA/AAACAAEA"
    "AAABAAMAAAADAAIAAQACAAMA";

/// A tetrahedron (0, x, y, z unit corners) whose node is scaled by `scale` along x and moved by
/// 10 m along y.
inline std::string tetrahedron_gltf(const std::string& scale) {
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],
"nodes":[{"children":[1],"translation":[0,10,0]},{"mesh":0,"scale":[)" +
         scale + R"(,1,1]}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],
"buffers":[{"byteLength":72,"uri":"data:application/octet-stream;base64,)" +
         std::string(kTetrahedronBytes) + R"("}],
"bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":48},
{"buffer":0,"byteOffset":48,"byteLength":24}],
"accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","min":[0,0,0],
"max":[1,1,1]},{"bufferView":1,"componentType":5123,"count":12,"type":"SCALAR"}]})";
}

}  // namespace impetus
