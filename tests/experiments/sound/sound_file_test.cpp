// Sounds from files, held in the scene that names them.
// SPDX-License-Identifier: MIT
#include "experiments/files/sound_file.hpp"

#include <gtest/gtest.h>

#include "experiments/files/protocol_files.hpp"
#include "experiments/models/mesh_bytes.hpp"
#include "experiments/protocol/protocol_scenes.hpp"
#include "experiments/protocol/screen_file.hpp"
#include "experiments/sound/waveform.hpp"
#include "tests/experiments/refusals.hpp"
#include "tests/experiments/temporary_folder.hpp"
#include "tests/experiments/test_study.hpp"

namespace impetus::sound_file_test {

void append_16(std::string& bytes, int value) {
  const auto bits = static_cast<unsigned>(value);
  bytes += static_cast<char>(bits & 0xFFU);
  bytes += static_cast<char>(bits >> 8U & 0xFFU);
}

/// A WAV file of 16 bits.
std::string wav(int channels, std::uint32_t rate_hz, const std::vector<std::int16_t>& values) {
  const auto size = static_cast<std::uint32_t>(2 * values.size());
  std::string bytes = "RIFF";
  append_number(bytes, std::uint32_t{36} + size);
  bytes += "WAVEfmt ";
  append_number(bytes, std::uint32_t{16});
  append_16(bytes, 1);
  append_16(bytes, channels);
  append_number(bytes, rate_hz);
  append_number(bytes, 2 * rate_hz * static_cast<std::uint32_t>(channels));
  append_16(bytes, 2 * channels);
  append_16(bytes, 16);
  bytes += "data";
  append_number(bytes, size);
  for (const std::int16_t value : values) {
    append_16(bytes, value);
  }
  return bytes;
}

TEST(SoundFile, HasItsChannelsAsOne) {
  const TemporaryFolder folder;
  folder.write("two.wav", wav(2, 44100, {16384, 0, -16384, -16384, 0, 8192}));
  const SoundSamples samples = load_sound(folder / "two.wav");
  EXPECT_EQ(samples.rate_hz, 44100.0);
  EXPECT_EQ(samples.values, (std::vector<float>{0.25F, -0.5F, 0.125F}));
}

TEST(SoundFile, ThatIsNoneIsRefusedInASentence) {
  const TemporaryFolder folder;
  folder.write("none.wav", "this is no sound at all, however long it may be");
  folder.write("long.wav", wav(1, 8000, std::vector<std::int16_t>(48'000)));
  folder.write("empty.wav", wav(1, 8000, {}));
  const auto words = [&](const char* name) -> std::string {
    try {
      load_sound(folder / name);
    } catch (const std::runtime_error& error) {
      return std::string(error.what()).substr((folder / name).string().size());
    }
    return "accepted";
  };
  EXPECT_NE(words("none.wav"), "accepted");
  EXPECT_NE(words("nowhere.wav"), "accepted");
  EXPECT_EQ(words("long.wav"), ": expected a sound of up to 5 s, got one of 6 s");
  EXPECT_EQ(words("empty.wav"), ": expected a sound of up to 5 s, got one of 0 s");
}

/// The shipped study, with recordings in place of wood.
class HeardFiles : public testing::Test {
 protected:
  HeardFiles() {
    protocol_ = nlohmann::json::parse(text_of(source_file("protocols/stream-or-bounce.json")));
    scene_ = nlohmann::json::parse(text_of(source_file("stimuli/stream-or-bounce.json")));
    scene_["sound"] = {{"kind", "file"}, {"file", "knock.wav"}, {"at_s", 0.75}};
    nlohmann::json& factor = protocol_["design"]["factors"][0];
    factor["levels"] = {"knock", "click"};
    factor["sets"] = nlohmann::json::object();
    factor["sets"]["knock"]["/sound/file"] = "knock.wav";
    factor["sets"]["click"]["/sound/file"] = "click.wav";
    protocol_["design"].erase("practice");
    folder_.write("stimuli/knock.wav", wav(1, 48000, {1000, -32768, 500}));
    folder_.write("stimuli/click.wav", wav(1, 24000, {16384, 0}));
  }

  Protocol loaded() {
    folder_.write("stimuli/stream-or-bounce.json", scene_.dump());
    folder_.write("protocols/a.json", protocol_.dump());
    return load_protocol(folder_ / "protocols/a.json");
  }

  TemporaryFolder folder_;
  nlohmann::json protocol_;
  nlohmann::json scene_;
};

TEST_F(HeardFiles, AreHeldInTheSceneThoseOfFactorsToo) {
  const Protocol protocol = loaded();
  std::filesystem::remove_all(folder_ / "stimuli");  // a recording needs no file
  const ProtocolScenes scenes(protocol, 0.0);
  for (const Condition& condition : cells(protocol.design)) {
    PlannedTrial trial;
    trial.condition = condition;
    const StagedScene staged = scenes.stage(trial, assumed_screen());
    ASSERT_TRUE(staged.sound && staged.sound->samples);
    if (staged.sound->file == "click.wav") {
      EXPECT_EQ(staged.sound->samples->rate_hz, 24000.0);
      EXPECT_EQ(waveform_of(*staged.sound, 48000.0), (std::vector<float>{0.5F, 0.25F, 0.0F}));
    } else {
      EXPECT_EQ(waveform_of(*staged.sound, 48000.0)[1], -1.0F);
    }
  }
}

TEST_F(HeardFiles, ThatCannotBeAreRefusedWithTheirPlace) {
  scene_["sound"]["file"] = "../../knock.wav";
  EXPECT_NE(refusal([this] { loaded(); }).find(":/sound/file: expected"), std::string::npos);
  scene_["sound"]["file"] = "gone.wav";
  EXPECT_NE(refusal([this] { loaded(); }).find(":/sound/file: expected a sound file, but "),
            std::string::npos);
  scene_["sound"].erase("file");
  nlohmann::json& sets = protocol_["design"]["factors"][0]["sets"];
  sets = nlohmann::json::object();
  sets["knock"]["/sound/lag_ms"] = 1;
  sets["click"]["/sound/lag_ms"] = 2;
  EXPECT_NE(refusal([this] { loaded(); }).find("the key \"file\" for kind file"),
            std::string::npos);
}

}  // namespace impetus::sound_file_test
