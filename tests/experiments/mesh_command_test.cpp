// `impetus mesh check` as a researcher meets it: report, sentence, exit status.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <string>

#include "tests/experiments/program.hpp"

namespace impetus::mesh_command_test {

const char kVertices[] = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
const char kFaces[] = "f 1 3 2\nf 1 2 4\nf 1 4 3\n";

std::string open_tetrahedron() { return std::string(kVertices) + kFaces; }

std::string tetrahedron() { return open_tetrahedron() + "f 2 3 4\n"; }

TEST(MeshCommand, AMeshThatCanBeSimulatedIsFine) {
  const TemporaryFolder folder;
  folder.write("a.obj", tetrahedron());
  const ProgramResult result = run_program(folder, {"mesh", "check", "a.obj"});
  EXPECT_EQ(result.errors, "");
  EXPECT_EQ(result.status, 0);
  EXPECT_NE(result.output.find("\nvolume        0.166667 m^3\n"), std::string::npos);
}

TEST(MeshCommand, AMeshThatCannotBeSimulatedIsRefusedWithReasonAndCount) {
  const TemporaryFolder folder;
  folder.write("a.obj", open_tetrahedron());
  const ProgramResult result = run_program(folder, {"mesh", "check", "a.obj"});
  EXPECT_EQ(result.errors,
            "impetus: a.obj: cannot be simulated: it has 3 open edges; Blender, "
            "MeshLab or admesh can mend it\n");
  EXPECT_EQ(result.status, 1);
}

TEST(MeshCommand, AFileThatCannotBeReadIsNoMesh) {
  const TemporaryFolder folder;
  const ProgramResult result = run_program(folder, {"mesh", "check", "a.obj"});
  EXPECT_EQ(result.errors, "impetus: a.obj: there is no such file\n");
  EXPECT_EQ(result.status, 2);
}

TEST(MeshCommand, EveryFileIsLookedAtAndTheWorstCounts) {
  const TemporaryFolder folder;
  folder.write("open.obj", open_tetrahedron());
  folder.write("whole.obj", tetrahedron());
  const ProgramResult result =
      run_program(folder, {"mesh", "check", "none.obj", "open.obj", "whole.obj"});
  EXPECT_EQ(result.errors,
            "impetus: none.obj: there is no such file\n"
            "impetus: open.obj: cannot be simulated: it has 3 open edges; Blender, MeshLab or "
            "admesh can mend it\n");
  EXPECT_NE(result.output.find("whole.obj\n"), std::string::npos);
  EXPECT_EQ(result.status, 2);
}

}  // namespace impetus::mesh_command_test
