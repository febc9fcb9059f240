// A crowd that has room on the screen of the checks, but not on the laboratory's, is refused in one
// sentence wherever its scene is staged.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "experiments/protocol/protocol_scenes.hpp"
#include "tests/experiments/command_lines.hpp"
#include "tests/experiments/refusals.hpp"

namespace impetus::no_room_test {

constexpr double kWide_m = 0.1;
constexpr double kAway_m = 0.57;

/// The enclosure is all that the viewer sees: the smaller the screen, the less room.
json crowded_scene() {
  json scene = json::parse(shipped("stimuli/spheres-in-view.json"));
  scene["crowd"]["count"] = 300;
  return scene;
}

const std::string kSentence =
    "/crowd/count: expected as many bodies as the enclosure has room for on a screen of 10 cm x 10 "
    "cm seen from 57 cm, got 300";

TEST(NoRoom, ATrialNamesTheSceneAndTheScreen) {
  json document = json::parse(shipped("protocols/scheduler-distribution.json"));
  const Protocol protocol = make_protocol(parse_json("d.json", document.dump()),
                                          parse_json("s.json", crowded_scene().dump()));
  const ProtocolScenes scenes(protocol, 0.0);
  ScreenGeometry screen;
  screen.width_m = kWide_m;
  screen.height_m = kWide_m;
  screen.viewing_distance_m = kAway_m;
  EXPECT_EQ(
      refusal([&] { static_cast<void>(scenes.stage(cells(protocol.design).front(), screen)); }),
      "s.json:" + kSentence);
}

TEST(NoRoom, CommandsRefuseTheScene) {
  const TemporaryFolder folder;
  folder.write("s.json", crowded_scene().dump());
  folder.write("screen.json",
               R"({"schema_version": 1, "width_cm": 10, "height_cm": 10,
                   "viewing_distance_cm": 57})");
  expect_refused(folder, {"trade", "s.json", "--screen", "screen.json"}, "s.json:" + kSentence);
  EXPECT_FALSE(std::filesystem::exists(folder / "trade"));
#ifdef IMPETUS_PROGRAM_HAS_WINDOW
  expect_refused(folder, {"preview", "s.json", "--screen", "screen.json", "--strip", "a.png"},
                 "s.json:" + kSentence);
#endif
}

}  // namespace impetus::no_room_test
