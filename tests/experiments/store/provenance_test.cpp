// What a session says of where it was recorded, and by what.
// SPDX-License-Identifier: MIT
#include <regex>

#include "engine/world/world.hpp"
#include "experiments/store/migration.hpp"
#include "tests/experiments/command_lines.hpp"

namespace impetus::provenance_test {

/// "impetus 0.1.0, 0123456789ab-dirty, GNU 12.2.0, -O3 -ffp-contract=off": version, commit,
/// compiler and flags.
const std::regex kBuildText(
    R"(impetus \d+\.\d+\.\d+, (unknown commit|[-.\w]+), \w+ \d+[.\d]*, .*-ffp-contract=off.*)");

TEST(Provenance, TheProgramNamesVersionCommitCompilerAndWhatItReplays) {
  const TemporaryFolder folder;
  const std::string said = run_program(folder, {"--version"}).output;
  EXPECT_TRUE(std::regex_match(
      said, std::regex("impetus \\d+\\.\\d+\\.\\d+\n"
                       "commit: (unknown commit|[-.\\w]+)\n"
                       "compiler: \\w+ \\d+[.\\d]*, .*-ffp-contract=off.*\n"
                       "replays recordings of format: 1 to " +
                       std::to_string(kRecordingFormat) + "\nreads studies of schema: 1 to " +
                       std::to_string(kSchemaVersion) + "\n")))
      << said;
}

TEST(Provenance, EverySessionNamesBuildMachineDisplayAndScreen) {
  const TemporaryFolder folder;
  run_program(folder, simulated_run({"--participant", "S01"}));
  const auto value = [&](const std::string& column) {
    return value_of(folder, "SELECT " + column + " FROM session_provenance");
  };
  EXPECT_EQ(value("count(*)"), "1");
  EXPECT_TRUE(std::regex_match(value("build"), kBuildText)) << value("build");
  // "Debian GNU/Linux 12 (bookworm), Linux 6.1.0-18-amd64 x86_64, AMD Ryzen 7, 16 cores, 31.3 GiB"
  EXPECT_TRUE(std::regex_match(value("machine"),
                               std::regex(R"((.+, )?Linux \S+ \S+, (.+, )?\d+ cores, [\d.]+ GiB)")))
      << value("machine");
  EXPECT_EQ(value("participant || simulated || protocol || ending"), "S011causalityfinished");
  EXPECT_EQ(value("screen_width_px > 0 AND viewing_distance_m > 0 AND refresh_hz = 60"), "1");
  EXPECT_EQ(value("sync_tries || sync_passed || sync_overridden"), "010");
  EXPECT_EQ(value("gaze_source IS NULL AND merged_from IS NULL AND resumed_at IS NULL"), "1");
  EXPECT_NE(value("observer"), "");
}

}  // namespace impetus::provenance_test
