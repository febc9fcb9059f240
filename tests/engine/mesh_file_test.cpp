// Mesh files: every format gives the same welded surface, and every refusal says what was wrong.
// SPDX-License-Identifier: MIT
#include "experiments/files/mesh_file.hpp"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "experiments/models/mesh_report.hpp"
#include "tests/engine/mesh_files.hpp"

namespace impetus::mesh_file_test {

class MeshFile : public MeshFiles {};

void expect_cube(const TriangleMesh& mesh) {
  const MeshReport report = report_mesh(mesh);
  EXPECT_EQ(report.vertices, 8);
  EXPECT_EQ(report.triangles, 12);
  EXPECT_EQ(report.components, 1);
  EXPECT_TRUE(report.defects.none());
  ASSERT_TRUE(report.usable());
  EXPECT_NEAR(report.solid->volume_m3, 8.0, 1e-14);
}

TEST_F(MeshFile, EveryFormatGivesTheSameWeldedCube) {
  const TriangleMesh cube = load_mesh(write("cube.obj", cube_obj()));
  expect_cube(cube);
  expect_cube(load_mesh(write("cube.off", cube_off())));
  expect_cube(load_mesh(write("cube.ply", cube_ply())));
  expect_cube(load_mesh(write("cube.stl", as_stl(cube))));
}

TEST_F(MeshFile, ABinaryBodyThatBeginsAsALineEndsIsReadWhole) {
  const TriangleMesh cube = load_mesh(write("cube.obj", cube_obj()));
  const auto binary = [&](float half, const std::string& line_end) {  // little-endian, as here
    std::string text;
    for (const char letter : ply_header("binary_little_endian", 8, 12, "uchar")) {
      text += letter == '\n' ? line_end : std::string(1, letter);
    }
    const auto put = [&](const auto& number) {
      text.append(reinterpret_cast<const char*>(&number), sizeof(number));
    };
    for (const Vector3& vertex : cube.vertices) {
      for (int axis = 0; axis < 3; ++axis) {
        put(half * static_cast<float>(vertex[axis]));
      }
    }
    for (const auto& triangle : cube.triangles) {
      put(std::uint8_t{3});
      for (const std::uint32_t corner : triangle) {
        put(corner);
      }
    }
    return text;
  };
  for (const float half : {0.64F, 0.02F, 0.5F}) {
    for (const std::string line_end : {"\n", "\r\n"}) {
      const std::string text = binary(half, line_end);
      const std::size_t body = text.find("end_header" + line_end) + 10 + line_end.size();
      EXPECT_EQ(text[body] == '\n', half != 0.5F) << half;
      const MeshReport report = report_mesh(load_mesh(write("cube.ply", text)));
      ASSERT_TRUE(report.usable()) << half << line_end;
      const double side_m = 2.0 * static_cast<double>(half);
      EXPECT_NEAR(report.solid->volume_m3 / (side_m * side_m * side_m), 1.0, 1e-6) << half;
    }
  }
}

TEST_F(MeshFile, NormalsAndTextureCoordinatesDoNotKeepVerticesApart) {
  const std::string text = std::string(kCubeObj) +
                           "vn 0 0 -1\nvn 0 0 1\nvn 0 -1 0\nvn 0 1 0\nvn -1 0 0\nvn 1 0 0\n"
                           "f 1//1 3//1 4//1 2//1\nf 5//2 6//2 8//2 7//2\nf 1//3 2//3 6//3 5//3\n"
                           "f 3//4 7//4 8//4 4//4\nf 1//5 5//5 7//5 3//5\nf 2//6 4//6 8//6 6//6\n";
  expect_cube(load_mesh(write("hard_edges.obj", text)));
}

TEST_F(MeshFile, MeshesOfOneFileAreMergedAndComponentsCounted) {
  std::string text = cube_obj();
  text += "o second\n";
  text += "v 5 0 0\nv 6 0 0\nv 5 1 0\nv 5 0 1\n";
  text += "f 9 11 10\nf 9 10 12\nf 9 12 11\nf 10 11 12\n";
  const MeshReport report = report_mesh(load_mesh(write("two.obj", text)));
  EXPECT_EQ(report.components, 2);
  EXPECT_EQ(report.triangles, 16);
  EXPECT_TRUE(report.defects.none());
  EXPECT_NEAR(report.solid->volume_m3, 8.0 + 1.0 / 6.0, 1e-14);
}

TEST_F(MeshFile, TransformsOfNodesAreApplied) {
  const TriangleMesh mesh = load_mesh(write("scaled.gltf", tetrahedron_gltf("2")));
  const MeshReport report = report_mesh(mesh);
  ASSERT_TRUE(report.usable());
  EXPECT_NEAR(report.solid->volume_m3, 2.0 / 6.0, 1e-15);
  EXPECT_LT((report.solid->centre - Vector3(0.5, 10.25, 0.25)).norm(), 1e-14);
}

TEST_F(MeshFile, AMirroringTransformKeepsTheOutsideOutside) {
  const MeshReport report = report_mesh(load_mesh(write("mirrored.gltf", tetrahedron_gltf("-2"))));
  ASSERT_TRUE(report.usable());
  EXPECT_NEAR(report.solid->volume_m3, 2.0 / 6.0, 1e-15);
}

TEST_F(MeshFile, RefusesWhatIsNotThere) {
  EXPECT_EQ(refusal(folder_ / "missing.obj"), "missing.obj: there is no such file");
  std::filesystem::create_directory(folder_ / "folder.obj");
  EXPECT_EQ(refusal(folder_ / "folder.obj"), "folder.obj: it is a directory, not a file");
}

TEST_F(MeshFile, RefusesWhatIsNotAMesh) {
  EXPECT_EQ(refusal(write("notes.txt", "shopping list\n")),
            "notes.txt: cannot be read as a mesh: No suitable reader found for the file format of "
            "file \"" +
                (folder_ / "notes.txt").string() + "\".");
  EXPECT_EQ(refusal(write("empty.stl", "")), "empty.stl: cannot be read as a mesh: File is empty");
}

TEST_F(MeshFile, RefusesAFileThatWasCutShort) {
  // assimp alone would never return from the first and abort the program on the second.
  EXPECT_EQ(refusal(write("header.ply", "ply\nformat ascii 1.0\nelement vert")),
            "header.ply: cannot be read as a mesh: its PLY header has no end");
  const std::string ply = cube_ply();
  const std::string first_vertex = "-1 -1 -1\n";
  EXPECT_EQ(refusal(write("cut.ply", ply.substr(0, ply.find(first_vertex) + first_vertex.size()))),
            "cut.ply: a face has no vertices: the file may be cut short");
}

TEST_F(MeshFile, AnyPrefixOfAFileIsReadOrRefused) {
  const std::string stl = as_stl(load_mesh(write("cube.obj", cube_obj())));
  const std::vector<std::pair<std::string, std::string>> files{
      {"prefix.obj", cube_obj()},
      {"prefix.off", cube_off()},
      {"prefix.ply", cube_ply()},
      {"prefix.stl", stl},
      {"prefix.gltf", tetrahedron_gltf("2")}};
  for (const auto& [name, text] : files) {
    for (std::size_t length = 0; length < text.size(); length += 7) {
      refusal(write(name, text.substr(0, length)));  // returns, and throws nothing else
    }
  }
}

TEST_F(MeshFile, RefusesAFileWithoutTriangles) {
  EXPECT_EQ(refusal(write("lines.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nl 1 2 3\n")),
            "lines.obj: has no triangles");
  EXPECT_EQ(refusal(write("points.obj", "v 0 0 0\nv 1 0 0\np 1 2\n")),
            "points.obj: has no triangles");
}

TEST_F(MeshFile, AMaterialFileThatIsMissingIsNotMissed) {
  expect_cube(load_mesh(write("painted.obj", "mtllib missing.mtl\nusemtl red\n" + cube_obj())));
}

TEST_F(MeshFile, RefusesAnIndexOutOfRange) {
  std::string off = cube_off();
  off.replace(off.rfind("4 1 3 7 5"), 9, "4 1 3 7 8");
  EXPECT_EQ(refusal(write("index.off", off)),
            "index.off: cannot be read as a mesh: Error, T0: OFF: Vertex index is out of range");
  std::string ply = cube_ply();
  ply.replace(ply.rfind("4 1 3 7 5"), 9, "4 1 3 7 8");
  EXPECT_EQ(refusal(write("index.ply", ply)), "index.ply: a face names vertex 8 of 8");
  EXPECT_EQ(refusal(write("index.obj", std::string(kCubeObj) + "f 1 2 9\n")),
            "index.obj: cannot be read as a mesh: OBJ: vertex index out of range");
}

TEST_F(MeshFile, RefusesACoordinateThatIsNotFinite) {
  EXPECT_EQ(refusal(write("nan.obj", "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")),
            "nan.obj: 1 vertex has a coordinate that is not a finite number");
  EXPECT_EQ(refusal(write("inf.obj", "v inf 0 0\nv 1 -inf 0\nv 0 1 0\nf 1 2 3\n")),
            "inf.obj: 2 vertices have a coordinate that is not a finite number");
}

TEST_F(MeshFile, AReportDescribesASolid) {
  EXPECT_EQ(describe(report_mesh(load_mesh(write("cube.obj", cube_obj())))),
            "triangles     12\n"
            "vertices      8\n"
            "components    1\n"
            "closed        yes\n"
            "oriented      yes\n"
            "outward       yes\n"
            "manifold      yes\n"
            "clean faces   yes\n"
            "self-crossing none\n"
            "volume        8 m^3\n"
            "centre        (0, 0, 0) m\n"
            "mass          8000 kg at 1000 kg/m^3\n"
            "inertia       xx 5333.33, yy 5333.33, zz 5333.33, xy 0, xz 0, yz 0 kg m^2 about the "
            "centre\n");
}

TEST_F(MeshFile, AReportSaysWhyASurfaceIsNoSolid) {
  const std::string open = std::string(kCubeObj) + "f 1 3 4 2\n";
  EXPECT_EQ(describe(report_mesh(load_mesh(write("open.obj", open)))),
            "triangles     2\n"
            "vertices      4\n"
            "components    1\n"
            "closed        no: 4 open edges\n"
            "oriented      yes\n"
            "outward       unknown: the surface encloses no solid\n"
            "manifold      yes\n"
            "clean faces   yes\n"
            "self-crossing none\n"
            "volume        undefined: the surface encloses no solid\n");
}

TEST_F(MeshFile, AReportSaysWhenASurfaceIsInsideOut) {
  const std::string turned =
      std::string(kCubeObj) + "f 1 2 4 3\nf 5 7 8 6\nf 1 5 6 2\nf 3 4 8 7\nf 1 3 7 5\nf 2 6 8 4\n";
  const TriangleMesh mesh = load_mesh(write("turned.obj", turned));
  EXPECT_FALSE(report_mesh(mesh).usable());
  EXPECT_NE(describe(report_mesh(mesh)).find("-8 m^3: the surface is inside out"),
            std::string::npos);
}

}  // namespace impetus::mesh_file_test
