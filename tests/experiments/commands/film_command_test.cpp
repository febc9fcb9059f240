// `impetus film` as a researcher meets it: what it refuses, in which words, and that nothing is
// left of a film that was not made. What ffmpeg makes of the pictures is looked at in tests/window.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "tests/experiments/command_lines.hpp"
#include "tests/experiments/small_study.hpp"
#include "tests/experiments/test_scenes.hpp"

#ifdef IMPETUS_PROGRAM_HAS_WINDOW
#include "tests/experiments/read_png.hpp"

namespace impetus::film_command_test {

using nlohmann::json;

/// A folder with a study of five trials, which is 1 of practice and four that count.
class FilmCommand : public ::testing::Test {
 protected:
  FilmCommand() { small_study(folder_ / "a.sqlite"); }

  ~FilmCommand() override {
    for (const auto& entry : std::filesystem::directory_iterator(folder_.path())) {
      EXPECT_EQ(entry.path().string().find(".partial-"), std::string::npos) << entry.path();
    }
  }

  void expect_no_film(const Words& words, const std::string& sentence) {
    Words all{"film"};
    all.insert(all.end(), words.begin(), words.end());
    expect_refused(folder_, all, sentence);
    EXPECT_FALSE(std::filesystem::exists(folder_ / "f.mkv")) << sentence;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "f.json")) << sentence;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "f")) << sentence;
  }

  /// Of the film of `words` in the folder f.
  json film(Words words) {
    words.insert(words.begin(), "film");
    words.insert(words.end(), {"--out", "f/"});
    const ProgramResult result = run_program(folder_, words);
    EXPECT_EQ(result.status, 0) << result.errors;
    return json::parse(text_of(folder_ / "f/film.json"));
  }

  Pixels frame(int number) {
    char name[32];
    std::snprintf(name, sizeof name, "f/frame-%06d.png", number);
    return read_png(folder_ / name);
  }

  TemporaryFolder folder_;
};

TEST_F(FilmCommand, WhatCannotBeFilmedIsRefusedInASentence) {
  expect_no_film({"--out", "f.mkv"},
                 "expected a study with --trial, a protocol, or a scene with --scene, got none of "
                 "them");
  expect_no_film({"a.sqlite", "--out", "f.mkv"},
                 "--trial: expected the number of a trial (the column `trial` of the views), which "
                 "is missing");
  expect_no_film({"a.sqlite", "--trial", "99", "--out", "f.mkv"},
                 "a.sqlite: expected a recorded trial 99, but there is none");
  expect_no_film({"a.sqlite", "--trial", "1", "--attempt", "2", "--out", "f.mkv"},
                 "a.sqlite: expected a recorded trial 1 with an attempt 2, but there is none");
  expect_no_film({"b.sqlite", "--trial", "1", "--out", "f.mkv"},
                 "b.sqlite: expected an Impetus study, but there is no such file");
  expect_no_film({"a.sqlite", "--trial", "1", "--out", "f.avi"},
                 "--out f.avi: expected a name that ends in one of .mkv, .mp4, .webm, .gif, or in "
                 "/ for a folder of PNG files, got .avi");
  expect_no_film({"a.sqlite", "--trial", "1", "--out", "f.mkv", "--refresh", "50"},
                 "--refresh: expected a scene or a protocol beside it, got a study");
  expect_no_film({causality_file(), "--trial", "1", "--out", "f/"},
                 "--trial: expected a study beside it, got " + causality_file());
  expect_no_film({causality_file(), "--out", "f.mkv"},
                 "--out: expected a folder for the films of a protocol, got f.mkv");
  const std::string scene = source_folder() + "/stimuli/two-spheres.json";
  expect_no_film({scene, "--out", "f/"},
                 scene + ": expected a study or a protocol; a scene is filmed by --scene");
}

TEST_F(FilmCommand, ASizeThatTheFilmCannotHaveIsRefused) {
  expect_no_film(
      {"a.sqlite", "--trial", "1", "--out", "f.mp4", "--width", "639", "--height", "511"},
      "expected even sides, which .mp4 needs, got 639 x 511 pixels; --width and "
      "--height change them, and .mkv takes any");
  expect_no_film({"a.sqlite", "--trial", "1", "--out", "f/", "--width", "640", "--height", "640"},
                 "--width, --height: expected the shape of the screen, 1.25 : 1, got 640 x 640 "
                 "pixels");
  expect_no_film({"a.sqlite", "--trial", "1", "--out", "f/", "--width", "9000"},
                 "--width: expected from 1 to 8192 pixels, got 9000");
}

TEST_F(FilmCommand, WhatIsThereIsNotOverwritten) {
  folder_.write("g.mkv", "mine");
  folder_.write("h.json", "mine");
  folder_.write("i/film.json", "mine");
  for (const auto& [out, there] :
       {std::pair{"g.mkv", "g.mkv: exists already"}, std::pair{"h.mkv", "h.json: exists already"},
        std::pair{"i/", "i: holds files already"}}) {
    expect_no_film({"a.sqlite", "--trial", "1", "--out", out},
                   std::string(there) + " and is not overwritten");
  }
  EXPECT_EQ(text_of(folder_ / "g.mkv") + text_of(folder_ / "i/film.json"), "minemine");
}

TEST_F(FilmCommand, WithoutFfmpegItSaysWhereToGetIt) {
  const ProgramResult result =
      run_program(folder_, {"film", "a.sqlite", "--trial", "1", "--out", "f.mkv"},
                  [] { setenv("PATH", "/none", 1); });
  EXPECT_EQ(result.errors,
            "impetus: expected ffmpeg, got none on the path (apt-get install ffmpeg); a folder of "
            "PNG files needs none: --out NAME/\n");
  EXPECT_EQ(result.status, 2);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "f.mkv"));
}

TEST_F(FilmCommand, ATrialThatDivergesIsRefused) {
  tamper(folder_ / "a.sqlite", "UPDATE step SET hash = hash + 1 WHERE attempt_id = 2 AND step = 7");
  expect_no_film({"a.sqlite", "--trial", "2", "--out", "f/"},
                 "a.sqlite: trial 2 diverges at step 7 when it is replayed, so a film would not be "
                 "what was shown");
}

TEST_F(FilmCommand, ATrialWithoutFramesIsRefused) {
  tamper(folder_ / "a.sqlite", "DELETE FROM frame WHERE attempt_id = 2");
  expect_no_film({"a.sqlite", "--trial", "2", "--out", "f/"},
                 "a.sqlite: trial 2 has no frames that were shown");
}

TEST_F(FilmCommand, TheFileBesideTellsOfEveryFrame) {
  const json told = film({"a.sqlite", "--trial", "2", "--width", "160"});
  ASSERT_EQ(std::to_string(told["frames"].size()),
            value_of(folder_, "SELECT count(*) FROM frame WHERE attempt_id = 2"));
  EXPECT_EQ(told["condition"].dump(),
            value_of(folder_, "SELECT condition FROM trial WHERE id = 2"));
  EXPECT_EQ(std::to_string(told["contact_frame"].get<std::int64_t>()),
            value_of(folder_,
                     "SELECT collision.first_frame + (SELECT count(*) FROM frame WHERE attempt_id "
                     "= 2 AND phase = 'fixation') FROM collision WHERE attempt_id = 2"));
  std::size_t number = 0;
  for (const json& row : told["frames"]) {
    EXPECT_EQ(row["frame"], number);
    EXPECT_EQ(std::to_string(row["flipped_ns"].get<std::int64_t>()),
              value_of(folder_, "SELECT flipped_ns FROM frame WHERE attempt_id = 2 AND frame = " +
                                    std::to_string(number)));
    EXPECT_EQ(row.contains("bodies"), row["showing"] == "stimulus");
    ++number;
  }
  const json& contact = told["frames"][told["contact_frame"].get<std::size_t>()]["contacts"][0];
  EXPECT_EQ(contact["bodies"], (json{"left", "right"}));
  EXPECT_TRUE(contact["begins"]);
  EXPECT_TRUE(contact.contains("level") && contact.contains("gap_arcmin"));
}

TEST_F(FilmCommand, AFrameIsHeldWhileTheNextIsLate) {
  tamper(folder_ / "a.sqlite",
         "UPDATE frame SET missed_slots = 1 WHERE attempt_id = 2 AND frame = 50;"
         "UPDATE frame SET scheduled_ns = scheduled_ns + 16666667 WHERE attempt_id = 2 AND frame > "
         "50");
  const json told = film({"a.sqlite", "--trial", "2", "--width", "160"});
  ASSERT_EQ(std::to_string(told["frames"].size()),
            value_of(folder_, "SELECT count(*) + 1 FROM frame WHERE attempt_id = 2"));
  EXPECT_TRUE(told["frames"][50]["held"]);
  EXPECT_TRUE(told["frames"][50]["flipped_ns"].is_null());
  EXPECT_EQ(told["frames"][51]["recorded_frame"], 50);
  EXPECT_EQ(frame(50).rgb, frame(49).rgb);
  EXPECT_NE(frame(51).rgb, frame(50).rgb);
}

/// Another way to the same picture, `impetus preview`, steps the scene by itself.
TEST_F(FilmCommand, FramesOfASceneAreItsPictures) {
  const std::string scene = source_folder() + "/stimuli/two-l-blocks.json";
  const json told = film({"--scene", scene, "--width", "320", "--refresh", "50"});
  EXPECT_EQ(told["frames"].size(), 101U) << "two seconds, begin and end included";
  EXPECT_EQ(frame(0).height, 256);
  for (const int number : {0, 31, 55}) {
    std::filesystem::remove(folder_ / "p.png");
    run_program(folder_, {"preview", scene, "--picture", "p.png", "--at",
                          std::to_string(number / 50.0), "--width", "320", "--height", "256"});
    EXPECT_EQ(frame(number).rgb, read_png(folder_ / "p.png").rgb) << number;
  }
  EXPECT_NE(frame(31).rgb, frame(32).rgb);
}

TEST_F(FilmCommand, OverlaysAreDrawnOverAndToldOf) {
  const Words words{"a.sqlite", "--trial", "2", "--width", "320"};
  const auto contact = film(words)["contact_frame"].get<int>();
  const Pixels plain = frame(contact);
  const Pixels apart = frame(contact - 20);
  std::filesystem::remove_all(folder_ / "f");
  Words more = words;
  more.insert(more.end(), {"--show", "contacts,volumes"});
  EXPECT_EQ(film(more)["overlays"], (json{"contacts", "volumes"}));
  EXPECT_NE(frame(contact).rgb, plain.rgb);
  EXPECT_EQ(frame(contact - 20).rgb, apart.rgb) << "nothing to tell of bodies that are apart";
}

TEST_F(FilmCommand, APointerThatWasShownIsSaidToBeLeftOut) {
  EXPECT_EQ(film({"a.sqlite", "--trial", "2", "--width", "160"})["left_out"], json::array());
  std::filesystem::remove_all(folder_ / "f");
  tamper(folder_ / "a.sqlite", "UPDATE attempt SET gaze_source = 'mouse'");
  EXPECT_EQ(film({"a.sqlite", "--trial", "2", "--width", "160"})["left_out"],
            json{"the mouse pointer"});
}

TEST_F(FilmCommand, ThePhotodiodePatchIsPartOfThePicture) {
  tamper(folder_ / "a.sqlite",
         "UPDATE session SET photodiode_patch = 'top left';"
         "UPDATE frame SET patch = CASE WHEN phase = 'stimulus' THEN 3 ELSE 0 END");
  const json told = film({"a.sqlite", "--trial", "2", "--width", "320"});
  const std::size_t last = told["frames"].size() - 1;
  EXPECT_EQ(frame(0).rgb[0], 0) << "dark in the corner while the cross is shown";
  EXPECT_EQ(frame(static_cast<int>(last)).rgb[0], 255);
}

TEST_F(FilmCommand, AProtocolIsAFilmOfEachStimulusAndATable) {
  folder_.write("protocols/small.json", small_protocol().document.value.dump());
  folder_.write("stimuli/two-spheres.json", shipped("stimuli/two-spheres.json"));
  const ProgramResult result = run_program(folder_, {"film", "protocols/small.json", "--out",
                                                     "films", "--format", "png", "--width", "80"});
  ASSERT_EQ(result.status, 0) << result.errors;
  const std::vector<std::string> rows = lines_of(text_of(folder_ / "films/films.csv"));
  ASSERT_EQ(rows.size(), 4U) << "two delays, shown twice each, and one that is practised";
  EXPECT_EQ(rows.front(),
            "file,part,condition,repetition,delay_ms,speed_deg_s,viewpoint_deg,frames,seconds,"
            "contact_frame,contact_s,collisions,level,gap_arcmin");
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const std::filesystem::path film = folder_ / "films" / rows[i].substr(0, rows[i].find(','));
    EXPECT_TRUE(std::filesystem::exists(film / "film.json")) << film;
  }
}

TEST_F(FilmCommand, AFactorThatIsCalledAsAColumnHasOneOfItsOwn) {
  json protocol = small_protocol().document.value;
  json& design = protocol["design"];
  design["factors"] = json::parse(R"([{"name": "level", "label": "Restitution", "levels": [0.5, 1],
                                       "pointer": "/engine/restitution"}])");
  design["practice"] = json::parse(R"([{"level": 1}])");
  design["repetitions"] = 1;
  for (const char* of_other_factors : {"longest_runs", "blocks", "catch_trials"}) {
    design.erase(of_other_factors);
  }
  folder_.write("protocols/small.json", protocol.dump());
  folder_.write("stimuli/two-spheres.json", shipped("stimuli/two-spheres.json"));
  const ProgramResult result = run_program(folder_, {"film", "protocols/small.json", "--out",
                                                     "films", "--format", "png", "--width", "80"});
  ASSERT_EQ(result.status, 0) << result.errors;
  EXPECT_EQ(lines_of(text_of(folder_ / "films/films.csv")).front(),
            "file,part,condition,repetition,factor_level,frames,seconds,contact_frame,contact_s,"
            "collisions,level,gap_arcmin");
}

TEST_F(FilmCommand, AGazeThatWasRecordedIsNotInAProtocol) {
  const std::string protocol = source_folder() + "/protocols/gaze-contingent-yoked.json";
  const ProgramResult result =
      run_program(folder_, {"film", protocol, "--out", "f", "--format", "png", "--width", "80"});
  EXPECT_NE(result.errors.find("expected stimuli that nobody has to look at, got a region that "
                               "follows a participant's recorded gaze; a trial of a study has it, "
                               "and can be filmed\n"),
            std::string::npos)
      << result.errors;
  EXPECT_FALSE(std::filesystem::exists(folder_ / "f"));
}

}  // namespace impetus::film_command_test

#endif
