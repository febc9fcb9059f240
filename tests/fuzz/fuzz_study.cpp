// SPDX-License-Identifier: MIT
#include <sqlite3.h>
#include <unistd.h>

#include <SQLiteCpp/Database.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

#include "experiments/store/adaptive_rows.hpp"
#include "experiments/study/replay_library.hpp"
#include "tests/fuzz/asked_work.hpp"
#include "tests/fuzz/refusals.hpp"
#include "tests/fuzz/small_studies.hpp"
#include "tests/fuzz/targets.hpp"

namespace impetus {
namespace {

/// Rows may be changed, nothing else: no other file, no other table.
int only_rows(void* /*nothing*/, int action, const char*, const char*, const char*, const char*) {
  for (const int allowed : {SQLITE_INSERT, SQLITE_UPDATE, SQLITE_DELETE, SQLITE_SELECT, SQLITE_READ,
                            SQLITE_TRANSACTION}) {
    if (action == allowed) {
      return SQLITE_OK;
    }
  }
  return SQLITE_DENY;
}

void change_rows(const std::filesystem::path& file, std::string_view statements) {
  constexpr int kMostBytes = 1'000'000;
  SQLite::Database database(file.string(), SQLite::OPEN_READWRITE);
  sqlite3_set_authorizer(database.getHandle(), only_rows, nullptr);
  sqlite3_limit(database.getHandle(), SQLITE_LIMIT_LENGTH, kMostBytes);
  database.tryExec(std::string(statements));
}

/// Whether a protocol of the study, if it is JSON, asks for much.
bool holds_heavy_work(StudyFile& study, std::int64_t protocol_id) {
  const ProtocolTexts texts = load_protocol_texts(study, protocol_id);
  const auto protocol = nlohmann::json::parse(texts.protocol_json, nullptr, false);
  const auto scene = nlohmann::json::parse(texts.scene_json, nullptr, false);
  return !protocol.is_discarded() && !scene.is_discarded() && asks_for_much(scene, protocol);
}

void read_all_of(StudyFile& study, const StoredAttempt& attempt) {
  load_gaze(study, attempt.id);
  load_clicks(study, attempt.id);
  load_onset(study, attempt.id, 1);
  load_responses(study, attempt.id);
  load_late_frames(study, attempt.id);
}

void replay_some(StudyFile& study) {
  constexpr std::size_t kMostAttempts = 3;
  constexpr std::size_t kMostSteps = 8;
  std::vector<StoredAttempt> attempts = load_attempts(study);
  attempts.resize(std::min(attempts.size(), kMostAttempts));
  ReplayLibrary library(study);
  for (const StoredAttempt& attempt : attempts) {
    read_all_of(study, attempt);
    if (holds_heavy_work(study, attempt.protocol_id)) {
      continue;
    }
    for (std::int64_t interval = 1; interval <= library.intervals(attempt); ++interval) {
      std::vector<StepRecord> steps = library.steps(attempt, interval);
      steps.resize(std::min(steps.size(), kMostSteps));
      replay(library.stage(attempt, interval), steps);
    }
  }
  load_adaptive_trials(study);
}

}  // namespace

void fuzz_study(std::string_view bytes) {
  if (bytes.empty()) {
    return;
  }
  const std::filesystem::path file = std::filesystem::temp_directory_path() /
                                     ("impetus-fuzz-" + std::to_string(getpid()) + ".sqlite");
  const auto& studies = small_studies();
  const bool whole = bytes.front() == kWholeFile;
  const std::string_view content =
      whole ? bytes.substr(1) : studies[static_cast<unsigned char>(bytes.front()) % studies.size()];
  std::ofstream(file, std::ios::binary)
      .write(content.data(), static_cast<std::streamsize>(content.size()));
  if (!whole) {
    change_rows(file, bytes.substr(1));
  }
  expect_taken_or_refused({file.string()}, [&] {
    try {
      StudyFile study = StudyFile::open_for_reading(file);
      replay_some(study);
    } catch (const SQLite::Exception&) {  // as the commands do: they say that it cannot be read
    }
  });
  std::filesystem::remove(file);
}

}  // namespace impetus
