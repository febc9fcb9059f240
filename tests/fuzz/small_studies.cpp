// SPDX-License-Identifier: MIT
#include "tests/fuzz/small_studies.hpp"

#include <unistd.h>

#include <SQLiteCpp/Database.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "tests/fuzz/targets.hpp"
#include "tests/places/places.hpp"

namespace impetus {
namespace {

using nlohmann::json;

/// One with gaze and clicks among them, whose scene is too heavy to replay. Of far-and-fast the
/// checks of its scene alone would take seconds with the fuzzers' instruments.
constexpr const char* kRecordings[] = {"causality-thresholds", "gap", "causality-thresholds-quest",
                                       "gaze-contingent-yoked"};

std::filesystem::path recording(const std::string& name) {
  return std::filesystem::path(source_folder()) / "tests/recordings" / (name + ".sqlite");
}

std::string cut(const std::string& name) {
  const std::filesystem::path file = std::filesystem::temp_directory_path() /
                                     ("impetus-cut-" + std::to_string(getpid()) + ".sqlite");
  std::filesystem::copy_file(recording(name), file,
                             std::filesystem::copy_options::overwrite_existing);
  {
    SQLite::Database database(file.string(), SQLite::OPEN_READWRITE);
    if (database.tableExists("click")) {  // not in studies of schema 1
      database.exec(
          "UPDATE click SET attempt_id = 1; DELETE FROM response WHERE attempt_id > 2;"
          "DELETE FROM gaze WHERE attempt_id > 2 OR sample > 8");
    }
    database.exec(
        "DELETE FROM step WHERE attempt_id > 2 OR step > 8; DELETE FROM collision;"
        "DELETE FROM frame; DELETE FROM rating WHERE attempt_id > 2;"
        "DELETE FROM attempt WHERE id > 2; PRAGMA page_size = 512; VACUUM");
  }
  std::ifstream stream(file, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  std::filesystem::remove(file);
  return bytes;
}

/// No tree deeper, and no list, than the second level.
void make_shallow(json& value, const std::string& key = "") {
  constexpr int kDeepest = 2;
  if (value.is_structured()) {
    for (auto part = value.begin(); part != value.end(); ++part) {
      make_shallow(*part, value.is_object() ? part.key() : "");
    }
  } else if ((key.ends_with("level") || key == "tree_depth") && value.is_number()) {
    value = std::min(value.get<int>(), kDeepest);
  }
}

/// Two levels of each factor at most, those of trees shallow; no practice and no demonstrations.
void make_small(json& protocol) {
  for (json& factor : protocol["design"]["factors"]) {
    json& levels = factor["levels"];
    while (levels.size() > 2) {
      levels.erase(1);
    }
    for (json& level : levels) {
      make_shallow(level, factor.value("pointer", ""));
    }
  }
  if (protocol.contains("session")) {
    protocol["session"].erase("demonstrations");
  }
  protocol["design"].erase("practice");
  protocol["design"].erase("practice_until");
  protocol["design"].erase("train_until");
}

}  // namespace

const std::vector<std::string>& small_studies() {
  static const std::vector<std::string> studies = [] {
    std::vector<std::string> made;
    for (const char* name : kRecordings) {
      made.push_back(cut(name));
    }
    return made;
  }();
  return studies;
}

std::vector<std::string> small_protocols() {
  std::vector<std::string> texts;
  for (const char* name : {"causality-thresholds", "causality-thresholds-quest", "far-and-fast",
                           "gap", "response", "scheduler-distribution", "gaze-contingent"}) {
    SQLite::Database database(recording(name).string(), SQLite::OPEN_READONLY);
    const auto text = [&](const char* column) {
      return json::parse(
          database
              .execAndGet("SELECT " + std::string(column) + " FROM protocol ORDER BY id LIMIT 1")
              .getString());
    };
    json protocol = text("protocol_json");
    json scene = text("scene_json");
    make_small(protocol);
    make_shallow(scene);
    texts.push_back(protocol.dump() + kPartSeparator + scene.dump());
  }
  return texts;
}

PublishedStudy small_published_study() {
  const std::string texts = small_protocols().front();
  const std::size_t end = texts.find(kPartSeparator);
  return {texts.substr(0, end), texts.substr(end + 1), {}, "a fuzzer"};
}

}  // namespace impetus
