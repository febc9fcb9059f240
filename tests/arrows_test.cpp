// Refuses an #include that points against the arrows between the rooms.
//
// The tables below are the rules, stated once. Arrows are transitive: a room may include its
// rooms, and theirs. Third-party libraries are not: a room gets only those it names.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/places/places.hpp"

namespace impetus {
namespace {

struct Room {
  std::string folder;
  std::vector<std::string> rooms;
  std::vector<std::string> libraries;
};

const std::vector<Room> kRooms = {
    {"engine/numerics", {}, {"Eigen"}},
    {"engine/volumes", {"engine/numerics"}, {}},
    {"engine/shapes", {"engine/numerics"}, {}},
    {"engine/shapes/solids", {"engine/shapes"}, {}},
    {"engine/trees", {"engine/shapes", "engine/volumes"}, {}},
    {"engine/trees/builders", {"engine/trees", "engine/shapes/solids"}, {}},
    {"engine/scheduling", {"engine/volumes"}, {}},
    {"engine/collision", {"engine/trees", "engine/scheduling"}, {}},
    {"engine/collision/entry", {"engine/collision"}, {}},
    {"engine/dynamics", {"engine/collision/entry", "engine/trees/builders"}, {}},
    {"engine/figures", {"engine/dynamics"}, {}},
    {"engine/world", {"engine/figures"}, {}},
    {"experiments/tables", {}, {}},
    {"experiments/connections", {}, {}},
    {"experiments/models", {"engine/world"}, {"JSON"}},
    {"experiments/settings", {"experiments/models"}, {"JSON", "valijson"}},
    {"experiments/design", {"experiments/settings", "experiments/tables"}, {}},
    {"experiments/languages", {"experiments/settings"}, {"JSON"}},
    {"experiments/record", {"experiments/design", "experiments/languages"}, {}},
    {"experiments/gaze", {"experiments/record"}, {}},
    {"experiments/sound", {"experiments/record"}, {}},
    {"experiments/questions", {"experiments/gaze"}, {"JSON"}},
    {"experiments/run", {"experiments/gaze"}, {}},
    {"experiments/trackers", {"experiments/gaze", "experiments/connections"}, {"JSON"}},
    {"experiments/viewing", {"experiments/run"}, {}},
    {"experiments/session", {"experiments/run", "experiments/questions"}, {}},
    {"experiments/scenes", {"experiments/run"}, {"JSON"}},
    {"experiments/observers", {"experiments/run", "experiments/questions"}, {"JSON"}},
    {"experiments/extremes", {"engine/world"}, {}},
    {"experiments/workers", {"engine/scheduling"}, {}},
    {"experiments/markers", {"experiments/record", "experiments/connections"}, {}},
    {"experiments/timing", {"experiments/scenes", "experiments/session"}, {"JSON"}},
    {"experiments/trade", {"experiments/scenes", "experiments/tables"}, {"JSON"}},
    {"experiments/protocol",
     {"experiments/scenes", "experiments/observers", "experiments/session", "experiments/tables"},
     {"JSON"}},
    {"experiments/lines", {"experiments/protocol"}, {"JSON"}},
    {"experiments/files", {"experiments/protocol"}, {"assimp", "JSON", "sndfile"}},
    {"experiments/store", {"experiments/session"}, {"SQLite"}},
    {"experiments/store/merging", {"experiments/store"}, {"SQLite"}},
    {"experiments/study", {"experiments/protocol", "experiments/store"}, {"JSON", "SQLite"}},
    {"experiments/provenance", {"experiments/store"}, {}},
    {"experiments/exports",
     {"experiments/store", "experiments/tables", "experiments/connections"},
     {"JSON", "SQLite", "zlib"}},
    {"experiments/fitting", {"experiments/observers", "experiments/tables"}, {"Eigen"}},
    {"experiments/power", {"experiments/settings", "experiments/tables"}, {"JSON", "SQLite"}},
    {"experiments/site",
     {"experiments/lines", "experiments/study", "experiments/exports"},
     {"JSON", "SQLite"}},
    {"experiments/drawing", {"experiments/run"}, {"window"}},
    {"experiments/browser", {"experiments/lines", "experiments/drawing"}, {"JSON"}},
    {"experiments/window",
     {"experiments/drawing", "experiments/session", "experiments/sound"},
     {"PNG", "window"}},
    {"experiments/viewers", {"experiments/window", "experiments/viewing"}, {"window"}},
    {"experiments/viewers/replays", {"experiments/viewers"}, {"window"}},
    {"experiments/commands",
     {"experiments/files", "experiments/study", "experiments/store/merging",
      "experiments/viewers/replays", "experiments/trade", "experiments/timing",
      "experiments/extremes", "experiments/exports", "experiments/fitting", "experiments/power",
      "experiments/site", "experiments/provenance", "experiments/markers", "experiments/trackers",
      "experiments/workers"},
     {"CLI", "JSON", "SQLite", "valijson", "assimp", "window"}},
    {"experiments/python",
     {"experiments/files", "experiments/study", "experiments/exports", "experiments/provenance"},
     {"JSON", "SQLite", "pybind11"}},
};

/// How a library's headers begin.
struct Library {
  std::string name;
  std::string header;
};

const std::vector<Library> kLibraries = {
    {"Eigen", "Eigen/"},       {"assimp", "assimp/"},     {"JSON", "nlohmann/"},
    {"valijson", "valijson/"}, {"SQLite", "sqlite3"},     {"SQLite", "SQLiteCpp/"},
    {"window", "SDL"},         {"window", "epoxy/"},      {"window", "GL/"},
    {"window", "imgui"},       {"CLI", "CLI/"},           {"zlib", "zlib.h"},
    {"sndfile", "sndfile.h"},  {"pybind11", "pybind11/"}, {"PNG", "png.h"},
    {"FCL", "fcl/"},  // tests alone
};

/// The engine reads no clock, no file and no global random state, prints nothing, has no threads
/// and no container whose order depends on a hash.
const std::set<std::string> kNotInTheEngine = {
    "chrono", "ctime",  "time.h", "fstream",       "iostream",      "cstdio",     "stdio.h",
    "random", "thread", "future", "unordered_map", "unordered_set", "filesystem",
};

bool begins_with(const std::string& text, const std::string& start) {
  return text.compare(0, start.size(), start) == 0;
}

/// The room of a file: the nearest folder above it that the table knows; a folder within a room
/// that the table does not know belongs to that room. Null when it knows none.
const Room* room_of(const std::string& path) {
  std::string folder = path;
  for (std::size_t end = path.rfind('/'); end != std::string::npos; end = folder.rfind('/')) {
    folder.resize(end);
    const auto room = std::find_if(kRooms.begin(), kRooms.end(),
                                   [&](const Room& each) { return each.folder == folder; });
    if (room != kRooms.end()) {
      return &*room;
    }
  }
  return nullptr;
}

bool may_reach(const Room& from, const std::string& folder) {
  if (from.folder == folder) {
    return true;
  }
  return std::any_of(from.rooms.begin(), from.rooms.end(), [&](const std::string& name) {
    return may_reach(*room_of(name + "/file"), folder);
  });
}

/// What is wrong with `header` in a file of `room`; empty when it may be included.
std::string objection(const Room& room, const std::string& header) {
  if (begins_with(header, "engine/") || begins_with(header, "experiments/")) {
    const Room* target = room_of(header);
    if (target == nullptr) {
      return "is in no room";
    }
    return may_reach(room, target->folder) ? "" : "points against the arrows";
  }
  if (begins_with(header, "tests/")) {
    return "is a test";
  }
  for (const Library& library : kLibraries) {
    const auto& own = room.libraries;
    if (begins_with(header, library.header) &&
        std::find(own.begin(), own.end(), library.name) == own.end()) {
      return "is a library that this room does not use";
    }
  }
  if (begins_with(room.folder, "engine") && kNotInTheEngine.count(header) > 0) {
    return "has no place in the engine";
  }
  return "";
}

/// One line for every include of `text`, the content of the file `path`, that breaks a rule.
std::vector<std::string> violations(const std::string& path, const std::string& text) {
  static const std::regex include(R"(^\s*#\s*include\s*[<"]([^>"]+)[>"])");
  const Room* room = room_of(path);
  if (room == nullptr) {
    return {path + ": is in no room of the table"};
  }
  std::vector<std::string> found;
  std::istringstream lines(text);
  std::smatch match;
  for (std::string line; std::getline(lines, line);) {
    if (std::regex_search(line, match, include)) {
      const std::string wrong = objection(*room, match[1]);
      if (!wrong.empty()) {
        found.push_back(path + ": " + match[1].str() + " " + wrong);
      }
    }
  }
  return found;
}

std::vector<std::filesystem::path> sources_under(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    const std::string extension = entry.path().extension().string();
    if (extension == ".hpp" || extension == ".cpp" || extension == ".h") {
      files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

TEST(Arrows, NoIncludePointsAgainstThem) {
  const std::filesystem::path root = source_folder();
  std::size_t files = 0;
  for (const char* folder : {"engine", "experiments"}) {
    for (const std::filesystem::path& file : sources_under(root / folder)) {
      std::ostringstream text;
      text << std::ifstream(file).rdbuf();
      const std::string path = file.lexically_relative(root).generic_string();
      for (const std::string& violation : violations(path, text.str())) {
        ADD_FAILURE() << violation;
      }
      ++files;
    }
  }
  EXPECT_GT(files, 30U) << "the sources were not found under " << root;
}

TEST(Rooms, HoldNoMoreThanAPersonKeepsInMind) {
  constexpr std::size_t kMostFiles = 45;
  std::map<std::filesystem::path, std::size_t> files;
  for (const char* folder : {"engine", "experiments", "tests"}) {
    for (const std::filesystem::path& file :
         sources_under(std::filesystem::path(source_folder()) / folder)) {
      ++files[file.parent_path().lexically_relative(source_folder())];
    }
  }
  for (const auto& [folder, count] : files) {
    EXPECT_LE(count, kMostFiles) << folder << " wants rooms within";
  }
}

TEST(Arrows, EveryRoomOfTheTableLeadsToRoomsOfTheTable) {
  for (const Room& room : kRooms) {
    for (const std::string& name : room.rooms) {
      EXPECT_EQ(room_of(name + "/file")->folder, name);
    }
  }
}

struct Planted {
  std::string path;
  std::string line;
};

TEST(Arrows, PlantedViolationsAreCaught) {
  const std::vector<Planted> plants = {
      {"engine/volumes/sphere.hpp", "#include \"engine/trees/volume_tree.hpp\""},
      {"engine/scheduling/viewer.hpp", "#include \"engine/trees/volume_tree.hpp\""},
      {"engine/dynamics/body.cpp", "#include \"engine/world/world.hpp\""},
      {"engine/world/world.cpp", "  #  include \"experiments/design/plan.hpp\""},
      {"engine/world/world.cpp", "#include <chrono>"},
      {"engine/trees/volume_tree.cpp", "#include <unordered_map>"},
      {"engine/shapes/triangle_mesh.cpp", "#include <fstream>"},
      {"engine/world/world.cpp", "#include \"tests/engine/builders.hpp\""},
      {"experiments/design/plan.cpp", "#include <nlohmann/json.hpp>"},
      {"experiments/design/plan.cpp", "#include \"experiments/store/writer.hpp\""},
      {"experiments/store/writer.cpp", "#include \"experiments/protocol/protocol_file.hpp\""},
      {"experiments/protocol/protocol_file.cpp", "#include <SQLiteCpp/Database.h>"},
      {"experiments/protocol/protocol_file.cpp", "#include <assimp/scene.h>"},
      {"experiments/window/window.cpp", "#include \"experiments/store/writer.hpp\""},
      {"experiments/observers/headless_lab.hpp", "#include <SDL.h>"},
      {"experiments/store/writer.cpp", "#include \"experiments/commands/run.hpp\""},
      {"experiments/attic/anything.cpp", ""},
      {"engine/world/world.cpp", "#include \"engine/attic/anything.hpp\""},
  };
  for (const Planted& plant : plants) {
    EXPECT_EQ(violations(plant.path, plant.line + "\n").size(), 1U)
        << plant.path << ": " << plant.line;
  }
}

TEST(Arrows, LawfulIncludesPass) {
  EXPECT_TRUE(violations("experiments/store/reader.cpp",
                         "#include <SQLiteCpp/Database.h>\n#include <vector>\n"
                         "#include \"engine/numerics/bits.hpp\"\n"
                         "#include \"experiments/design/plan.hpp\"\n")
                  .empty());
}

}  // namespace
}  // namespace impetus
