// What tests of the program's commands say: a refusal in one sentence, a changed copy of the
// shipped protocol, a value of the study.
// SPDX-License-Identifier: MIT
#pragma once

#include <SQLiteCpp/Database.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/experiments/program.hpp"
#include "tests/places/places.hpp"

namespace impetus {

using Words = std::vector<std::string>;

/// Said beside, where a screen is needed and none was entered.
inline const std::string kAssumedScreen =
    "No screen was entered: 37.6 cm x 30.1 cm seen from 57 cm is assumed; `impetus screen` asks.\n";

/// One sentence on stderr, nothing on stdout, and this status.
inline void expect_refused(const TemporaryFolder& folder, const Words& arguments,
                           const std::string& sentence, int status = 2) {
  const ProgramResult result = run_program(folder, arguments);
  EXPECT_EQ(result.errors, "impetus: " + sentence + "\n");
  EXPECT_EQ(result.output, "");
  EXPECT_EQ(result.status, status) << sentence;
}

inline void expect_refused_without_a_file(const TemporaryFolder& folder, const Words& arguments,
                                          const std::string& sentence) {
  expect_refused(folder, arguments, sentence);
  EXPECT_FALSE(std::filesystem::exists(folder / "a.sqlite")) << sentence;
}

/// The folder with a changed copy of the shipped protocol, beside its scene and observer.
inline std::string changed_protocol(const TemporaryFolder& folder, const std::string& pointer,
                                    const nlohmann::json& value) {
  const std::filesystem::path source = source_folder();
  nlohmann::json protocol = nlohmann::json::parse(text_of(causality_file()));
  protocol[nlohmann::json::json_pointer(pointer)] = value;
  folder.write("protocols/a.json", protocol.dump());
  folder.write("stimuli/two-spheres.json", text_of(source / "stimuli/two-spheres.json"));
  folder.write("experiments/observers/causality.json",
               text_of(source / "experiments/observers/causality.json"));
  return "protocols/a.json";
}

inline std::string value_of(const TemporaryFolder& folder, const std::string& sql,
                            const std::string& file = "a.sqlite") {
  SQLite::Database database((folder / file).string(), SQLite::OPEN_READONLY);
  return database.execAndGet(sql).getString();
}

inline void change(const TemporaryFolder& folder, const std::string& sql) {
  SQLite::Database((folder / "a.sqlite").string(), SQLite::OPEN_READWRITE).exec(sql);
}

/// Conditions of the main trials in their order.
inline std::string order_of(const TemporaryFolder& folder, const std::string& participant,
                            const std::string& file = "a.sqlite") {
  return value_of(folder,
                  "SELECT group_concat(condition || seed) FROM (SELECT condition, trial.seed AS "
                  "seed FROM trial JOIN enrolment ON enrolment.id = enrolment_id JOIN participant "
                  "ON participant.id = participant_id WHERE pseudonym = '" +
                      participant + "' ORDER BY slot)",
                  file);
}

}  // namespace impetus
