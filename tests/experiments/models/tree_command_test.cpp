// `impetus tree` as a researcher meets it: a table, a file, pictures, sentences.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "experiments/models/named_shape.hpp"
#include "experiments/models/tree_file.hpp"
#include "tests/experiments/program.hpp"

namespace impetus::tree_command_test {

const char kTetrahedron[] =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

ProgramResult build(const TemporaryFolder& folder, std::vector<std::string> words) {
  words.insert(words.begin(), {"tree", "build"});
  return run_program(folder, words);
}

TEST(TreeCommand, EveryShapeBecomesATreeFileWithARowForEachLevel) {
  const TemporaryFolder folder;
  for (const std::string& shape : shape_names()) {
    const ProgramResult result =
        build(folder, {shape, "--kind", "octree", "--depth", "2", "-o", shape + ".tree"});
    EXPECT_EQ(complaints_of(result), "") << shape;
    EXPECT_EQ(result.status, 0) << shape;
    const StoredTree stored = load_tree(folder / (shape + ".tree"));
    EXPECT_EQ(stored.name, shape);
    EXPECT_EQ(stored.settings, (TreeSettings{TreeKind::kOctree, 2, 8}));
    const auto levels = static_cast<std::size_t>(stored.tree.level_count());
    EXPECT_EQ(stored.quality.size(), levels);
    const std::vector<std::string> lines = lines_of(result.output);
    ASSERT_EQ(lines.size(), levels + 3) << result.output;  // what, heading, where
    EXPECT_TRUE(lines[0].starts_with(shape + ": octree of ")) << lines[0];
    EXPECT_TRUE(lines[1].starts_with("level     nodes  worst protrusion")) << lines[1];
    EXPECT_TRUE(lines[2].starts_with("    0         1 ")) << lines[2];
    EXPECT_TRUE(lines.back().starts_with("written to " + shape + ".tree, ")) << lines.back();
  }
}

TEST(TreeCommand, AFileWinsOverTheShapeOfItsName) {
  const TemporaryFolder folder;
  const auto triangles = [&](const char* what) {
    const ProgramResult result = build(folder, {what, "--depth", "1", "--force", "-o", "a.tree"});
    EXPECT_EQ(result.status, 0) << result.errors;
    return load_tree(folder / "a.tree").mesh.triangles.size();
  };
  EXPECT_EQ(triangles("box"), 12U);
  folder.write("box", kTetrahedron);
  EXPECT_EQ(triangles("box"), 4U);
}

TEST(TreeCommand, ResolutionMakesAShapeFiner) {
  const TemporaryFolder folder;
  const auto triangles = [&](const char* resolution) {
    build(folder, {"knot", "--depth", "0", "--resolution", resolution, "--force", "-o", "a.tree"});
    return load_tree(folder / "a.tree").mesh.triangles.size();
  };
  EXPECT_EQ(triangles("4"), 2U * 32U * 4U);
  EXPECT_EQ(triangles("12"), 2U * 96U * 12U);
}

TEST(TreeCommand, WhatCannotBeBuiltIsRefusedInOneSentence) {
  const TemporaryFolder folder;
  folder.write("open.obj", std::string(kTetrahedron).substr(0, 56));
  folder.write("there.tree", "mine");
  std::filesystem::create_directory(folder / "folder.tree");
  struct Case {
    std::vector<std::string> words;
    int status;
    std::string sentence;
  };
  const std::vector<Case> cases{
      {{"cube", "-o", "a.tree"},
       2,
       "expected a mesh file or one of the shapes sphere, box, l-block, plate, torus, knot, "
       "creature, line-swept, rectangle-swept, got \"cube\""},
      {{"box", "--kind", "ball", "-o", "a.tree"},
       2,
       "tree: expected a kind among octree, medial, voxel, box, swept, heterogeneous, got "
       "\"ball\""},
      {{"box", "--depth", "9", "-o", "a.tree"}, 2, "tree: expected a depth from 0 to 8, got 9"},
      {{"box", "--branching", "4", "-o", "a.tree"},
       2,
       "tree: expected a branching of 8 for an octree, got 4"},
      {{"box", "--resolution", "5", "-o", "a.tree"},
       2,
       "expected no resolution for the shape box, got 5"},
      {{"knot", "--resolution", "13", "-o", "a.tree"},
       2,
       "expected a resolution from 4 to 12, got 13"},
      {{"open.obj", "--resolution", "5", "-o", "a.tree"},
       2,
       "--resolution: expected none for the mesh file open.obj, got 5"},
      {{"open.obj", "-o", "a.tree"}, 1, "open.obj: cannot be simulated: it has 3 open edges"},
      {{"box", "-o", "there.tree"},
       2,
       "there.tree: exists already and is not overwritten without --force"},
      {{"open.obj", "-o", "none/a.tree"},  // before the mesh is looked at
       2,
       "none/a.tree: cannot be written (No such file or directory)"},
      {{"open.obj", "--force", "-o", "folder.tree"},
       2,
       "folder.tree: cannot be written (Is a directory)"},
  };
  for (const Case& each : cases) {
    const ProgramResult result = build(folder, each.words);
    EXPECT_EQ(complaints_of(result), "impetus: " + each.sentence + "\n");
    EXPECT_EQ(result.status, each.status) << each.sentence;
  }
  EXPECT_EQ(text_of(folder / "there.tree"), "mine");
  EXPECT_FALSE(std::filesystem::exists(folder / "a.tree"));
  for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
    EXPECT_FALSE(entry.path().filename().string().starts_with("folder.tree.")) << "left behind";
  }
  EXPECT_EQ(build(folder, {"box", "--force", "-o", "there.tree"}).status, 0);
  EXPECT_EQ(load_tree(folder / "there.tree").name, "box");
}

TEST(TreeCommand, WhatIsNoTreeFileIsNotShown) {
  const TemporaryFolder folder;
  folder.write("a.tree", "mine");
  const ProgramResult result = run_program(folder, {"tree", "show", "a.tree", "--png", "a.png"});
  EXPECT_EQ(result.errors,
            "impetus: a.tree: expected a tree file, which begins with \"impetree\", got another "
            "kind of file\n");
  EXPECT_EQ(result.status, 2);
}

#ifdef IMPETUS_PROGRAM_HAS_WINDOW

/// Width and height of a PNG file, from its header; zeros when it is none.
std::pair<unsigned, unsigned> size_of_png(const std::string& bytes) {
  const auto number = [&](std::size_t place) {
    unsigned value = 0;
    for (std::size_t i = place; i < place + 4; ++i) {
      value = value << 8U | static_cast<unsigned char>(bytes[i]);
    }
    return value;
  };
  const bool is_png = bytes.size() > 24 && bytes.substr(1, 3) == "PNG";
  return is_png ? std::pair(number(16), number(20)) : std::pair(0U, 0U);
}

class TreePictures : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(build(folder_, {"l-block", "--depth", "3", "-o", "a.tree"}).status, 0);
  }

  /// The bytes of the picture that `words` ask for, drawn without a display.
  std::string picture(std::vector<std::string> words, const std::string& option = "--png") {
    words.insert(words.begin(), {"tree", "show", "a.tree", option, "a.png"});
    const ProgramResult result = run_program(folder_, words);
    EXPECT_EQ(result.status, 0) << result.errors;
    std::string bytes = text_of(folder_ / "a.png");
    std::filesystem::remove(folder_ / "a.png");
    return bytes;
  }

  TemporaryFolder folder_;
};

TEST_F(TreePictures, LevelsColoursAndTheMeshMakeDifferentPictures) {
  const std::vector<std::string> small{"--width", "160", "--height", "120"};
  const auto with = [&](const std::vector<std::string>& more) {
    std::vector<std::string> words = small;
    words.insert(words.end(), more.begin(), more.end());
    return picture(words);
  };
  const std::vector<std::string> pictures{
      with({"--level", "0"}), with({"--level", "1"}),          with({"--level", "2"}),
      with({"--level", "3"}), with({"--colour", "occupancy"}), with({"--colour", "group"}),
      with({"--no-mesh"}),    with({"--no-volumes"})};
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    EXPECT_EQ(size_of_png(pictures[i]), std::pair(160U, 120U));
    EXPECT_GT(pictures[i].size(), 1000U) << "an empty picture packs to a few hundred bytes";
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_NE(pictures[i], pictures[j]) << i << " and " << j;
    }
  }
  EXPECT_EQ(with({}), pictures[3]) << "the finest level when none is given";
}

TEST_F(TreePictures, AStripHasAllLevelsSideBySide) {
  EXPECT_EQ(size_of_png(picture({"--width", "100", "--height", "90"}, "--strip")),
            std::pair(400U, 90U));
}

TEST_F(TreePictures, NothingIsOverwritten) {
  const std::string before = text_of(folder_ / "a.tree");
  for (const std::string option : {"--png", "--strip"}) {
    const ProgramResult result = run_program(folder_, {"tree", "show", "a.tree", option, "a.tree"});
    EXPECT_EQ(result.errors, "impetus: a.tree: exists already and is not overwritten\n");
    EXPECT_EQ(result.status, 2);
  }
  EXPECT_EQ(text_of(folder_ / "a.tree"), before);
}

TEST_F(TreePictures, APictureIsAPngFileAndAloneHasASize) {
  const auto refused = [&](const std::vector<std::string>& words) {
    std::vector<std::string> all{"tree", "show", "a.tree"};
    all.insert(all.end(), words.begin(), words.end());
    return run_program(folder_, all).errors;
  };
  EXPECT_EQ(refused({"--png", "a.jpg"}),
            "impetus: --png: expected a picture's name, which ends in .png, got a.jpg\n");
  EXPECT_EQ(refused({"--height", "90"}),
            "impetus: --height: expected --png or --strip beside it, which is missing\n");
}

TEST_F(TreePictures, WhatCannotBePicturedIsRefused) {
  struct Case {
    std::vector<std::string> words;
    std::string sentence;
  };
  for (const Case& each : std::vector<Case>{
           {{"--level", "4"}, "--level: expected a level from 0 to 3, got 4"},
           {{"--colour", "depth"}, "--colour: expected one of level, occupancy, group, got depth"},
           {{"--width", "9000"}, "--width: expected from 1 to 8192 pixels, got 9000"}}) {
    std::vector<std::string> words{"tree", "show", "a.tree", "--png", "a.png"};
    words.insert(words.end(), each.words.begin(), each.words.end());
    const ProgramResult result = run_program(folder_, words);
    EXPECT_EQ(result.errors, "impetus: " + each.sentence + "\n");
    EXPECT_EQ(result.status, 2);
  }
}

TEST_F(TreePictures, WithoutADisplayThereIsNoWindow) {
  const ProgramResult result = run_program(folder_, {"tree", "show", "a.tree"});
  EXPECT_TRUE(result.errors.starts_with("impetus: no display could be opened: ")) << result.errors;
  EXPECT_EQ(result.status, 2);
}

#endif

}  // namespace impetus::tree_command_test
