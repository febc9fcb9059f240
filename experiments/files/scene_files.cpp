// SPDX-License-Identifier: MIT
#include "experiments/files/scene_files.hpp"

#include <exception>
#include <optional>
#include <stdexcept>
#include <utility>

#include "experiments/files/mesh_file.hpp"
#include "experiments/files/sound_file.hpp"
#include "experiments/models/base64.hpp"
#include "experiments/models/mesh_bytes.hpp"
#include "experiments/models/mesh_report.hpp"
#include "experiments/models/readable_file.hpp"
#include "experiments/protocol/checked_scene.hpp"
#include "experiments/protocol/observer_file.hpp"
#include "experiments/scenes/scene_checks.hpp"
#include "experiments/scenes/scene_meshes.hpp"
#include "experiments/settings/named_file.hpp"

namespace impetus::inline files {
namespace {

using nlohmann::json;

json content_of(const TriangleMesh& mesh) {
  std::string bytes;
  append_mesh(bytes, mesh);
  return {{"vertices", mesh.vertices.size()},
          {"triangles", mesh.triangles.size()},
          {"hash", content_hash(mesh)},
          {"base64", base64(bytes)}};
}

/// Puts the content of `file` into the scene, unless it is there; `pointer` is where it is named.
void hold_figure(JsonDocument& scene, const FigureFile& named,
                 const std::filesystem::path& folder) {
  if (scene.value.contains("figure_files") && scene.value["figure_files"].contains(named.file)) {
    return;
  }
  std::string problem = problem_of_place(named.file, folder);
  const std::filesystem::path path = folder / named.file;
  if (!problem.empty()) {
    refuse(scene, named.pointer, problem);
  }
  if (problem = reading_problem(path); !problem.empty()) {
    refuse(scene, named.pointer, "expected a figure file, but " + path.string() + ": " + problem);
  }
  const JsonDocument figure = read_json(path);
  if (const auto broken = find_schema_problem(figure_schema(), figure.value)) {
    refuse(figure, broken->pointer, broken->message);
  }
  scene.value["figure_files"][named.file] = figure.value;
}

/// Puts the numbers of whom the schedule names in place of the file's name.
void hold_noticing(JsonDocument& scene, const std::filesystem::path& path) {
  const std::string place = "/engine/schedule/noticing";
  const json::json_pointer pointer(place);
  if (!scene.value.contains(pointer) || !scene.value[pointer].is_string()) {
    return;
  }
  const std::filesystem::path file =
      named_file(scene, path, place, "a file of a simulated participant");
  const ObserverFile observer = load_observer(file.string(), path);
  if (observer.kind->name != "gaze-contingent") {
    refuse(observer.document, "/observer",
           "expected gaze-contingent, who notices gaps, got " + json(observer.kind->name).dump());
  }
  json numbers;
  for (const char* name : {"threshold_arcmin", "crowding_per_body", "width_log10", "miss_rate"}) {
    numbers[name] = observer.document.value["parameters"][name]["value"];
  }
  scene.value[pointer] = std::move(numbers);
  scene.text = scene.value.dump();
}

/// Puts the content of `file` into the scene, unless it is there; `pointer` is where it is named.
void hold_sound(JsonDocument& scene, const std::string& pointer, const std::string& file,
                const std::filesystem::path& folder) {
  if (scene.value.contains("sound_files") && scene.value["sound_files"].contains(file)) {
    return;
  }
  if (const std::string problem = problem_of_place(file, folder); !problem.empty()) {
    refuse(scene, pointer, problem);
  }
  try {
    scene.value["sound_files"][file] = content_of(load_sound(folder / file));
  } catch (const std::runtime_error& error) {
    refuse(scene, pointer, std::string("expected a sound file, but ") + error.what());
  }
}

/// Of the scene, and of a protocol's factors.
void hold_sounds(JsonDocument& scene, const MoreFiles& more, const std::filesystem::path& folder) {
  const std::optional<std::string> own = named_sound_file(scene.value);
  if (own) {
    hold_sound(scene, "/sound/file", *own, folder);
  }
  for (const std::string& file : more.sounds) {
    hold_sound(scene, "", file, folder);
  }
  if (own || !more.sounds.empty()) {
    scene.text = scene.value.dump();
  }
}

/// Figures first: their parts may be meshes.
void hold_files(JsonDocument& scene, const MoreFiles& more, const std::filesystem::path& folder) {
  std::vector<FigureFile> figures = named_figure_files(scene.value);
  for (const std::string& file : more.figures) {
    figures.push_back({"", file});
  }
  for (const FigureFile& each : figures) {
    hold_figure(scene, each, folder);
  }
  std::vector<MeshFile> meshes = named_mesh_files(scene.value);
  for (const std::string& file : more.meshes) {
    meshes.push_back({"", file});
  }
  for (const MeshFile& each : meshes) {
    const std::string problem = hold_mesh(scene.value, each.file, folder);
    if (!problem.empty()) {
      refuse(scene, each.pointer, problem);
    }
  }
  if (!figures.empty() || !meshes.empty()) {
    scene.text = scene.value.dump();
  }
}

/// A protocol is no scene, but names one.
void require_no_protocol(const JsonDocument& document) {
  if (is_protocol(document)) {
    const json named = document.value.value("scene", json());
    throw InputError(document.name + ": expected a scene, got a protocol" +
                     (named.is_string() ? ", whose scene is " + named.get<std::string>() : "") +
                     "; impetus check explains a protocol, impetus run shows it");
  }
}

}  // namespace

std::string hold_mesh(json& scene, const std::string& file, const std::filesystem::path& folder) {
  if (scene.contains("meshes") && scene["meshes"].contains(file)) {
    return "";
  }
  std::string misplaced = problem_of_place(file, folder);
  if (!misplaced.empty()) {
    return misplaced;
  }
  try {
    const TriangleMesh mesh = load_mesh(folder / file);
    const std::string problem = refusal(report_mesh(mesh));
    if (!problem.empty()) {
      return "expected a closed mesh, but " + (folder / file).string() + " " + problem;
    }
    scene["meshes"][file] = content_of(mesh);
  } catch (const std::exception& error) {
    return std::string("expected a mesh file, but ") + error.what();
  }
  return "";
}

JsonDocument read_scene(const std::filesystem::path& path) {
  JsonDocument document = read_json(path);
  require_no_protocol(document);
  return with_files(std::move(document), path);
}

JsonDocument with_files(JsonDocument scene, const std::filesystem::path& path,
                        const MoreFiles& more) {
  require_scene_schema(scene);
  hold_noticing(scene, path);
  hold_files(scene, more, path.parent_path());
  hold_sounds(scene, more, path.parent_path());
  return scene;
}

JsonDocument load_scene(const std::filesystem::path& path) {
  JsonDocument scene = read_scene(path);
  require_scene(scene);
  return scene;
}

}  // namespace impetus::inline files
