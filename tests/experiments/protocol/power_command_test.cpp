// `impetus power` as a researcher meets it: what it refuses before anything is simulated, and the
// participant without an effect. What it simulates and finds is tested in power_test.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "experiments/protocol/observer_file.hpp"
#include "tests/experiments/command_lines.hpp"
#include "tests/experiments/program.hpp"
#include "tests/places/places.hpp"

namespace impetus::power_command_test {

Words power_of(const std::string& protocol, const Words& more) {
  Words words{"power", source_folder() + "/protocols/" + protocol, "--n", "2", "--studies", "1"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

void expect_power_refused(const Words& arguments, const std::string& sentence) {
  const TemporaryFolder folder;
  expect_refused(folder, arguments, sentence);
  EXPECT_FALSE(std::filesystem::exists(folder / "power")) << sentence;
}

std::string protocol_file(const std::string& name) {
  return source_folder() + "/protocols/" + name;
}

TEST(PowerCommand, RefusesWhatTheProtocolDoesNotHave) {
  const std::string file = protocol_file("causality.json");
  const auto causality = [](const Words& more) {
    Words words = power_of("causality.json", {"--observer", "causality"});
    words.insert(words.end(), more.begin(), more.end());
    return words;
  };
  expect_power_refused(
      causality({"--response", "clicks"}),
      "--response: expected what " + file + " asks for ([\"rating\"]), got clicks");
  expect_power_refused(causality({"--factor", "colour"}),
                       "--factor: expected a factor of " + file +
                           " (delay_ms, speed_deg_s, viewpoint_deg), got colour");
  expect_power_refused(causality({"--compare", "delay_ms"}),
                       "--compare: expected FACTOR=LEVEL,LEVEL, got delay_ms");
  expect_power_refused(causality({"--compare", "delay_ms=0,200"}),
                       "--compare: expected two levels of delay_ms, got 200");
  expect_power_refused(causality({"--compare", "delay_ms=0,0"}),
                       "--compare: expected two levels of delay_ms, got 0");
  expect_power_refused(causality({"--compare", "delay_ms=0,100", "--factor", "delay_ms"}),
                       "--factor: expected either --factor or --compare, got both");
}

TEST(PowerCommand, RefusesThresholdsThatNothingCanBeComparedWith) {
  const TemporaryFolder folder;
  ASSERT_EQ(run_program(folder, {"new", "one", "--vary", "delay_ms=0,50,100,150,200,300", "--ask",
                                 "detection", "--levels", "staircase"})
                .status,
            0);
  expect_refused(folder,
                 {"power", "one/protocol.json", "--observer", "one/observer.json", "--n", "3",
                  "--studies", "2", "--out", "power"},
                 "one/protocol.json:/design/factors: expected a factor beside \"delay_ms\", "
                 "between whose levels thresholds can be compared, got none");
  EXPECT_FALSE(std::filesystem::exists(folder / "power"));
}

TEST(PowerCommand, RefusesAProtocolThatNobodyTakesPartIn) {
  expect_power_refused(power_of("scheduler-distribution.json", {"--observer", "causality"}),
                       protocol_file("scheduler-distribution.json") +
                           ": expected a protocol with participants, got one without");
}

TEST(PowerCommand, RefusesAnObserverWhoCannotDoWhatIsAsked) {
  const TemporaryFolder folder;
  const ProgramResult result =
      run_program(folder, power_of("gaze-contingent.json", {"--observer", "causality"}));
  EXPECT_EQ(result.status, 2);
  EXPECT_NE(result.errors.find("/rating: expected a scale of 3 points"), std::string::npos)
      << result.errors;
}

TEST(PowerCommand, LeavesAFolderOfOtherThingsAlone) {
  const TemporaryFolder folder;
  folder.write("power/thesis.tex", "all of it");
  expect_refused(folder, power_of("causality.json", {"--observer", "causality"}),
                 "power: expected a new folder, an empty one or an earlier power analysis, got one "
                 "that holds thesis.tex");
  EXPECT_EQ(text_of(folder / "power/thesis.tex"), "all of it");
}

TEST(PowerCommand, WithoutRSaysSoBeforeItSimulates) {
  const TemporaryFolder folder;
  const ProgramResult result =
      run_program(folder, power_of("causality.json", {"--observer", "causality"}),
                  [] { setenv("PATH", "/nowhere", 1); });
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(result.errors,
            "impetus: expected R, got no Rscript on the path (apt-get install r-base-core)\n");
  EXPECT_FALSE(std::filesystem::exists(folder / "power/power.sqlite"));
}

double number_of(const ObserverFile& observer, const std::string& name) {
  return observer.document.value["parameters"][name]["value"].get<double>();
}

TEST(NullObserver, OfRatingsDiffersInNothingButTheEffect) {
  const ObserverFile gap = load_observer("gap", protocol_file("gap.json"));
  const auto without = without_effect(gap, "rating");
  ASSERT_TRUE(without);
  nlohmann::json same = without->document.value;
  EXPECT_EQ(number_of(*without, "effect"), 0.0);
  same["parameters"]["effect"] = gap.document.value["parameters"]["effect"];
  EXPECT_TRUE(same == gap.document.value);
  EXPECT_EQ(without->parameters->effect, 0.0);
  EXPECT_GT(without->parameters->effect_sd, 0.0);
}

TEST(NullObserver, OfClicksSeesNothing) {
  const ObserverFile gaze = load_observer("gaze-contingent", protocol_file("gaze-contingent.json"));
  const auto without = without_effect(gaze, "clicks");
  ASSERT_TRUE(without);
  EXPECT_EQ(number_of(*without, "miss_rate"), 1.0);
  EXPECT_EQ(number_of(*without, "effect"), number_of(gaze, "effect"));
}

TEST(NullObserver, IsNotKnownForAnswersNorWithoutWhatIsSetToZero) {
  const ObserverFile causality =
      load_observer("causality-thresholds", protocol_file("causality-thresholds.json"));
  EXPECT_FALSE(without_effect(causality, "answer"));
  EXPECT_FALSE(without_effect(load_observer("causality", causality_file()), "clicks"));
}

}  // namespace impetus::power_command_test
