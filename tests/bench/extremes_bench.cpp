// The extremes in our engine, Bullet and ODE: who keeps what, who hangs and who crashes.
//
//   impetus_extremes_bench [--only CASE]
//
// The cases are those of `impetus extremes` that are about motions, and two more: a velocity that
// is no number, and an empty mesh. Each scene runs in a process of its own, for at most twenty
// seconds of CPU time.
//
//   CASE, what is measured (the less the better), what counts as kept
//     engine   scenes that kept it, of all | median, worst | without a figure, hung, crashed,
//     refused
//
// Without a figure are scenes that ended with what is no number, or in which nothing touched.
//
// A promise counts as kept within a hundredth, or its own number if that is more: single precision
// is not held against anybody. Peers run scenes that differ only in what our engine is told (trees,
// response, rotation) once; ours runs them all.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "experiments/extremes/building_blocks.hpp"
#include "experiments/extremes/extreme_cases.hpp"
#include "tests/bench/bounded_child.hpp"
#include "tests/bench/peers/peer_scene.hpp"

#ifdef BT_USE_DOUBLE_PRECISION
#define BULLET_PRECISION "double"
#else
#define BULLET_PRECISION "single"
#endif

namespace impetus {
namespace {

constexpr int kMostCpu_s = 20;
constexpr double kLax = 0.01;

struct Engine {
  const char* name;
  std::unique_ptr<PeerScene> (*make)(const ExtremeScene&);
  bool ours{false};
};

constexpr std::array kEngines{
    Engine{"ours", our_scene, true},
    Engine{"Bullet, " BULLET_PRECISION, bullet_scene},
    Engine{"Bullet, " BULLET_PRECISION ", continuous", continuous_bullet_scene},
    Engine{"ODE, quick step", ode_scene},
    Engine{"ODE, exact step", exact_ode_scene},
};

/// What became of one promise in all scenes of an engine.
struct Tally {
  int scenes{0};
  int kept{0};
  int without_figure{0};
  int hung{0};
  int crashed{0};
  int refused{0};
  std::vector<double> figures{};
};

void add_end(ChildEnd end, Tally& tally) {
  tally.hung += end == ChildEnd::kHung ? 1 : 0;
  tally.crashed += end == ChildEnd::kCrashed ? 1 : 0;
  tally.refused += end == ChildEnd::kRefused ? 1 : 0;
}

void add_figure(double figure, double at_most, Tally& tally) {
  if (!std::isfinite(figure)) {
    ++tally.without_figure;
    return;
  }
  tally.figures.push_back(figure);
  tally.kept += figure <= std::max(at_most, kLax) ? 1 : 0;
}

std::string faults_of(const Tally& tally) {
  std::string text;
  const auto add = [&](int count, const char* what) {
    if (count > 0) {
      text += std::string(text.empty() ? "" : ", ") + std::to_string(count) + " " + what;
    }
  };
  add(tally.without_figure, "without a figure");
  add(tally.hung, "hung");
  add(tally.crashed, "crashed");
  add(tally.refused, "refused");
  return text;
}

void print(const char* engine, Tally tally) {
  std::sort(tally.figures.begin(), tally.figures.end());
  std::printf("  %-28s %3d of %3d", engine, tally.kept, tally.scenes);
  if (tally.figures.empty()) {
    std::printf("  %22s", "");
  } else {
    std::printf("  %10.3g %10.3g ", tally.figures[tally.figures.size() / 2], tally.figures.back());
  }
  std::printf("  %s\n", faults_of(tally).c_str());
  std::fflush(stdout);
}

/// What peers are told of a scene, as text: the same for scenes that differ only in the rest.
std::string told(const ExtremeScene& scene) {
  std::string text = std::to_string(scene.step_s) + " " + std::to_string(scene.steps) + " " +
                     std::to_string(scene.settings.restitution);
  for (const ExtremeBody& body : scene.bodies) {
    const MotionSeen& start = body.start;
    const Vector3 inertia = inertia_of(body);
    char line[400];
    std::snprintf(line, sizeof line, "\n%zu %a %a %a %a|%a %a %a|%a %a %a %a|%a %a %a|%a %a %a",
                  body.solid.index(), body.mass_kg, inertia.x(), inertia.y(), inertia.z(),
                  start.pose.position.x(), start.pose.position.y(), start.pose.position.z(),
                  start.pose.orientation.w(), start.pose.orientation.x(),
                  start.pose.orientation.y(), start.pose.orientation.z(), start.velocity_m_s.x(),
                  start.velocity_m_s.y(), start.velocity_m_s.z(), start.spin_rad_s.x(),
                  start.spin_rad_s.y(), start.spin_rad_s.z());
    text += line;
  }
  return text;
}

std::vector<ExtremeScene> once_each(const std::vector<ExtremeScene>& scenes) {
  std::vector<std::string> known;
  std::vector<ExtremeScene> result;
  for (const ExtremeScene& scene : scenes) {
    const std::string text = told(scene);
    if (std::find(known.begin(), known.end(), text) == known.end()) {
      known.push_back(text);
      result.push_back(scene);
    }
  }
  return result;
}

std::vector<double> figures_of(const ExtremeCase& extreme, const ExtremeScene& scene,
                               const Engine& engine) {
  const std::unique_ptr<PeerScene> peer = engine.make(scene);
  Course course(scene);
  for (std::int64_t step = 0; step < scene.steps; ++step) {
    peer->step();
    course.look(peer->motions());
  }
  std::vector<double> figures;
  for (const ExtremePromise& promise : extreme.promises) {
    figures.push_back(course.finite() ? promise.measure(course)
                                      : std::numeric_limits<double>::quiet_NaN());
  }
  return figures;
}

/// Promises about our own reports mean nothing of motions that were only seen.
bool is_about_motions(const ExtremePromise& promise) {
  return promise.sentence.find("report") == std::string::npos;
}

void print_case(const ExtremeCase& extreme) {
  const bool crowded = extreme.family == "rest and touch";  // as many bodies as it is about
  const std::vector<ExtremeScene> scenes =
      extreme.scenes(crowded ? Length::kUsual : Length::kQuick);
  const std::vector<ExtremeScene> for_peers = once_each(scenes);
  std::vector<std::vector<Tally>> tallies;  // by engine, by promise
  for (const Engine& engine : kEngines) {
    tallies.emplace_back(extreme.promises.size());
    for (const ExtremeScene& scene : engine.ours ? scenes : for_peers) {
      if (engine.ours) {
        static_cast<void>(world_of(scene));  // trees are kept: no child need build them again
      }
      const ChildResult result =
          in_bounded_child([&] { return figures_of(extreme, scene, engine); }, kMostCpu_s);
      for (std::size_t i = 0; i < extreme.promises.size(); ++i) {
        Tally& tally = tallies.back()[i];
        ++tally.scenes;
        add_end(result.end, tally);
        if (result.end == ChildEnd::kDone) {
          add_figure(result.found.at(i), extreme.promises[i].at_most, tally);
        }
      }
    }
  }
  for (std::size_t i = 0; i < extreme.promises.size(); ++i) {
    if (!is_about_motions(extreme.promises[i])) {
      continue;
    }
    std::printf("\n%s: %s ... (kept: %g)\n", extreme.name.c_str(),
                extreme.promises[i].sentence.c_str(), std::max(extreme.promises[i].at_most, kLax));
    for (std::size_t engine = 0; engine < kEngines.size(); ++engine) {
      print(kEngines[engine].name, tallies[engine][i]);
    }
  }
}

/// How many other bodies of a crowd are no numbers forty steps after one was spoilt.
std::vector<double> spread_of_nan(const Engine& engine) {
  constexpr std::size_t kSpoilt = 7;
  ExtremeScene scene = crowd_scene(/*count=*/40, /*filled=*/3.0, /*restitution=*/1.0, /*steps=*/0);
  scene.settings.enclosure.reset();
  const std::unique_ptr<PeerScene> peer = engine.make(scene);
  for (int step = 0; step < 40; ++step) {
    if (step == 3) {
      peer->spoil(kSpoilt);
    }
    peer->step();
  }
  double spoilt = 0.0;
  const std::vector<MotionSeen> motions = peer->motions();
  for (std::size_t body = 0; body < motions.size(); ++body) {
    const bool finite =
        motions[body].pose.position.allFinite() && motions[body].velocity_m_s.allFinite();
    spoilt += body != kSpoilt && !finite ? 1.0 : 0.0;
  }
  return {spoilt};
}

void print_nan() {
  std::printf("\nnan: a body of a crowd of 40 whose velocity is made no number: others spoilt\n");
  for (const Engine& engine : kEngines) {
    const ChildResult result = in_bounded_child([&] { return spread_of_nan(engine); }, kMostCpu_s);
    Tally tally;
    tally.scenes = 1;
    add_end(result.end, tally);
    if (result.end == ChildEnd::kDone) {
      add_figure(result.found.at(0), 0.0, tally);
    }
    print(engine.name, tally);
  }
}

void print_empty_meshes() {
  std::printf("\nempty: a mesh without triangles, and a ball where it is\n");
  constexpr std::array<std::pair<const char*, void (*)()>, 4> kLibraries{
      {{"ours", empty_mesh_in_ours},
       {"Bullet, " BULLET_PRECISION, empty_mesh_in_bullet},
       {"ODE", empty_mesh_in_ode},
       {"FCL", empty_mesh_in_fcl}}};
  for (const auto& [name, act] : kLibraries) {
    const auto run = act;
    const ChildResult result = in_bounded_child(
        [run] {
          run();
          return std::vector<double>{};
        },
        kMostCpu_s);
    constexpr std::array kWords{"takes it for nothing", "refuses it", "hangs", "crashes"};
    std::printf("  %-28s %s\n", name, kWords[static_cast<std::size_t>(result.end)]);
  }
}

void print_asked(const std::string& only) {
  const auto asked = [&](const std::string& name) { return name.rfind(only, 0) == 0; };
  for (const ExtremeCase& extreme : extreme_cases()) {
    if (extreme.scenes && extreme.family != "long runs" && asked(extreme.name)) {
      print_case(extreme);
    }
  }
  if (asked("nan")) {
    print_nan();
  }
  if (asked("empty")) {
    print_empty_meshes();
  }
}

}  // namespace
}  // namespace impetus

int main(int count, char** arguments) {
  const bool only = count == 3 && std::string(arguments[1]) == "--only";
  if (count != 1 && !only) {
    std::fprintf(stderr, "expected nothing or --only CASE\n");
    return 2;
  }
  impetus::print_asked(only ? arguments[2] : "");
  return 0;
}
