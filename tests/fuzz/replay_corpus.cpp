// The fuzzers' seeds, cut short and damaged, and what the fuzzers once found, in the ordinary
// build.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>

#include "tests/fuzz/seeds.hpp"
#include "tests/fuzz/targets.hpp"
#include "tests/places/places.hpp"

namespace impetus {
namespace {

constexpr std::uint64_t kSeed = 20261121;

using Target = std::function<void(std::string_view)>;

/// Every seed, its beginnings, and copies with random bytes changed.
void feed(const Target& target, const std::vector<std::string>& seeds, int changes) {
  RandomStream random(kSeed, "fuzz");
  SCOPED_TRACE("seed " + std::to_string(kSeed));
  for (const std::string& seed : seeds) {
    target(seed);
    for (int i = 0; i < changes; ++i) {
      target(seed.substr(0, random.below(seed.size())));
      std::string changed = seed;
      for (int byte = 0; byte < 3; ++byte) {
        changed[random.below(changed.size())] = static_cast<char>(random.below(256));
      }
      target(changed);
    }
  }
}

/// Committed files that once crashed something; there may be none.
void feed_found(const Target& target, const std::string& kind) {
  const std::filesystem::path folder =
      std::filesystem::path(source_folder()) / "tests/fuzz/found" / kind;
  if (!std::filesystem::exists(folder)) {
    return;
  }
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    std::ifstream file(entry.path(), std::ios::binary);
    target(std::string{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()});
  }
}

TEST(FuzzCorpus, NoMeshFileEndsTheProgram) {
  feed(fuzz_mesh_file, mesh_seeds(), 20);
  feed_found(fuzz_mesh_file, "mesh");
}

TEST(FuzzCorpus, NoTreeFileEndsTheProgram) {
  feed(fuzz_tree_file, tree_seeds(), 300);
  feed_found(fuzz_tree_file, "tree");
}

TEST(FuzzCorpus, EverySeedIsAccepted) {
  for (const std::string& seed : tree_seeds()) {
    EXPECT_EQ(sentence_of([&] { stored_tree_from(sealed(seed), "a.tree"); }), "accepted");
  }
}

}  // namespace
}  // namespace impetus
