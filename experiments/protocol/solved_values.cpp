// SPDX-License-Identifier: MIT
#include "experiments/protocol/solved_values.hpp"

#include <algorithm>
#include <cmath>

#include "engine/numerics/elementary_functions.hpp"
#include "engine/scheduling/solved_thresholds.hpp"
#include "experiments/protocol/checks/protocol_scene_checks.hpp"
#include "experiments/protocol/screen_file.hpp"
#include "experiments/protocol/spin_limits.hpp"
#include "experiments/questions/level_value.hpp"
#include "experiments/run/live_run.hpp"
#include "experiments/scenes/engine_setup.hpp"
#include "experiments/scenes/scene_file.hpp"
#include "experiments/session/unattended.hpp"
#include "experiments/tables/number_text.hpp"

namespace impetus::inline protocol {
namespace {

using nlohmann::json;

constexpr const char* kSpinPointer = "/imposed/random_spin";

constexpr const char* kEqualLists = "equal-lists";

RowList<SolveEntry> equal_lists_rows() {
  using E = SolveEntry;
  return {row("share", &E::share, number({0, 1}), "Of the first list."),
          row("within", &E::within, number(above(0, 1)), "The share may miss by so much."),
          row("pilot_s", &E::pilot_s, number(above(0, 3600)),
              "Simulated time of the pilot, whose random start is its own.")};
}

RowList<SolveEntry> rows_of_kind(const std::string& kind) {
  return kind == kEqualLists ? equal_lists_rows() : spin_limits_rows();
}

/// An entry has the keys of its kind and none of the other's.
void check_solve_keys(const JsonDocument& document, const std::string& kind,
                      const std::string& place) {
  const json& entry = document.value[json::json_pointer(place)];
  for (const auto& each : rows_of_kind(kind)) {
    if (!entry.contains(each.key)) {
      refuse(document, place,
             "expected the key \"" + each.key + "\" for kind " + kind + ", which is missing");
    }
  }
  const auto others = kind == kEqualLists ? spin_limits_rows() : equal_lists_rows();
  for (auto key = entry.begin(); key != entry.end(); ++key) {
    if (std::any_of(others.begin(), others.end(),
                    [&](const auto& each) { return each.key == key.key(); })) {
      refuse(document, place + "/" + key.key(), "expected none for kind " + kind);
    }
  }
}

void check_solve_factors(const Protocol& protocol, const SolveEntry& entry,
                         const std::string& place) {
  for (std::size_t i = 0; i < entry.for_each.size(); ++i) {
    const std::string& name = entry.for_each[i];
    named_factor(protocol.document, item(place + "/for_each", i), protocol.design, name);
    if (protocol.design.adaptive && protocol.design.adaptive->factor == name) {
      refuse(
          protocol.document, item(place + "/for_each", i),
          "expected a factor whose levels are planned, got the adaptive one, " + json_text(name));
    }
  }
}

void check_pointer(const Protocol& protocol, const SolveEntry& entry, const std::string& place,
                   const std::string& solved) {
  if (entry.pointer != solved) {
    refuse(protocol.document, place + "/pointer",
           "expected \"" + solved + "\", got " + json_text(entry.pointer));
  }
}

void check_spin(const Protocol& protocol, const SolveEntry& entry, const std::string& place) {
  const json& scene = protocol.scene.value;
  const std::string has_none = ", but " + protocol.scene.name + " has none";
  check_pointer(protocol, entry, place, kSpinPointer);
  if (!scene.contains(json::json_pointer(kSpinPointer))) {
    refuse(protocol.document, place + "/pointer",
           "expected a scene with " + std::string(kSpinPointer) + has_none);
  }
  if (!scene["engine"].contains("level")) {
    refuse(protocol.document, place, "expected a scene with /engine/level" + has_none);
  }
  if (!(entry.percentiles[0] < entry.percentiles[1])) {
    refuse(
        protocol.document, place + "/percentiles",
        "expected the lower first, got " + list_text({entry.percentiles[0], entry.percentiles[1]}));
  }
}

void check_lists(const Protocol& protocol, const SolveEntry& entry, const std::string& place) {
  const json& scene = protocol.scene.value;
  const std::string threshold = "/engine/schedule/thresholds/0";
  check_pointer(protocol, entry, place, threshold);
  const bool two_lists =
      names_single_value(scene, threshold) && scene["engine"]["schedule"]["lists"].size() == 2;
  if (!two_lists) {
    refuse(protocol.document, place,
           "expected a scene with two priority lists and a threshold between them, but " +
               protocol.scene.name + " has none");
  }
  const json::json_pointer by_time("/engine/budget/ms_per_step");
  if (scene.contains(by_time)) {
    refuse(protocol.document, place,
           "expected a scene with a budget in tests_per_step or without any, for a pilot finds the "
           "same on every machine, but " +
               protocol.scene.name + " has one of " + scene[by_time].dump() + " ms_per_step");
  }
}

/// The pilot's collisions of two bodies.
struct Pilot {
  std::vector<double> measures;
  double share{0.0};  ///< of them in the first list
};

Pilot run_pilot(const Scene& scene, double pilot_s, ShapeLibrary& shapes,
                const Progress& progress) {
  LiveRun live(build_scene(scene, assumed_screen(), 0.0, shapes, "pilot"), 1);
  live.drop_digests();
  play_to(live, pilot_s, progress);
  Pilot pilot;
  for (const CollisionRecord& collision : live.take_collisions()) {
    if (!is_wall(collision.report.bodies.b) && collision.priority) {
      pilot.measures.push_back(*collision.priority);
      pilot.share += collision.report.list == 0 ? 1.0 : 0.0;
    }
  }
  pilot.share /= std::max(1.0, static_cast<double>(pilot.measures.size()));
  return pilot;
}

double threshold_of(const EngineSettings& engine, double share,
                    const std::vector<double>& measures) {
  const double m_per_deg = metres_per_degree(assumed_screen().viewing_distance_m);
  const auto metric = make_metric(engine.scheduler(), metric_options_of(engine, m_per_deg));
  return thresholds_for({share}, measures, *metric).front();
}

std::string percent(double share) { return printed("%.0f", 100.0 * share); }

std::string parted(double share) { return percent(share) + " to " + percent(1.0 - share); }

/// The threshold that parts the collisions of a pilot in two lists of given shares.
///
///   pilot ──collisions of two bodies, measured──> threshold ──> pilot again ──> shares as wanted?
///
/// Where lists differ in detail, the threshold changes what happens, so it is tried and, when it
/// misses, found anew from that pilot. Collisions with walls are not counted: nothing is modelled
/// of a wall's surface. (Dingliana 2002, sec. 6.3: "some sampling of the scene") Throws InputError
/// when no threshold comes within the tolerance of the share.
std::vector<SolvedValue> solve_equal_lists(const SolveTask& task, ShapeLibrary& shapes,
                                           const Progress& progress) {
  constexpr int kMostPilots = 6;
  const double share = task.entry.share;
  Scene scene = task.scene;
  int number = 0;  // of pilots that are done
  const Progress tell_pilot = [&](double done) { progress((number + done) / kMostPilots); };
  Pilot pilot = run_pilot(scene, task.entry.pilot_s, shapes, tell_pilot);
  for (number = 1; number < kMostPilots && !pilot.measures.empty(); ++number) {
    const double threshold = threshold_of(scene.engine, share, pilot.measures);
    scene.engine.schedule->limits["thresholds"].front() = threshold;
    pilot = run_pilot(scene, task.entry.pilot_s, shapes, tell_pilot);
    if (!pilot.measures.empty() && std::abs(pilot.share - share) <= task.entry.within) {
      return {{task.entry.pointer, threshold}};
    }
  }
  refuse(*task.document, task.place,
         "expected a threshold that parts the pilot's collisions " + parted(share) + " within " +
             percent(task.entry.within) + " %, but under " + to_json(task.condition).dump() +
             (pilot.measures.empty() ? " no two bodies collide in the pilot"
                                     : " the best found parts them " + parted(pilot.share)));
}

std::vector<SolvedValue> solve_one(const SolveTask& task, ShapeLibrary& shapes,
                                   const Progress& progress) {
  return task.entry.kind == kEqualLists ? solve_equal_lists(task, shapes, progress)
                                        : solve_spin_limits(task, shapes, progress);
}

}  // namespace

Kind<SolveEntry> solve_kind() {
  using E = SolveEntry;
  RowList<E> rows{
      required("kind", &E::kind, one_of({"random-spin-limits", kEqualLists}),
               "random-spin-limits: the limits of /imposed/random_spin, percentiles of the changes "
               "of angular velocity in accurate collisions of the same bodies from starts that are "
               "slightly turned and shifted; needs accurate_level, runs, turn_deg, size_share and "
               "percentiles. equal-lists: the threshold between two priority lists that parts a "
               "pilot's collisions of bodies in this share; needs share, within and pilot_s."),
      required("pointer", &E::pointer, any_text(), "JSON Pointer into the scene: what is solved."),
      row("for_each", &E::for_each, list(any_text(), {0, -1, /*is_set=*/true}),
          "Factors at each of whose levels it is solved anew; the others stay as they are in the "
          "scene.")};
  return object<E>("", rows.append(spin_limits_rows()).append(equal_lists_rows()));
}

void check_solve(const Protocol& protocol) {
  for (std::size_t i = 0; i < protocol.solve.size(); ++i) {
    const SolveEntry& entry = protocol.solve[i];
    const std::string place = item("/solve", i);
    check_solve_keys(protocol.document, entry.kind, place);
    check_solve_factors(protocol, entry, place);
    if (entry.kind == kEqualLists) {
      check_lists(protocol, entry, place);
    } else {
      check_spin(protocol, entry, place);
    }
  }
}

std::vector<SolvedFor> solve(const Protocol& protocol, ShapeLibrary& shapes,
                             const Progress& progress) {
  std::vector<SolveTask> tasks;
  for (std::size_t i = 0; i < protocol.solve.size(); ++i) {
    for (const Condition& condition : cells_of(protocol.design, protocol.solve[i].for_each)) {
      tasks.push_back({&protocol.document, item("/solve", i), protocol.solve[i], condition,
                       scene_under(protocol, condition)});
    }
  }
  std::vector<SolvedFor> solved;
  for (const SolveTask& task : tasks) {
    const auto tell = [&](double share) {
      if (progress) {
        progress((static_cast<double>(solved.size()) + share) / static_cast<double>(tasks.size()));
      }
    };
    solved.push_back({task.condition, solve_one(task, shapes, tell)});
  }
  return solved;
}

void put_solved(const std::vector<SolvedFor>& solved, Plan& plan) {
  for (PlannedTrial& trial : plan) {
    for (const SolvedFor& each : solved) {
      if (has_levels(trial.condition, each.condition)) {
        trial.solved.insert(trial.solved.end(), each.values.begin(), each.values.end());
      }
    }
  }
}

void put_into_scene(const std::vector<SolvedValue>& values, json& scene) {
  for (const SolvedValue& value : values) {
    scene[json::json_pointer(value.pointer)] = value.value;
  }
}

json solved_values_json(const std::vector<SolvedValue>& values) {
  json object = json::object();
  for (const SolvedValue& value : values) {
    object[value.pointer] = value.value;
  }
  return object;
}

std::vector<SolvedValue> solved_values_from_json(const json& object) {
  std::vector<SolvedValue> values;
  for (auto value = object.begin(); value != object.end(); ++value) {
    values.push_back({value.key(), value.value().get<double>()});
  }
  return values;
}

std::string to_text(const std::vector<SolvedValue>& values) {
  return values.empty() ? "" : solved_values_json(values).dump();
}

std::vector<SolvedValue> solved_values_from(const std::string& text) {
  return text.empty() ? std::vector<SolvedValue>{} : solved_values_from_json(json::parse(text));
}

}  // namespace impetus::inline protocol
