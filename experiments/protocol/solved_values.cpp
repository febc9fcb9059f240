// SPDX-License-Identifier: MIT
#include "experiments/protocol/solved_values.hpp"

#include <algorithm>

#include "experiments/protocol/equal_lists.hpp"
#include "experiments/protocol/spin_limits.hpp"

namespace impetus::inline protocol {
namespace {

using nlohmann::json;

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
