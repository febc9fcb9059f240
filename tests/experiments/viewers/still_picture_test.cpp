// Pictures of scenes as participants see them: what an appearance changes of them, and what not.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include "tests/experiments/command_lines.hpp"
#include "tests/experiments/program.hpp"
#include "tests/experiments/test_scenes.hpp"

#ifdef IMPETUS_PROGRAM_HAS_WINDOW
#include "tests/experiments/read_png.hpp"

namespace impetus::still_picture_test {

/// How much lighter pictures are than black, pixel by pixel: sums tell which is darker.
long brightness(const Pixels& picture) {
  return std::accumulate(picture.rgb.begin(), picture.rgb.end(), 0L);
}

class StillPicture : public ::testing::Test {
 protected:
  ProgramResult write(const json& scene, std::vector<std::string> words = {}) {
    folder_.write("scene.json", scene.dump());
    words.insert(words.begin(), {"preview", "scene.json", "--picture", "a.png"});
    return run_program(folder_, words);
  }

  /// At contact, 320 pixels wide, which is half a degree of the two balls' one to 8 pixels or so.
  Pixels picture(const json& scene, const std::string& at_s = "1") {
    std::filesystem::remove(folder_ / "a.png");
    const ProgramResult result = write(scene, {"--width", "320", "--at", at_s});
    EXPECT_EQ(result.status, 0) << result.errors;
    return read_png(folder_ / "a.png");
  }

  /// Two balls of 3° seen from above; they touch at 1 s.
  static json balls(const json& appearance = json::object()) {
    json scene = json::parse(shipped("stimuli/two-spheres.json"));
    scene["viewer"]["elevation_deg"] = 25;
    scene["bodies"][0]["shape"]["radius_deg"] = 3;
    scene["bodies"][1]["shape"]["radius_deg"] = 3;
    scene["appearance"] = appearance;
    return scene;
  }

  TemporaryFolder folder_;
};

TEST_F(StillPicture, OfASceneThatNamesWhatIsUsualIsThatOfOneThatSaysNothing) {
  for (const char* name : {"two-spheres", "two-l-blocks", "l-blocks-in-a-cube"}) {
    const json scene = json::parse(shipped(std::string("stimuli/") + name + ".json"));
    const json usual = json::parse(R"({"ground": "none", "cast_shadows": 0, "contact_shadows": 0,
      "texture": "none", "gloss": 0.1, "smooth_below_deg": 30, "colours": "given"})");
    EXPECT_EQ(picture(changed(scene, "/appearance", usual)).rgb, picture(scene).rgb) << name;
  }
}

TEST_F(StillPicture, IsTheSameEachTime) {
  const json scene = json::parse(shipped("stimuli/two-balls-on-the-ground.json"));
  EXPECT_EQ(picture(scene).rgb, picture(scene).rgb);
}

TEST_F(StillPicture, OfEachChoiceDiffersFromTheUsualOne) {
  const json choices = json::parse(R"([
    {}, {"ground": "plain"}, {"ground": "checks"}, {"cast_shadows": 0.8}, {"texture": "wood"},
    {"texture": "marble"}, {"texture": "speckles"}, {"gloss": 0.5},
    {"lights": [{"azimuth_deg": 60, "elevation_deg": 30}]},
    {"lights": [{"azimuth_deg": 60, "elevation_deg": 30},
                {"azimuth_deg": -60, "elevation_deg": 30}]}])");
  std::map<std::vector<std::uint8_t>, std::string> pictures;
  for (const json& choice : choices) {
    const auto [known, is_new] = pictures.emplace(picture(balls(choice)).rgb, choice.dump());
    EXPECT_TRUE(is_new) << choice << " looks like " << known->second;
  }
}

TEST_F(StillPicture, SmoothingShadesFacesAsOne) {
  json scene = json::parse(shipped("stimuli/two-l-blocks.json"));
  const auto colours = [&](double below_deg) {
    scene["appearance"] = {{"smooth_below_deg", below_deg}, {"gloss", 0}};
    const Pixels shown = picture(scene, "0");
    std::set<std::vector<std::uint8_t>> found;
    for (std::size_t pixel = 0; pixel + 2 < shown.rgb.size(); pixel += 3) {
      found.insert({shown.rgb[pixel], shown.rgb[pixel + 1], shown.rgb[pixel + 2]});
    }
    return found.size();
  };
  EXPECT_GT(colours(120), 4 * colours(0)) << "each face of a block has one, but for its edges";
}

TEST_F(StillPicture, CastShadowsDarkenTheGroundTheMoreTheStronger) {
  const auto bright = [&](double share) {
    return brightness(picture(balls({{"ground", "plain"}, {"cast_shadows", share}})));
  };
  const long none = bright(0);
  const long half = bright(0.4);
  const long much = bright(0.8);
  EXPECT_GT(none - half, 1000) << "hundreds of pixels, tens of grey values each";
  EXPECT_GT(half - much, 1000);
}

TEST_F(StillPicture, CastShadowsOfEachLightAreTheirOwn) {
  const json left = {{"azimuth_deg", -60}, {"elevation_deg", 40}, {"strength", 0.5}};
  const json right = {{"azimuth_deg", 60}, {"elevation_deg", 40}, {"strength", 0.5}};
  const auto lost = [&](const json& lights) {
    json looks = {{"ground", "plain"}, {"lights", lights}};
    const long open = brightness(picture(balls(looks)));
    looks["cast_shadows"] = 0.9;
    return open - brightness(picture(balls(looks)));
  };
  const long both = lost(json::array({left, right}));
  EXPECT_GT(lost(json::array({left})), 1000);
  EXPECT_GT(both, lost(json::array({left})) + lost(json::array({right})) / 4)
      << "light is no sum where it is seen as sRGB";
}

TEST_F(StillPicture, ContactShadowsDarkenTheGroundTheMoreTheNearerTheBody) {
  const auto lost = [&](double ground_deg) {
    json looks = {{"ground", "plain"}, {"ground_deg", ground_deg}};
    const long open = brightness(picture(balls(looks)));
    looks["contact_shadows"] = 0.8;
    return open - brightness(picture(balls(looks)));
  };
  const long touching = lost(-3.0);
  const long near = lost(-4.0);
  EXPECT_GT(touching, near + 500);
  EXPECT_GT(near, 500);
  EXPECT_EQ(lost(-6.0), 0) << "beyond their reach of seven tenths of a radius";
}

TEST_F(StillPicture, ShadowsFallOnWallsAndOnBodies) {
  json cube = json::parse(shipped("stimuli/l-blocks-in-a-cube.json"));
  const long open = brightness(picture(cube, "0"));
  cube["appearance"] = {{"cast_shadows", 0.8}};
  EXPECT_GT(open - brightness(picture(cube, "0")), 1000);
  const json side = {{{"azimuth_deg", -90}, {"elevation_deg", 0}}};
  const long lit = brightness(picture(balls({{"lights", side}})));
  const long shaded = brightness(picture(balls({{"lights", side}, {"cast_shadows", 1}})));
  EXPECT_GT(lit - shaded, 1000) << "the left ball stands in the right one's light";
}

TEST_F(StillPicture, ALitSphereHasNoShadowOfItsOwn) {
  json one = json::parse(shipped("stimuli/spheres-in-view.json"));
  one["crowd"]["count"] = 1;
  one.erase("enclosure");
  one.erase("crowd");
  one["engine"].erase("schedule");
  one["bodies"] = json::parse(R"([{"name": "ball", "shape": {"kind": "sphere", "radius_deg": 6},
    "density_kg_m3": 1000, "colour": "#808080", "position_deg": [0, 0, 0]}])");
  one["appearance"] = {{"gloss", 0}};
  const Pixels open = picture(one, "0");
  one["appearance"]["cast_shadows"] = 1;
  const Pixels shaded = picture(one, "0");
  int most = 0;
  for (std::size_t i = 0; i < open.rgb.size(); ++i) {
    most = std::max(most, open.rgb[i] - shaded.rgb[i]);
  }
  EXPECT_LE(most, 12) << "but for a trace where it turns from the light";
}

TEST_F(StillPicture, IsOfTheMomentThatIsAskedFor) {
  EXPECT_NE(picture(balls(), "0.5").rgb, picture(balls(), "0.9").rgb);
  std::filesystem::remove(folder_ / "a.png");
  const ProgramResult late = write(balls(), {"--at", "5"});
  EXPECT_EQ(late.errors, kAssumedScreen +
                             "impetus: --at: expected from 0 to the 2 s that the scene lasts, got "
                             "5\n");
  EXPECT_EQ(late.status, 2);
}

}  // namespace impetus::still_picture_test

#endif
