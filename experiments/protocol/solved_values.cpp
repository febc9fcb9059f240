// SPDX-License-Identifier: MIT
#include "experiments/protocol/solved_values.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "engine/numerics/elementary_functions.hpp"
#include "engine/scheduling/solved_thresholds.hpp"
#include "experiments/protocol/checks/protocol_scene_checks.hpp"
#include "experiments/protocol/design_reading.hpp"
#include "experiments/protocol/screen_file.hpp"
#include "experiments/protocol/spin_limits.hpp"
#include "experiments/run/live_run.hpp"
#include "experiments/scenes/engine_setup.hpp"
#include "experiments/scenes/scene_file.hpp"
#include "experiments/session/unattended.hpp"

namespace impetus::inline protocol {
namespace {

using nlohmann::json;

constexpr const char* kSpinPointer = "/imposed/random_spin";

const std::vector<std::string>& keys_of(const std::string& kind) {
  static const std::vector<std::string> spin{"accurate_level", "runs", "turn_deg", "size_share",
                                             "percentiles"};
  static const std::vector<std::string> lists{"share", "within", "pilot_s"};
  return kind == "equal-lists" ? lists : spin;
}

void check_solve_keys(const JsonDocument& document, const json& entry, const std::string& place) {
  const auto kind = entry["kind"].get<std::string>();
  const std::vector<std::string>& own = keys_of(kind);
  for (const std::string& key : own) {
    if (!entry.contains(key)) {
      refuse(document, place,
             "expected the key \"" + key + "\" for kind " + kind + ", which is missing");
    }
  }
  for (auto key = entry.begin(); key != entry.end(); ++key) {
    const bool shared = key.key() == "kind" || key.key() == "pointer" || key.key() == "for_each";
    if (!shared && std::find(own.begin(), own.end(), key.key()) == own.end()) {
      refuse(document, place + "/" + key.key(), "expected none for kind " + kind);
    }
  }
}

void check_solve_factors(const Protocol& protocol, const json& entry, const std::string& place) {
  const json names = entry.value("for_each", json::array());
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto& factors = protocol.design.factors;
    if (std::none_of(factors.begin(), factors.end(), [&](const Factor& factor) {
          return factor.name == names[i].get<std::string>();
        })) {
      refuse(protocol.document, place + "/for_each/" + std::to_string(i),
             "expected the name of a factor, got " + names[i].dump());
    }
    const auto& adaptive = protocol.design.adaptive;
    if (adaptive && adaptive->factor == names[i].get<std::string>()) {
      refuse(
          protocol.document, place + "/for_each/" + std::to_string(i),
          "expected a factor whose levels are planned, got the adaptive one, " + names[i].dump());
    }
  }
}

void check_spin(const Protocol& protocol, const json& entry, const std::string& place) {
  const json& scene = protocol.scene.value;
  if (entry["pointer"].get<std::string>() != std::string(kSpinPointer)) {
    refuse(protocol.document, place + "/pointer",
           "expected \"" + std::string(kSpinPointer) + "\", got " + entry["pointer"].dump());
  }
  if (!scene.contains(json::json_pointer(kSpinPointer))) {
    refuse(protocol.document, place + "/pointer",
           "expected a scene with " + std::string(kSpinPointer) + ", but " + protocol.scene.name +
               " has none");
  }
  if (!scene["engine"].contains("level")) {
    refuse(protocol.document, place,
           "expected a scene with /engine/level, but " + protocol.scene.name + " has none");
  }
  if (!(entry["percentiles"][0] < entry["percentiles"][1])) {
    refuse(protocol.document, place + "/percentiles",
           "expected the lower first, got " + entry["percentiles"].dump());
  }
}

void check_lists(const Protocol& protocol, const json& entry, const std::string& place) {
  const json& scene = protocol.scene.value;
  const std::string threshold = "/engine/schedule/thresholds/0";
  if (entry["pointer"].get<std::string>() != threshold) {
    refuse(protocol.document, place + "/pointer",
           "expected \"" + threshold + "\", got " + entry["pointer"].dump());
  }
  const bool two_lists =
      names_single_value(scene, threshold) && scene["engine"]["schedule"]["lists"].size() == 2;
  if (!two_lists) {
    refuse(protocol.document, place,
           "expected a scene with two priority lists and a threshold between them, but " +
               protocol.scene.name + " has none");
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

std::string percent(double share) {
  char text[32];
  std::snprintf(text, sizeof text, "%.0f", 100.0 * share);
  return text;
}

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
  const auto share = task.entry["share"].get<double>();
  const auto within = task.entry["within"].get<double>();
  const auto pilot_s = task.entry["pilot_s"].get<double>();
  const auto pointer = task.entry["pointer"].get<std::string>();
  Scene scene = task.scene;
  int number = 0;  // of pilots that are done
  const Progress tell_pilot = [&](double done) { progress((number + done) / kMostPilots); };
  Pilot pilot = run_pilot(scene, pilot_s, shapes, tell_pilot);
  for (number = 1; number < kMostPilots && !pilot.measures.empty(); ++number) {
    const double threshold = threshold_of(scene.engine, share, pilot.measures);
    scene.engine.schedule->limits["thresholds"].front() = threshold;
    pilot = run_pilot(scene, pilot_s, shapes, tell_pilot);
    if (!pilot.measures.empty() && std::abs(pilot.share - share) <= within) {
      return {{pointer, threshold}};
    }
  }
  refuse(*task.document, task.place,
         "expected a threshold that parts the pilot's collisions " + parted(share) + " within " +
             percent(within) + " %, but under " + to_json(task.condition).dump() +
             (pilot.measures.empty() ? " no two bodies collide in the pilot"
                                     : " the best found parts them " + parted(pilot.share)));
}

/// Every combination of the levels of the factors that an entry is solved for.
std::vector<Condition> conditions_of(const Protocol& protocol, const json& entry) {
  const auto names = entry.value("for_each", std::vector<std::string>{});
  Design part;
  for (const Factor& factor : protocol.design.factors) {
    if (std::find(names.begin(), names.end(), factor.name) != names.end()) {
      part.factors.push_back(factor);
    }
  }
  return cells(part);
}

bool has_levels(const Condition& condition, const Condition& levels) {
  return std::all_of(levels.begin(), levels.end(), [&](const FactorLevel& level) {
    return std::find(condition.begin(), condition.end(), level) != condition.end();
  });
}

std::vector<SolvedValue> solve_one(const SolveTask& task, ShapeLibrary& shapes,
                                   const Progress& progress) {
  return task.entry["kind"].get<std::string>() == std::string("equal-lists")
             ? solve_equal_lists(task, shapes, progress)
             : solve_spin_limits(task, shapes, progress);
}

}  // namespace

void check_solve(const Protocol& protocol) {
  const json entries = protocol.document.value.value("solve", json::array());
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const std::string place = "/solve/" + std::to_string(i);
    check_solve_keys(protocol.document, entries[i], place);
    check_solve_factors(protocol, entries[i], place);
    if (entries[i]["kind"].get<std::string>() == std::string("equal-lists")) {
      check_lists(protocol, entries[i], place);
    } else {
      check_spin(protocol, entries[i], place);
    }
  }
}

std::vector<SolvedFor> solve(const Protocol& protocol, ShapeLibrary& shapes,
                             const Progress& progress) {
  const json entries = protocol.document.value.value("solve", json::array());
  std::vector<SolveTask> tasks;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    for (const Condition& condition : conditions_of(protocol, entries[i])) {
      tasks.push_back({&protocol.document, "/solve/" + std::to_string(i), entries[i], condition,
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

std::string to_text(const std::vector<SolvedValue>& values) {
  json object = json::object();
  for (const SolvedValue& value : values) {
    object[value.pointer] = value.value;
  }
  return values.empty() ? "" : object.dump();
}

std::vector<SolvedValue> solved_values_from(const std::string& text) {
  std::vector<SolvedValue> values;
  if (text.empty()) {
    return values;
  }
  const json object = json::parse(text);
  for (auto value = object.begin(); value != object.end(); ++value) {
    values.push_back({value.key(), value.value().get<double>()});
  }
  return values;
}

}  // namespace impetus::inline protocol
