// The cache of trees: found again, built anew when damaged, never in the way.
// SPDX-License-Identifier: MIT
#include "experiments/models/tree_cache.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <vector>

#include "engine/shapes/mass_properties.hpp"
#include "engine/shapes/solids/block_meshes.hpp"
#include "experiments/models/tree_file.hpp"
#include "tests/experiments/temporary_folder.hpp"

namespace impetus::tree_cache_test {

const TreeSettings kSettings{TreeKind::kOctree, 3, 8};

TriangleMesh block() { return about_centre_of_mass(l_block_mesh(1.0, 0.35)); }

std::string bytes_of_tree(const VolumeTree& tree, const TreeSettings& settings = kSettings) {
  return bytes_of({"", settings, block(), tree});
}

/// Whether the tree was built: a build tells its progress, a file does not.
struct Asked {
  VolumeTree tree;
  bool built;
};

Asked ask(const TreeCache& cache, const TriangleMesh& mesh = block(),
          const TreeSettings& settings = kSettings) {
  bool built = false;
  VolumeTree tree = cache.tree(mesh, settings, [&](double) { built = true; });
  return {std::move(tree), built};
}

TEST(TreeCache, ATreeIsBuiltOnceAndComesBackBitForBit) {
  const TemporaryFolder folder;
  const TreeCache cache(folder / "trees");
  const Asked first = ask(cache);
  const Asked second = ask(cache);
  const Asked without = ask(TreeCache());
  EXPECT_TRUE(first.built);
  EXPECT_FALSE(second.built);
  EXPECT_TRUE(without.built);
  EXPECT_EQ(bytes_of_tree(second.tree), bytes_of_tree(first.tree));
  EXPECT_EQ(bytes_of_tree(without.tree), bytes_of_tree(first.tree));
}

TEST(TreeCache, AWatchHearsOfTreesThatNobodyElseListensTo) {
  std::vector<double> heard;
  {
    const BuildingWatch watch([&](double share) { heard.push_back(share); });
    static_cast<void>(TreeCache().tree(block(), kSettings));
    ASSERT_FALSE(heard.empty());
    EXPECT_EQ(heard.front(), 0.0);
    heard.clear();
    EXPECT_TRUE(ask(TreeCache()).built);  // another one listens
  }
  static_cast<void>(TreeCache().tree(block(), kSettings));
  EXPECT_TRUE(heard.empty());
}

TEST(TreeCache, AnotherMeshOrOtherSettingsAreAnotherTree) {
  const TemporaryFolder folder;
  const TreeCache cache(folder / "trees");
  ask(cache);
  TriangleMesh moved = block();
  moved.vertices[0].x() = std::nextafter(moved.vertices[0].x(), 2.0);
  EXPECT_TRUE(ask(cache, moved).built);
  EXPECT_TRUE(ask(cache, block(), {TreeKind::kOctree, 2, 8}).built);
  EXPECT_TRUE(ask(cache, block(), {TreeKind::kBox, 3, 8}).built);
  EXPECT_TRUE(ask(cache, block(), {TreeKind::kBox, 3, 4}).built);
  EXPECT_FALSE(ask(cache).built);
}

TEST(TreeCache, ADamagedFileIsBuiltAnewAndPutRight) {
  const TemporaryFolder folder;
  const TreeCache cache(folder / "trees");
  const std::string right = bytes_of_tree(ask(cache).tree);
  const std::filesystem::path file = cache.file_of(block(), kSettings);
  const std::string whole = text_of(file);
  for (const std::string& damage : {whole.substr(0, whole.size() / 2), std::string("mine")}) {
    std::ofstream(file, std::ios::binary | std::ios::trunc) << damage;
    const Asked again = ask(cache);
    EXPECT_TRUE(again.built);
    EXPECT_EQ(bytes_of_tree(again.tree), right);
    EXPECT_EQ(text_of(file), whole);
  }
}

TEST(TreeCache, AWholeTreeOfAnotherMeshOrBuilderInItsPlaceIsNotTaken) {
  const TemporaryFolder folder;
  const TreeCache cache(folder / "trees");
  const std::string right = bytes_of_tree(ask(cache).tree);
  const std::filesystem::path file = cache.file_of(block(), kSettings);
  StoredTree other = load_tree(file);
  other.mesh.vertices[0].x() += 1.0;
  save_tree(other, file, true);
  EXPECT_TRUE(ask(cache).built);
  other = load_tree(file);
  other.builder_version += 1;
  save_tree(other, file, true);
  const Asked again = ask(cache);
  EXPECT_TRUE(again.built);
  EXPECT_EQ(bytes_of_tree(again.tree), right);
}

TEST(TreeCache, AFolderThatCannotBeWrittenIsNoError) {
  const TemporaryFolder folder;
  const TreeCache cache(folder.write("file", "in the way") / "trees");
  const Asked first = ask(cache);
  EXPECT_TRUE(ask(cache).built);
  EXPECT_EQ(bytes_of_tree(first.tree), bytes_of_tree(ask(TreeCache()).tree));
}

TEST(TreeCache, ManyWritersAtOnceLeaveOneWholeFile) {
  const TemporaryFolder folder;
  const TreeCache cache(folder / "trees");
  std::vector<pid_t> children;
  for (int writer = 0; writer < 6; ++writer) {
    children.push_back(fork());
    if (children.back() == 0) {
      bool right = true;
      const std::string expected = bytes_of_tree(build_tree(block(), kSettings));
      for (int repetition = 0; repetition < 10; ++repetition) {
        std::error_code ignored;
        std::filesystem::remove(cache.file_of(block(), kSettings), ignored);
        right = right && bytes_of_tree(cache.tree(block(), kSettings)) == expected;
      }
      _exit(right ? 0 : 1);
    }
  }
  for (const pid_t child : children) {
    int status = -1;
    waitpid(child, &status, 0);
    EXPECT_EQ(status, 0);
  }
  EXPECT_FALSE(ask(cache).built);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder / "trees"), {}), 1);
}

TEST(TreeCache, TheUsersFolderFollowsTheEnvironment) {
  const auto folder_under = [](const char* own, const char* caches, const char* home) {
    const auto set = [](const char* name, const char* value) {
      value == nullptr ? unsetenv(name) : setenv(name, value, 1);
    };
    std::string before[3];
    const char* names[] = {"IMPETUS_TREE_CACHE", "XDG_CACHE_HOME", "HOME"};
    const char* values[] = {own, caches, home};
    bool was_set[3];
    for (int i = 0; i < 3; ++i) {
      const char* value = std::getenv(names[i]);
      was_set[i] = value != nullptr;
      before[i] = was_set[i] ? value : "";
      set(names[i], values[i]);
    }
    const auto folder = TreeCache::of_user().folder();
    for (int i = 0; i < 3; ++i) {
      set(names[i], was_set[i] ? before[i].c_str() : nullptr);
    }
    return folder ? folder->string() : "none";
  };
  EXPECT_EQ(folder_under(nullptr, "/c", "/h"), "/c/impetus/trees");
  EXPECT_EQ(folder_under(nullptr, "relative", "/h"), "/h/.cache/impetus/trees");
  EXPECT_EQ(folder_under(nullptr, nullptr, "/h"), "/h/.cache/impetus/trees");
  EXPECT_EQ(folder_under(nullptr, nullptr, nullptr), "none");
  EXPECT_EQ(folder_under("/mine", "/c", "/h"), "/mine");
  EXPECT_EQ(folder_under("off", "/c", "/h"), "none");
}

}  // namespace impetus::tree_cache_test
