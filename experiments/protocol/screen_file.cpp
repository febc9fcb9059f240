// SPDX-License-Identifier: MIT
#include "experiments/protocol/screen_file.hpp"

#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>

#include "experiments/settings/json_document.hpp"
#include "experiments/settings/schema_sentences.hpp"

namespace impetus::inline protocol {
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
      "viewing_distance_cm": {"type": "number", "minimum": 20, "maximum": 300},
      "square_pixels": {"type": "boolean"},
      "light": {
        "type": "object",
        "additionalProperties": false,
        "required": ["black_cd_m2", "white_cd_m2", "gamma"],
        "properties": {
          "black_cd_m2": {"type": "number", "minimum": 0, "maximum": 1000},
          "white_cd_m2": {"type": "number", "exclusiveMinimum": 0, "maximum": 10000},
          "gamma": {"type": "number", "minimum": 0.5, "maximum": 5}
        }
      }
    }
  })");
  return schema;
}

ScreenLight light_of(const JsonDocument& document) {
  const json& light = document.value["light"];
  const ScreenLight read{light["black_cd_m2"].get<double>(), light["white_cd_m2"].get<double>(),
                         light["gamma"].get<double>()};
  if (read.white_cd_m2 <= read.black_cd_m2) {
    refuse(document, "/light/white_cd_m2",
           "expected more than black, " + light["black_cd_m2"].dump() + ", got " +
               light["white_cd_m2"].dump());
  }
  return read;
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

LabScreen load_screen(const std::filesystem::path& path) {
  const JsonDocument document = read_json(path);
  if (const auto problem = find_schema_problem(screen_schema(), document.value)) {
    refuse(document, problem->pointer, problem->message);
  }
  LabScreen screen;
  screen.geometry.width_m = document.value["width_cm"].get<double>() / 100.0;
  screen.geometry.height_m = document.value["height_cm"].get<double>() / 100.0;
  screen.geometry.viewing_distance_m = document.value["viewing_distance_cm"].get<double>() / 100.0;
  screen.square_pixels = document.value.value("square_pixels", true);
  if (document.value.contains("light")) {
    screen.light = light_of(document);
  }
  return screen;
}

ScreenGeometry load_screen_of(const std::filesystem::path& path, int width_px, int height_px) {
  const LabScreen lab = load_screen(path);
  ScreenGeometry screen = lab.geometry;
  screen.width_px = width_px;
  screen.height_px = height_px;
  if (lab.square_pixels && !has_square_pixels(screen)) {
    throw InputError(path.string() + ":/width_cm: expected a width at which pixels are square " +
                     "within 1 %, got " + screen_words(screen) + ", each pixel " +
                     pixel_words(screen) +
                     "; `impetus screen` measures anew, or keeps that they are not square "
                     "(--pixels-not-square)");
  }
  return screen;
}

void save_screen(const LabScreen& screen, const std::filesystem::path& path) {
  // To the micrometre: 57, where the product of metres is 56.99999999999999.
  const auto centimetres = [](double metres) { return std::round(metres * 1e6) / 1e4; };
  const ScreenGeometry& size = screen.geometry;
  json document{{"schema_version", 1},
                {"width_cm", centimetres(size.width_m)},
                {"height_cm", centimetres(size.height_m)},
                {"viewing_distance_cm", centimetres(size.viewing_distance_m)}};
  if (!screen.square_pixels) {
    document["square_pixels"] = false;
  }
  if (screen.light) {
    document["light"] = {{"black_cd_m2", screen.light->black_cd_m2},
                         {"white_cd_m2", screen.light->white_cd_m2},
                         {"gamma", screen.light->gamma}};
  }
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

ScreenGeometry assumed_screen(int width_px, int height_px) {
  constexpr double kHeight_m = 0.301;
  // To the millimetre, as a ruler would tell: 37.6 cm of 1280 × 1024 pixels.
  const double width_m = std::round(1e3 * kHeight_m * width_px / height_px) / 1e3;
  return {width_m, kHeight_m, width_px, height_px, 0.57};
}

}  // namespace impetus::inline protocol
