// What an observer and a screen file must be: every refusal, word for word.
// SPDX-License-Identifier: MIT
#include "experiments/protocol/observer_file.hpp"
#include "experiments/protocol/screen_file.hpp"
#include "tests/experiments/refusals.hpp"
#include "tests/places/places.hpp"

namespace impetus::lab_files_test {

// ---------------------------------------------------------------- the observer's file

/// A shipped observer with one value changed, refused.
std::string observer_refusal(const TemporaryFolder& folder, const std::string& pointer,
                             const json& value, const std::string& name = "causality") {
  json observer = json::parse(shipped("experiments/observers/" + name + ".json"));
  observer[json::json_pointer(pointer)] = value;
  const std::string path = folder.write("o.json", observer.dump()).string();
  const std::string sentence = refusal([&] { load_observer(path, "protocols/causality.json"); });
  return sentence.rfind(path, 0) == 0 ? "o.json" + sentence.substr(path.size()) : sentence;
}

TEST(ObserverFile, EveryRefusalNamesThePlace) {
  const TemporaryFolder folder;
  const std::vector<Case> cases{
      {"/observer", "gaze",
       "o.json:/observer: expected one of \"adapting\", \"awaiting\", \"bouncing\", \"causality\", "
       "\"counterfactual\", \"foreseeing\", \"gap\", \"gap-thresholds\", "
       "\"gaze-contingent\", \"launching\", \"psychometric\", \"rebound\", \"response\", "
       "got \"gaze\""},
      {"/parameters/lapse_rate/value", 2,
       "o.json:/parameters/lapse_rate/value: expected a number ≥ 0 and ≤ 1, got 2"},
      {"/parameters/threshold_sd_ms/value", -1,
       "o.json:/parameters/threshold_sd_ms/value: expected a number ≥ 0 and ≤ 1000000000, got -1"},
      {"/parameters/threshold_width_ms/value", 0,
       "o.json:/parameters/threshold_width_ms/value: expected a number ≥ 0.001 and ≤ 1000000000, "
       "got 0"},
      {"/parameters/baseline/source", "",
       "o.json:/parameters/baseline/source: expected a text that is not empty, got \"\""},
      {"/parameters/baseline", -2.2, "o.json:/parameters/baseline: expected an object, got -2.2"},
      {"/parameters/cut_2_3/value", -1.5,
       "o.json:/parameters/cut_2_3/value: expected more than cut_1_2, got -1.5"},
      {"/parameters/cut_3_4",
       {{"value", 1.1}, {"unit", "logit"}, {"source", "assumed"}},
       "o.json:/parameters/cut_3_4/value: expected more than cut_2_3, got 1.1"},
      {"/parameters/cut_2_3",
       {{"value", 1}, {"unit", "logit"}},
       "o.json:/parameters/cut_2_3: expected the key \"source\", which is missing"}};
  for (const Case& one : cases) {
    EXPECT_EQ(observer_refusal(folder, one.pointer, one.value), one.sentence);
  }
  EXPECT_EQ(observer_refusal(folder, "/note", "mine"), "accepted");
}

TEST(ObserverFile, AnEyesTimesAndRatesAreWithinReach) {
  const TemporaryFolder folder;
  const std::vector<Case> cases{
      {"/parameters/fixation_max_ms/value", 150,
       "o.json:/parameters/fixation_max_ms/value: expected at least fixation_min_ms, got 150"},
      {"/parameters/pursuit_max_ms/value", 399,
       "o.json:/parameters/pursuit_max_ms/value: expected at least pursuit_min_ms, got 399"},
      {"/parameters/sampling_hz/value", 30,
       "o.json:/parameters/sampling_hz/value: expected a number ≥ 60 and ≤ 1000, got 30"},
      {"/parameters/cut_4_5/value", 0,
       "o.json:/parameters/cut_4_5/value: expected more than cut_3_4, got 0"}};
  for (const Case& one : cases) {
    EXPECT_EQ(observer_refusal(folder, one.pointer, one.value, "gaze-contingent"), one.sentence);
  }
  EXPECT_EQ(observer_refusal(folder, "/parameters/sampling_hz/value", 1000, "gaze-contingent"),
            "accepted");
}

TEST(ObserverFile, AnswersOnOnePointMoreThanItHasCuts) {
  for (const auto& [name, points] : std::vector<std::pair<std::string, std::size_t>>{
           {"causality", 3}, {"gap", 3}, {"gaze-contingent", 5}}) {
    const auto path =
        std::filesystem::path(source_folder()) / "experiments/observers" / (name + ".json");
    EXPECT_EQ(load_observer(path.string(), "x").parameters->points(), points) << name;
  }
}

TEST(ObserverFile, AnUnknownNameIsRefusedWithWhatListsThem) {
  const TemporaryFolder folder;
  EXPECT_EQ(refusal([&] { load_observer("nobody", folder / "protocols/a.json"); }),
            "--observer nobody: expected a file, or a name that `impetus observers` lists");
}

// ---------------------------------------------------------------- the screen's file

TEST(ScreenFile, EveryRefusalNamesThePlace) {
  const TemporaryFolder folder;
  const std::string path = (folder / "screen.json").string();
  const auto refused = [&](const std::string& text) {
    folder.write("screen.json", text);
    return refusal([&] { load_screen(path); });
  };
  EXPECT_EQ(refused(R"({"schema_version": 1, "width_cm": 40, "height_cm": 30})"),
            path + ":/: expected the key \"viewing_distance_cm\", which is missing");
  EXPECT_EQ(refused(R"({"schema_version": 1, "width_cm": 0.4, "height_cm": 30,
                        "viewing_distance_cm": 57})"),
            path + ":/width_cm: expected a number ≥ 10 and ≤ 300, got 0.4");
  EXPECT_EQ(refused(R"({"schema_version": 1, "width_cm": 40, "height_cm": "30",
                        "viewing_distance_cm": 57})"),
            path + ":/height_cm: expected a number ≥ 10 and ≤ 200, got \"30\"");
}

TEST(ScreenFile, WhatIsSavedIsLoadedAgain) {
  const TemporaryFolder folder;
  const ScreenGeometry screen{0.376, 0.301, 0, 0, 0.57};
  save_screen({screen}, folder / "new/folder/screen.json");
  const ScreenGeometry loaded = load_screen(folder / "new/folder/screen.json").geometry;
  // Kept to the micrometre, in whole digits of a centimetre; one rounding on the way back.
  EXPECT_DOUBLE_EQ(loaded.width_m, screen.width_m);
  EXPECT_DOUBLE_EQ(loaded.height_m, screen.height_m);
  EXPECT_DOUBLE_EQ(loaded.viewing_distance_m, screen.viewing_distance_m);
}

TEST(ScreenFile, KeepsTheLightThatWasMeasured) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder / "screen.json";
  LabScreen screen{{0.376, 0.301, 0, 0, 0.57}};
  save_screen(screen, path);
  EXPECT_FALSE(load_screen(path).light);
  screen.light = ScreenLight{0.3, 120.0, 2.2};
  save_screen(screen, path);
  const std::optional<ScreenLight> loaded = load_screen(path).light;
  ASSERT_TRUE(loaded);
  EXPECT_EQ(light_words(*loaded), "black 0.3, white 120 cd/m², gamma 2.2");
  EXPECT_NEAR(luminance_cd_m2(*loaded, {0.0F, 0.0F, 0.0F}), 0.3, 1e-9);
  EXPECT_NEAR(luminance_cd_m2(*loaded, {1.0F, 1.0F, 1.0F}), 120.0, 1e-9);
  EXPECT_NEAR(luminance_cd_m2(*loaded, {0.5F, 0.5F, 0.5F}), 0.3 + 119.7 * std::pow(0.5, 2.2), 1e-9);
  EXPECT_NEAR(luminance_cd_m2(*loaded, {0.0F, 1.0F, 0.0F}), 0.3 + 119.7 * 0.7152, 1e-9);
  screen.light->white_cd_m2 = 0.2;
  save_screen(screen, path);
  EXPECT_EQ(refusal([&] { load_screen(path); }),
            path.string() + ":/light/white_cd_m2: expected more than black, 0.3, got 0.2");
}

TEST(ScreenFile, PixelsThatAreNotSquareAreRefusedUnlessItSaysSo) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder / "screen.json";
  LabScreen screen{{0.376, 0.301, 0, 0, 0.57}};
  save_screen(screen, path);
  EXPECT_EQ(load_screen_of(path, 1280, 1024).width_px, 1280);
  EXPECT_EQ(refusal([&] { load_screen_of(path, 1920, 1080); }),
            path.string() +
                ":/width_cm: expected a width at which pixels are square within 1 %, got 37.6 cm x "
                "30.1 cm, 1920 x 1080 pixels, seen from 57.0 cm, each pixel 0.196 mm wide and "
                "0.279 mm high; `impetus screen` measures anew, or keeps that they are not square "
                "(--pixels-not-square)");
  screen.square_pixels = false;
  save_screen(screen, path);
  EXPECT_FALSE(load_screen(path).square_pixels);
  EXPECT_EQ(load_screen_of(path, 1920, 1080).height_px, 1080);
}

TEST(ScreenFile, WhatIsAssumedHasSquarePixelsWhateverTheirNumber) {
  for (const auto& [width_px, height_px] : std::vector<std::pair<int, int>>{
           {1280, 1024}, {1920, 1080}, {3440, 1440}, {1080, 1920}, {640, 480}, {7680, 4320}}) {
    EXPECT_TRUE(has_square_pixels(assumed_screen(width_px, height_px))) << width_px;
  }
  EXPECT_EQ(assumed_screen().width_m, 0.376);
  EXPECT_EQ(assumed_screen(1920, 1080).width_m, 0.535);
}

TEST(LabScreen, PixelsAreSquareUpToOnePercent) {
  EXPECT_TRUE(has_square_pixels({0.4, 0.3, 1600, 1200, 0.57}));
  EXPECT_TRUE(has_square_pixels({0.4 * 1.0099, 0.3, 1600, 1200, 0.57}));
  EXPECT_FALSE(has_square_pixels({0.4 * 1.0101, 0.3, 1600, 1200, 0.57}));
  EXPECT_TRUE(has_square_pixels({0.4 / 1.0099, 0.3, 1600, 1200, 0.57}));
  EXPECT_FALSE(has_square_pixels({0.4 / 1.0101, 0.3, 1600, 1200, 0.57}));
}

TEST(LabScreen, APartOfAWindowHasTheShapeOfTheWholeScreenInPixels) {
  const ScreenGeometry stretched{0.376, 0.301, 1920, 1080, 0.57};
  const PicturePixels beside = largest_picture(stretched, 960, 900);
  EXPECT_EQ(beside.width, 960);
  EXPECT_EQ(beside.height, 540);
  EXPECT_EQ(largest_picture(stretched, 5000, 108).width, 192);
}

TEST(ScreenFile, AFileThatCannotBeWrittenIsRefusedWithTheReason) {
  const TemporaryFolder folder;
  folder.write("file", "");
  const std::string path = (folder / "file/screen.json").string();
  EXPECT_EQ(refusal([&] { save_screen({assumed_screen()}, path); }),
            path + ": expected a file that can be written, but it cannot be: Not a directory");
}

}  // namespace impetus::lab_files_test
