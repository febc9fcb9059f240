// SPDX-License-Identifier: MIT
#include "experiments/protocol/screen_file.hpp"

#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>

#include "experiments/protocol/json_document.hpp"
#include "experiments/protocol/validation.hpp"

namespace impetus {
namespace {

using nlohmann::json;

const json& screen_schema() {
  static const json schema = json::parse(R"({
    "type": "object",
    "additionalProperties": false,
    "required": ["schema_version", "width_cm", "height_cm", "viewing_distance_cm"],
    "properties": {
      "schema_version": {"const": 1},
      "width_cm": {"type": "number", "minimum": 10, "maximum": 300},
      "height_cm": {"type": "number", "minimum": 10, "maximum": 200},
      "viewing_distance_cm": {"type": "number", "minimum": 20, "maximum": 300}
    }
  })");
  return schema;
}

}  // namespace

std::filesystem::path default_screen_file() {
  const char* config = std::getenv("XDG_CONFIG_HOME");
  const char* home = std::getenv("HOME");
  const std::filesystem::path base =
      config != nullptr && *config != '\0'
          ? std::filesystem::path(config)
          : std::filesystem::path(home != nullptr ? home : ".") / ".config";
  return base / "impetus" / "screen.json";
}

ScreenGeometry load_screen(const std::filesystem::path& path) {
  const JsonDocument document = read_json(path);
  if (const auto problem = find_schema_problem(screen_schema(), document.value)) {
    refuse(document, problem->pointer, problem->message);
  }
  ScreenGeometry screen;
  screen.width_m = document.value["width_cm"].get<double>() / 100.0;
  screen.height_m = document.value["height_cm"].get<double>() / 100.0;
  screen.viewing_distance_m = document.value["viewing_distance_cm"].get<double>() / 100.0;
  return screen;
}

void save_screen(const ScreenGeometry& screen, const std::filesystem::path& path) {
  // To the micrometre: 57, where the product of metres is 56.99999999999999.
  const auto centimetres = [](double metres) { return std::round(metres * 1e6) / 1e4; };
  const json document{{"schema_version", 1},
                      {"width_cm", centimetres(screen.width_m)},
                      {"height_cm", centimetres(screen.height_m)},
                      {"viewing_distance_cm", centimetres(screen.viewing_distance_m)}};
  std::error_code failed;
  std::filesystem::create_directories(path.parent_path(), failed);
  const std::filesystem::path fresh = path.string() + ".new";
  std::ofstream file(fresh);
  file << document.dump(2) << "\n";
  file.close();
  std::string reason = file ? "" : std::strerror(errno);
  if (file) {
    std::filesystem::rename(fresh, path, failed);
    reason = failed ? failed.message() : "";
  }
  if (!reason.empty()) {
    throw InputError(path.string() +
                     ": expected a file that can be written, but it cannot be: " + reason);
  }
}

ScreenGeometry assumed_screen() { return {0.376, 0.301, 1280, 1024, 0.57}; }

}  // namespace impetus
