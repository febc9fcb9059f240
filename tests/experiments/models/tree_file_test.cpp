// Tree files: what is read back is what was written, and nothing else is taken for a tree.
// SPDX-License-Identifier: MIT
#include "experiments/models/tree_file.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cmath>
#include <cstring>
#include <functional>
#include <limits>

#include "engine/shapes/mass_properties.hpp"
#include "engine/shapes/solids/block_meshes.hpp"
#include "experiments/models/tree_header.hpp"
#include "tests/experiments/stored_trees.hpp"
#include "tests/experiments/temporary_folder.hpp"

namespace impetus::tree_file_test {

constexpr std::uint64_t kSeed = 20261121;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// The numbers of a volume; equal for equal bits but for the signs of zeros.
std::vector<double> numbers_of(const Volume& volume) {
  const auto with = [](std::vector<double> all, const auto& vector) {
    for (Eigen::Index i = 0; i < vector.size(); ++i) {
      all.push_back(vector[i]);
    }
    return all;
  };
  struct Visitor {
    decltype(with)& add;
    std::vector<double> operator()(const Sphere& s) { return add({s.radius_m}, s.centre); }
    std::vector<double> operator()(const LineSwept& s) {
      return add(add({s.radius_m}, s.centre), s.half_axis);
    }
    std::vector<double> operator()(const RectangleSwept& s) {
      return add(add(add({s.radius_m}, s.centre), s.half_u), s.half_v);
    }
    std::vector<double> operator()(const Box& b) {
      return add(add(add({}, b.centre), b.half_extents_m), b.orientation.coeffs());
    }
    std::vector<double> operator()(const Cube& c) {
      return add(add({c.half_edge_m}, c.centre), c.orientation.coeffs());
    }
  };
  return std::visit(Visitor{with}, volume);
}

void expect_same(const VolumeTree& one, const VolumeTree& other) {
  ASSERT_EQ(one.node_count(), other.node_count());
  ASSERT_EQ(one.level_count(), other.level_count());
  for (int level = 0; level < one.level_count(); ++level) {
    EXPECT_EQ(one.level_begin(level), other.level_begin(level));
  }
  for (std::int32_t node = 0; node < one.node_count(); ++node) {
    EXPECT_EQ(one.links(node), other.links(node));
    EXPECT_EQ(one.surface(node), other.surface(node));
    EXPECT_EQ(one.volume(node).index(), other.volume(node).index());
    EXPECT_EQ(numbers_of(one.volume(node)), numbers_of(other.volume(node)));
  }
  EXPECT_EQ(one.volumes().are_voxels(), other.volumes().are_voxels());
  EXPECT_EQ(one.volumes().grid(), other.volumes().grid());
  EXPECT_EQ(one.volumes().cells(), other.volumes().cells());
  EXPECT_EQ(one.bytes(), other.bytes());
}

/// The sentence with which bytes are refused, without the file's name; "accepted" when not.
std::string refused(const std::string& bytes) {
  const std::string sentence = sentence_of([&] { stored_tree_from(bytes, "a.tree"); });
  return sentence.starts_with("a.tree: ") ? sentence.substr(8) : sentence;
}

/// The bytes of a tree of one kind with one change, under a checksum that is right.
std::string changed(const StoredTree& tree, const std::function<void(std::string&)>& change) {
  constexpr std::size_t kChecksumLetters = 32;
  std::string bytes = bytes_of(tree);
  bytes.resize(bytes.size() - kChecksumLetters);
  change(bytes);
  return sealed(std::move(bytes));
}

/// Where the header begins, and what follows it.
constexpr std::size_t kHeaderStart = 8 + 4 + 8;

std::size_t volumes_start(const StoredTree& tree) {
  return kHeaderStart + text_of(header_of(tree)).size();
}

template <typename T>
void put(std::string& bytes, std::size_t place, T number) {
  std::memcpy(bytes.data() + place, &number, sizeof number);
}

std::string with_header(const StoredTree& tree, const std::string& from, const std::string& to) {
  return changed(tree, [&](std::string& bytes) {
    const std::size_t place = bytes.find(from);
    ASSERT_NE(place, std::string::npos);
    bytes.replace(place, from.size(), to);
    const std::size_t length = text_of(header_of(tree)).size() + to.size() - from.size();
    put(bytes, 12, static_cast<std::uint64_t>(length));
  });
}

TEST(TreeFile, EveryKindOfVolumeComesBackBitForBit) {
  RandomStream random(kSeed, "tree file");
  SCOPED_TRACE("seed " + std::to_string(kSeed));
  for (int repetition = 0; repetition < 20; ++repetition) {
    for (const StoredTree& tree : all_stored(random)) {
      const std::string bytes = bytes_of(tree);
      const StoredTree again = stored_tree_from(bytes, "a.tree");
      expect_same(tree.tree, again.tree);
      EXPECT_EQ(again.name, tree.name);
      EXPECT_EQ(again.settings, tree.settings);
      EXPECT_EQ(again.mesh.vertices, tree.mesh.vertices);
      EXPECT_EQ(again.mesh.triangles, tree.mesh.triangles);
      EXPECT_EQ(bytes_of(again), bytes);
    }
  }
}

TEST(TreeFile, ABuiltTreeAndItsQualityComeBackFromDisk) {
  const TemporaryFolder folder;
  const TriangleMesh mesh = about_centre_of_mass(l_block_mesh(1.0, 0.35));
  const TreeSettings settings{TreeKind::kOctree, 3, 8};
  const VolumeTree tree = build_tree(mesh, settings);
  const StoredTree stored{"l-block", settings, mesh, tree, measure_levels(mesh, tree)};
  save_tree(stored, folder / "a.tree");
  const StoredTree again = load_tree(folder / "a.tree");
  expect_same(again.tree, tree);
  ASSERT_EQ(again.quality.size(), stored.quality.size());
  for (std::size_t level = 0; level < again.quality.size(); ++level) {
    EXPECT_EQ(again.quality[level].nodes, stored.quality[level].nodes);
    EXPECT_EQ(again.quality[level].worst_protrusion_m, stored.quality[level].worst_protrusion_m);
    EXPECT_EQ(again.quality[level].bytes, stored.quality[level].bytes);
  }
}

TEST(TreeFile, AnExistingFileIsReplacedOnlyWhenAsked) {
  const TemporaryFolder folder;
  RandomStream random(kSeed, "tree file");
  const StoredTree tree = stored_of_all_kinds(random);
  const std::filesystem::path file = folder.write("notes.txt", "mine");
  EXPECT_EQ(sentence_of([&] { save_tree(tree, file); }),
            file.string() + ": exists already and is not overwritten");
  EXPECT_EQ(text_of(file), "mine");
  save_tree(tree, file, /*replace=*/true);
  EXPECT_EQ(text_of(file), bytes_of(tree));
}

TEST(TreeFile, AFileThatCannotBeWrittenLeavesNothingBehind) {
  const TemporaryFolder folder;
  RandomStream random(kSeed, "tree file");
  const std::string file = folder / "none/a.tree";
  EXPECT_EQ(sentence_of([&] { save_tree(stored_of_all_kinds(random), file); }),
            file + ": cannot be written (No such file or directory)");
  std::filesystem::create_directory(folder / "b.tree");  // nothing is renamed over a folder
  EXPECT_EQ(sentence_of([&] { save_tree(stored_of_all_kinds(random), folder / "b.tree", true); }),
            (folder / "b.tree").string() + ": cannot be written (Is a directory)");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

TEST(TreeFile, WhatIsNoTreeFileIsRefusedInOneSentence) {
  const TemporaryFolder folder;
  EXPECT_EQ(sentence_of([&] { load_tree(folder / "a.tree"); }),
            (folder / "a.tree").string() + ": there is no such file");
  EXPECT_EQ(sentence_of([&] { load_tree(folder.path()); }),
            folder.path().string() + ": it is a directory, not a file");
  ASSERT_EQ(mkfifo((folder / "pipe.tree").c_str(), 0600), 0);
  EXPECT_EQ(sentence_of([&] { load_tree(folder / "pipe.tree"); }),
            (folder / "pipe.tree").string() + ": it is a named pipe, not a file");
  EXPECT_EQ(refused("v 0 0 0\n"),
            "expected a tree file, which begins with \"impetree\", got another kind of file");
  EXPECT_EQ(refused(""),
            "expected a tree file, which begins with \"impetree\", got another kind of file");
  EXPECT_EQ(refused("impetree"), "expected 4 bytes more, got 0");
}

TEST(TreeFile, AnotherFormatIsNamed) {
  RandomStream random(kSeed, "tree file");
  EXPECT_EQ(refused(changed(stored_voxels(random),
                            [](std::string& bytes) { put(bytes, 8, std::uint32_t{7}); })),
            "expected a tree file of format 1, got format 7");
}

TEST(TreeFile, AnyFlippedBitAndAnyMissingEndIsNoticed) {
  RandomStream random(kSeed, "tree file");
  const std::string whole = bytes_of(stored_of_all_kinds(random));
  for (std::size_t place = 0; place < whole.size(); place += 7) {
    std::string bytes = whole;
    bytes[place] = static_cast<char>(bytes[place] ^ (1 << (place % 8)));
    EXPECT_NE(refused(bytes), "accepted") << "byte " << place;
    EXPECT_NE(refused(whole.substr(0, place)), "accepted") << "of " << place << " bytes";
  }
  const std::string sentence = refused(whole.substr(0, whole.size() - 1));
  EXPECT_TRUE(sentence.starts_with("expected the checksum ")) << sentence;
  EXPECT_TRUE(sentence.ends_with(" at the end, got another: the file is damaged or cut short"))
      << sentence;
}

TEST(TreeFile, VolumesThatAreNoneAreRefusedByNode) {
  RandomStream random(kSeed, "tree file");
  const StoredTree spheres = stored_of_one_kind(random, 0);
  const std::size_t nodes = small_links().size();
  const std::size_t first = volumes_start(spheres) + nodes;  // after the kinds
  constexpr std::size_t kSphereBytes = 4 * sizeof(double);
  const auto with = [&](std::size_t place, double value) {
    return refused(changed(spheres, [&](std::string& bytes) { put(bytes, place, value); }));
  };
  EXPECT_EQ(with(first + kSphereBytes, kNan), "node 1: expected finite numbers, got nan");
  EXPECT_EQ(with(first + 2 * kSphereBytes + 3 * sizeof(double), -0.5),
            "node 2: expected a size that is not negative, got -0.500000");
  EXPECT_EQ(
      refused(changed(spheres, [&](std::string& bytes) { bytes[volumes_start(spheres)] = 5; })),
      "node 0: expected a kind of volume below 5, got 5.000000");
  const StoredTree cubes = stored_of_one_kind(random, 4);
  const std::size_t turn = volumes_start(cubes) + nodes + 4 * sizeof(double);
  const std::string sentence =
      refused(changed(cubes, [&](std::string& bytes) { put(bytes, turn, 9.0); }));
  EXPECT_TRUE(sentence.starts_with("node 0: expected a unit quaternion, got 9.")) << sentence;
}

TEST(TreeFile, LinksSurfacesAndMeshesThatAreNoneAreRefused) {
  RandomStream random(kSeed, "tree file");
  const StoredTree tree = stored_voxels(random);
  const std::size_t nodes = small_links().size();
  const std::size_t links = volumes_start(tree) + nodes * sizeof(std::uint32_t);
  const std::size_t surfaces = links + nodes * sizeof(NodeLinks);
  const std::size_t mesh = surfaces + nodes * 24;
  const auto with = [&](std::size_t place, auto value) {
    return refused(changed(tree, [&](std::string& bytes) { put(bytes, place, value); }));
  };
  EXPECT_EQ(with(links, std::int32_t{2}),
            "volume tree: nodes are not in breadth-first order by level");
  EXPECT_EQ(with(volumes_start(tree) + 4, std::uint32_t{8}),
            "voxel tree: node 1 lies outside its level's grid");
  EXPECT_EQ(with(surfaces, 1.5F), "node 0: expected an occupancy from 0 to 1, got 1.500000");
  EXPECT_EQ(with(surfaces + 4, std::int32_t{-2}),
            "node 0: expected a group of at least -1, got -2.000000");
  EXPECT_EQ(with(surfaces + 24 + 20, -1.0F),
            "node 1: expected a fit error that is not negative, got -1.000000");
  EXPECT_EQ(with(mesh + 3 * sizeof(double), kNan),
            "expected finite coordinates of the mesh, got none at vertex 1");
  EXPECT_EQ(with(mesh + 8 * 3 * sizeof(double), std::uint32_t{8}),
            "expected triangles of 8 vertices, got one that names vertex 8");
  const std::string sentence = with(mesh, 0.25);
  EXPECT_TRUE(sentence.starts_with("expected the mesh with the hash that the header names, got "))
      << sentence;
  EXPECT_EQ(refused(changed(tree, [](std::string& bytes) { bytes += "more"; })),
            "expected the mesh to end the file, got 4 bytes more");
}

TEST(TreeFile, HeadersThatAreNoneAreRefusedByKey) {
  RandomStream random(kSeed, "tree file");
  const StoredTree tree = stored_voxels(random);
  EXPECT_EQ(refused(with_header(tree, "{\"branching\"", "[\"branching\"")),
            "expected a JSON object as header, got something else");
  EXPECT_EQ(refused(with_header(tree, "\"depth\":2", "\"depth\":9")),
            "header/depth: expected a whole number from 0 to 8, got 9");
  EXPECT_EQ(refused(with_header(tree, "\"depth\":2", "\"death\":2")),
            "header/depth: expected a value, got none");
  EXPECT_EQ(refused(with_header(tree, "\"heterogeneous\"", "\"quadtree\"")),
            "header/kind: tree: expected a kind among octree, medial, voxel, box, swept, "
            "heterogeneous, got \"quadtree\"");
  EXPECT_EQ(refused(with_header(tree, "\"nodes\":6", "\"nodes\":[]")),
            "header/nodes: expected a whole number from 1 to 1000000000, got array");
  EXPECT_EQ(refused(with_header(tree, "\"edge_m\":0.9", "\"edge_m\":-1")),
            "header/grid/edge_m: expected a number that is not negative, got -1");
  EXPECT_EQ(refused(with_header(tree, "\"nodes\":6", "\"nodes\":999999999")),
            "expected 3999999996 bytes more, got 552");
  EXPECT_EQ(refused(with_header(tree, "[0,1,4]", "[0,1,5]")).substr(0, 6), "volume");
}

}  // namespace impetus::tree_file_test
