// One study file with all that a study can hold, made by the program itself: short versions of
// three studies, by simulated participants; collisions measured, an exclusion, what people type.
// SPDX-License-Identifier: MIT
#pragma once

#include <SQLiteCpp/Statement.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/experiments/command_lines.hpp"

namespace impetus {

/// `text` with the first `from` in it replaced.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

class WholeStudy {
 public:
  static const WholeStudy& once() {
    static const WholeStudy kStudy;
    return kStudy;
  }

  [[nodiscard]] std::filesystem::path file() const { return folder_ / "study.sqlite"; }

  /// A copy of the study in another folder, to be changed by statements.
  std::filesystem::path copy_to(const TemporaryFolder& folder, const std::string& sql = "") const {
    const std::filesystem::path copy = folder / "a.sqlite";
    std::filesystem::copy_file(file(), copy);
    SQLite::Database database(copy.string(), SQLite::OPEN_READWRITE);
    database.exec(sql);
    return copy;
  }

 private:
  WholeStudy() {
    const std::string source = source_folder();
    std::filesystem::create_directories(folder_ / "stimuli");
    for (const char* name : {"two-spheres", "shells"}) {
      std::filesystem::copy_file(source + "/stimuli/" + name + ".json",
                                 folder_ / "stimuli" / (std::string(name) + ".json"));
    }
    folder_.write("stimuli/l-blocks-in-a-cube.json",
                  replaced(text_of(source + "/stimuli/l-blocks-in-a-cube.json"),
                           "\"duration_s\": 10", "\"duration_s\": 1"));
    run("causality", {{"\"repetitions\": 3", "\"repetitions\": 1"}});
    run("gap-thresholds", {{"\"trials_per_track\": 40", "\"trials_per_track\": 1"}});
    run("gaze-contingent", {{"\"repetitions\": 3", "\"repetitions\": 1"},
                            {"[5, 10, 15]", "[5, 10]"},
                            {"\"bodies\": 15", "\"bodies\": 5"}});
    run_program(folder_, {"replay", "study.sqlite", "--truth", "--trial", "1"});
    run_program(folder_, {"exclude", "study.sqlite", "--participant", "S01", "--trial", "7",
                          "--reason", "fell asleep, \"twice\""});
    SQLite::Database(file().string(), SQLite::OPEN_READWRITE)
        .exec(
            "INSERT INTO note (session_id, written_utc, kind, text) VALUES "
            "(1, '2026-01-02T03:04:05Z', 'test', ''); "
            "INSERT INTO marker VALUES (1, 1, 'onset', 20, 500, 600, 1), "
            "(1, 2, 'contact', 30, 700, NULL, 1); "
            "INSERT INTO sound VALUES (1, 1, 240, -150, 0.5, 700, 550, 560, 1), "
            "(1, 2, NULL, 0, 0.25, NULL, 800, NULL, 1)");
  }

  void run(const std::string& study,
           const std::vector<std::pair<std::string, std::string>>& changes) {
    std::string protocol = text_of(source_folder() + "/protocols/" + study + ".json");
    for (const auto& [from, to] : changes) {
      protocol = replaced(protocol, from, to);
    }
    const std::string file = "protocols/" + study + ".json";
    folder_.write(file, protocol);
    const ProgramResult result =
        run_program(folder_, {"run", file, "--db", "study.sqlite", "--observer",
                              source_folder() + "/experiments/observers/" + study + ".json",
                              "--participant", "S01", "--allow-rounding"});
    EXPECT_EQ(result.status, 0) << result.errors;
  }

  TemporaryFolder folder_;
};

}  // namespace impetus
