// A protocol's checks, its solved values and its trials build each of its shapes once.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <filesystem>

#include "experiments/files/protocol_files.hpp"
#include "experiments/protocol/protocol_scenes.hpp"
#include "experiments/protocol/screen_file.hpp"
#include "tests/places/places.hpp"

namespace impetus::shapes_built_test {

/// Whatever is built goes into the protocol's library: nobody has one of its own.
void expect_all_in_the_protocols_library(const char* file) {
  const std::int64_t before = ShapeLibrary::built_by_all();
  const Protocol protocol = load_protocol(std::filesystem::path(source_folder()) / file);
  ProtocolScenes(protocol, 0.0).build_shapes(assumed_screen());
  EXPECT_EQ(ShapeLibrary::built_by_all() - before,
            static_cast<std::int64_t>(protocol.shapes->size()))
      << file;
}

TEST(ShapesBuilt, ChecksAndTrialsShareOneLibrary) {
  for (const char* file :
       {"protocols/response.json", "protocols/figures.json", "protocols/gap.json"}) {
    expect_all_in_the_protocols_library(file);
  }
}

TEST(ShapesBuilt, AProtocolReadAgainFromTextsTakesShapesThatAreThere) {
  const Protocol first =
      load_protocol(std::filesystem::path(source_folder()) / "protocols/response.json");
  const std::int64_t before = ShapeLibrary::built_by_all();
  static_cast<void>(make_protocol(first.document, first.scene, first.shapes));
  EXPECT_EQ(ShapeLibrary::built_by_all(), before);
}

}  // namespace impetus::shapes_built_test
