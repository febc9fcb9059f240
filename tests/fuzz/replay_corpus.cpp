// The fuzzers' seeds, cut short and damaged, and what the fuzzers once found, in the ordinary
// build.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>

#include "experiments/protocol/protocol_file.hpp"
#include "tests/fuzz/json_mutation.hpp"
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
  feed_found(fuzz_mesh_file, "mesh_file");
}

TEST(FuzzCorpus, NoLinesOfAPageEndTheProgram) {
  feed(fuzz_lines, lines_seeds(), 60);
  feed_found(fuzz_lines, "lines");
}

TEST(FuzzCorpus, NothingThatATrackerSendsEndsTheProgram) {
  feed(fuzz_tracker, tracker_seeds(), 2000);
  feed_found(fuzz_tracker, "tracker");
  // A list in a list in a list, a million deep.
  fuzz_tracker(std::string(1, static_cast<char>(kPupilMessage)) + std::string(1 << 20, '\x91'));
}

TEST(FuzzCorpus, NoTreeFileEndsTheProgram) {
  feed(fuzz_tree_file, tree_seeds(), 300);
  feed_found(fuzz_tree_file, "tree_file");
}

/// Every seed, and copies with one value changed after the other.
void feed_json(const Target& target, const std::vector<std::string>& seeds, int changes) {
  RandomStream random(kSeed, "fuzz JSON");
  SCOPED_TRACE("seed " + std::to_string(kSeed));
  for (const std::string& seed : seeds) {
    target(seed);
    std::string changed = seed;
    for (int i = 0; i < changes; ++i) {
      constexpr int kInARow = 3;
      changed = mutated_pair(i % kInARow == 0 ? seed : changed, random);
      target(changed);
    }
  }
}

TEST(FuzzCorpus, NoProtocolEndsTheProgram) {
  feed_json(fuzz_protocol, protocol_seeds(), 20);
  feed(fuzz_protocol, protocol_seeds(), 5);
  feed_found(fuzz_protocol, "protocol");
}

TEST(FuzzCorpus, NoSceneEndsTheProgram) {
  feed_json(fuzz_scene, scene_seeds(), 60);
  feed(fuzz_scene, scene_seeds(), 5);
  feed_found(fuzz_scene, "scene");
}

TEST(FuzzCorpus, NoStudyEndsTheProgram) {
  feed(fuzz_study, study_seeds(), 1);
  feed_found(fuzz_study, "study");
}

TEST(FuzzCorpus, EverySeedOfAProtocolIsAProtocol) {
  for (const std::string& seed : protocol_seeds()) {
    const std::size_t end = seed.find(kPartSeparator);
    const auto act = [&] {
      make_protocol(parse_json("protocol.json", seed.substr(0, end)),
                    parse_json("scene.json", seed.substr(end + 1)));
    };
    EXPECT_EQ(sentence_of(act), "accepted");
  }
}

TEST(FuzzCorpus, EverySeedIsAccepted) {
  for (const std::string& seed : tree_seeds()) {
    EXPECT_EQ(sentence_of([&] { stored_tree_from(sealed(seed), "a.tree"); }), "accepted");
  }
}

}  // namespace
}  // namespace impetus
