// Repaired mesh files: every change is named, the new file passes the check, and what cannot be
// repaired is refused in a sentence and not written.
// SPDX-License-Identifier: MIT
#include "experiments/models/mesh_mending.hpp"

#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "engine/shapes/mass_properties.hpp"
#include "engine/shapes/solids/ball_meshes.hpp"
#include "engine/shapes/solids/block_meshes.hpp"
#include "experiments/models/mesh_file.hpp"
#include "experiments/models/mesh_report.hpp"
#include "experiments/models/mesh_writer.hpp"

namespace impetus::mesh_mending_test {

class MeshMending : public ::testing::Test {
 protected:
  void SetUp() override {
    const std::string name = ::testing::UnitTest::GetInstance()->current_test_info()->name();
    folder_ = std::filesystem::temp_directory_path() / ("impetus_mesh_mending_" + name);
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path write(const TriangleMesh& mesh, const std::string& name = "in.obj") {
    write_mesh(mesh, folder_ / name);
    return folder_ / name;
  }

  /// The changes as told; the written file is checked and its volume compared.
  std::string changes(const TriangleMesh& mesh, double volume_m3, double tolerance_m3,
                      const std::string& out = "out.obj") {
    std::filesystem::remove(folder_ / "in.obj");
    const Mending mending = mend(write(mesh), folder_ / out);
    EXPECT_EQ(mending.refusal, "");
    const MeshReport report = report_mesh(load_mesh(folder_ / out));
    EXPECT_TRUE(report.usable());
    EXPECT_EQ(report.self_intersections.pairs(), 0);
    EXPECT_NEAR(report.solid ? report.solid->volume_m3 : 0.0, volume_m3, tolerance_m3);
    return describe_changes(mending.repair);
  }

  /// Why the mesh is not repaired; nothing is written.
  std::string refusal_of(const TriangleMesh& mesh) {
    std::filesystem::remove(folder_ / "in.obj");
    const Mending mending = mend(write(mesh), folder_ / "out.obj");
    EXPECT_FALSE(std::filesystem::exists(folder_ / "out.obj"));
    return mending.refusal;
  }

  /// The sentence that mend() throws, without the folder.
  std::string thrown(const std::filesystem::path& file, const std::string& out) {
    try {
      mend(file, folder_ / out);
    } catch (const std::runtime_error& error) {
      return std::string(error.what()).substr(folder_.string().size() + 1);
    }
    return "accepted";
  }

  std::filesystem::path folder_;
};

TriangleMesh cube() { return box_mesh(Vector3::Constant(2.0)); }

TriangleMesh ball() { return icosphere_mesh(1.0, 2); }

double ball_volume_m3() { return solid_of(ball(), /*density_kg_m3=*/1.0).volume_m3; }

void turn(TriangleMesh& mesh, std::size_t triangle) {
  std::swap(mesh.triangles[triangle][1], mesh.triangles[triangle][2]);
}

TEST_F(MeshMending, AGoodMeshIsCopiedUnchanged) {
  EXPECT_EQ(changes(cube(), 8.0, 1e-14), "changed       nothing\n");
}

TEST_F(MeshMending, EveryFormatKeepsSinglePrecisionExactly) {
  const TriangleMesh first = load_mesh(write(ball()));
  for (const std::string name : {"ball.ply", "ball.stl", "again.OBJ"}) {
    const TriangleMesh copy = load_mesh(write(first, name));
    ASSERT_EQ(copy.triangles.size(), first.triangles.size());
    for (std::size_t t = 0; t < copy.triangles.size(); ++t) {
      for (std::size_t i = 0; i < 3; ++i) {
        ASSERT_EQ(copy.vertices[copy.triangles[t][i]], first.vertices[first.triangles[t][i]]);
      }
    }
  }
}

TEST_F(MeshMending, EachChangeIsNamedWithItsCount) {
  TriangleMesh mesh = ball();
  mesh.triangles.push_back(mesh.triangles[7]);
  mesh.triangles.push_back({mesh.triangles[9][1], mesh.triangles[9][0], mesh.triangles[9][2]});
  mesh.triangles.push_back({0, 1, 1});
  turn(mesh, 30);
  turn(mesh, 200);
  mesh.triangles.erase(mesh.triangles.begin() + 100);
  EXPECT_EQ(changes(mesh, ball_volume_m3(), 1e-6),
            "changed       1 triangle without area dropped\n"
            "changed       2 duplicate triangles dropped\n"
            "changed       2 triangles turned to agree with their neighbours\n"
            "changed       1 hole of 3 edges filled with 1 triangle\n");
}

TEST_F(MeshMending, AMeshInsideOutIsTurned) {
  TriangleMesh mesh = ball();
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    turn(mesh, t);
  }
  EXPECT_EQ(refusal(report_mesh(mesh)), "cannot be simulated: it has 1 component inside out");
  EXPECT_EQ(changes(mesh, ball_volume_m3(), 1e-6),
            "changed       1 component turned outside out\n");
}

TEST_F(MeshMending, OfTwoBodiesInOneFileOnlyTheOneInsideOutIsTurned) {
  TriangleMesh mesh = cube();
  for (const Vector3& vertex : cube().vertices) {
    mesh.vertices.push_back(vertex + Vector3(5.0, 0.0, 0.0));
  }
  for (const auto& [a, b, c] : cube().triangles) {
    mesh.triangles.push_back({a + 8, c + 8, b + 8});
  }
  EXPECT_EQ(refusal(report_mesh(mesh)), "cannot be simulated: it has 1 component inside out");
  EXPECT_EQ(changes(mesh, 16.0, 1e-13), "changed       1 component turned outside out\n");
}

TEST_F(MeshMending, AFlatHoleIsClosedInItsPlane) {
  TriangleMesh mesh = cube();
  mesh.triangles.erase(mesh.triangles.begin(), mesh.triangles.begin() + 2);  // one side
  EXPECT_EQ(changes(mesh, 8.0, 1e-14), "changed       1 hole of 4 edges filled with 2 triangles\n");
}

TEST_F(MeshMending, VerticesThatAreAlmostAtOnePlaceAreWelded) {
  TriangleMesh mesh = cube();
  const std::uint32_t old = mesh.triangles[4][0];
  mesh.vertices.push_back(mesh.vertices[old] + Vector3(1e-6, 0.0, 0.0));
  mesh.triangles[4][0] = 8;
  EXPECT_EQ(changes(mesh, 8.0, 1e-4), "changed       1 vertex welded to another\n");
}

TEST_F(MeshMending, ANeedleAndVerySmallAndLargeMeshesAreKept) {
  for (const double scale : {1e-6, 1.0, 1e6}) {
    const double volume_m3 = scale * scale * scale * 1e-8;
    const TriangleMesh needle = box_mesh(scale * Vector3(1e-4, 1e-4, 1.0));
    std::filesystem::remove(folder_ / "out.obj");
    EXPECT_EQ(changes(needle, volume_m3, 1e-6 * volume_m3), "changed       nothing\n") << scale;
  }
}

TEST_F(MeshMending, RefusesWhatItCannotRepair) {
  TriangleMesh flap = cube();
  flap.vertices.emplace_back(9.0, 9.0, 9.0);
  flap.triangles.push_back({flap.triangles[0][0], flap.triangles[0][1], 8});
  EXPECT_EQ(refusal_of(flap),
            "cannot be repaired: 1 edge has more than two triangles, and which of them belong "
            "together is not known");

  TriangleMesh triangle;
  triangle.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  triangle.triangles = {{0, 1, 2}};
  EXPECT_EQ(refusal(report_mesh(triangle)), "cannot be simulated: it has 3 open edges");
  EXPECT_EQ(refusal_of(triangle),
            "cannot be repaired: 1 hole cannot be closed without a new defect");

  TriangleMesh square = triangle;
  square.vertices.emplace_back(1.0, 1.0, 0.0);
  square.triangles.push_back({1, 3, 2});
  EXPECT_EQ(refusal_of(square), "cannot be simulated: it has 1 flat component");

  TriangleMesh line = triangle;
  line.triangles = {{0, 1, 1}};
  EXPECT_EQ(refusal_of(line), "cannot be repaired: no triangle has an area");
}

TEST_F(MeshMending, RefusesAOneSidedSurface) {
  TriangleMesh strip;  // five triangles: the smallest Möbius strip
  strip.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
  strip.triangles = {{0, 1, 2}, {1, 2, 3}, {2, 3, 4}, {3, 4, 0}, {4, 0, 1}};
  EXPECT_EQ(refusal_of(strip),
            "cannot be repaired: the surface has one side only, like a Moebius strip");
}

TEST_F(MeshMending, RefusesAHoleOfMoreThan64Edges) {
  TriangleMesh bowl = icosphere_mesh(1.0, 4);
  std::vector<std::array<std::uint32_t, 3>> lower;
  for (const auto& triangle : bowl.triangles) {
    if (bowl.vertices[triangle[0]].z() < 0.0) {
      lower.push_back(triangle);
    }
  }
  bowl.triangles = lower;
  EXPECT_EQ(refusal_of(bowl), "cannot be repaired: 1 hole has more than 64 edges");
}

TEST_F(MeshMending, NeverOverwritesAFile) {
  const auto file = write(cube());
  std::ofstream(folder_ / "there.obj") << "precious";
  EXPECT_EQ(thrown(file, "there.obj"), "there.obj: exists already and is not overwritten");
  EXPECT_EQ(thrown(file, "in.obj"), "in.obj: exists already and is not overwritten");
  std::ifstream kept(folder_ / "there.obj");
  std::string text;
  kept >> text;
  EXPECT_EQ(text, "precious");
}

TEST_F(MeshMending, RefusesAnExtensionItDoesNotKnowAndAFolderThatIsNotThere) {
  const auto file = write(cube());
  EXPECT_EQ(thrown(file, "out.step"), "out.step: expected a name that ends in .obj, .ply or .stl");
  EXPECT_EQ(thrown(file, "missing/out.obj"), "missing/out.obj: cannot be written");
}

TEST_F(MeshMending, RefusesAFileItCannotRead) {
  std::ofstream(folder_ / "nan.obj") << "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  EXPECT_EQ(thrown(folder_ / "nan.obj", "out.obj"),
            "nan.obj: 1 vertex has a coordinate that is not a finite number");
  EXPECT_EQ(thrown(folder_ / "missing.obj", "out.obj"), "missing.obj: there is no such file");
}

}  // namespace impetus::mesh_mending_test
