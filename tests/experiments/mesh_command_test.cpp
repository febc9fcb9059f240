// `impetus mesh check` as a researcher meets it: report, sentence, exit status, repaired copy.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

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
  EXPECT_EQ(result.errors, "impetus: a.obj: cannot be simulated: it has 3 open edges\n");
  EXPECT_EQ(result.status, 1);
}

TEST(MeshCommand, AFileThatCannotBeReadIsNoMesh) {
  const TemporaryFolder folder;
  const ProgramResult result = run_program(folder, {"mesh", "check", "a.obj"});
  EXPECT_EQ(result.errors, "impetus: a.obj: there is no such file\n");
  EXPECT_EQ(result.status, 2);
}

TEST(MeshCommand, ARepairNamesItsChangesAndChecksWhatItWrote) {
  const TemporaryFolder folder;
  folder.write("a.obj", open_tetrahedron());
  const std::vector<std::string> words{"mesh", "check", "a.obj", "--repair", "b.ply"};
  const ProgramResult result = run_program(folder, words);
  EXPECT_EQ(result.errors, "");
  EXPECT_EQ(result.status, 0);
  const std::string start =
      "a.obj\n"
      "changed       1 hole of 3 edges filled with 1 triangle\n"
      "written       b.ply\n"
      "b.ply\n"
      "triangles     4\n";
  EXPECT_EQ(result.output.substr(0, start.size()), start);
  EXPECT_EQ(run_program(folder, {"mesh", "check", "b.ply"}).status, 0);
  const ProgramResult again = run_program(folder, words);
  EXPECT_EQ(again.errors, "impetus: b.ply: exists already and is not overwritten\n");
  EXPECT_EQ(again.status, 2);
}

TEST(MeshCommand, WhatCannotBeRepairedIsRefusedAndNotWritten) {
  const TemporaryFolder folder;
  folder.write("a.obj", std::string(kVertices) + "f 1 2 3\n");
  const ProgramResult result = run_program(folder, {"mesh", "check", "a.obj", "--repair", "b.ply"});
  EXPECT_EQ(result.errors,
            "impetus: a.obj: cannot be repaired: 1 hole cannot be closed without a new defect; "
            "nothing was written\n");
  EXPECT_EQ(result.status, 1);
  EXPECT_FALSE(std::filesystem::exists(folder / "b.ply"));
}

}  // namespace impetus::mesh_command_test
