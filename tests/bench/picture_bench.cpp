// What a frame of a stimulus costs to paint, plainly and with all that a scene's appearance can
// add.
//
//   impetus_picture_bench [--quick]      needs no display
//
// Where there is no graphics card, the software renderer's count of work stands in for it: how
// often it ran the fragment shaders, less once a pixel, which averages samples. A lit fragment
// takes some 300 operations, a power counted as eight; a modest card does 200 thousand million a
// second, half of what the graphics of an office processor of 2017 are sold as (Intel UHD 620, 403
// GFLOPS). Not in it: memory for four samples a pixel. The processor time is what a machine without
// a card takes.
// SPDX-License-Identifier: MIT
#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <ctime>
#include <exception>
#include <string>
#include <vector>

#include "experiments/drawing/scene_painter.hpp"
#include "experiments/files/scene_files.hpp"
#include "experiments/protocol/screen_file.hpp"
#include "experiments/run/live_run.hpp"
#include "experiments/scenes/scene_file.hpp"
#include "experiments/scenes/shape_library.hpp"
#include "experiments/window/gl_window.hpp"
#include "experiments/window/pixels.hpp"
#include "tests/bench/thread_time.hpp"
#include "tests/places/places.hpp"

namespace impetus {
namespace {

constexpr int kWidth_px = 1920;
constexpr int kHeight_px = 1080;
constexpr int kFrames = 30;
constexpr double kOperations = 300.0;  ///< of a lit fragment
constexpr double kCardOperations_s = 200e9;

/// A scene that is painted, and how long a frame of it may take on a modest card.
struct PaintedScene {
  const char* name;
  const char* file;
  nlohmann::json changes;
  double goal_ms;
};

nlohmann::json everything() {
  return {{"cast_shadows", 0.6}, {"contact_shadows", 0.6}, {"texture", "marble"}, {"gloss", 0.3}};
}

std::vector<PaintedScene> painted_scenes() {
  nlohmann::json on_ground = everything();
  on_ground["ground"] = "checks";
  nlohmann::json four_lights = on_ground;
  for (const double azimuth_deg : {-60.0, -20.0, 20.0, 60.0}) {
    four_lights["lights"].push_back(
        {{"azimuth_deg", azimuth_deg}, {"elevation_deg", 50}, {"strength", 0.4}});
  }
  const nlohmann::json raised{{"elevation_deg", 12}};
  return {
      {"two balls", "two-spheres", {}, 4.0},
      {"  on a ground", "two-spheres", {{"appearance", on_ground}, {"viewer", raised}}, 4.0},
      {"  by four lights", "two-spheres", {{"appearance", four_lights}, {"viewer", raised}}, 4.0},
      {"two figures on a ground",
       "two-figures",
       {{"appearance", on_ground}, {"viewer", raised}},
       4.0},
      {"50 creatures in a cube", "creatures-in-a-cube", {{"crowd", {{"count", 50}}}}, 12.0},
      {"  all looks",
       "creatures-in-a-cube",
       {{"crowd", {{"count", 50}}}, {"appearance", everything()}},
       12.0}};
}

/// Seconds of processor time that this process has had, in all its threads.
double process_cpu_s() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Counts how often shaders of one kind run; 0 where the driver does not count.
class Invocations {
 public:
  explicit Invocations(GLenum what) : what_(what) { glGenQueries(1, &query_); }
  ~Invocations() { glDeleteQueries(1, &query_); }
  Invocations(const Invocations&) = delete;
  Invocations& operator=(const Invocations&) = delete;

  void begin() const {
    if (counts()) {
      glBeginQuery(what_, query_);
    }
  }
  double end() const {
    if (!counts()) {
      return 0.0;
    }
    glEndQuery(what_);
    GLuint64 count = 0;
    glGetQueryObjectui64v(query_, GL_QUERY_RESULT, &count);
    return static_cast<double>(count);
  }

 private:
  static bool counts() { return epoxy_has_gl_extension("GL_ARB_pipeline_statistics_query"); }
  GLenum what_;
  GLuint query_{0};
};

StagedScene staged(const PaintedScene& scene) {
  ShapeLibrary library;
  nlohmann::json document = load_scene(source_folder() + "/stimuli/" + scene.file + ".json").value;
  document.merge_patch(scene.changes);
  return build_scene(document, assumed_screen(kWidth_px, kHeight_px), 0.0, library);
}

void measure(const PaintedScene& scene, int frames) {
  LiveRun live(staged(scene), 1);
  const double time_s = 0.5 * live.scene().duration_s;
  const Picture picture = picture_of(live.scene(), live.poses_at(time_s), time_s, {});
  ScenePainter painter;
  const PixelArea whole{0, 0, kWidth_px, kHeight_px};
  const Invocations fragments(GL_FRAGMENT_SHADER_INVOCATIONS_ARB);
  const Invocations vertices(GL_VERTEX_SHADER_INVOCATIONS_ARB);
  painter.paint(picture, whole);  // compiles the shaders
  glFinish();
  std::vector<double> cpu_ms;
  double fragment_count = 0.0;
  double vertex_count = 0.0;
  for (int frame = 0; frame < frames; ++frame) {
    const double before_s = process_cpu_s();
    fragments.begin();
    vertices.begin();
    painter.paint(picture, whole);
    vertex_count = vertices.end();
    fragment_count = fragments.end();
    glFinish();
    cpu_ms.push_back(1e3 * (process_cpu_s() - before_s));
  }
  const double lit = std::max(0.0, fragment_count - kWidth_px * kHeight_px);
  const double card_ms = 1e3 * lit * kOperations / kCardOperations_s;
  std::printf("| %s | %.2f | %.0f | %.1f | %.1f | %.0f | %.2f |\n", scene.name, lit / 1e6,
              vertex_count / 1e3, spread_of(cpu_ms).median, card_ms, scene.goal_ms,
              card_ms / scene.goal_ms);
}

int measure_all(const std::vector<std::string>& arguments) {
  const bool quick = std::find(arguments.begin(), arguments.end(), "--quick") != arguments.end();
  const GlWindow window(unseen_window({kWidth_px, kHeight_px}));
  std::printf(
      "%s\n\n| %d x %d pixels | million lit fragments | thousand vertices | CPU ms | "
      "card ms, estimated | goal | of it |\n|---|---|---|---|---|---|---|\n",
      window.description().c_str(), kWidth_px, kHeight_px);
  for (const PaintedScene& scene : painted_scenes()) {
    measure(scene, quick ? 3 : kFrames);
  }
  return 0;
}

}  // namespace
}  // namespace impetus

int main(int count, char** words) {
  try {
    return impetus::measure_all(std::vector<std::string>(words + 1, words + count));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "impetus_picture_bench: %s\n", error.what());
    return 1;
  }
}
